// What do 10,000 readings and a 4K image cost from C#, beside what they cost from C? Both read into the same memory, in
// turns, in one process; the median of the turns' ratios counts. Fails where C# takes more than 2 % longer. See
// read_speed.sh.
using System;
using System.Diagnostics;
using System.Reflection;
using System.Runtime.InteropServices;
using Ups;

internal static unsafe class ReadSpeed
{
    private const int MeterCount = 10000, Width = 3840, Height = 2160;
    private static int failures;

    [DllImport("libread_speed.so")]
    private static extern double read_meters_s(IntPtr result, SensorId sensor, MeterReading* readings, UIntPtr count,
                                               int calls);

    [DllImport("libread_speed.so")]
    private static extern double read_image_s(IntPtr result, SensorId camera, float* values, UIntPtr bytes, int calls);

    private static void Compare(string what, int turns, int calls, Func<double> inC, Action inCSharp)
    {
        double[] c = new double[turns], cSharp = new double[turns], ratio = new double[turns];
        for (var turn = 0; turn < turns; ++turn)
        {
            c[turn] = inC();
            if (c[turn] < 0) throw new InvalidOperationException(what + ": a call from C failed");
            var watch = Stopwatch.StartNew();
            for (var i = 0; i < calls; ++i) inCSharp();
            cSharp[turn] = watch.Elapsed.TotalSeconds;
            ratio[turn] = cSharp[turn] / c[turn];
        }
        var over = 100 * (Median(ratio) - 1);
        Console.WriteLine("{0}: C {1:0.00} us, C# {2:0.00} us, {3:+0.00;-0.00} %", what, 1e6 * Median(c) / calls,
                          1e6 * Median(cSharp) / calls, over);
        if (over > 2) ++failures;
    }

    private static double Median(double[] values)
    {
        Array.Sort(values);
        return values[values.Length / 2];
    }

    private static Result Render(Context context, out SensorId meters, out SensorId camera)
    {
        using (var scene = new Scene(context))
        {
            var floor = InstanceDesc.Create();
            floor.Mesh = scene.AddMesh(new float[] { -5, -5, 0, 5, -5, 0, 5, 5, 0, -5, 5, 0 },
                                       new uint[] { 0, 1, 2, 0, 2, 3 }, scene.AddMaterial(MaterialDesc.Create()));
            scene.AddInstance(floor);
            var light = LightDesc.Create();
            light.IntensityRgb = new float[] { 100, 100, 100 };
            light.ToWorld[11] = 2.5;
            scene.AddLight(light);
            var positions = new double[3 * MeterCount];
            var normals = new float[3 * MeterCount];
            for (var i = 0; i < MeterCount; ++i)
            {
                positions[3 * i] = 0.02 * (i % 100);
                positions[3 * i + 1] = 0.02 * (i / 100);
                positions[3 * i + 2] = 0.5;
                normals[3 * i + 2] = 1;
            }
            meters = scene.AddMeters(positions, normals);
            var desc = CameraDesc.Create();
            desc.Width = Width;
            desc.Height = Height;
            desc.ToWorld[11] = 2;
            camera = scene.AddCamera(desc);
            scene.Commit();
            var render = RenderDesc.Create();
            render.Method = Method.PathTracing;
            render.MaxPathLength = 2;
            render.IterationCount = 1;
            return scene.Render(render);
        }
    }

    private static int Main()
    {
        SensorId meters, camera;
        using (var context = new Context())
        using (var result = Render(context, out meters, out camera))
        {
            var handle = (SafeHandle)typeof(Result).GetField("Handle", BindingFlags.Instance | BindingFlags.NonPublic)
                .GetValue(result);
            var address = handle.DangerousGetHandle();
            var readings = new MeterReading[MeterCount];
            var image = new float[3 * Width * Height];
            fixed (MeterReading* r = readings)
            fixed (float* v = image)
            {
                var readingsAt = (IntPtr)r;
                var imageAt = (IntPtr)v;
                var bytes = (UIntPtr)(sizeof(float) * (ulong)image.Length);
                Compare("10,000 meters", 200, 100, () => read_meters_s(address, meters, (MeterReading*)readingsAt,
                                                                       (UIntPtr)MeterCount, 100),
                        () => result.ReadMeters(meters, readings));
                Compare("3840 x 2160 image", 200, 1, () => read_image_s(address, camera, (float*)imageAt, bytes, 1),
                        () => result.ReadImage(camera, Channel.LuminanceRgb, image));
                var watch = Stopwatch.StartNew();
                for (var i = 0; i < 10; ++i) result.Meters(meters);
                Console.WriteLine("10,000 meters as a new array, with their statistics: {0:0.00} us",
                                  1e5 * watch.Elapsed.TotalSeconds);
            }
            if (readings[0].IlluminanceLx < 1 || image[3 * Width * Height / 2] <= 0)
                throw new InvalidOperationException("nothing was read");
        }
        return failures;
    }
}
