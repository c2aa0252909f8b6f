// UPS for C#: what is a luminaire made of: emitters, reflectors, lenses, collimators and meshes, in their own frame.
// Programs use Fixture, which Scene.AddFixture places; see Ups.cs.
using System;

namespace Ups
{
    /// <summary>Parts of a luminaire; light leaves along local -Z; one thread at a time. Add... return the part's
    /// number. material: for Finish.Custom.</summary>
    public sealed unsafe class Fixture : IDisposable
    {
        internal readonly FixtureHandle Handle;

        public Fixture(Context context)
        {
            Library.Check(Native.ups_fixture_create(Library.Given(context, "context").Handle, out Handle));
        }

        public FixturePartId AddEmitter(FixtureEmitterDesc desc)
        {
            FixturePartId id;
            Library.Check(Native.ups_fixture_add_emitter(Handle, &desc, &id));
            return id;
        }

        /// <summary>profileRzM: radius and z of each point of a Polyline.</summary>
        public FixturePartId AddReflector(ReflectorDesc desc, ReadOnlySpan<double> profileRzM = default,
                                          MaterialDesc? material = null)
        {
            FixturePartId id;
            var custom = material.GetValueOrDefault();
            desc.Material = material.HasValue ? &custom : null;
            desc.ProfilePointCount = Elements.Count(profileRzM.Length, 2, "profileRzM");
            fixed (double* points = profileRzM)
            {
                desc.ProfileRzM = points;
                Library.Check(Native.ups_fixture_add_reflector(Handle, &desc, &id));
            }
            return id;
        }

        public FixturePartId AddLens(LensDesc desc, MaterialDesc? material = null)
        {
            FixturePartId id;
            var custom = material.GetValueOrDefault();
            desc.Material = material.HasValue ? &custom : null;
            Library.Check(Native.ups_fixture_add_lens(Handle, &desc, &id));
            return id;
        }

        /// <summary>wallRzM: radius and z of each point of a Polyline.</summary>
        public FixturePartId AddCollimator(CollimatorDesc desc, ReadOnlySpan<double> wallRzM = default,
                                          MaterialDesc? material = null)
        {
            FixturePartId id;
            var custom = material.GetValueOrDefault();
            desc.Material = material.HasValue ? &custom : null;
            desc.WallPointCount = Elements.Count(wallRzM.Length, 2, "wallRzM");
            fixed (double* points = wallRzM)
            {
                desc.WallRzM = points;
                Library.Check(Native.ups_fixture_add_collimator(Handle, &desc, &id));
            }
            return id;
        }

        /// <summary>Positions, normals xyz; three indices a triangle, counter-clockwise.</summary>
        public FixturePartId AddPart(FixturePartDesc desc, ReadOnlySpan<float> positionsM, ReadOnlySpan<uint> indices,
                                     ReadOnlySpan<float> normals = default,
                                     MaterialDesc? material = null)
        {
            FixturePartId id;
            var custom = material.GetValueOrDefault();
            desc.Material = material.HasValue ? &custom : null;
            var mesh = Elements.Mesh(positionsM.Length, indices.Length, normals.Length, 0, 0);
            fixed (float* p = positionsM, n = normals)
            fixed (uint* i = indices)
            {
                mesh.PositionsM = p;
                mesh.Normals = n;
                mesh.Indices = i;
                desc.Mesh = &mesh;
                Library.Check(Native.ups_fixture_add_part(Handle, &desc, &id));
            }
            return id;
        }

        public FixtureInfo Info
        {
            get
            {
                var info = FixtureInfo.Sized();
                Library.Check(Native.ups_fixture_get_info(Handle, &info));
                return info;
            }
        }

        public void Dispose() { Handle.Dispose(); }
    }
}
