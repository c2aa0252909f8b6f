// Where EN 12464-1 wants an area's illuminance.
using System;

namespace Ups
{
    public static unsafe class En12464Grid
    {
        /// <summary>In a polygon without holes.</summary>
        public static En12464Point[] In(ReadOnlySpan<double> cornersM, double borderM, out En12464Info info)
        {
            return In(cornersM, new double[0][], borderM, out info);
        }

        /// <summary>The grid's points in a polygon: x, y of its corners, and of each hole's.</summary>
        public static En12464Point[] In(ReadOnlySpan<double> cornersM, double[][] holesM, double borderM,
                                        out En12464Info info)
        {
            Library.Given(holesM, "holesM");
            var desc = En12464Desc.Create();
            desc.CornerCount = Elements.Count(cornersM.Length, 2, "cornersM");
            desc.HoleCount = (uint)holesM.Length;
            desc.BorderM = borderM;
            var counts = new uint[holesM.Length];
            var all = new System.Collections.Generic.List<double>();
            for (int h = 0; h < holesM.Length; ++h)
            {
                counts[h] = Elements.Count(Library.Given(holesM[h], "holesM").Length, 2, "holesM[" + h + "]");
                all.AddRange(holesM[h]);
            }
            var found = En12464Info.Sized();
            UIntPtr needed;
            fixed (double* corners = cornersM, holes = all.ToArray())
            fixed (uint* n = counts)
            {
                desc.CornersM = corners;
                desc.HoleCornersM = holes;
                desc.HoleCornerCounts = n;
                Library.Check(Native.ups_en12464_grid(&desc, &found, null, UIntPtr.Zero, &needed));
                var points = new En12464Point[(int)needed];
                fixed (En12464Point* p = points)
                    Library.Check(Native.ups_en12464_grid(&desc, &found, p, needed, &needed));
                info = found;
                return points;
            }
        }
    }
}
