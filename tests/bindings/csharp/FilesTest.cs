// Do glTF, OpenEXR, PNG, maps and the report work from C#? What the files hold is tested with the libraries; here that
// all of it arrives.
using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using Ups;
using Xunit;

public sealed class FilesTest : IDisposable
{
    private readonly string folder_ = Path.Combine(Path.GetTempPath(), "ups_files_" + Guid.NewGuid().ToString("N"));

    public FilesTest() { Directory.CreateDirectory(folder_); }
    public void Dispose() { Directory.Delete(folder_, true); }

    private string File(string name) { return Path.Combine(folder_, name); }

    private const string Room = @"{
""asset"": {""version"": ""2.0""}, ""scene"": 0, ""scenes"": [{""nodes"": [0, 1, 2]}],
""extensionsUsed"": [""KHR_lights_punctual""],
""extensions"": {""KHR_lights_punctual"": {""lights"": [{""type"": ""point"", ""intensity"": 100}]}},
""nodes"": [
 {""name"": ""lamp"", ""translation"": [0, 2, 0], ""extensions"": {""KHR_lights_punctual"": {""light"": 0}}},
 {""name"": ""desk"", ""rotation"": [-0.70710678, 0, 0, 0.70710678], 
  ""extras"": {""ups"": {""meters"": {""width_m"": 2, ""height_m"": 1, ""columns"": 4, ""rows"": 2}}}},
 {""name"": ""eye"", ""camera"": 0, ""translation"": [0, 0, 5]}],
""cameras"": [{""type"": ""perspective"", ""perspective"": {""yfov"": 0.7, ""znear"": 0.1, ""aspectRatio"": 1.5}}]
}";

    [Fact]
    public void TestGltf()
    {
        System.IO.File.WriteAllText(File("room ä.gltf"), Room);
        using (var context = new Context(1))
        using (var scene = new Scene(context))
        {
            var desc = GltfImportDesc.Create();
            desc.CameraWidth = 6;
            desc.CameraHeight = 4;
            using (var import = GltfImport.File(context, File("room ä.gltf"), scene, desc))
            {
                scene.Commit();
                var sensors = import.Sensors();
                Assert.Equal(2, sensors.Length);
                var desk = Array.FindIndex(sensors, s => s.Kind == GltfSensorKind.Meters);
                Assert.Equal("desk", import.SensorName(desk));
                Assert.True(sensors[desk].Columns == 4 && sensors[desk].Rows == 2 && sensors[1 - desk].Width == 6 &&
                            sensors[desk].Layout == GltfLayout.Grid, "what the sensors are");
                double[] positions;
                float[] normals;
                import.Meters(desk, out positions, out normals);
                Assert.True(positions.Length == 24 && Math.Abs(normals[2] - 1) < 1e-6f, "where the meters are");
                Assert.Equal("", import.Warnings);
                using (var result = scene.Render(RenderOnce(true)))
                {
                    var reading = result.Meters(sensors[desk].Sensor)[1];
                    // 100 cd from 2 m above, 0.25 m to each side: I h / d^3
                    var d2 = 4 + 0.25 * 0.25 + 0.25 * 0.25;
                    Assert.True(Math.Abs(reading.IlluminanceLx - 200 / Math.Pow(d2, 1.5)) < 0.01,
                                "lux: " + reading.IlluminanceLx);
                    var source = result.Sources()[0];
                    Assert.Equal("lamp", import.SourceName(source.Kind, source.Id));
                    Assert.Equal("", import.SourceFile(source.Kind, source.Id));
                }
            }
            var error = Assert.Throws<UpsException>(() => GltfImport.File(context, File("none.gltf"), scene));
            Assert.Equal(Status.ErrorIo, error.Status);
            Assert.Contains("none.gltf", error.Message);
            Assert.Throws<ArgumentException>(() => GltfImport.File(context, "a\0b", scene));
        }
    }

    private static RenderDesc RenderOnce(bool apart)
    {
        var desc = RenderDesc.Create();
        desc.IterationCount = 2;
        desc.Separation = apart ? Separation.Luminaires : Separation.Nothing;
        return desc;
    }

    [Fact]
    public void TestExr()
    {
        var rgb = new float[18];
        for (var i = 0; i < rgb.Length; ++i) rgb[i] = i + 0.1f;
        var layers = new List<ExrLayer>(ExrLayer.Rgb(rgb));
        layers.Add(new ExrLayer("lux", new float[] { 7, 1, 2, 3, 4, 5, 6 }, 1));
        Exr.Write(File("a.exr"), 3, 2, layers.ToArray(), new Dictionary<string, string> { { "unit.lux", "lx" } });
        using (var image = ExrImage.Read(File("a.exr")))
        {
            Assert.True(image.Width == 3 && image.Height == 2, "the size");
            Assert.Equal("B G R lux", string.Join(" ", image.Channels()));
            Assert.Equal(new[] { rgb[1], rgb[4], rgb[7], rgb[10], rgb[13], rgb[16] }, image.Channel("G"));
            Assert.Equal(new float[] { 1, 2, 3, 4, 5, 6 }, image.Channel("lux"));
            Assert.Equal("lx", image.Attribute("unit.lux"));
            Assert.Contains("lux", Assert.Throws<UpsException>(() => image.Channel("Z")).Message);
        }
        Assert.Equal(Status.ErrorIo, Assert.Throws<UpsException>(() => ExrImage.Read(File("none.exr"))).Status);
        Assert.Contains("expected at least 6", Assert.Throws<ArgumentException>(() =>
            Exr.Write(File("b.exr"), 3, 2, new ExrLayer("Y", new float[5]))).Message);
        Assert.True(!System.IO.File.Exists(File("b.exr")), "no file of an error");
    }

    private void ExpectPng(string name, int width, int height)
    {
        var bytes = System.IO.File.ReadAllBytes(File(name));
        Assert.Equal("PNG", Encoding.ASCII.GetString(bytes, 1, 3));
        var size = (bytes[18] << 8 | bytes[19]) + " x " + (bytes[22] << 8 | bytes[23]);  // IHDR comes first
        if (width > 0) Assert.Equal(width + " x " + height, size);
    }

    private static float Spread(float[] values)
    {
        float least = values[0], most = values[0];
        foreach (var value in values)
        {
            least = Math.Min(least, value);
            most = Math.Max(most, value);
        }
        return most - least;
    }

    [Fact]
    public void TestPng()
    {
        var rgb = new float[3 * 40 * 30];
        var errors = new float[rgb.Length];
        for (var i = 0; i < rgb.Length; ++i)
        {
            rgb[i] = 10 + i % 7;
            errors[i] = 3;
        }
        var exposure = Png.ChooseExposure(rgb, 40, 30);
        Assert.True(exposure > 0.26 / 17 && exposure < 0.26 / 9, "exposure " + exposure);
        Assert.True(Math.Abs(Png.Exposure(Png.Ev100(exposure)) / exposure - 1) < 1e-9, "there and back");
        Png.Write(File("a.png"), rgb, 40, 30);
        ExpectPng("a.png", 40, 30);
        var smooth = Png.Smooth(rgb, 40, 30, new SmoothLayers { StandardErrorRgb = errors });
        Assert.True(smooth.Length == rgb.Length && Spread(smooth) < 0.5 * Spread(rgb), "smoothed: " + Spread(smooth));
        Png.WriteSmoothed(File("s.png"), smooth, 40, 30, exposure);
        ExpectPng("s.png", 40, 30);
        Png.WriteFalseColor(File("f.png"), new float[] { 1, 2, 3, -1, 5, 6 }, 3, 2, "desk", firstRowAtBottom: true);
        ExpectPng("f.png", 0, 0);
        Png.WritePixels(File("p.png"), new byte[2 * 3 * 3], 2, 3);
        ExpectPng("p.png", 2, 3);
        Assert.Throws<ArgumentException>(() => Png.Write(File("x.png"), rgb, 40, 31));
        rgb[5] = float.NaN;
        var error = Assert.Throws<UpsException>(() => Png.Write(File("x.png"), rgb, 40, 30));
        Assert.Equal(Status.ErrorInvalidArgument, error.Status);
        Assert.True(!System.IO.File.Exists(File("x.png")), "no file of an error");
    }

    private static GltfImportDesc SmallCameras()
    {
        var desc = GltfImportDesc.Create();
        desc.CameraWidth = 6;
        desc.CameraHeight = 4;
        return desc;
    }

    private string Text(string name) { return System.IO.File.ReadAllText(File(name), Encoding.UTF8); }

    private static void ExpectNull(string name, Action action)
    {
        Assert.Equal(name, Assert.Throws<ArgumentNullException>(action).ParamName);
    }

    [Fact]
    public void TestNullArraysAreTold()
    {
        var three = new float[3];
        var one = new float[1];
        var none = new float[0];
        var at = new double[3];
        ExpectNull("positionsM", () => Report.PointsMap(File("none.svg"), null, three, one, none));
        ExpectNull("normals", () => Report.PointsMap(File("none.svg"), at, null, one, none));
        ExpectNull("illuminanceLx", () => Report.PointsMap(File("none.svg"), at, three, null, none));
        ExpectNull("errorBoundsLx", () => Report.PointsMap(File("none.svg"), at, three, one, null));
        ExpectNull("values", () => Report.ImageMap(File("none.svg"), null, 1, none));
        ExpectNull("errorBounds", () => Report.ImageMap(File("none.svg"), one, 1, null));
        ExpectNull("layers", () => Exr.Write(File("none.exr"), 1, 1, null));
        ExpectNull("layers", () => Exr.Write(File("none.exr"), 1, 1, new ExrLayer[1]));
        ExpectNull("attributes", () => Exr.Write(File("none.exr"), 1, 1, new[] { new ExrLayer("Y", one) }, null));
        En12464Info info;
        ExpectNull("holesM", () => En12464Grid.In(new double[] { 0, 0, 5, 0, 5, 5 }, null, 0.5, out info));
        ExpectNull("holesM", () => En12464Grid.In(new double[] { 0, 0, 5, 0, 5, 5 }, new double[1][], 0.5, out info));
    }

    [Fact]
    public void TestReport()
    {
        System.IO.File.WriteAllText(File("room.gltf"), Room);
        using (var context = new Context(1))
        using (var scene = new Scene(context))
        using (var import = GltfImport.File(context, File("room.gltf"), scene, SmallCameras()))
        {
            scene.Commit();
            var sensors = import.Sensors();
            var desk = Array.Find(sensors, s => s.Kind == GltfSensorKind.Meters).Sensor;
            var camera = Array.Find(sensors, s => s.Kind == GltfSensorKind.Camera);
            var eye = camera.Sensor;
            int width = (int)camera.Width, height = (int)camera.Height;
            using (var result = scene.Render(RenderOnce(false)))
            {
                var style = ReportStyleDesc.Create();
                style.ThresholdLx = 20;
                Report.Map(File("desk ä.svg"), scene, result, desk, "Tisch ä", style);
                Assert.Contains("Illuminance: Tisch ä", Text("desk ä.svg"));
                Assert.Contains("Of 8 values, 20 lx is met at 8", Text("desk ä.svg"));
                Report.Map(File("eye.png"), scene, result, eye);
                ExpectPng("eye.png", 0, 0);
                Report.PointsMap(File("points.svg"), new double[] { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0 }, new float[0],
                                 new float[] { 1, 2, 3, 4 }, new float[0], 2, "four");
                Assert.Contains("mean 2.5 lx", Text("points.svg"));
                Report.ImageMap(File("image.pdf"), new float[] { 1, 2, 3, 4, 5, 6 }, 3, new float[0]);
                Assert.Equal("%PDF", Encoding.ASCII.GetString(System.IO.File.ReadAllBytes(File("image.pdf")), 0, 4));

                var page = new ReportPage { Title = "Room & co", Repeat = "again", ThresholdsLx = new double[] { 10 },
                                            TargetsJson = @"{""areas"": [{""meters"": ""desk"", ""mean_lx"": 1}]}" };
                page.Sensors.Add(desk, "desk").Add(eye);
                page.AddSource(SourceKind.Luminaire, scene.Sources()[0].Id, "lamp <1>", "a.ies");
                page.Ratios.Add(new ReportRatio { Numerator = desk, Denominator = desk });
                Png.Write(File("eye.png"), result.Image(eye, width, height), width, height);
                page.Pictures.Add(new CameraPicture { Camera = eye, Path = File("eye.png") });
                Report.Page(File("page.html"), scene, result, page);
                foreach (var words in new[] { "<h1>Room &amp; co</h1>", "lamp &lt;1&gt;", "a.ies", "again", "camera 2",
                                              "requirement is met", "At least 10 lx", "data:image/png;base64," })
                    Assert.Contains(words, Text("page.html"));
                page.TargetsJson = "{";
                page.TargetsName = "wishes";
                var error = Assert.Throws<UpsException>(() => Report.Page(File("none.html"), scene, result, page));
                Assert.Equal(Status.ErrorParse, error.Status);
                Assert.Contains("wishes: is no JSON", error.Message);
                Assert.True(!System.IO.File.Exists(File("none.html")), "no file of an error");
                Assert.Throws<UpsException>(() => Report.Map(File("desk.gif"), scene, result, desk));
                ExpectNull("scene", () => Report.Map(File("none.svg"), null, result, desk));
                ExpectNull("result", () => Report.Map(File("none.svg"), scene, null, desk));
                ExpectNull("scene", () => Report.PointsMap(File("none.svg"), null, new double[3], new float[0],
                                                           new float[1], new float[0]));
                ExpectNull("scene", () => Report.Page(File("none.html"), null, result, page));
                ExpectNull("result", () => Report.Page(File("none.html"), scene, null, page));
                ExpectNull("context", () => GltfImport.File(null, File("room.gltf"), scene));
                ExpectNull("scene", () => GltfImport.File(context, File("room.gltf"), null));
            }
        }
    }
}
