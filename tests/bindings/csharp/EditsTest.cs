// Are things that were added set, asked for and removed from C#, and do awaited commits commit? What each edit does to
// the light is tested with the library; here that everything arrives, and comes back.
using System;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Ups;
using Xunit;

public sealed class EditsTest : IDisposable
{
    private static readonly double[] Moved = { 1, 0, 0, 0.5, 0, 1, 0, 0.25, 0, 0, 1, 3 };

    private readonly Context context = new Context(2);
    private readonly Scene scene;
    private readonly TextureId texture;
    private readonly MaterialId material;
    private readonly MeshId mesh;
    private readonly InstanceId instance;
    private readonly LuminaireId light;
    private readonly SensorId meters;

    public EditsTest()
    {
        scene = new Scene(context);
        texture = scene.AddTexture(2, 1, 1, new[] { 0.25f, 0.75f });
        var white = MaterialDesc.Create();
        white.ReflectanceTexture = texture;
        material = scene.AddMaterial(white);
        mesh = scene.AddMesh(new float[] { -5, -5, 0, 5, -5, 0, 5, 5, 0, -5, 5, 0 }, new uint[] { 0, 1, 2, 0, 2, 3 },
                             material, uvs: new float[] { 0, 0, 1, 0, 1, 1, 0, 1 });
        var floor = InstanceDesc.Create();
        floor.Mesh = mesh;
        instance = scene.AddInstance(floor);
        var lamp = LightDesc.Create();
        lamp.IntensityRgb = new float[] { 400, 400, 400 };
        lamp.ToWorld[11] = 2;
        light = scene.AddLight(lamp);
        meters = scene.AddMeters(new double[] { 0, 0, 1 }, new float[] { 0, 0, 1 });
    }

    public void Dispose()
    {
        scene.Dispose();
        context.Dispose();
    }

    private double Lux()
    {
        var desc = RenderDesc.Create();
        desc.IterationCount = 1;
        using (var result = scene.Render(desc)) return Math.Round(result.Meters(meters)[0].IlluminanceLx, 3);
    }

    private static void ExpectRefused(string part, Action action)
    {
        var error = Assert.Throws<UpsException>(action);
        Assert.Equal(Status.ErrorInvalidArgument, error.Status);
        Assert.Contains(part, error.Message);
    }

    [Fact]
    public void TestSurfaces()
    {
        Assert.Equal(2u, scene.GetTexture(texture).Width);
        scene.SetTexture(texture, 1, 2, 1, new[] { 0.5f, 0.125f });
        Assert.Equal(new[] { 0.5f, 0.125f }, scene.Texels(texture));

        var pane = new PaneTable { AngleDeg = new float[] { 0, 60, 90 }, Transmittance = new[] { 0.8f, 0.7f, 0 },
                                   Reflectance = new[] { 0.1f, 0.2f, 1 } };
        var glazing = MaterialDesc.Create();
        glazing.Model = MaterialModel.Glazing;
        var window = scene.AddMaterial(glazing, pane);
        PaneTable found;
        glazing = scene.GetMaterial(window, out found);
        Assert.Equal(pane.Reflectance, found.Reflectance);
        glazing.Ior = 1.6f;
        scene.SetMaterial(window, glazing, found);
        Assert.Equal(1.6f, scene.GetMaterial(window, out found).Ior);
        Assert.Equal(pane.Transmittance, found.Transmittance);
        // Without the table the pane would become another, whatever else was changed.
        Assert.Throws<ArgumentException>(() => scene.SetMaterial(window, scene.GetMaterial(window)));
        Assert.Throws<ArgumentException>(() => scene.AddMaterial(scene.GetMaterial(window)));
        scene.GetMaterial(window, out found);
        Assert.Equal(pane.Transmittance, found.Transmittance);
        Assert.Equal(0, scene.GetMaterial(material, out found).PaneAngleCount + found.AngleDeg.Length);

        var arrays = scene.GetMesh(mesh);
        Assert.True(arrays.Material.V == material.V && arrays.Normals.Length == 0 && arrays.Uvs[4] == 1, "the mesh");
        arrays.PositionsM[2] = -1;
        scene.SetMeshVertices(mesh, arrays.PositionsM);
        Assert.Equal(arrays.PositionsM, scene.GetMesh(mesh).PositionsM);
        scene.SetMesh(mesh, arrays.PositionsM, new uint[] { 0, 1, 2 }, window);
        Assert.Equal(new uint[] { 0, 1, 2 }, scene.GetMesh(mesh).Indices);
        ExpectRefused("vertex_count", () => scene.SetMeshVertices(mesh, new float[9]));

        var placed = scene.GetInstance(instance);
        placed.Group = 7;
        scene.SetInstance(instance, placed);
        scene.SetTransform(instance, Moved);
        Assert.Equal(7u, scene.GetInstance(instance).Group);
        Assert.Equal(Moved, scene.GetInstance(instance).ToWorld.ToArray());
    }

    [Fact]
    public void TestLuminaires()
    {
        scene.Commit();
        Assert.Equal(400.0, Lux());
        scene.SetTransform(light, new double[] { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 3 });
        scene.SetDimming(light, 0.5f);
        scene.MaintenanceFactor = 0.8;
        Assert.True(scene.IsDirty && Lux() == 400, "as committed");
        scene.Commit();
        Assert.True(!scene.IsDirty && scene.GetDimming(light) == 0.5f && scene.MaintenanceFactor == 0.8, "committed");
        Assert.Equal(50.0, Lux());
        var lamp = scene.GetLight(light);
        lamp.IntensityRgb = new float[] { 800, 800, 800 };
        scene.SetLight(light, lamp);
        scene.Commit();
        Assert.Equal(100.0, Lux());

        using (var table = Profile.FromTable(context, new float[] { 0 }, new float[] { 0, 90 }, new float[] { 9, 9 }))
        using (var other = Profile.FromTable(context, new float[] { 0 }, new float[] { 0, 90 }, new float[] { 1, 1 }))
        {
            var luminaire = scene.AddLuminaire(table, LuminaireDesc.Create());
            var desc = scene.GetLuminaire(luminaire);
            desc.Group = 4;
            scene.SetLuminaire(luminaire, desc);
            using (var its = scene.LuminaireProfile(luminaire)) Assert.Equal(9f, its.Info.PeakCd);
            scene.SetLuminaire(luminaire, other, desc);
            using (var its = scene.LuminaireProfile(luminaire)) Assert.Equal(1f, its.Info.PeakCd);
            Assert.Equal(4u, scene.GetLuminaire(luminaire).Group);
            ExpectRefused("not a light", () => scene.GetLight(luminaire));
        }
        using (var fixture = new Fixture(context))
        {
            var emitter = FixtureEmitterDesc.Create();
            emitter.RadiusM = 0.01;
            emitter.FluxLm = 100;
            fixture.AddEmitter(emitter);
            var placed = scene.AddFixture(fixture, FixtureInstanceDesc.Create());
            var desc = scene.GetFixture(placed);
            desc.Dimming = 0.25f;
            scene.SetFixture(placed, desc);
            Assert.Equal(0.25f, scene.GetFixture(placed).Dimming);
        }
    }

    [Fact]
    public void TestSensors()
    {
        var set = scene.GetMeters(meters);
        set.PositionsM = new double[] { 0, 0, 1, 1, 0, 1 };
        set.Normals = new float[] { 0, 0, 1, 0, 0, 1 };
        set.FootprintM = 0.5f;
        scene.SetMeters(meters, set);
        var now = scene.GetMeters(meters);
        Assert.True(now.PositionsM.SequenceEqual(set.PositionsM) && now.FootprintM == 0.5f && now.Tangents.Length == 0,
                    "meters");

        var camera = CameraDesc.Create();
        camera.Width = camera.Height = 4;
        var eye = scene.AddCamera(camera);
        camera.Width = 8;
        scene.SetCamera(eye, camera);
        Assert.Equal(8u, scene.GetCamera(eye).Width);
        ExpectRefused("meters", () => scene.GetMeters(eye));

        bool back;
        uint width, height;
        var triangles = scene.AddSurfaceMeters(new[] { instance });
        scene.SetSurfaceMeters(triangles, new[] { instance }, back: true);
        Assert.True(scene.GetSurfaceMeters(triangles, out back)[0].V == instance.V && back, "surface meters");
        var texels = scene.AddLightmap(new[] { instance }, 2, 2);
        scene.SetLightmap(texels, new[] { instance }, 4, 3);
        Assert.Equal(instance.V, scene.GetLightmap(texels, out width, out height, out back).Single().V);
        Assert.True(width == 4 && height == 3 && !back, "a lightmap");

        var observer = ObserverDesc.Create();
        var watcher = scene.AddObserver(observer);
        observer.ToWorld[3] = 1.5;
        scene.SetObserver(watcher, observer);
        Assert.Equal(1.5, scene.GetObserver(watcher).ToWorld[3]);

        float[] c, gamma;
        var sphere = scene.AddGoniometer(GoniometerDesc.Create(), new float[] { 0, 90, 180, 270 },
                                         new float[] { 0, 90, 180 });
        var desc = scene.GetGoniometer(sphere, out c, out gamma);
        Assert.Equal(new float[] { 0, 90, 180 }, gamma);
        Assert.Throws<UpsException>(() => scene.SetGoniometer(sphere, desc));  // which would take other angles
        gamma[1] = 60;
        scene.SetGoniometer(sphere, desc, c, gamma);
        scene.GetGoniometer(sphere, out c, out gamma);
        Assert.True(c.Length == 4 && gamma[1] == 60, "a goniometer");
    }

    [Fact]
    public void TestRemove()
    {
        ExpectRefused("instance", () => scene.Remove(mesh));
        ExpectRefused("mesh", () => scene.Remove(material));
        ExpectRefused("material", () => scene.Remove(texture));
        scene.Remove(instance);
        scene.Remove(mesh);
        scene.Remove(material);
        scene.Remove(texture);
        ExpectRefused("removed", () => scene.GetMesh(mesh));
        ExpectRefused("removed", () => scene.GetTexture(texture));
    }

    [Fact]
    public void TestACommitIsHeldToItsMemory()
    {
        scene.Commit();
        const int side = 200;
        var points = new float[3 * side * side];
        for (var i = 0; i < side * side; ++i)
        {
            points[3 * i] = i % side / (float)side;
            points[3 * i + 1] = i / side / (float)side;
            points[3 * i + 2] = i % 7 * 1e-3f;
        }
        var corners = from y in Enumerable.Range(0, side - 1)
                      from x in Enumerable.Range(0, side - 1)
                      select y * side + x;
        var triangles = corners.SelectMany(c => new[] { c, c + 1, c + side, c + 1, c + side + 1, c + side });
        var sheet = InstanceDesc.Create();
        sheet.Mesh = scene.AddMesh(points, triangles.Select(c => (uint)c).ToArray(), material);
        scene.AddInstance(sheet);
        scene.SetDimming(light, 0.5f);
        var small = CommitDesc.Create();
        small.MemoryLimitBytes = 1 << 20;
        using (var job = scene.StartCommit(small))
        {
            var error = Assert.Throws<UpsException>(() => job.Wait());
            Assert.Equal(Status.ErrorOutOfMemory, error.Status);
            Assert.Contains("memory_limit_bytes", error.Message);
        }
        Assert.True(scene.IsDirty && Lux() == 400, "as it was before");
        small.MemoryLimitBytes = 1 << 28;
        using (var job = scene.StartCommit(small)) Assert.Equal(Status.Ok, job.Wait());
        Assert.Equal(200.0, Lux());
    }

    [Fact]
    public async Task TestAwaitedCommits()
    {
        Assert.True(scene.IsDirty, "nothing was committed");
        await scene.CommitAsync();
        Assert.True(!scene.IsDirty && Lux() == 400, "committed");
        scene.SetDimming(light, 0.25f);
        using (var job = scene.StartCommit())
        {
            Assert.Equal(Status.Ok, job.Wait());
            Assert.Equal(1f, job.Poll().Fraction);
            Assert.Equal(Status.ErrorInvalidState, Assert.Throws<UpsException>(() => job.Result()).Status);
        }
        Assert.Equal(100.0, Lux());
        scene.SetDimming(light, 0.5f);
        var humble = CommitDesc.Create();
        humble.ThreadLimit = 1;
        humble.Priority = Priority.Low;
        using (var job = scene.StartCommit(humble)) Assert.Equal(Status.Ok, job.Wait());
        Assert.Equal(200.0, Lux());
        humble.Priority = (Priority)2;
        Assert.Equal(Status.ErrorInvalidArgument,
                     Assert.Throws<UpsException>(() => scene.StartCommit(humble)).Status);
        scene.SetDimming(light, 0.25f);
        scene.Commit();
        scene.SetDimming(light, 1);
        using (var cancel = new CancellationTokenSource())
        {
            cancel.Cancel();
            for (var i = 0; i < 20; ++i)
            {
                var task = scene.CommitAsync(cancel.Token);
                try
                {
                    await task;
                }
                catch (OperationCanceledException e)
                {
                    Assert.True(e.CancellationToken == cancel.Token, "whose token it was");
                }
                Assert.True(task.IsCanceled && scene.IsDirty && Lux() == 100, "as it was committed before");
            }
        }
        await scene.CommitAsync(CancellationToken.None);
        Assert.Equal(400.0, Lux());
    }
}
