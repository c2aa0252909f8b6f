// UPS for C#: what did one sample of a render meet? Programs use ReplayedPath, which Scene.Replay makes; see Ups.cs.
using System;

namespace Ups
{
    /// <summary>A sample of a render, traced again by Scene.Replay.</summary>
    public sealed unsafe class ReplayedPath : IDisposable
    {
        internal readonly PathHandle Handle;

        internal ReplayedPath(PathHandle handle) { Handle = handle; }

        public PathInfo Info
        {
            get
            {
                var info = PathInfo.Sized();
                Library.Check(Native.ups_path_get_info(Handle, &info));
                return info;
            }
        }

        /// <summary>Walk by walk, each from its start.</summary>
        public PathVertex[] Vertices()
        {
            UIntPtr needed;
            Library.Check(Native.ups_path_read_vertices(Handle, null, UIntPtr.Zero, &needed));
            var vertices = new PathVertex[(int)needed];
            fixed (PathVertex* v = vertices)
                Library.Check(Native.ups_path_read_vertices(Handle, v, needed, &needed));
            return vertices;
        }

        /// <summary>The largest first.</summary>
        public PathContribution[] Contributions()
        {
            UIntPtr needed;
            Library.Check(Native.ups_path_read_contributions(Handle, null, UIntPtr.Zero, &needed));
            var contributions = new PathContribution[(int)needed];
            fixed (PathContribution* c = contributions)
                Library.Check(Native.ups_path_read_contributions(Handle, c, needed, &needed));
            return contributions;
        }

        /// <summary>All that is known of the path, for people.</summary>
        public string Text()
        {
            return Library.Text((p, capacity, needed) => Native.ups_path_get_text(Handle, p, capacity, needed));
        }

        public void Dispose() { Handle.Dispose(); }
    }
}
