// What a CAD program does with a scene that it keeps: an L-shaped room, ten luminaires, two grids, a camera. One
// luminaire is moved, dimmed, aimed and removed; each is one call and a commit, where a program that describes all anew
// makes a call for each thing. Prints what either takes, and fails where the light of the edited scene has not the same
// bits as that of a new one.
//
//   mcs -unsafe -langversion:latest -out:Edits.exe samples/csharp/Edits.cs bindings/csharp/*.cs
//   LD_LIBRARY_PATH=build/release/src/api mono Edits.exe
using System;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using Ups;

internal sealed class Room
{
    internal const int Luminaires = 10, CallsOfAnEdit = 2;
    // The scene, material, mesh, instance, two grids, camera, commit, and each luminaire.
    internal int CallsOfANewScene { get { return 8 + Removed.Count(removed => !removed); } }

    internal readonly LuminaireDesc[] Placed = new LuminaireDesc[Luminaires];
    internal readonly bool[] Removed = new bool[Luminaires];
    internal readonly LuminaireId[] Ids = new LuminaireId[Luminaires];
    internal SensorId Near, Far, Camera;
    private readonly Profile profile;

    internal Room(Context context)
    {
        profile = Profile.FromTable(context, new float[] { 0 }, new float[] { 0, 30, 60, 90 },
                                    new float[] { 1000, 740, 190, 0 });
        for (var i = 0; i < Luminaires; ++i)
        {
            Placed[i] = LuminaireDesc.Create();
            Placed[i].ToWorld = Place(i < 6 ? 1 + i : 1, i < 6 ? 1 : i - 4, 2.6, 0);
        }
    }

    /// <summary>At a point, turned about Y: 3x4, row-major.</summary>
    internal static double[] Place(double x, double y, double z, double tiltRad)
    {
        double c = Math.Cos(tiltRad), s = Math.Sin(tiltRad);
        return new[] { c, 0, s, x, 0, 1, 0, y, -s, 0, c, z };
    }

    // [anew]
    /// <summary>7 x 2 m along X and 2 x 6.5 m along Y share a corner; 2.7 m high.</summary>
    private static MeshId AddWalls(Scene scene, MaterialId material)
    {
        float[] x = { 0, 7, 7, 2, 2, 0 }, y = { 0, 0, 2, 2, 6.5f, 6.5f };
        var positions = new float[3 * 12];
        for (var i = 0; i < 12; ++i)
        {
            positions[3 * i] = x[i % 6];
            positions[3 * i + 1] = y[i % 6];
            positions[3 * i + 2] = i < 6 ? 0 : 2.7f;
        }
        uint[] floor = { 0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5 };
        var ceiling = floor.Select((corner, i) => floor[i % 3 == 0 ? i : i % 3 == 1 ? i + 1 : i - 1] + 6);
        var walls = Enumerable.Range(0, 6).SelectMany(i =>
        {
            uint a = (uint)i, b = (uint)(i + 1) % 6;
            return new[] { a, a + 6, b + 6, a, b + 6, b };
        });
        return scene.AddMesh(positions, floor.Concat(ceiling).Concat(walls).ToArray(), material);
    }

    private static SensorId AddGrid(Scene scene, double x, double y)
    {
        var positions = new double[3 * 20];
        var normals = new float[positions.Length];
        for (var i = 0; i < 20; ++i)
        {
            positions[3 * i] = x + 0.3 * (i % 5);
            positions[3 * i + 1] = y + 0.3 * (i / 5);
            positions[3 * i + 2] = 0.75;
            normals[3 * i + 2] = 1;
        }
        return scene.AddMeters(positions, normals);
    }

    /// <summary>The whole room into a new scene, committed.</summary>
    internal Scene Describe(Context context)
    {
        var scene = new Scene(context);
        var white = MaterialDesc.Create();
        white.ReflectanceRgb = new[] { 0.6f, 0.6f, 0.6f };
        var walls = InstanceDesc.Create();
        walls.Mesh = AddWalls(scene, scene.AddMaterial(white));
        scene.AddInstance(walls);
        for (var i = 0; i < Luminaires; ++i)
            if (!Removed[i]) Ids[i] = scene.AddLuminaire(profile, Placed[i]);
        Near = AddGrid(scene, 4, 0.5);
        Far = AddGrid(scene, 0.4, 4);
        var camera = CameraDesc.Create();
        camera.Width = 32;
        camera.Height = 24;
        camera.ToWorld = new[] { 0, 0, -1, 0.5, -1, 0, 0, 1, 0, 1, 0, 1.5 };  // along +X, +Z up
        Camera = scene.AddCamera(camera);
        scene.Commit();
        return scene;
    }
    // [end]
}

internal static class Edits
{
    private static MeterReading[] Render(Scene scene, Room room, out float[] image)
    {
        var desc = RenderDesc.Create();
        desc.IterationCount = 2;
        desc.LightPathsPerIteration = 2048;
        desc.Seed = 11;
        using (var result = scene.Render(desc))
        {
            image = result.Image(room.Camera, 32, 24);
            return result.Meters(room.Near).Concat(result.Meters(room.Far)).ToArray();
        }
    }

    /// <summary>The edit of a kept scene, and the same in a new one.</summary>
    private static bool Show(string what, Context context, Scene kept, Room room, Room other, Action edit)
    {
        var watch = Stopwatch.StartNew();
        edit();
        kept.Commit();
        var edited = watch.Elapsed.TotalMilliseconds;
        float[] image, imageAnew;
        var readings = Render(kept, room, out image);
        watch.Restart();
        using (var anew = other.Describe(context))
        {
            var described = watch.Elapsed.TotalMilliseconds;
            var same = readings.SequenceEqual(Render(anew, other, out imageAnew)) && image.SequenceEqual(imageAnew);
            Console.WriteLine("{0,-7} {1} calls, {2:0.0} ms; anew {3} calls, {4:0.0} ms; {5,6:0.0} lx, {6,6:0.0} lx; {7}",
                              what, Room.CallsOfAnEdit, edited, other.CallsOfANewScene, described,
                              readings[7].IlluminanceLx, readings[27].IlluminanceLx,
                              same ? "the same bits" : "OTHER BITS");
            return same;
        }
    }

    private static int Main()
    {
        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        using (var context = new Context())
        {
            Room room = new Room(context), other = new Room(context);
            var place = Room.Place(4.5, 0.8, 2.4, 0);
            var aim = Room.Place(4.5, 0.8, 2.4, 0.6);
            using (var scene = room.Describe(context))
            {
                var id = room.Ids[3];
                var same = Show("move", context, scene, room, other, () =>
                {
                    scene.SetTransform(id, place);
                    other.Placed[3].ToWorld = place;
                });
                same &= Show("dim", context, scene, room, other, () =>
                {
                    scene.SetDimming(id, 0.5f);
                    other.Placed[3].Dimming = 0.5f;
                });
                same &= Show("aim", context, scene, room, other, () =>
                {
                    scene.SetTransform(id, aim);
                    other.Placed[3].ToWorld = aim;
                });
                same &= Show("remove", context, scene, room, other, () =>
                {
                    scene.Remove(id);
                    other.Removed[3] = true;
                });
                return same ? 0 : 1;
            }
        }
    }
}
