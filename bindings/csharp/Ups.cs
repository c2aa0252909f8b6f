// UPS for C#: illuminance and luminance by Unified Path Sampling. Programs use this file's classes; they call the raw
// layer in Ups.Native.cs, where the descriptions (MaterialDesc.Create() and so on) and enumerations stand too. Names,
// units and defaults are those of the C headers, where each function and field is described.
//
// Every failure throws UpsException. Everything that owns something is IDisposable; any order of disposal is right.
// Language level: C# 6, .NET Framework 4.5 (Mono) and later; compile with -unsafe.
using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Ups
{
    public sealed class UpsException : Exception
    {
        public Status Status { get; private set; }
        public UpsException(Status status, string message) : base(status + ": " + message) { Status = status; }
    }

    /// <summary>Owns one handle of the library and destroys it once.</summary>
    public abstract class NativeHandle : SafeHandle
    {
        protected NativeHandle() : base(IntPtr.Zero, true) { }
        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }
    }

    /// <summary>Version of the loaded library.</summary>
    public static class Library
    {
        public static Version Version
        {
            get
            {
                var v = (int)Native.ups_version();
                return new Version(v / 10000, v / 100 % 100, v % 100);
            }
        }

        /// <summary>Failures are negative; Timeout and Cancelled are answers.</summary>
        internal static Status Check(Status status)
        {
            if (status < 0) throw new UpsException(status, Utf8(Native.ups_last_error()));
            return status;
        }

        internal static unsafe string Utf8(IntPtr zeroTerminated)
        {
            var p = (byte*)zeroTerminated;
            var length = 0;
            while (p[length] != 0) ++length;
            var bytes = new byte[length];
            Marshal.Copy(zeroTerminated, bytes, 0, length);
            return Encoding.UTF8.GetString(bytes);
        }

        internal unsafe delegate Status TextCall(byte* text, UIntPtr capacity, UIntPtr* needed);

        /// <summary>The two calls that every text takes: its size, then its bytes. Null: there is none.</summary>
        internal static unsafe string Text(TextCall call)
        {
            UIntPtr needed;
            Check(call(null, UIntPtr.Zero, &needed));
            if (needed == UIntPtr.Zero) return null;
            var bytes = new byte[(int)needed];
            fixed (byte* p = bytes) Check(call(p, needed, &needed));
            return Encoding.UTF8.GetString(bytes, 0, bytes.Length - 1);
        }
    }

    /// <summary>Arrays that C keeps inside a struct, and checks of those that it is given.</summary>
    internal static unsafe class Elements
    {
        internal static float[] Copy(float* p, int count)
        {
            var values = new float[count];
            Marshal.Copy((IntPtr)p, values, 0, count);
            return values;
        }

        internal static double[] Copy(double* p, int count)
        {
            var values = new double[count];
            Marshal.Copy((IntPtr)p, values, 0, count);
            return values;
        }

        internal static void Set(float* p, int count, float[] values, string name)
        {
            Expect(values, count, name);
            Marshal.Copy(values, 0, (IntPtr)p, count);
        }

        internal static void Set(double* p, int count, double[] values, string name)
        {
            Expect(values, count, name);
            Marshal.Copy(values, 0, (IntPtr)p, count);
        }

        internal static void Expect(Array values, long count, string name)
        {
            if (values == null) throw new ArgumentNullException(name);
            if (values.Length != count)
                throw new ArgumentException("expected " + count + " values, got " + values.Length, name);
        }

        /// <summary>The number of elements of `width` values each.</summary>
        internal static uint Count(Array values, int width, string name)
        {
            if (values == null) throw new ArgumentNullException(name);
            if (values.Length % width != 0)
                throw new ArgumentException("expected a multiple of " + width + " values, got " + values.Length, name);
            return (uint)(values.Length / width);
        }
    }

    /// <summary>Threads and log. threadCount 0: all hardware threads.</summary>
    public sealed unsafe class Context : IDisposable
    {
        internal readonly ContextHandle Handle;

        public Context(int threadCount = 0)
        {
            var desc = ContextDesc.Create();
            desc.ThreadCount = threadCount;
            Library.Check(Native.ups_context_create(&desc, out Handle));
        }

        public int ThreadCount
        {
            get
            {
                int count;
                Library.Check(Native.ups_context_get_thread_count(Handle, &count));
                return count;
            }
        }

        /// <summary>Takes the oldest log message; null when there is none.</summary>
        public string PopLog(out LogLevel level)
        {
            var taken = LogLevel.Info;
            var text = Library.Text((p, capacity, needed) =>
            {
                LogLevel l;
                var status = Native.ups_context_pop_log(Handle, p, capacity, needed, &l);
                if (status == Status.Ok && p != null) taken = l;
                return status;
            });
            level = taken;
            return text;
        }

        public void Dispose() { Handle.Dispose(); }
    }

    /// <summary>One luminous intensity distribution; immutable.</summary>
    public sealed unsafe class Profile : IDisposable
    {
        internal readonly ProfileHandle Handle;

        private Profile(ProfileHandle handle) { Handle = handle; }

        /// <summary>From the bytes of a photometric file.</summary>
        public static Profile Parse(Context context, byte[] bytes, ProfileFormat format = ProfileFormat.Auto)
        {
            if (bytes == null) throw new ArgumentNullException("bytes");
            ProfileHandle handle;
            fixed (byte* p = bytes)
                Library.Check(Native.ups_profile_parse(context.Handle, p, (UIntPtr)bytes.Length, format, out handle));
            return new Profile(handle);
        }

        /// <summary>From intensities of each plane C, gamma fastest.</summary>
        public static Profile FromTable(Context context, float[] cDeg, float[] gammaDeg, float[] intensityCd)
        {
            var desc = ProfileDesc.Create();
            desc.CCount = Elements.Count(cDeg, 1, "cDeg");
            desc.GammaCount = Elements.Count(gammaDeg, 1, "gammaDeg");
            Elements.Expect(intensityCd, (long)desc.CCount * desc.GammaCount, "intensityCd");
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
                Native.ups_profile_get_text(Handle, topic, p, capacity, needed)) ?? "";
        }

        /// <summary>cd, for directions xyz in the profile's frame: nadir -Z, C0 +X, C90 +Y.</summary>
        public float[] IntensityCd(float[] directions)
        {
            var values = new float[Elements.Count(directions, 3, "directions")];
            fixed (float* d = directions, v = values)
                Library.Check(Native.ups_profile_eval(Handle, d, (UIntPtr)values.Length, v));
            return values;
        }

        public void Dispose() { Handle.Dispose(); }
    }

    /// <summary>Description of what there is; one thread at a time. Changes take effect at the next Commit.</summary>
    public sealed unsafe class Scene : IDisposable
    {
        internal readonly SceneHandle Handle;

        public Scene(Context context) { Library.Check(Native.ups_scene_create(context.Handle, out Handle)); }

        /// <summary>Texels linear, row 0 first; 1, 3 or 4 channels.</summary>
        public TextureId AddTexture(int width, int height, int channels, float[] texels)
        {
            Elements.Expect(texels, (long)width * height * channels, "texels");
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
        public MeshId AddMesh(float[] positionsM, uint[] indices, MaterialId material, float[] normals = null,
                              float[] uvs = null, float[] tangents = null)
        {
            var desc = MeshDesc.Create();
            desc.Material = material;
            desc.VertexCount = Elements.Count(positionsM, 3, "positionsM");
            desc.TriangleCount = Elements.Count(indices, 3, "indices");
            if (normals != null) Elements.Expect(normals, 3L * desc.VertexCount, "normals");
            if (uvs != null) Elements.Expect(uvs, 2L * desc.VertexCount, "uvs");
            if (tangents != null) Elements.Expect(tangents, 4L * desc.VertexCount, "tangents");
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

        public SensorId AddCamera(CameraDesc desc)
        {
            SensorId id;
            Library.Check(Native.ups_scene_add_camera(Handle, &desc, &id));
            return id;
        }

        /// <summary>Positions, normals, tangents xyz. With tangents and cell sides: means over rectangles.</summary>
        public SensorId AddMeters(double[] positionsM, float[] normals, float[] tangents = null, float cellWidthM = 0,
                                  float cellHeightM = 0)
        {
            var desc = MeterDesc.Create();
            desc.Count = Elements.Count(positionsM, 3, "positionsM");
            desc.CellSizeM = new[] { cellWidthM, cellHeightM };
            Elements.Expect(normals, 3L * desc.Count, "normals");
            if (tangents != null) Elements.Expect(tangents, 3L * desc.Count, "tangents");
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

        public void SetMaterial(MaterialId id, MaterialDesc desc)
        {
            Library.Check(Native.ups_scene_set_material(Handle, id, &desc));
        }

        /// <summary>Twelve values, 3x4, row-major, object to world.</summary>
        public void SetTransform(InstanceId id, double[] toWorld)
        {
            Elements.Expect(toWorld, 12, "toWorld");
            fixed (double* m = toWorld) Library.Check(Native.ups_scene_set_transform(Handle, id, m));
        }

        public void SetDimming(LuminaireId id, float dimming)
        {
            Library.Check(Native.ups_scene_set_dimming(Handle, id, dimming));
        }

        public void Remove(InstanceId id) { Library.Check(Native.ups_scene_remove_instance(Handle, id)); }
        public void Remove(LuminaireId id) { Library.Check(Native.ups_scene_remove_luminaire(Handle, id)); }
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
                Native.ups_scene_get_text(Handle, topic, p, capacity, needed)) ?? "";
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

        public void Dispose() { Handle.Dispose(); }
    }

    /// <summary>A render on the library's own threads; any thread may call. Disposing of it cancels it.</summary>
    public sealed unsafe class Job : IDisposable
    {
        internal readonly JobHandle Handle;

        internal Job(JobHandle handle) { Handle = handle; }

        public Progress Poll()
        {
            var progress = Progress.Sized();
            Library.Check(Native.ups_job_poll(Handle, &progress));
            return progress;
        }

        /// <summary>Ok, Timeout or Cancelled; throws the job's own error.</summary>
        public Status Wait(uint timeoutMs = uint.MaxValue)
        {
            return Library.Check(Native.ups_job_wait(Handle, timeoutMs));
        }

        public void Cancel() { Native.ups_job_cancel(Handle); }

        /// <summary>What is there after the last whole iteration.</summary>
        public Result Result()
        {
            ResultHandle result;
            Library.Check(Native.ups_job_result(Handle, out result));
            return new Result(result);
        }

        public void Dispose() { Handle.Dispose(); }
    }

    /// <summary>What a render has found so far; immutable.</summary>
    public sealed unsafe class Result : IDisposable
    {
        internal readonly ResultHandle Handle;

        internal Result(ResultHandle handle) { Handle = handle; }

        public ResultInfo Info
        {
            get
            {
                var info = ResultInfo.Sized();
                Library.Check(Native.ups_result_get_info(Handle, &info));
                return info;
            }
        }

        public MeterReading[] Meters(SensorId sensor)
        {
            var readings = new MeterReading[Statistics(sensor).Count];
            fixed (MeterReading* r = readings)
                Library.Check(Native.ups_result_read_meters(Handle, sensor, r, (UIntPtr)readings.Length));
            return readings;
        }

        public MeterStatistics Statistics(SensorId sensor)
        {
            var statistics = MeterStatistics.Sized();
            Library.Check(Native.ups_result_get_meter_statistics(Handle, sensor, &statistics));
            return statistics;
        }

        /// <summary>Rows from the top, tight: 3 floats a pixel, 1 for the illuminance. The camera's own size.</summary>
        public float[] Image(SensorId camera, int width, int height, Channel channel = Channel.LuminanceRgb)
        {
            var values = new float[(long)width * height * (channel == Channel.Illuminance ? 1 : 3)];
            fixed (float* v = values)
                Library.Check(Native.ups_result_read_image(Handle, camera, channel, v, UIntPtr.Zero,
                                                           (UIntPtr)(sizeof(float) * (ulong)values.Length)));
            return values;
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
            var values = new float[(long)width * height * 3];
            fixed (float* v = values)
                Library.Check(Native.ups_result_read_technique(Handle, camera, index, contribution, v, UIntPtr.Zero,
                                                               (UIntPtr)(sizeof(float) * (ulong)values.Length)));
            return values;
        }

        public ConvergencePoint[] Convergence()
        {
            UIntPtr needed;
            var status = Native.ups_result_read_convergence(Handle, null, UIntPtr.Zero, &needed);
            if (status != Status.ErrorBufferTooSmall) Library.Check(status);
            var points = new ConvergencePoint[(int)needed];
            fixed (ConvergencePoint* p = points)
                Library.Check(Native.ups_result_read_convergence(Handle, p, needed, &needed));
            return points;
        }

        public string Text(ResultText topic)
        {
            return Library.Text((p, capacity, needed) =>
                Native.ups_result_get_text(Handle, topic, p, capacity, needed)) ?? "";
        }

        public void Dispose() { Handle.Dispose(); }
    }
}
