// A room in sixty lines: a downlight, meters on a grid, a render that is awaited, and lux. With the package Ups:
// dotnet new console && dotnet add package Ups --source FOLDER && cp SmallRoom.cs Program.cs && dotnet run
using System;
using System.Globalization;
using System.Text;
using System.Threading.Tasks;
using Ups;

internal static class SmallRoom
{
    private const string Ies = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 10 1 1 2 0 0 0\n1 1 20\n" +
        "0 10 20 30 40 50 60 70 80 90\n0\n1000 970 880 740 560 370 190 70 15 0\n";

    private static async Task Main()
    {
        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        using (var context = new Context())
        using (var scene = new Scene(context))
        using (var profile = Profile.Parse(context, Encoding.ASCII.GetBytes(Ies)))
        {
            float x = 4, y = 3, z = 2.6f;  // metres; the room's corners, faces seen from inside
            var corners = new float[] { 0, 0, 0, x, 0, 0, x, y, 0, 0, y, 0, 0, 0, z, x, 0, z, x, y, z, 0, y, z };
            var faces = new uint[] { 0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 5, 1, 0, 4, 5,
                                     1, 6, 2, 1, 5, 6, 2, 7, 3, 2, 6, 7, 3, 4, 0, 3, 7, 4 };
            var white = MaterialDesc.Create();
            white.ReflectanceRgb = new[] { 0.6f, 0.6f, 0.6f };
            var room = InstanceDesc.Create();
            room.Mesh = scene.AddMesh(corners, faces, scene.AddMaterial(white));
            scene.AddInstance(room);

            var luminaire = LuminaireDesc.Create();
            luminaire.ToWorld[3] = x / 2;  // 3x4, row-major
            luminaire.ToWorld[7] = y / 2;
            luminaire.ToWorld[11] = z - 0.1;
            scene.AddLuminaire(profile, luminaire);

            var places = new double[3 * 12];
            var normals = new float[places.Length];
            for (var i = 0; i < 12; ++i)
            {
                places[3 * i] = (i % 4 + 0.5) * x / 4;
                places[3 * i + 1] = (i / 4 + 0.5) * y / 3;
                places[3 * i + 2] = 0.75;
                normals[3 * i + 2] = 1;
            }
            var meters = scene.AddMeters(places, normals);
            scene.Commit();

            var render = RenderDesc.Create();
            render.TargetRelativeError = 0.02f;
            render.TimeLimitS = 5;
            using (var result = await scene.RenderAsync(render))
            {
                foreach (var r in result.Meters(meters)) Console.WriteLine("{0,6:0.0} ± {1:0.0} lx", r.IlluminanceLx,
                                                                           r.ErrorBoundLx);
                Console.WriteLine("mean {0:0.0} lx", result.Statistics(meters).MeanLx);
            }
        }
    }
}
