// Does a render in C# have the same bits as in C? UPS_SAME_BITS names the file that tests/bindings/same_bits.c wrote,
// of the scene that is described there and here.
using System;
using System.IO;
using System.Runtime.InteropServices;
using Ups;
using Xunit;

public sealed class SameBitsTest
{
    private static void AddSurfaces(Scene scene)
    {
        var positions = new[] { 0, 0, 0, 4, 0, 0, 4, 3, 0, 0, 3, 0, 0, 0, 2.5f, 4, 0, 2.5f,
                                4, 3, 2.5f, 0, 3, 2.5f, 1, 1, 1.5f, 2, 1, 1.5f, 2, 2, 1.5f, 1, 2, 1.5f };
        var indices = new uint[] { 0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 5, 1, 0, 4, 5, 1, 6, 2, 1, 5, 6,
                                   2, 7, 3, 2, 6, 7, 3, 4, 0, 3, 7, 4, 8, 9, 10, 8, 10, 11 };
        var material = MaterialDesc.Create();
        material.Model = MaterialModel.Plastic;
        material.ReflectanceRgb = new[] { 0.5f, 0.6f, 0.7f };
        material.Roughness = 0.4f;
        var instance = InstanceDesc.Create();
        instance.Mesh = scene.AddMesh(positions, indices, scene.AddMaterial(material));
        scene.AddInstance(instance);
    }

    private static void AddLuminaire(Context context, Scene scene)
    {
        using (var profile = Profile.FromTable(context, new float[] { 0 }, new float[] { 0, 30, 60, 90 },
                                               new float[] { 1000, 740, 190, 0 }))
        {
            var luminaire = LuminaireDesc.Create();
            luminaire.ToWorld[3] = 2;
            luminaire.ToWorld[7] = 1.5;
            luminaire.ToWorld[11] = 2.4;
            scene.AddLuminaire(profile, luminaire);
        }
    }

    private static SensorId AddMeters(Scene scene)
    {
        var positions = new double[3 * 35];
        var normals = new float[3 * 35];
        for (var i = 0; i < 35; ++i)
        {
            positions[3 * i] = (i % 7 + 0.5) * 4 / 7;
            positions[3 * i + 1] = (i / 7 + 0.5) * 3 / 5;
            positions[3 * i + 2] = 0.75;
            normals[3 * i + 2] = 1;
        }
        return scene.AddMeters(positions, normals);
    }

    private static SensorId AddCamera(Scene scene)
    {
        var camera = CameraDesc.Create();
        camera.Width = 24;
        camera.Height = 16;
        camera.ToWorld = new[] { 0, 0, -1, 0.5, -1, 0, 0, 1.5, 0, 1, 0, 1.25 };
        return scene.AddCamera(camera);
    }

    private static byte[] Bits<T>(T[] values) where T : struct
    {
        return MemoryMarshal.AsBytes(new ReadOnlySpan<T>(values)).ToArray();
    }

    [Fact]
    public void TestSameBitsAsInC()
    {
        using (var context = new Context())
        using (var scene = new Scene(context))
        {
            AddSurfaces(scene);
            AddLuminaire(context, scene);
            var meters = AddMeters(scene);
            var camera = AddCamera(scene);
            scene.Commit();
            var render = RenderDesc.Create();
            render.Method = Method.Ups;
            render.IterationCount = 8;
            render.Seed = 20;
            using (var result = scene.Render(render))
            {
                var readings = result.Meters(meters);
                Assert.True(readings[17].IlluminanceLx > 10, "there is light: " + readings[17].IlluminanceLx);
                var expected = File.ReadAllBytes(Environment.GetEnvironmentVariable("UPS_SAME_BITS"));
                var found = new MemoryStream();
                foreach (var part in new[] { Bits(readings), Bits(result.Image(camera, 24, 16)) })
                    found.Write(part, 0, part.Length);
                Assert.Equal(expected, found.ToArray());
            }
        }
    }
}
