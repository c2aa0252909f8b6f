// UPS for C#: what measures: cameras, meters, observers, goniometers; added, set and asked for. The second part of
// Scene; see Ups.Scene.cs.
using System;

namespace Ups
{
    /// <summary>A set of meters as Scene.AddMeters takes it. Positions, normals, tangents xyz. With tangents and cell
    /// sides: means over rectangles. A footprint: means over discs of that diameter.</summary>
    public sealed class MeterArrays
    {
        public double[] PositionsM = new double[0];
        public float[] Normals = new float[0], Tangents = new float[0];
        public float CellWidthM, CellHeightM, FootprintM;
        public MeterKind Kind = MeterKind.Planar;
    }

    public sealed unsafe partial class Scene
    {
        public SensorId AddCamera(CameraDesc desc)
        {
            SensorId id;
            Library.Check(Native.ups_scene_add_camera(Handle, &desc, &id));
            return id;
        }

        public void SetCamera(SensorId id, CameraDesc desc)
        {
            Library.Check(Native.ups_scene_set_camera(Handle, id, &desc));
        }

        public CameraDesc GetCamera(SensorId id)
        {
            var desc = CameraDesc.Create();
            Library.Check(Native.ups_scene_get_camera(Handle, id, &desc));
            return desc;
        }

        /// <summary>As MeterArrays, of which it takes those that differ from its defaults.</summary>
        public SensorId AddMeters(ReadOnlySpan<double> positionsM, ReadOnlySpan<float> normals,
                                  ReadOnlySpan<float> tangents = default, float cellWidthM = 0, float cellHeightM = 0,
                                  float footprintM = 0, MeterKind kind = MeterKind.Planar)
        {
            SensorId id;
            PutMeters(positionsM, normals, tangents, cellWidthM, cellHeightM, footprintM, kind, &id, default);
            return id;
        }

        public void SetMeters(SensorId id, MeterArrays meters)
        {
            Library.Given(meters, "meters");
            PutMeters(meters.PositionsM, meters.Normals, meters.Tangents, meters.CellWidthM, meters.CellHeightM,
                      meters.FootprintM, meters.Kind, null, id);
        }

        private void PutMeters(ReadOnlySpan<double> positionsM, ReadOnlySpan<float> normals,
                               ReadOnlySpan<float> tangents, float cellWidthM, float cellHeightM, float footprintM,
                               MeterKind kind, SensorId* added, SensorId id)
        {
            var desc = MeterDesc.Create();
            desc.Kind = kind;
            desc.Count = Elements.Count(positionsM.Length, 3, "positionsM");
            desc.CellSizeM = new[] { cellWidthM, cellHeightM };
            desc.FootprintM = footprintM;
            Elements.Expect(normals.Length, 3L * desc.Count, "normals");
            Elements.ExpectIfAny(tangents.Length, 3L * desc.Count, "tangents");
            fixed (double* p = positionsM)
            fixed (float* n = normals, t = tangents)
            {
                desc.PositionsM = p;
                desc.Normals = n;
                desc.Tangents = t;
                Library.Check(added != null ? Native.ups_scene_add_meters(Handle, &desc, added)
                                            : Native.ups_scene_set_meters(Handle, id, &desc));
            }
        }

        /// <summary>Copied.</summary>
        public MeterArrays GetMeters(SensorId id)
        {
            var desc = MeterDesc.Create();
            using (Handle.Held())
            {
                Library.Check(Native.ups_scene_get_meters(Handle, id, &desc));
                var values = 3 * (int)desc.Count;
                return new MeterArrays { PositionsM = Elements.Copy(desc.PositionsM, values),
                                         Normals = Elements.Copy(desc.Normals, values),
                                         Tangents = Elements.Copy(desc.Tangents, values),
                                         CellWidthM = desc.CellSizeM[0], CellHeightM = desc.CellSizeM[1],
                                         FootprintM = desc.FootprintM, Kind = desc.Kind };
            }
        }

        /// <summary>One planar meter for each triangle of the instances, counted through them.</summary>
        public SensorId AddSurfaceMeters(ReadOnlySpan<InstanceId> instances, bool back = false)
        {
            SensorId id;
            PutSurfaceMeters(instances, back, &id, default);
            return id;
        }

        public void SetSurfaceMeters(SensorId id, ReadOnlySpan<InstanceId> instances, bool back = false)
        {
            PutSurfaceMeters(instances, back, null, id);
        }

        private void PutSurfaceMeters(ReadOnlySpan<InstanceId> instances, bool back, SensorId* added, SensorId id)
        {
            var desc = SurfaceMetersDesc.Create();
            desc.InstanceCount = (uint)instances.Length;
            desc.Back = back ? 1 : 0;
            fixed (InstanceId* i = instances)
            {
                desc.Instances = i;
                Library.Check(added != null ? Native.ups_scene_add_surface_meters(Handle, &desc, added)
                                            : Native.ups_scene_set_surface_meters(Handle, id, &desc));
            }
        }

        public InstanceId[] GetSurfaceMeters(SensorId id, out bool back)
        {
            var desc = SurfaceMetersDesc.Create();
            using (Handle.Held())
            {
                Library.Check(Native.ups_scene_get_surface_meters(Handle, id, &desc));
                back = desc.Back != 0;
                return new ReadOnlySpan<InstanceId>(desc.Instances, (int)desc.InstanceCount).ToArray();
            }
        }

        /// <summary>One planar meter for each texel of the instances' UVs, row 0 at v = 0 first.</summary>
        public SensorId AddLightmap(ReadOnlySpan<InstanceId> instances, uint width, uint height, bool back = false)
        {
            SensorId id;
            PutLightmap(instances, width, height, back, &id, default);
            return id;
        }

        public void SetLightmap(SensorId id, ReadOnlySpan<InstanceId> instances, uint width, uint height,
                                bool back = false)
        {
            PutLightmap(instances, width, height, back, null, id);
        }

        private void PutLightmap(ReadOnlySpan<InstanceId> instances, uint width, uint height, bool back,
                                 SensorId* added, SensorId id)
        {
            var desc = LightmapDesc.Create();
            desc.InstanceCount = (uint)instances.Length;
            desc.Width = width;
            desc.Height = height;
            desc.Back = back ? 1 : 0;
            fixed (InstanceId* i = instances)
            {
                desc.Instances = i;
                Library.Check(added != null ? Native.ups_scene_add_lightmap(Handle, &desc, added)
                                            : Native.ups_scene_set_lightmap(Handle, id, &desc));
            }
        }

        public InstanceId[] GetLightmap(SensorId id, out uint width, out uint height, out bool back)
        {
            var desc = LightmapDesc.Create();
            using (Handle.Held())
            {
                Library.Check(Native.ups_scene_get_lightmap(Handle, id, &desc));
                width = desc.Width;
                height = desc.Height;
                back = desc.Back != 0;
                return new ReadOnlySpan<InstanceId>(desc.Instances, (int)desc.InstanceCount).ToArray();
            }
        }

        /// <summary>What each meter of the committed scene measures.</summary>
        public MeterPlace[] MeterPlaces(SensorId meters)
        {
            for (;;)
            {
                UIntPtr needed;
                Library.Check(Native.ups_scene_read_meter_places(Handle, meters, null, UIntPtr.Zero, &needed));
                var places = new MeterPlace[(int)needed];
                Status status;
                fixed (MeterPlace* p = places)
                    status = Native.ups_scene_read_meter_places(Handle, meters, p, (UIntPtr)places.Length, &needed);
                if (!Library.Fits(status)) continue;
                Array.Resize(ref places, (int)needed);
                return places;
            }
        }

        /// <summary>An eye whose glare is rated; its meter's readings are those of a set of one.</summary>
        public SensorId AddObserver(ObserverDesc desc)
        {
            SensorId id;
            Library.Check(Native.ups_scene_add_observer(Handle, &desc, &id));
            return id;
        }

        public void SetObserver(SensorId id, ObserverDesc desc)
        {
            Library.Check(Native.ups_scene_set_observer(Handle, id, &desc));
        }

        public ObserverDesc GetObserver(SensorId id)
        {
            var desc = ObserverDesc.Create();
            Library.Check(Native.ups_scene_get_observer(Handle, id, &desc));
            return desc;
        }

        /// <summary>Light that leaves the scene, by direction. Without angles: equal steps, desc.CCount and GammaCount
        /// of them.</summary>
        public SensorId AddGoniometer(GoniometerDesc desc, ReadOnlySpan<float> cDeg = default,
                                      ReadOnlySpan<float> gammaDeg = default)
        {
            SensorId id;
            PutGoniometer(desc, cDeg, gammaDeg, &id, default);
            return id;
        }

        public void SetGoniometer(SensorId id, GoniometerDesc desc, ReadOnlySpan<float> cDeg = default,
                                  ReadOnlySpan<float> gammaDeg = default)
        {
            PutGoniometer(desc, cDeg, gammaDeg, null, id);
        }

        private void PutGoniometer(GoniometerDesc desc, ReadOnlySpan<float> cDeg, ReadOnlySpan<float> gammaDeg,
                                   SensorId* added, SensorId id)
        {
            if (!cDeg.IsEmpty) desc.CCount = (uint)cDeg.Length;
            if (!gammaDeg.IsEmpty) desc.GammaCount = (uint)gammaDeg.Length;
            fixed (float* c = cDeg, gamma = gammaDeg)
            {
                desc.CDeg = c;
                desc.GammaDeg = gamma;
                Library.Check(added != null ? Native.ups_scene_add_goniometer(Handle, &desc, added)
                                            : Native.ups_scene_set_goniometer(Handle, id, &desc));
            }
        }

        /// <summary>With its angles, copied, to hand to SetGoniometer with the rest.</summary>
        public GoniometerDesc GetGoniometer(SensorId id, out float[] cDeg, out float[] gammaDeg)
        {
            var desc = GoniometerDesc.Create();
            using (Handle.Held())
            {
                Library.Check(Native.ups_scene_get_goniometer(Handle, id, &desc));
                cDeg = Elements.Copy(desc.CDeg, (int)desc.CCount);
                gammaDeg = Elements.Copy(desc.GammaDeg, (int)desc.GammaCount);
            }
            // Without them they would be equal steps: so many that are not handed on are an error.
            if (desc.CDeg != null) desc.CCount = 0;
            if (desc.GammaDeg != null) desc.GammaCount = 0;
            desc.CDeg = desc.GammaDeg = null;
            return desc;
        }
    }
}
