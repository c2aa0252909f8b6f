// UPS for C#: what is there to light and to measure: materials, meshes, luminaires, fixtures, sensors; commit, render.
// Programs use Scene; see Ups.cs.
using System;
using System.Threading;
using System.Threading.Tasks;

namespace Ups
{
    /// <summary>Description of what there is; one thread at a time. Changes take effect at the next Commit.</summary>
    public sealed unsafe class Scene : IDisposable
    {
        internal readonly SceneHandle Handle;

        public Scene(Context context) { Library.Check(Native.ups_scene_create(context.Handle, out Handle)); }

        /// <summary>Texels linear, row 0 first; 1, 3 or 4 channels.</summary>
        public TextureId AddTexture(int width, int height, int channels, ReadOnlySpan<float> texels)
        {
            Elements.Expect(texels.Length, (long)width * height * channels, "texels");
            var desc = TextureDesc.Create();
            desc.Width = (uint)width;
            desc.Height = (uint)height;
            desc.ChannelCount = (uint)channels;
            TextureId id;
            fixed (float* t = texels)
            {
                desc.Texels = t;
                Library.Check(Native.ups_scene_add_texture(Handle, &desc, &id));
            }
            return id;
        }

        public MaterialId AddMaterial(MaterialDesc desc)
        {
            MaterialId id;
            Library.Check(Native.ups_scene_add_material(Handle, &desc, &id));
            return id;
        }

        /// <summary>Positions, normals xyz; uvs; tangents xyzw; three indices a triangle, counter-clockwise.</summary>
        public MeshId AddMesh(ReadOnlySpan<float> positionsM, ReadOnlySpan<uint> indices, MaterialId material,
                              ReadOnlySpan<float> normals = default,
                              ReadOnlySpan<float> uvs = default,
                              ReadOnlySpan<float> tangents = default)
        {
            var desc = Elements.Mesh(positionsM.Length, indices.Length, normals.Length, uvs.Length, tangents.Length);
            desc.Material = material;
            MeshId id;
            fixed (float* p = positionsM, n = normals, t = uvs, g = tangents)
            fixed (uint* i = indices)
            {
                desc.PositionsM = p;
                desc.Normals = n;
                desc.Uvs = t;
                desc.Tangents = g;
                desc.Indices = i;
                Library.Check(Native.ups_scene_add_mesh(Handle, &desc, &id));
            }
            return id;
        }

        public InstanceId AddInstance(InstanceDesc desc)
        {
            InstanceId id;
            Library.Check(Native.ups_scene_add_instance(Handle, &desc, &id));
            return id;
        }

        public LuminaireId AddLight(LightDesc desc)
        {
            LuminaireId id;
            Library.Check(Native.ups_scene_add_light(Handle, &desc, &id));
            return id;
        }

        /// <summary>desc: LuminaireDesc.Create(), then the place and what differs from the defaults.</summary>
        public LuminaireId AddLuminaire(Profile profile, LuminaireDesc desc)
        {
            LuminaireId id;
            var held = false;
            try
            {
                profile.Handle.DangerousAddRef(ref held);
                desc.Profile = profile.Handle.DangerousGetHandle();
                Library.Check(Native.ups_scene_add_luminaire(Handle, &desc, &id));
            }
            finally
            {
                if (held) profile.Handle.DangerousRelease();
            }
            return id;
        }

        /// <summary>Places a fixture as it is now, which may be changed or disposed of afterwards.</summary>
        public FixtureId AddFixture(Fixture fixture, FixtureInstanceDesc desc)
        {
            FixtureId id;
            Library.Check(Native.ups_scene_add_fixture(Handle, fixture.Handle, &desc, &id));
            return id;
        }

        public SensorId AddCamera(CameraDesc desc)
        {
            SensorId id;
            Library.Check(Native.ups_scene_add_camera(Handle, &desc, &id));
            return id;
        }

        /// <summary>Positions, normals, tangents xyz. With tangents and cell sides: means over rectangles.
        /// A footprint: means over discs of that diameter.</summary>
        public SensorId AddMeters(ReadOnlySpan<double> positionsM, ReadOnlySpan<float> normals,
                                  ReadOnlySpan<float> tangents = default, float cellWidthM = 0,
                                  float cellHeightM = 0, float footprintM = 0, MeterKind kind = MeterKind.Planar)
        {
            var desc = MeterDesc.Create();
            desc.Kind = kind;
            desc.Count = Elements.Count(positionsM.Length, 3, "positionsM");
            desc.CellSizeM = new[] { cellWidthM, cellHeightM };
            desc.FootprintM = footprintM;
            Elements.Expect(normals.Length, 3L * desc.Count, "normals");
            Elements.ExpectIfAny(tangents.Length, 3L * desc.Count, "tangents");
            SensorId id;
            fixed (double* p = positionsM)
            fixed (float* n = normals, t = tangents)
            {
                desc.PositionsM = p;
                desc.Normals = n;
                desc.Tangents = t;
                Library.Check(Native.ups_scene_add_meters(Handle, &desc, &id));
            }
            return id;
        }

        /// <summary>One planar meter for each triangle of the instances, counted through them.</summary>
        public SensorId AddSurfaceMeters(ReadOnlySpan<InstanceId> instances, bool back = false)
        {
            var desc = SurfaceMetersDesc.Create();
            desc.InstanceCount = (uint)instances.Length;
            desc.Back = back ? 1 : 0;
            SensorId id;
            fixed (InstanceId* i = instances)
            {
                desc.Instances = i;
                Library.Check(Native.ups_scene_add_surface_meters(Handle, &desc, &id));
            }
            return id;
        }

        /// <summary>One planar meter for each texel of the instances' UVs, row 0 at v = 0 first.</summary>
        public SensorId AddLightmap(ReadOnlySpan<InstanceId> instances, uint width, uint height, bool back = false)
        {
            var desc = LightmapDesc.Create();
            desc.InstanceCount = (uint)instances.Length;
            desc.Width = width;
            desc.Height = height;
            desc.Back = back ? 1 : 0;
            SensorId id;
            fixed (InstanceId* i = instances)
            {
                desc.Instances = i;
                Library.Check(Native.ups_scene_add_lightmap(Handle, &desc, &id));
            }
            return id;
        }

        /// <summary>What each meter of the committed scene measures.</summary>
        public MeterPlace[] MeterPlaces(SensorId meters)
        {
            UIntPtr needed;
            Library.Check(Native.ups_scene_read_meter_places(Handle, meters, null, UIntPtr.Zero, &needed));
            var places = new MeterPlace[(int)needed];
            fixed (MeterPlace* p = places)
                Library.Check(Native.ups_scene_read_meter_places(Handle, meters, p, needed, &needed));
            return places;
        }

        /// <summary>An eye whose glare is rated; its meter's readings are those of a set of one.</summary>
        public SensorId AddObserver(ObserverDesc desc)
        {
            SensorId id;
            Library.Check(Native.ups_scene_add_observer(Handle, &desc, &id));
            return id;
        }

        /// <summary>Light that leaves the scene, by direction. Without angles: equal steps, desc.CCount and GammaCount
        /// of them.</summary>
        public SensorId AddGoniometer(GoniometerDesc desc, ReadOnlySpan<float> cDeg = default,
                                      ReadOnlySpan<float> gammaDeg = default)
        {
            if (!cDeg.IsEmpty) desc.CCount = (uint)cDeg.Length;
            if (!gammaDeg.IsEmpty) desc.GammaCount = (uint)gammaDeg.Length;
            SensorId id;
            fixed (float* c = cDeg, gamma = gammaDeg)
            {
                desc.CDeg = c;
                desc.GammaDeg = gamma;
                Library.Check(Native.ups_scene_add_goniometer(Handle, &desc, &id));
            }
            return id;
        }

        public void SetMaterial(MaterialId id, MaterialDesc desc)
        {
            Library.Check(Native.ups_scene_set_material(Handle, id, &desc));
        }

        /// <summary>Twelve values, 3x4, row-major, object to world.</summary>
        public void SetTransform(InstanceId id, ReadOnlySpan<double> toWorld)
        {
            Elements.Expect(toWorld.Length, 12, "toWorld");
            fixed (double* m = toWorld) Library.Check(Native.ups_scene_set_transform(Handle, id, m));
        }

        /// <summary>Twelve values, 3x4, row-major, fixture to world: a rotation and a translation.</summary>
        public void SetTransform(FixtureId id, ReadOnlySpan<double> toWorld)
        {
            Elements.Expect(toWorld.Length, 12, "toWorld");
            fixed (double* m = toWorld) Library.Check(Native.ups_scene_set_fixture_transform(Handle, id, m));
        }

        public void SetDimming(LuminaireId id, float dimming)
        {
            Library.Check(Native.ups_scene_set_dimming(Handle, id, dimming));
        }

        public void SetDimming(FixtureId id, float dimming)
        {
            Library.Check(Native.ups_scene_set_fixture_dimming(Handle, id, dimming));
        }

        /// <summary>Multiplies the flux of every luminaire and fixture: above 0, at most 1.</summary>
        public void SetMaintenanceFactor(double factor)
        {
            Library.Check(Native.ups_scene_set_maintenance_factor(Handle, factor));
        }

        /// <summary>The instance that a part of a placed fixture became.</summary>
        public InstanceId FixtureInstance(FixtureId id, FixturePartId part)
        {
            InstanceId instance;
            Library.Check(Native.ups_scene_get_fixture_instance(Handle, id, part, &instance));
            return instance;
        }

        public void Remove(InstanceId id) { Library.Check(Native.ups_scene_remove_instance(Handle, id)); }
        public void Remove(LuminaireId id) { Library.Check(Native.ups_scene_remove_luminaire(Handle, id)); }
        public void Remove(FixtureId id) { Library.Check(Native.ups_scene_remove_fixture(Handle, id)); }
        public void Remove(SensorId id) { Library.Check(Native.ups_scene_remove_sensor(Handle, id)); }
        public void Commit() { Library.Check(Native.ups_scene_commit(Handle)); }

        public SceneInfo Info
        {
            get
            {
                var info = SceneInfo.Sized();
                Library.Check(Native.ups_scene_get_info(Handle, &info));
                return info;
            }
        }

        public string Text(SceneText topic)
        {
            return Library.Text((p, capacity, needed) =>
                Native.ups_scene_get_text(Handle, topic, p, capacity, needed));
        }

        /// <summary>Where a plane cuts the committed scene's surfaces.</summary>
        public Segment[] Section(ReadOnlySpan<double> pointM, ReadOnlySpan<double> normal)
        {
            return Segments((p, n, s, capacity, needed) =>
                Native.ups_scene_read_section(Handle, p, n, s, capacity, needed), pointM, normal);
        }

        /// <summary>Edges of surfaces that are seen beneath a plane, as ups_scene_read_outlines.</summary>
        public Segment[] Outlines(ReadOnlySpan<double> pointM, ReadOnlySpan<double> normal,
                                  double depthM = double.PositiveInfinity)
        {
            return Segments((p, n, s, capacity, needed) =>
                Native.ups_scene_read_outlines(Handle, p, n, depthM, s, capacity, needed), pointM, normal);
        }

        private delegate Status ReadSegments(double* point, double* normal, Segment* segments, UIntPtr capacity,
            UIntPtr* needed);

        private static Segment[] Segments(ReadSegments read, ReadOnlySpan<double> pointM, ReadOnlySpan<double> normal)
        {
            Elements.Expect(pointM.Length, 3, "pointM");
            Elements.Expect(normal.Length, 3, "normal");
            UIntPtr needed;
            fixed (double* p = pointM, n = normal)
            {
                Library.Check(read(p, n, null, UIntPtr.Zero, &needed));
                var segments = new Segment[(int)needed];
                fixed (Segment* s = segments)
                    Library.Check(read(p, n, s, needed, &needed));
                return segments;
            }
        }

        /// <summary>Each luminaire, light and emissive instance of the committed scene: what it is, where, its
        /// flux.</summary>
        public SceneSource[] Sources()
        {
            uint count;
            Library.Check(Native.ups_scene_get_source_count(Handle, &count));
            var all = new SceneSource[count];
            for (uint i = 0; i < count; ++i)
            {
                var source = Ups.SceneSource.Sized();
                Library.Check(Native.ups_scene_get_source(Handle, i, &source));
                all[i] = source;
            }
            return all;
        }

        /// <summary>The profile of a luminaire, by its index in Sources().</summary>
        public Profile SourceProfile(int index)
        {
            ProfileHandle profile;
            Library.Check(Native.ups_scene_get_source_profile(Handle, (uint)index, out profile));
            return new Profile(profile);
        }

        /// <summary>Traces one of Result.LargestSamples again; desc: that of the render that it is of.</summary>
        public ReplayedPath Replay(RenderDesc desc, Sample sample)
        {
            PathHandle path;
            Library.Check(Native.ups_replay(Handle, &desc, &sample, out path));
            return new ReplayedPath(path);
        }

        /// <summary>Blocks until a limit or the target is met.</summary>
        public Result Render(RenderDesc desc)
        {
            ResultHandle result;
            Library.Check(Native.ups_render(Handle, &desc, out result));
            return new Result(result);
        }

        /// <summary>The same as a job, which can be watched and cancelled.</summary>
        public Job Start(RenderDesc desc)
        {
            JobHandle job;
            Library.Check(Native.ups_job_start(Handle, &desc, out job));
            return new Job(job);
        }

        /// <summary>As Start, Job.WaitAsync and Job.Result in one. Cancelled, the task throws
        /// OperationCanceledException and what was found is lost; to keep it, use these three. What Start refuses is
        /// thrown at once. The scene may be changed and disposed of as soon as this returns.</summary>
        public Task<Result> RenderAsync(RenderDesc desc, CancellationToken cancel = default)
        {
            return Waiting.Finish(Start(desc), Waiting.Nobody, cancel);
        }

        public Task<Result> RenderAsync(RenderDesc desc, IProgress<Progress> progress,
                                        CancellationToken cancel = default)
        {
            if (progress == null) throw new ArgumentNullException("progress");
            return Waiting.Finish(Start(desc), progress, cancel);
        }

        /// <summary>What such a render will take; takes as long as its preparations.</summary>
        public MemoryEstimate EstimateMemory(RenderDesc desc)
        {
            var estimate = MemoryEstimate.Sized();
            Library.Check(Native.ups_scene_estimate_memory(Handle, &desc, &estimate));
            return estimate;
        }

        public void Dispose() { Handle.Dispose(); }
    }
}
