// UPS for C#: illuminance and luminance by Unified Path Sampling. Programs use the classes of this file and of
// Ups.Profile.cs, Ups.Fixture.cs, Ups.Scene.cs, Ups.Result.cs; they call the raw layer in Ups.Native.cs, where the
// descriptions (MaterialDesc.Create() and so on) and enumerations stand too. Names, units and defaults are those of the
// C headers, where each function and field is described. The library is loaded by its versioned name, libups.so.0.1, so
// that a program runs where no development files are.
//
// Arrays inside a description are set by element, desc.ToWorld[3] = 2.5, or whole, desc.ToWorld = new double[12]. As of
// any struct, that needs a variable: an element of what a property returns would be set in a copy, which is an error to
// the compiler (CS1612; Mono's mcs misses it).
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
        internal static unsafe byte[] Bytes(TextCall call)
        {
            UIntPtr needed;
            Check(call(null, UIntPtr.Zero, &needed));
            if (needed == UIntPtr.Zero) return null;
            var bytes = new byte[(int)needed];
            fixed (byte* p = bytes) Check(call(p, needed, &needed));
            Array.Resize(ref bytes, bytes.Length - 1);  // the final zero
            return bytes;
        }

        internal static string Text(TextCall call)
        {
            var bytes = Bytes(call);
            return bytes == null ? null : Encoding.UTF8.GetString(bytes);
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

        internal static int Index(int index, int count)
        {
            if (index < 0 || index >= count) throw new IndexOutOfRangeException("index " + index + " of " + count);
            return index;
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

        /// <summary>Counts of a mesh's arrays; the caller pins them.</summary>
        internal static MeshDesc Mesh(float[] positionsM, uint[] indices, float[] normals, float[] uvs,
                                      float[] tangents)
        {
            var desc = MeshDesc.Create();
            desc.VertexCount = Count(positionsM, 3, "positionsM");
            desc.TriangleCount = Count(indices, 3, "indices");
            if (normals != null) Expect(normals, 3L * desc.VertexCount, "normals");
            if (uvs != null) Expect(uvs, 2L * desc.VertexCount, "uvs");
            if (tangents != null) Expect(tangents, 4L * desc.VertexCount, "tangents");
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
}
