// UPS for C#: what has a render found: images of cameras, of single techniques, distributions of goniometers.
// The second part of Result; see Ups.Result.cs.
using System;

namespace Ups
{
    public sealed unsafe partial class Result
    {
        /// <summary>Flux, light output ratio and accuracy.</summary>
        public GoniometerInfo GoniometerInfo(SensorId sensor)
        {
            var info = Ups.GoniometerInfo.Sized();
            Library.Check(Native.ups_result_get_goniometer_info(Handle, sensor, &info));
            return info;
        }

        /// <summary>CCount * GammaCount readings, gamma fastest.</summary>
        public IntensityReading[] Goniometer(SensorId sensor)
        {
            var info = GoniometerInfo(sensor);
            var readings = new IntensityReading[(long)info.CCount * info.GammaCount];
            ReadGoniometer(sensor, readings);
            return readings;
        }

        public void ReadGoniometer(SensorId sensor, Span<IntensityReading> readings)
        {
            fixed (IntensityReading* r = readings)
                Library.Check(Native.ups_result_read_goniometer(Handle, sensor, r, (UIntPtr)readings.Length));
        }

        /// <summary>The angles of the readings: CCount planes, GammaCount angles in each.</summary>
        public void GoniometerAngles(SensorId sensor, out float[] cDeg, out float[] gammaDeg)
        {
            var info = GoniometerInfo(sensor);
            cDeg = new float[info.CCount];
            gammaDeg = new float[info.GammaCount];
            fixed (float* c = cDeg, gamma = gammaDeg)
                Library.Check(Native.ups_result_get_goniometer_angles(Handle, sensor, c, (UIntPtr)info.CCount, gamma,
                                                                      (UIntPtr)info.GammaCount));
        }

        /// <summary>The beam angle (fraction 0.5) or field angle (0.1) in the plane C / C + 180, with its
        /// error.</summary>
        public GoniometerBeam GoniometerBeam(SensorId sensor, float cDeg = 0, float fraction = 0.5f)
        {
            var beam = Ups.GoniometerBeam.Sized();
            Library.Check(Native.ups_result_get_goniometer_beam(Handle, sensor, cDeg, fraction, &beam));
            return beam;
        }

        /// <summary>For luminaires, and to write a photometric file. The caller disposes of it.</summary>
        public Profile GoniometerProfile(SensorId sensor)
        {
            ProfileHandle profile;
            Library.Check(Native.ups_result_get_goniometer_profile(Handle, sensor, out profile));
            return new Profile(profile);
        }

        /// <summary>Floats of a pixel: 3 of colours and normals, else 1.</summary>
        public static int FloatsOf(Channel channel)
        {
            switch (channel)
            {
                case Channel.Illuminance:
                case Channel.IlluminanceStandardError:
                case Channel.IlluminanceBias:
                case Channel.IlluminanceErrorBound:
                case Channel.Bias:
                case Channel.ErrorBound:
                case Channel.Depth:
                case Channel.Id:
                    return 1;
                default:
                    return 3;
            }
        }

        private void SizeOf(SensorId camera, Channel channel, out int width, out int height)
        {
            float* pixels;
            uint w, h;
            Library.Check(Native.ups_result_view_image(Handle, camera, channel, &pixels, &w, &h));
            width = (int)w;
            height = (int)h;
        }

        private void ExpectSize(SensorId camera, Channel channel, int width, int height)
        {
            int w, h;
            SizeOf(camera, channel, out w, out h);
            if (width != w || height != h)
                throw new ArgumentException("width and height are " + width + " x " + height + "; the camera had " + w +
                                            " x " + h + " pixels");
        }

        /// <summary>Rows from the top, tight, FloatsOf(channel) a pixel. The size that the camera had when it was
        /// rendered, else an ArgumentException.</summary>
        public float[] Image(SensorId camera, int width, int height, Channel channel = Channel.LuminanceRgb)
        {
            ExpectSize(camera, channel, width, height);
            var values = new float[(long)width * height * FloatsOf(channel)];
            ReadImage(camera, channel, values);
            return values;
        }

        /// <summary>The same with the size that the result tells.</summary>
        public float[] Image(SensorId camera, out int width, out int height, Channel channel = Channel.LuminanceRgb)
        {
            SizeOf(camera, channel, out width, out height);
            return Image(camera, width, height, channel);
        }

        /// <summary>The same into memory of the caller's: width * height * FloatsOf(channel) values.</summary>
        public void ReadImage(SensorId camera, Channel channel, Span<float> values)
        {
            int w, h;
            SizeOf(camera, channel, out w, out h);
            Elements.Expect(values.Length, (long)w * h * FloatsOf(channel), "values");
            fixed (float* v = values)
                Library.Check(Native.ups_result_read_image(Handle, camera, channel, v, UIntPtr.Zero,
                                                           (UIntPtr)(sizeof(float) * (ulong)values.Length)));
        }

        /// <summary>Each technique that has an image; none unless RenderDesc.TechniqueImages was set.</summary>
        public TechniqueInfo[] Techniques(SensorId camera)
        {
            uint count;
            Library.Check(Native.ups_result_get_technique_count(Handle, camera, &count));
            var all = new TechniqueInfo[count];
            for (uint i = 0; i < count; ++i)
            {
                var info = TechniqueInfo.Sized();
                Library.Check(Native.ups_result_get_technique(Handle, camera, i, &info));
                all[i] = info;
            }
            return all;
        }

        /// <summary>Of the technique at that place in Techniques(); 3 floats a pixel, as Image().</summary>
        public float[] TechniqueImage(SensorId camera, uint index, int width, int height,
                                      Contribution contribution = Contribution.Weighted)
        {
            ExpectSize(camera, Channel.LuminanceRgb, width, height);
            var values = new float[(long)width * height * 3];
            ReadTechniqueImage(camera, index, contribution, values);
            return values;
        }

        public void ReadTechniqueImage(SensorId camera, uint index, Contribution contribution, Span<float> values)
        {
            fixed (float* v = values)
                Library.Check(Native.ups_result_read_technique(Handle, camera, index, contribution, v, UIntPtr.Zero,
                                                               (UIntPtr)(sizeof(float) * (ulong)values.Length)));
        }
    }
}
