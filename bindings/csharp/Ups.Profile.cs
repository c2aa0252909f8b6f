// UPS for C#: what does a luminaire send where: distributions from files and tables, queried and written.
// Programs use Profile; see Ups.cs.
using System;

namespace Ups
{
    /// <summary>One luminous intensity distribution; immutable.</summary>
    public sealed unsafe class Profile : IDisposable
    {
        internal readonly ProfileHandle Handle;

        internal Profile(ProfileHandle handle) { Handle = handle; }

        /// <summary>From the bytes of a photometric file.</summary>
        public static Profile Parse(Context context, ReadOnlySpan<byte> bytes,
                                    ProfileFormat format = ProfileFormat.Auto)
        {
            var desc = ProfileParseDesc.Create();
            desc.Format = format;
            return Parse(context, bytes, desc);
        }

        /// <summary>With a tilt or a lamp set; tiltFile: the bytes of the file that its TILT= names.</summary>
        public static Profile Parse(Context context, ReadOnlySpan<byte> bytes, ProfileParseDesc desc,
                                    ReadOnlySpan<byte> tiltFile = default)
        {
            Library.Given(context, "context");
            ProfileHandle handle;
            fixed (byte* p = bytes, tilt = tiltFile)
            {
                desc.Bytes = p;
                desc.Size = (UIntPtr)bytes.Length;
                desc.TiltFile = tilt;
                desc.TiltFileSize = (UIntPtr)tiltFile.Length;
                Library.Check(Native.ups_profile_parse_with(context.Handle, &desc, out handle));
            }
            return new Profile(handle);
        }

        /// <summary>From intensities of each plane C, gamma fastest.</summary>
        public static Profile FromTable(Context context, ReadOnlySpan<float> cDeg, ReadOnlySpan<float> gammaDeg,
                                        ReadOnlySpan<float> intensityCd)
        {
            return FromTable(context, cDeg, gammaDeg, intensityCd, ProfileDesc.Create());
        }

        /// <summary>desc: ProfileDesc.Create(), then the luminous opening and the input power.</summary>
        public static Profile FromTable(Context context, ReadOnlySpan<float> cDeg, ReadOnlySpan<float> gammaDeg,
                                        ReadOnlySpan<float> intensityCd, ProfileDesc desc)
        {
            Library.Given(context, "context");
            desc.CCount = Elements.Count(cDeg.Length, 1, "cDeg");
            desc.GammaCount = Elements.Count(gammaDeg.Length, 1, "gammaDeg");
            Elements.Expect(intensityCd.Length, (long)desc.CCount * desc.GammaCount, "intensityCd");
            ProfileHandle handle;
            fixed (float* c = cDeg, gamma = gammaDeg, intensity = intensityCd)
            {
                desc.CDeg = c;
                desc.GammaDeg = gamma;
                desc.IntensityCd = intensity;
                Library.Check(Native.ups_profile_create(context.Handle, &desc, out handle));
            }
            return new Profile(handle);
        }

        public ProfileInfo Info
        {
            get
            {
                var info = ProfileInfo.Sized();
                Library.Check(Native.ups_profile_get_info(Handle, &info));
                return info;
            }
        }

        public string Text(ProfileText topic)
        {
            return Library.Text((p, capacity, needed) =>
                Native.ups_profile_get_text(Handle, topic, p, capacity, needed));
        }

        /// <summary>Values of a keyword, in any case: a line each where there are several, "" where none.</summary>
        public string Keyword(string name)
        {
            var bytes = Library.Utf8(name, "name");
            return Library.Text((p, capacity, needed) =>
            {
                fixed (byte* n = bytes) return Native.ups_profile_get_keyword(Handle, n, p, capacity, needed);
            });
        }

        /// <summary>A copy in which the keyword has this value alone, for Write.</summary>
        public Profile WithKeyword(string name, string value)
        {
            ProfileHandle handle;
            fixed (byte* n = Library.Utf8(name, "name"), v = Library.Utf8(value, "value"))
                Library.Check(Native.ups_profile_with_keyword(Handle, n, v, out handle));
            return new Profile(handle);
        }

        /// <summary>The lamp set of that index, below Info.LampSetCount. Its texts: Text(ProfileText.LampTypes), a line
        /// each set, and so on.</summary>
        public ProfileLampSet LampSet(int index)
        {
            var lamps = ProfileLampSet.Sized();
            Library.Check(Native.ups_profile_get_lamp_set(Handle, checked((uint)index), &lamps));
            return lamps;
        }

        /// <summary>The bytes of a file, IesLm63 or Eulumdat, of the same distribution.</summary>
        public byte[] Write(ProfileFormat format = ProfileFormat.IesLm63)
        {
            byte[] bytes;
            Library.TryBytes((p, capacity, needed) => Native.ups_profile_write(Handle, format, p, capacity, needed),
                             Library.Check, out bytes);
            return bytes;
        }

        /// <summary>What the file that Write makes does not hold as the profile has it, a line each.</summary>
        public string WriteWarnings(ProfileFormat format = ProfileFormat.IesLm63)
        {
            return Library.Text((p, capacity, needed) =>
                Native.ups_profile_get_write_warnings(Handle, format, p, capacity, needed));
        }

        /// <summary>cd, for directions xyz in the profile's frame: nadir -Z, C0 +X, C90 +Y.</summary>
        public float[] IntensityCd(ReadOnlySpan<float> directions)
        {
            var values = new float[Elements.Count(directions.Length, 3, "directions")];
            fixed (float* d = directions, v = values)
                Library.Check(Native.ups_profile_eval(Handle, d, (UIntPtr)values.Length, v));
            return values;
        }

        /// <summary>cd/m^2, mean of the opening seen from directions xyz; below 0: a point, or an edge.</summary>
        public float[] LuminanceCdM2(ReadOnlySpan<float> directions)
        {
            var values = new float[Elements.Count(directions.Length, 3, "directions")];
            fixed (float* d = directions, v = values)
                Library.Check(Native.ups_profile_get_luminance(Handle, d, (UIntPtr)values.Length, v));
            return values;
        }

        /// <summary>lm between each two of the ascending angles, in [0, 180]: one value less.</summary>
        public double[] ZonalFluxLm(ReadOnlySpan<float> gammaDeg)
        {
            var values = new double[Math.Max(0, (int)Elements.Count(gammaDeg.Length, 1, "gammaDeg") - 1)];
            fixed (float* g = gammaDeg)
            fixed (double* v = values)
                Library.Check(Native.ups_profile_get_zonal_flux(Handle, g, (UIntPtr)gammaDeg.Length, v));
            return values;
        }

        /// <summary>The lobe around the peak of the plane C / C + 180, down to that fraction of it: 0.5 gives the beam
        /// angle, 0.1 the field angle.</summary>
        public ProfileBeam Beam(float cDeg = 0, float fraction = 0.5f)
        {
            var beam = ProfileBeam.Sized();
            Library.Check(Native.ups_profile_get_beam(Handle, cDeg, fraction, &beam));
            return beam;
        }

        /// <summary>By CIE 190: crosswise and endwise, room * 5 + set of reflectances.</summary>
        public UgrTable UgrTable()
        {
            var table = Ups.UgrTable.Sized();
            Library.Check(Native.ups_profile_get_ugr_table(Handle, &table));
            return table;
        }

        /// <summary>CIE flux code, luminance limits, spacing criterion, NEMA type, BUG rating. frontCDeg: where the
        /// front of an outdoor luminaire faces.</summary>
        public DataSheet DataSheet(float frontCDeg = 0)
        {
            var sheet = Ups.DataSheet.Sized();
            Library.Check(Native.ups_profile_get_data_sheet(Handle, frontCDeg, &sheet));
            return sheet;
        }

        /// <summary>Utilisation factors of ten rooms: room * 10 + set of reflectances.</summary>
        public UtilisationTable Utilisation()
        {
            var table = UtilisationTable.Sized();
            Library.Check(Native.ups_profile_get_utilisation(Handle, &table));
            return table;
        }

        public void Dispose() { Handle.Dispose(); }
    }

    /// <summary>How much a source dazzles: position indices and UGR by hand.</summary>
    public static unsafe class Glare
    {
        /// <summary>For directions xyz in the eye's frame, which looks along -Z, +Y up; -1: not a source
        /// there.</summary>
        public static float[] PositionIndex(ReadOnlySpan<float> directions,
                                            PositionIndex kind = Ups.PositionIndex.Table)
        {
            var values = new float[Elements.Count(directions.Length, 3, "directions")];
            fixed (float* d = directions, v = values)
                Library.Check(Native.ups_glare_get_position_index(kind, d, (UIntPtr)values.Length, v));
            return values;
        }

        /// <summary>Of sources by three arrays of one length; -1: none of them counts.</summary>
        public static float Ugr(ReadOnlySpan<float> luminanceCdM2, ReadOnlySpan<float> solidAngleSr,
                                ReadOnlySpan<float> positionIndex, double backgroundCdM2)
        {
            var count = Elements.Count(luminanceCdM2.Length, 1, "luminanceCdM2");
            Elements.Expect(solidAngleSr.Length, count, "solidAngleSr");
            Elements.Expect(positionIndex.Length, count, "positionIndex");
            float ugr;
            fixed (float* l = luminanceCdM2, w = solidAngleSr, p = positionIndex)
                Library.Check(Native.ups_glare_get_ugr(l, w, p, (UIntPtr)count, backgroundCdM2, &ugr));
            return ugr;
        }
    }
}
