// The room of samples/c in C#: a job whose progress is shown, then the same render in one call: the same bits.
//
//   mcs -unsafe -langversion:latest -out:Room.exe samples/csharp/Room.cs bindings/csharp/*.cs
//   LD_LIBRARY_PATH=build/release/src/api mono Room.exe [iterations]
using System;
using System.Globalization;
using System.Text;
using Ups;

internal static class Room
{
    private const string DownlightIes = "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2026-01-01\n" +
        "[MANUFAC] UPS samples\nTILT=NONE\n1 -1 1 10 1 1 2 0 0 0\n1 1 20\n0 10 20 30 40 50 60 70 80 90\n0\n" +
        "1000 970 880 740 560 370 190 70 15 0\n";

    private const int Columns = 8, Rows = 6;
    private static readonly float[] Size = { 4.0f, 3.0f, 2.6f };

    /// <summary>Some quads of the room's box; bits 0, 1, 2 of a corner: at the far x, y, z.</summary>
    private static void AddQuads(Scene scene, float reflectance, params int[] corners)
    {
        var material = MaterialDesc.Create();
        material.ReflectanceRgb = new[] { reflectance, reflectance, reflectance };
        var positions = new float[3 * corners.Length];
        for (var i = 0; i < positions.Length; ++i)
            positions[i] = (corners[i / 3] >> i % 3 & 1) * Size[i % 3];
        var indices = new uint[6 * corners.Length / 4];
        for (var i = 0; i < indices.Length; ++i)
            indices[i] = (uint)(4 * (i / 6)) + new uint[] { 0, 1, 2, 0, 2, 3 }[i % 6];
        var instance = InstanceDesc.Create();
        instance.Mesh = scene.AddMesh(positions, indices, scene.AddMaterial(material));
        scene.AddInstance(instance);
    }

    private static void AddDownlight(Context context, Scene scene)
    {
        using (var profile = Profile.Parse(context, Encoding.ASCII.GetBytes(DownlightIes)))
        {
            var luminaire = LuminaireDesc.Create();
            luminaire.ToWorld[3] = Size[0] / 2;  // 3x4, row-major
            luminaire.ToWorld[7] = Size[1] / 2;
            luminaire.ToWorld[11] = Size[2] - 0.1;
            scene.AddLuminaire(profile, luminaire);
        }
    }

    private static SensorId AddMeters(Scene scene)
    {
        var positions = new double[3 * Columns * Rows];
        var normals = new float[positions.Length];
        for (var i = 0; i < Columns * Rows; ++i)
        {
            positions[3 * i] = (i % Columns + 0.5) * Size[0] / Columns;
            positions[3 * i + 1] = (i / Columns + 0.5) * Size[1] / Rows;
            positions[3 * i + 2] = 0.75;
            normals[3 * i + 2] = 1;
        }
        return scene.AddMeters(positions, normals);
    }

    private static Result RenderWithProgress(Scene scene, RenderDesc desc)
    {
        using (var job = scene.Start(desc))
        {
            while (job.Wait(100) == Status.Timeout)
            {
                var progress = job.Poll();
                Console.Error.Write("\r{0,3:0} %, {1} iterations, {2:0.0} s ", 100 * progress.Fraction,
                                    progress.IterationsDone, progress.ElapsedS);
            }
            Console.Error.WriteLine();
            return job.Result();
        }
    }

    private static int Main(string[] arguments)
    {
        CultureInfo.DefaultThreadCurrentCulture = CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        using (var context = new Context())
        using (var scene = new Scene(context))
        {
            AddQuads(scene, 0.2f, 0, 1, 3, 2);
            AddQuads(scene, 0.8f, 4, 6, 7, 5);
            AddQuads(scene, 0.5f, 0, 4, 5, 1, 1, 5, 7, 3, 3, 7, 6, 2, 2, 6, 4, 0);
            AddDownlight(context, scene);
            var meters = AddMeters(scene);
            scene.Commit();

            var desc = RenderDesc.Create();
            desc.IterationCount = arguments.Length > 0 ? uint.Parse(arguments[0]) : 32;
            desc.Seed = 7;
            using (var result = RenderWithProgress(scene, desc))
            using (var again = scene.Render(desc))
            {
                var readings = result.Meters(meters);
                for (var row = Rows - 1; row >= 0; --row)
                {
                    for (var column = 0; column < Columns; ++column)
                    {
                        var r = readings[row * Columns + column];
                        Console.Write("{0,6:0.0} ±{1,5:0.0}  ", r.IlluminanceLx, r.ErrorBoundLx);
                    }
                    Console.WriteLine();
                }
                var statistics = result.Statistics(meters);
                Console.WriteLine("mean {0:0.0} lx, uniformity {1:0.00}", statistics.MeanLx, statistics.Uniformity);

                // The same seed and the same iterations give the same bits, whoever waits for them.
                var same = again.Meters(meters);
                for (var i = 0; i < same.Length; ++i)
                {
                    if (same[i].Equals(readings[i])) continue;  // compares every field
                    Console.Error.WriteLine("two renders with the same seed differ at meter " + i);
                    return 1;
                }
                Console.WriteLine("rendered again with the same seed: the same bits");
                return 0;
            }
        }
    }
}
