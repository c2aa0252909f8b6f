// UPS for C#: what is there to light and what lights it: textures, materials, meshes, instances, luminaires, fixtures;
// set and removed by ids that stay. Programs use Scene; Ups.Sensors.cs and Ups.Commit.cs have its other parts. See
// Ups.cs.
using System;

namespace Ups
{
    /// <summary>What a pane does by the angle of incidence, degrees, ascending. All empty: by its index of refraction;
    /// Reflectance alone may be empty too.</summary>
    public sealed class PaneTable
    {
        public float[] AngleDeg = new float[0], Transmittance = new float[0], Reflectance = new float[0];
    }

    /// <summary>A mesh as Scene.GetMesh finds it, copied; arrays that it has not are empty.</summary>
    public sealed class MeshArrays
    {
        public float[] PositionsM = new float[0], Normals = new float[0], Uvs = new float[0], Tangents = new float[0];
        public uint[] Indices = new uint[0];
        public MaterialId Material;
    }

    /// <summary>Description of what there is; many threads read, or one changes it. Edits take effect at the next
    /// Commit. Set... take all of a thing anew, Get... tell how it stands, edits that were not committed
    /// included.</summary>
    public sealed unsafe partial class Scene : IDisposable
    {
        internal readonly SceneHandle Handle;

        public Scene(Context context)
        {
            Library.Check(Native.ups_scene_create(Library.Given(context, "context").Handle, out Handle));
        }

        /// <summary>Texels linear, row 0 first; 1, 3 or 4 channels.</summary>
        public TextureId AddTexture(int width, int height, int channels, ReadOnlySpan<float> texels)
        {
            TextureId id;
            PutTexture(width, height, channels, texels, &id, default);
            return id;
        }

        public void SetTexture(TextureId id, int width, int height, int channels, ReadOnlySpan<float> texels)
        {
            PutTexture(width, height, channels, texels, null, id);
        }

        // Put...: what is added becomes *added; else that of the id is set.
        private void PutTexture(int width, int height, int channels, ReadOnlySpan<float> texels, TextureId* added,
                                TextureId id)
        {
            Elements.Expect(texels.Length, (long)width * height * channels, "texels");
            var desc = TextureDesc.Create();
            desc.Width = (uint)width;
            desc.Height = (uint)height;
            desc.ChannelCount = (uint)channels;
            fixed (float* t = texels)
            {
                desc.Texels = t;
                Library.Check(added != null ? Native.ups_scene_add_texture(Handle, &desc, added)
                                            : Native.ups_scene_set_texture(Handle, id, &desc));
            }
        }

        /// <summary>Width, Height and ChannelCount; the values are Texels().</summary>
        public TextureDesc GetTexture(TextureId id)
        {
            var desc = TextureDesc.Create();
            Library.Check(Native.ups_scene_get_texture(Handle, id, &desc));
            return desc;
        }

        public float[] Texels(TextureId id)
        {
            UIntPtr needed;
            Library.Check(Native.ups_scene_read_texture(Handle, id, null, UIntPtr.Zero, &needed));
            var texels = new float[(int)needed];
            fixed (float* t = texels) Library.Check(Native.ups_scene_read_texture(Handle, id, t, needed, &needed));
            return texels;
        }

        /// <summary>One that is measured by angle needs its table: ArgumentException without.</summary>
        public MaterialId AddMaterial(MaterialDesc desc) { return AddMaterial(desc, NoTable(desc)); }

        /// <summary>Of model Glazing, measured by angle.</summary>
        public MaterialId AddMaterial(MaterialDesc desc, PaneTable pane)
        {
            MaterialId id;
            PutMaterial(desc, pane, &id, default);
            return id;
        }

        /// <summary>One that is measured by angle needs its table: ArgumentException without.</summary>
        public void SetMaterial(MaterialId id, MaterialDesc desc) { SetMaterial(id, desc, NoTable(desc)); }

        public void SetMaterial(MaterialId id, MaterialDesc desc, PaneTable pane) { PutMaterial(desc, pane, null, id); }

        private static PaneTable NoTable(MaterialDesc desc)
        {
            if (desc.PaneAngleCount > 0)
                throw new ArgumentException("desc is of a pane measured at " + desc.PaneAngleCount + " angles: hand " +
                                            "its PaneTable on, from GetMaterial(id, out pane), or set " +
                                            "PaneAngleCount to 0");
            return new PaneTable();
        }

        private void PutMaterial(MaterialDesc desc, PaneTable pane, MaterialId* added, MaterialId id)
        {
            Library.Given(pane, "pane");
            Elements.Expect(pane.Transmittance.Length, pane.AngleDeg.Length, "Transmittance");
            Elements.ExpectIfAny(pane.Reflectance.Length, pane.AngleDeg.Length, "Reflectance");
            desc.PaneAngleCount = (uint)pane.AngleDeg.Length;
            fixed (float* a = pane.AngleDeg, t = pane.Transmittance, r = pane.Reflectance)
            {
                desc.PaneAngleDeg = a;
                desc.PaneTransmittance = t;
                desc.PaneReflectance = r;
                Library.Check(added != null ? Native.ups_scene_add_material(Handle, &desc, added)
                                            : Native.ups_scene_set_material(Handle, id, &desc));
            }
        }

        public MaterialDesc GetMaterial(MaterialId id)
        {
            PaneTable pane;
            return GetMaterial(id, out pane);
        }

        /// <summary>pane: to hand to SetMaterial with the rest.</summary>
        public MaterialDesc GetMaterial(MaterialId id, out PaneTable pane)
        {
            var desc = MaterialDesc.Create();
            using (Handle.Held())
            {
                Library.Check(Native.ups_scene_get_material(Handle, id, &desc));
                var count = (int)desc.PaneAngleCount;
                pane = new PaneTable { AngleDeg = Elements.Copy(desc.PaneAngleDeg, count),
                                       Transmittance = Elements.Copy(desc.PaneTransmittance, count),
                                       Reflectance = Elements.Copy(desc.PaneReflectance, count) };
            }
            desc.PaneAngleDeg = desc.PaneTransmittance = desc.PaneReflectance = null;
            return desc;
        }

        /// <summary>Positions, normals xyz; uvs; tangents xyzw; three indices a triangle, counter-clockwise.</summary>
        public MeshId AddMesh(ReadOnlySpan<float> positionsM, ReadOnlySpan<uint> indices, MaterialId material,
                              ReadOnlySpan<float> normals = default, ReadOnlySpan<float> uvs = default,
                              ReadOnlySpan<float> tangents = default)
        {
            MeshId id;
            PutMesh(positionsM, indices, material, normals, uvs, tangents, &id, default);
            return id;
        }

        public void SetMesh(MeshId id, ReadOnlySpan<float> positionsM, ReadOnlySpan<uint> indices, MaterialId material,
                            ReadOnlySpan<float> normals = default, ReadOnlySpan<float> uvs = default,
                            ReadOnlySpan<float> tangents = default)
        {
            PutMesh(positionsM, indices, material, normals, uvs, tangents, null, id);
        }

        private void PutMesh(ReadOnlySpan<float> positionsM, ReadOnlySpan<uint> indices, MaterialId material,
                             ReadOnlySpan<float> normals, ReadOnlySpan<float> uvs, ReadOnlySpan<float> tangents,
                             MeshId* added, MeshId id)
        {
            var desc = Elements.Mesh(positionsM.Length, indices.Length, normals.Length, uvs.Length, tangents.Length);
            desc.Material = material;
            fixed (float* p = positionsM, n = normals, t = uvs, g = tangents)
            fixed (uint* i = indices)
            {
                desc.PositionsM = p;
                desc.Normals = n;
                desc.Uvs = t;
                desc.Tangents = g;
                desc.Indices = i;
                Library.Check(added != null ? Native.ups_scene_add_mesh(Handle, &desc, added)
                                            : Native.ups_scene_set_mesh(Handle, id, &desc));
            }
        }

        /// <summary>The vertices alone, as many as the mesh has; without normals these stay.</summary>
        public void SetMeshVertices(MeshId id, ReadOnlySpan<float> positionsM, ReadOnlySpan<float> normals = default)
        {
            var count = Elements.Count(positionsM.Length, 3, "positionsM");
            Elements.ExpectIfAny(normals.Length, positionsM.Length, "normals");
            fixed (float* p = positionsM, n = normals)
                Library.Check(Native.ups_scene_set_mesh_vertices(Handle, id, p, n, count));
        }

        public MeshArrays GetMesh(MeshId id)
        {
            var desc = MeshDesc.Create();
            using (Handle.Held())
            {
                Library.Check(Native.ups_scene_get_mesh(Handle, id, &desc));
                var vertices = (int)desc.VertexCount;
                var indices = new ReadOnlySpan<uint>(desc.Indices, 3 * (int)desc.TriangleCount).ToArray();
                return new MeshArrays { PositionsM = Elements.Copy(desc.PositionsM, 3 * vertices),
                                        Normals = Elements.Copy(desc.Normals, 3 * vertices),
                                        Uvs = Elements.Copy(desc.Uvs, 2 * vertices),
                                        Tangents = Elements.Copy(desc.Tangents, 4 * vertices), Indices = indices,
                                        Material = desc.Material };
            }
        }

        public InstanceId AddInstance(InstanceDesc desc)
        {
            InstanceId id;
            Library.Check(Native.ups_scene_add_instance(Handle, &desc, &id));
            return id;
        }

        public void SetInstance(InstanceId id, InstanceDesc desc)
        {
            Library.Check(Native.ups_scene_set_instance(Handle, id, &desc));
        }

        public InstanceDesc GetInstance(InstanceId id)
        {
            var desc = InstanceDesc.Create();
            Library.Check(Native.ups_scene_get_instance(Handle, id, &desc));
            return desc;
        }

        public LuminaireId AddLight(LightDesc desc)
        {
            LuminaireId id;
            Library.Check(Native.ups_scene_add_light(Handle, &desc, &id));
            return id;
        }

        /// <summary>Of a light, not of a luminaire; keeps the dimming.</summary>
        public void SetLight(LuminaireId id, LightDesc desc)
        {
            Library.Check(Native.ups_scene_set_light(Handle, id, &desc));
        }

        public LightDesc GetLight(LuminaireId id)
        {
            var desc = LightDesc.Create();
            Library.Check(Native.ups_scene_get_light(Handle, id, &desc));
            return desc;
        }

        /// <summary>desc: LuminaireDesc.Create(), then the place and what differs from the defaults.</summary>
        public LuminaireId AddLuminaire(Profile profile, LuminaireDesc desc)
        {
            LuminaireId id;
            PutLuminaire(profile, desc, &id, default);
            return id;
        }

        /// <summary>With the profile that it has.</summary>
        public void SetLuminaire(LuminaireId id, LuminaireDesc desc)
        {
            desc.Profile = IntPtr.Zero;
            Library.Check(Native.ups_scene_set_luminaire(Handle, id, &desc));
        }

        public void SetLuminaire(LuminaireId id, Profile profile, LuminaireDesc desc)
        {
            PutLuminaire(profile, desc, null, id);
        }

        private void PutLuminaire(Profile profile, LuminaireDesc desc, LuminaireId* added, LuminaireId id)
        {
            var handle = Library.Given(profile, "profile").Handle;
            using (handle.Held())
            {
                desc.Profile = handle.DangerousGetHandle();
                Library.Check(added != null ? Native.ups_scene_add_luminaire(Handle, &desc, added)
                                            : Native.ups_scene_set_luminaire(Handle, id, &desc));
            }
        }

        /// <summary>All but its profile, which is LuminaireProfile().</summary>
        public LuminaireDesc GetLuminaire(LuminaireId id)
        {
            var desc = LuminaireDesc.Create();
            Library.Check(Native.ups_scene_get_luminaire(Handle, id, &desc));
            return desc;
        }

        /// <summary>The caller disposes of it.</summary>
        public Profile LuminaireProfile(LuminaireId id)
        {
            ProfileHandle profile;
            Library.Check(Native.ups_scene_get_luminaire_profile(Handle, id, out profile));
            return new Profile(profile);
        }

        /// <summary>Places a fixture as it is now, which may be changed or disposed of afterwards.</summary>
        public FixtureId AddFixture(Fixture fixture, FixtureInstanceDesc desc)
        {
            FixtureId id;
            Library.Check(Native.ups_scene_add_fixture(Handle, Library.Given(fixture, "fixture").Handle, &desc, &id));
            return id;
        }

        public void SetFixture(FixtureId id, FixtureInstanceDesc desc)
        {
            Library.Check(Native.ups_scene_set_fixture(Handle, id, &desc));
        }

        public FixtureInstanceDesc GetFixture(FixtureId id)
        {
            var desc = FixtureInstanceDesc.Create();
            Library.Check(Native.ups_scene_get_fixture(Handle, id, &desc));
            return desc;
        }

        /// <summary>The instance that a part of a placed fixture became.</summary>
        public InstanceId FixtureInstance(FixtureId id, FixturePartId part)
        {
            InstanceId instance;
            Library.Check(Native.ups_scene_get_fixture_instance(Handle, id, part, &instance));
            return instance;
        }

        /// <summary>Twelve values, 3x4, row-major, object to world.</summary>
        public void SetTransform(InstanceId id, ReadOnlySpan<double> toWorld)
        {
            Elements.Expect(toWorld.Length, 12, "toWorld");
            fixed (double* m = toWorld) Library.Check(Native.ups_scene_set_transform(Handle, id, m));
        }

        /// <summary>Of a luminaire or a light.</summary>
        public void SetTransform(LuminaireId id, ReadOnlySpan<double> toWorld)
        {
            Elements.Expect(toWorld.Length, 12, "toWorld");
            fixed (double* m = toWorld) Library.Check(Native.ups_scene_set_luminaire_transform(Handle, id, m));
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

        public float GetDimming(LuminaireId id)
        {
            float dimming;
            Library.Check(Native.ups_scene_get_dimming(Handle, id, &dimming));
            return dimming;
        }

        public void SetDimming(FixtureId id, float dimming)
        {
            Library.Check(Native.ups_scene_set_fixture_dimming(Handle, id, dimming));
        }

        /// <summary>Multiplies the flux of every luminaire and fixture: above 0, at most 1.</summary>
        public double MaintenanceFactor
        {
            get
            {
                double factor;
                Library.Check(Native.ups_scene_get_maintenance_factor(Handle, &factor));
                return factor;
            }
            set { Library.Check(Native.ups_scene_set_maintenance_factor(Handle, value)); }
        }

        // What others still need is not removed: the exception names the first of them.
        public void Remove(TextureId id) { Library.Check(Native.ups_scene_remove_texture(Handle, id)); }
        public void Remove(MaterialId id) { Library.Check(Native.ups_scene_remove_material(Handle, id)); }
        public void Remove(MeshId id) { Library.Check(Native.ups_scene_remove_mesh(Handle, id)); }
        public void Remove(InstanceId id) { Library.Check(Native.ups_scene_remove_instance(Handle, id)); }
        public void Remove(LuminaireId id) { Library.Check(Native.ups_scene_remove_luminaire(Handle, id)); }
        public void Remove(FixtureId id) { Library.Check(Native.ups_scene_remove_fixture(Handle, id)); }
        public void Remove(SensorId id) { Library.Check(Native.ups_scene_remove_sensor(Handle, id)); }

        public void Dispose() { Handle.Dispose(); }
    }
}
