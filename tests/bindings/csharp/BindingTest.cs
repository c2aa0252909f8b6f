// Does the C# binding work? Layout against tests/abi/layout.txt (which UPS_LAYOUT names), values in and out, errors,
// lifetimes. LightTest.cs has the rest of the class. Run by xunit on .NET (Tests.csproj) and by MonoRunner.cs on Mono.
using System;
using System.Collections.Generic;
using System.IO;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Threading;
using Ups;
using Xunit;

public sealed partial class BindingTest : IDisposable
{
    private const BindingFlags EveryField = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;
    private readonly Context context = new Context(2);

    public void Dispose() { context.Dispose(); }

    private static void Expect(bool condition, string what) { Assert.True(condition, what); }

    private static void ExpectNear(double value, double expected, double relative, string what)
    {
        Expect(Math.Abs(value - expected) <= relative * Math.Abs(expected), what + ": " + value + ", not " + expected);
    }

    private static void ExpectStatus(Status status, string part, Action action, string what)
    {
        try
        {
            action();
            Expect(false, what + ": no exception");
        }
        catch (UpsException e)
        {
            Expect(e.Status == status && e.Message.Contains(part), what + ": " + e.Message);
        }
    }

    /// <summary>to_world, ToWorld and the fixed buffer toWorld_ are one name.</summary>
    private static string Plain(string name) { return name.Replace("_", "").ToLowerInvariant(); }

    [Fact]
    public void TestLayout()
    {
        var types = new Dictionary<string, Type>();
        foreach (var type in typeof(MeshDesc).Assembly.GetTypes())
            if (type.IsValueType && type.Namespace == "Ups" && !type.IsNested) types[Plain("ups_" + type.Name)] = type;
        Type current = null;
        var fields = new Dictionary<string, FieldInfo>();
        int structs = 0, enumerators = 0;
        foreach (var line in File.ReadAllLines(Environment.GetEnvironmentVariable("UPS_LAYOUT")))
        {
            var words = line.Split(new[] { ' ' }, StringSplitOptions.RemoveEmptyEntries);
            if (line.StartsWith("UPS_"))
            {
                ++enumerators;
                continue;
            }
            if (words.Length == 2)
            {
                ++structs;
                Expect(fields.Count == 0, "fields that C has not: " + string.Join(", ", fields.Keys));
                Expect(types.TryGetValue(Plain(words[0]), out current), "no type for " + words[0]);
                fields.Clear();
                foreach (var f in current.GetFields(EveryField)) fields[Plain(f.Name)] = f;
                Expect(Marshal.SizeOf(current) == int.Parse(words[1]), "size of " + words[0]);
                continue;
            }
            FieldInfo field;
            if (!fields.TryGetValue(Plain(words[0]), out field))
            {
                Expect(false, "no field " + words[0] + " in " + current);
                continue;
            }
            fields.Remove(Plain(words[0]));
            var offset = (int)Marshal.OffsetOf(current, field.Name);
            Expect(offset == int.Parse(words[1]), "offset of " + current + "." + field.Name + ": " + offset);
        }
        Expect(fields.Count == 0, "fields that C has not: " + string.Join(", ", fields.Keys));
        Expect(structs > 20 && enumerators > 50, "layout.txt was read");
    }

    private static Scene LampOverFloor(Context context, float reflectance, out SensorId meters, out LuminaireId light)
    {
        var scene = new Scene(context);
        var material = MaterialDesc.Create();
        material.ReflectanceRgb = new[] { reflectance, reflectance, reflectance };
        var instance = InstanceDesc.Create();
        instance.Mesh = scene.AddMesh(new float[] { -5, -5, 0, 5, -5, 0, 5, 5, 0, -5, 5, 0 },
                                      new uint[] { 0, 1, 2, 0, 2, 3 }, scene.AddMaterial(material));
        scene.AddInstance(instance);
        var lamp = LightDesc.Create();
        lamp.Kind = LightKind.Point;
        lamp.IntensityRgb = new float[] { 400, 400, 400 };
        lamp.ToWorld = new double[] { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 2.5 };
        light = scene.AddLight(lamp);
        meters = scene.AddMeters(new[] { 0, 0, 0.5, 1, 0, 0.5 }, new float[] { 0, 0, 1, 0, 0, 1 });
        return scene;
    }

    private static RenderDesc Iterations(uint count)
    {
        var desc = RenderDesc.Create();
        desc.IterationCount = count;
        desc.Seed = 5;
        return desc;
    }

    [Fact]
    public void TestContext()
    {
        Expect(context.ThreadCount == 1 || context.ThreadCount == 2, "threads: no more than processors");
        string message;
        LogLevel level;
        Expect(!context.TryPopLog(out message, out level) && message == "", "an empty log");
        using (var crowded = new Context(1000))
            Expect(crowded.TryPopLog(out message, out level) && level == LogLevel.Info && message.Length > 20,
                   "a log of threads beyond the processors: " + message);
    }

    [Fact]
    public void TestValues()
    {
        var intensities = new float[19];
        var gammas = new float[19];
        for (var i = 0; i < 19; ++i)
        {
            intensities[i] = 100;
            gammas[i] = 10 * i;
        }
        using (var profile = Profile.FromTable(context, new float[] { 0 }, gammas, intensities))
        {
            ExpectNear(profile.Info.InterpolatedFluxLm, 400 * Math.PI, 1e-5, "flux of a uniform intensity");
            Expect(profile.IntensityCd(new float[] { 0, 0, -1, 1, 1, 1 })[1] == 100, "uniform intensity");
        }

        SensorId meters;
        LuminaireId light;
        using (var scene = LampOverFloor(context, 0.5f, out meters, out light))
        {
            var camera = CameraDesc.Create();
            camera.Width = 6;
            camera.Height = 4;
            camera.VerticalFovRad = 0.1f;
            camera.Illuminance = 1;
            camera.ToWorld = new double[] { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 2 };
            var eye = scene.AddCamera(camera);
            camera.Projection = Projection.Panorama;
            camera.Layers = (uint)(Layer.Depth | Layer.Normal);
            var around = scene.AddCamera(camera);
            var vectors = scene.AddMeters(new[] { 0, 0, 0.5 }, new float[] { 0, 0, 1 }, kind: MeterKind.Vector);
            scene.Commit();
            Expect(scene.Info.TriangleCount == 2 && scene.Info.MeterCount == 3, "what the scene holds");
            Expect(scene.Info.BoundsMaxM[1] == 5, "an array inside a struct");
            using (var result = scene.Render(Iterations(16)))
            {
                // I cos(a) / d^2: the meters see the point source alone, so there is no noise, only float rounding.
                var readings = result.Meters(meters);
                ExpectNear(readings[0].IlluminanceLx, 100, 1e-4, "below the lamp");
                ExpectNear(readings[1].IlluminanceLx, 800 / Math.Pow(5, 1.5), 1e-4, "beside the lamp");
                var direct = result.MeterPart(meters, LightPart.Direct);
                Expect(direct[0].IlluminanceLx == readings[0].DirectLx && direct[0].StandardErrorLx == 0, "exact");
                var vector = result.Vectors(vectors)[0];
                Expect(vector.VectorLx[2] > 0 && vector.VectorLx[2] < 100 && vector.ErrorBoundLx[2] > 0,
                       "the light vector, less what the floor reflects");
                var rest = result.VectorPart(vectors, LightPart.Indirect)[0];
                Expect(Math.Abs(result.VectorPart(vectors, LightPart.Direct)[0].VectorLx[2] + rest.VectorLx[2]
                                - vector.VectorLx[2]) < 1e-3, "direct and indirect are all of a vector");
                Expect(rest.VectorLx[2] < 0, "light from the floor comes from below");
                foreach (var flags in result.MeterFlags(meters))
                    Expect(flags == Reading.Exact || flags == Reading.FewPaths, "light by chance is none");
                Expect(result.Image(eye, 6, 4, Channel.IlluminanceStandardError).Length == 24, "errors of an image");
                Expect(result.Image(eye, 6, 4, Channel.IlluminanceBias).Length == 24, "bias of an image");
                foreach (var e in result.Image(eye, 6, 4, Channel.IlluminanceErrorBound))
                    Expect(e >= 0 && e < 1, "bounds of an image");
                // I h / d^3 in the pixels' middles; within one it changes by less than 0.3 % to each side.
                var onFloor = result.Image(eye, 6, 4, Channel.Illuminance);
                var side = 2 * 2 * Math.Tan(0.05) / 4;
                for (var i = 0; i < onFloor.Length; ++i)
                {
                    double x = side * (i % 6 - 2.5), y = side * (i / 6 - 1.5);
                    ExpectNear(onFloor[i], 400 * 2.5 / Math.Pow(x * x + y * y + 2.5 * 2.5, 1.5), 2e-3, "floor");
                }
                int width, height;
                Expect(result.Image(eye, out width, out height, Channel.Illuminance).Length == 24, "an image's own size");
                Expect(width == 6 && height == 4, "width and height");
                Assert.Throws<ArgumentException>(() => result.Image(eye, 4, 6));
                Assert.Throws<ArgumentException>(() => result.ReadImage(eye, Channel.LuminanceRgb, new float[73]));
                Expect(result.Image(around, 6, 4, Channel.Normal).Length == 72, "normals all around");
                var depths = result.Image(around, 6, 4, Channel.Depth);  // the panorama's top row is the axis' up, +y
                Expect(depths.Length == 24 && depths[9] > 2 && depths[6] == -1, "depth ahead and behind");
                Expect(result.Convergence().Length > 0, "convergence");
                var curve = result.Curve();
                Expect(curve.Length == 1 && curve[0].Iterations == 16 && curve[0].Rays > 0, "the curve");
                var foretold = result.Predict(0.01);
                Expect(foretold.LimitedBy == Limit.Noise && foretold.Iterations == 16, "the prediction");
                var worst = result.LargestError().Sensor.V;
                Expect(worst == meters.V || worst == vectors.V, "the worst meter");
                var largest = result.LargestSamples(eye);
                Expect(largest.Length > 0 && largest[0].Walk == Walk.Eye, "the samples that weigh most");
                using (var path = scene.Replay(Iterations(16), largest[0]))
                {
                    ExpectNear(path.Info.Value, largest[0].Value, 1e-5, "a sample traced again");
                    Expect(path.Vertices()[0].Event == PathEvent.Start, "where it starts");
                    Expect(path.Contributions().Length == (int)path.Info.Contributions, "its light");
                    Expect(path.Text().Contains("next-event estimation"), "what it says");
                }
                var places = scene.MeterPlaces(meters);
                Expect(places.Length == result.Meters(meters).Length && places[0].Valid == 1, "the meters' places");
                var cut = scene.Section(new double[] { 1, 0, 0 }, new double[] { 1, 0, 0 });
                Expect(cut.Length == 2 && cut[0].FromM[0] == 1, "a section");
                var seen = scene.Outlines(new double[] { 0, 0, 1 }, new double[] { 0, 0, 1 });
                Expect(seen.Length == 4 && seen[0].FromM[2] == 0, "outlines");
                var emits = scene.Sources();
                Expect(emits.Length == 1 && emits[0].LightKind == (int)LightKind.Point && emits[0].FluxLm > 0, "sources");
                Expect(result.Info.Iterations == 16 && result.Info.Seed == 5, "the render's own data");
                Expect(result.Info.AbsorbedFluxLm < 0 == result.Info.FluxBalanceStandardErrorLm < 0, "the balance");
                foreach (var sensor in new[] { meters, eye })
                    Expect(result.Choice(sensor).Techniques != 0 && result.Choice(sensor).PredictedGain > 0,
                           "how the light is found");
            }
            var memory = scene.EstimateMemory(Iterations(4));
            Expect(memory.PeakBytes > memory.SceneBytes + memory.ResultBytes && memory.AllowedBytes > memory.PeakBytes,
                   "the memory of a render");
            scene.SetDimming(light, 0.5f);
            scene.Commit();
            using (var result = scene.Render(Iterations(4)))
                ExpectNear(result.Meters(meters)[0].IlluminanceLx, 50, 1e-4, "dimmed");
        }
    }

    /// <summary>Arrays inside a struct: by element, whole, as an array; each write reaches the library.</summary>
    [Fact]
    public void TestArrays()
    {
        var light = LightDesc.Create();
        light.ToWorld[3] = 2.5;
        light.ToWorld[11] = 4;
        Expect(light.ToWorld[3] == 2.5 && light.ToWorld[11] == 4 && light.ToWorld[0] == 1, "elements that were set");
        var copy = light;
        copy.ToWorld[3] = 7;
        Expect(light.ToWorld[3] == 2.5, "a copy of a description is one");
        double[] array = light.ToWorld;
        array[3] = 0;
        Expect(array.Length == 12 && light.ToWorld.Length == 12 && light.ToWorld[3] == 2.5, "as an array: a copy");
        light.IntensityRgb = new float[] { 1, 2, 3 };
        var sum = 0.0;
        foreach (var value in light.IntensityRgb) sum += value;
        Expect(sum == 6 && string.Join(" ", light.IntensityRgb) == "1 2 3", "each element");
        for (var i = 0; i < 3; ++i) light.IntensityRgb[i] = 80;
        Action[] wrong = { () => light.ToWorld[12] = 1, () => light.ToWorld[-1] = 1 };
        foreach (var action in wrong)
        {
            try
            {
                action();
                Expect(false, "an element that is not there: no exception");
            }
            catch (IndexOutOfRangeException)
            {
            }
        }
        try
        {
            light.ToWorld = new double[11];
            Expect(false, "an array of the wrong length: no exception");
        }
        catch (ArgumentException e)
        {
            Expect(e.Message.Contains("expected 12 values, got 11"), e.Message);
        }
        using (var scene = new Scene(context))
        {
            scene.AddLight(light);
            var meters = scene.AddMeters(new[] { 2.5, 0, 2 }, new float[] { 0, 0, 1 });
            scene.Commit();
            using (var result = scene.Render(Iterations(2)))
                ExpectNear(result.Meters(meters)[0].IlluminanceLx, 20, 1e-5, "80 cd from 2 m, as the elements say");
        }
    }

    [Fact]
    public void TestErrors()
    {
        ExpectStatus(Status.ErrorInvalidArgument, "thread_count", () => new Context(-1), "negative thread count");
        ExpectStatus(Status.ErrorParse, "", () => Profile.Parse(context, new byte[] { 65, 66 }, ProfileFormat.IesLm63),
                     "bytes that are no photometry");
        using (var scene = new Scene(context))
            ExpectStatus(Status.ErrorInvalidState, "", () => { var i = scene.Info; }, "a scene without a commit");
        var closed = new Scene(context);
        closed.Dispose();
        closed.Dispose();
        try
        {
            closed.Commit();
            Expect(false, "a disposed scene: no exception");
        }
        catch (ObjectDisposedException)
        {
        }
    }

    private static void ExpectNull(string name, Action action)
    {
        Assert.Equal(name, Assert.Throws<ArgumentNullException>(action).ParamName);
    }

    [Fact]
    public void TestWhatIsNullIsTold()
    {
        Context none = null;
        var bytes = new byte[] { 65, 66 };
        var angles = new float[] { 0 };
        ExpectNull("context", () => new Scene(none));
        ExpectNull("context", () => new Fixture(none));
        ExpectNull("context", () => Profile.Parse(none, bytes));
        ExpectNull("context", () => Profile.FromTable(none, angles, angles, angles));
        using (var scene = new Scene(context))
        {
            var lamp = scene.AddLight(LightDesc.Create());
            var material = scene.AddMaterial(MaterialDesc.Create());
            var meters = scene.AddMeters(new double[3], new float[] { 0, 0, 1 });
            ExpectNull("profile", () => scene.AddLuminaire(null, LuminaireDesc.Create()));
            ExpectNull("profile", () => scene.SetLuminaire(lamp, null, LuminaireDesc.Create()));
            ExpectNull("fixture", () => scene.AddFixture(null, FixtureInstanceDesc.Create()));
            ExpectNull("pane", () => scene.AddMaterial(MaterialDesc.Create(), null));
            ExpectNull("pane", () => scene.SetMaterial(material, MaterialDesc.Create(), null));
            ExpectNull("meters", () => scene.SetMeters(meters, null));
            ExpectNull("progress", () => scene.CommitAsync(null, CancellationToken.None));
            scene.Commit();
            ExpectNull("progress", () => scene.RenderAsync(Iterations(1), null, CancellationToken.None));
            var closed = Profile.FromTable(context, angles, new float[] { 0, 90 }, new float[] { 1, 2 });
            closed.Dispose();
            Assert.Throws<ObjectDisposedException>(() => scene.AddLuminaire(closed, LuminaireDesc.Create()));
            Assert.Throws<ObjectDisposedException>(() => scene.SetLuminaire(lamp, closed, LuminaireDesc.Create()));
        }
    }

    [Fact]
    public void TestJobsAndLifetimes()
    {
        SensorId meters;
        LuminaireId light;
        var scene = LampOverFloor(context, 0.8f, out meters, out light);
        scene.Commit();
        var endless = RenderDesc.Create();
        endless.TimeLimitS = 600;
        using (var job = scene.Start(endless))
        {
            Expect(job.Wait(0) == Status.Timeout, "an endless job runs");
            job.Cancel();
            Expect(job.Wait() == Status.Cancelled, "a cancelled job ends");
        }
        var last = scene.Start(Iterations(8));
        context.Dispose();
        scene.Dispose();
        Expect(last.Wait() == Status.Ok, "a job outlives its scene");
        Expect(last.Poll().State == JobState.Finished, "finished");
        var result = last.Result();
        last.Dispose();
        GC.Collect();
        GC.WaitForPendingFinalizers();
        Expect(result.Meters(meters)[0].IlluminanceLx >= 99.9, "a result outlives its job");
    }

    [Fact]
    public void TestMeterShapes()
    {
        using (var scene = new Scene(context))
        {
            var instance = InstanceDesc.Create();
            instance.Mesh = scene.AddMesh(new float[] { 0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0 },
                                          new uint[] { 0, 1, 2, 0, 2, 3 }, scene.AddMaterial(MaterialDesc.Create()),
                                          uvs: new float[] { 0, 0, 1, 0, 1, 1, 0, 1 });
            var table = new[] { scene.AddInstance(instance) };
            var triangles = scene.AddSurfaceMeters(table);
            var texels = scene.AddLightmap(table, 4, 2, back: true);
            var disc = scene.AddMeters(new double[] { 0, 0, 2 }, new float[] { 0, 0, 1 }, footprintM: 0.5f);
            scene.Commit();
            Expect(scene.MeterPlaces(triangles).Length == 2, "a meter a triangle");
            var places = scene.MeterPlaces(texels);
            Expect(places.Length == 8 && places[7].AreaM2 == 0.25f && places[7].Normal[2] == -1, "a meter a texel");
            ExpectNear(places[7].PositionM[0], 1.75, 1e-6, "a texel's place");
            ExpectNear(scene.MeterPlaces(disc)[0].AreaM2, Math.PI / 16, 1e-6, "a disc");
        }
        En12464Info info;
        var hole = new double[] { 5, 1, 6, 1, 6, 2, 5, 2 };
        var points = En12464Grid.In(new double[] { 0, 0, 11, 0, 11, 3, 0, 3 }, 0.5, out info);
        Expect(info.Columns == 31 && info.Rows == 7 && points.Length == 217, "the grid of EN 12464-1");
        points = En12464Grid.In(new double[] { 0, 0, 11, 0, 11, 3, 0, 3 }, new[] { hole }, 0.5, out info);
        Expect(points.Length == info.PointCount && points.Length < 217, "a grid with a hole");
    }
}
