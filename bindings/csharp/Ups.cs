// UPS for C#: illuminance and luminance by Unified Path Sampling. Programs use the classes of this file and of
// Ups.Profile.cs, Ups.Fixture.cs, Ups.Scene.cs (with Ups.Sensors.cs and Ups.Commit.cs), Ups.Job.cs, Ups.Result.cs (with
// Ups.Images.cs), and for files those of Ups.Gltf.cs, Ups.Exr.cs, Ups.Png.cs; they call the raw layer in Ups.Native.cs,
// where the descriptions (MaterialDesc.Create() and so on) and enumerations stand too. Names, units and defaults are
// those of the C headers, where each function and field is described. The libraries are loaded by their versioned
// names, libups.so.0.1, so that a program runs where no development files are.
//
// Arrays go in and out as spans, to which arrays convert by themselves: nothing is copied on the way. An empty span (or
// null) is an array that is left out. No reference is null anywhere, neither given nor returned.
//
// Arrays inside a description are set by element, desc.ToWorld[3] = 2.5, or whole, desc.ToWorld = new double[12]. As of
// any struct, that needs a variable: an element of what a property returns would be set in a copy, which is an error to
// the compiler (CS1612; Mono's mcs misses it).
//
// Every failure throws UpsException. Everything that owns something is IDisposable; any order of disposal is right.
// Language level: C# 7.3, for .NET by way of Ups.csproj and for Mono by mcs -unsafe -langversion:latest, of the same
// files. Mono's compiler has no C# 8, so nullable references are annotated by having none.
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

        /// <summary>Until it is disposed of the handle stays, whoever disposes of that: for arrays that are the handle's
        /// own, and for descriptions that hold it.</summary>
        internal Hold Held() { return new Hold(this); }

        internal struct Hold : IDisposable
        {
            private readonly NativeHandle handle_;
            private bool held_;

            public Hold(NativeHandle handle)
            {
                handle_ = handle;
                held_ = false;
                handle.DangerousAddRef(ref held_);
            }

            public void Dispose()
            {
                if (held_) handle_.DangerousRelease();
                held_ = false;
            }
        }
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

        /// <summary>Of the second of two calls, the first of which told the size: false where a commit that came between
        /// has more to tell; both are to be made anew. It may have less.</summary>
        internal static bool Fits(Status status)
        {
            return status != Status.ErrorBufferTooSmall && Check(status) == Status.Ok;
        }

        /// <summary>An argument, which is not null.</summary>
        internal static T Given<T>(T argument, string name) where T : class
        {
            if (argument == null) throw new ArgumentNullException(name);
            return argument;
        }

        /// <summary>As C wants it: with a final zero, and none before.</summary>
        internal static byte[] Utf8(string text, string name)
        {
            if (Given(text, name).IndexOf('\0') >= 0)
                throw new ArgumentException("a zero character within the text", name);
            return Encoding.UTF8.GetBytes(text + "\0");
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

        internal delegate Status Checked(Status status);

        /// <summary>The two calls that every text takes: its size, then its bytes without the final zero. False: there
        /// is none.</summary>
        internal static unsafe bool TryBytes(TextCall call, Checked check, out byte[] bytes)
        {
            for (;;)
            {
                UIntPtr needed;
                check(call(null, UIntPtr.Zero, &needed));
                bytes = new byte[(int)needed];
                if (bytes.Length == 0) return false;
                Status status;
                fixed (byte* p = bytes) status = call(p, (UIntPtr)bytes.Length, &needed);
                if (status == Status.ErrorBufferTooSmall) continue;  // a commit that came between has more to tell
                check(status);
                Array.Resize(ref bytes, Math.Max((int)needed, 1) - 1);
                return true;
            }
        }

        internal static string Text(TextCall call) { return Text(call, Check); }

        internal static string Text(TextCall call, Checked check)
        {
            byte[] bytes;
            TryBytes(call, check, out bytes);
            return Encoding.UTF8.GetString(bytes);
        }
    }

    /// <summary>Arrays that C keeps inside a struct, and checks of those that it is given.</summary>
    internal static unsafe class Elements
    {
        /// <summary>Null: an array that there is not, which is empty.</summary>
        internal static float[] Copy(float* p, int count)
        {
            return new ReadOnlySpan<float>(p, p == null ? 0 : count).ToArray();
        }

        internal static double[] Copy(double* p, int count)
        {
            return new ReadOnlySpan<double>(p, p == null ? 0 : count).ToArray();
        }

        internal static void Set(float* p, int count, ReadOnlySpan<float> values, string name)
        {
            Expect(values.Length, count, name);
            values.CopyTo(new Span<float>(p, count));
        }

        internal static void Set(double* p, int count, ReadOnlySpan<double> values, string name)
        {
            Expect(values.Length, count, name);
            values.CopyTo(new Span<double>(p, count));
        }

        internal static int Index(int index, int count)
        {
            if (index < 0 || index >= count) throw new IndexOutOfRangeException("index " + index + " of " + count);
            return index;
        }

        internal static void Expect(int length, long count, string name)
        {
            if (length != count) throw new ArgumentException("expected " + count + " values, got " + length, name);
        }

        /// <summary>Of an array that may be left out.</summary>
        internal static void ExpectIfAny(int length, long count, string name)
        {
            if (length != 0) Expect(length, count, name);
        }

        /// <summary>The number of elements of `width` values each.</summary>
        internal static uint Count(int length, int width, string name)
        {
            if (length % width != 0)
                throw new ArgumentException("expected a multiple of " + width + " values, got " + length, name);
            return (uint)(length / width);
        }

        /// <summary>Counts of a mesh's arrays; the caller pins them.</summary>
        internal static MeshDesc Mesh(int positions, int indices, int normals, int uvs, int tangents)
        {
            var desc = MeshDesc.Create();
            desc.VertexCount = Count(positions, 3, "positionsM");
            desc.TriangleCount = Count(indices, 3, "indices");
            ExpectIfAny(normals, 3L * desc.VertexCount, "normals");
            ExpectIfAny(uvs, 2L * desc.VertexCount, "uvs");
            ExpectIfAny(tangents, 4L * desc.VertexCount, "tangents");
            return desc;
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

        /// <summary>Takes the oldest log message; false when there is none.</summary>
        public bool TryPopLog(out string message, out LogLevel level)
        {
            var taken = LogLevel.Info;
            byte[] bytes;
            bool found;
            Library.TextCall pop = (p, capacity, needed) =>
            {
                LogLevel l;
                var status = Native.ups_context_pop_log(Handle, p, capacity, needed, &l);
                if (status == Status.Ok && p != null) taken = l;
                return status;
            };
            lock (Handle)  // no other thread takes the message between the two calls
                found = Library.TryBytes(pop, Library.Check, out bytes);
            message = Encoding.UTF8.GetString(bytes);
            level = taken;
            return found;
        }

        public void Dispose() { Handle.Dispose(); }
    }
}
