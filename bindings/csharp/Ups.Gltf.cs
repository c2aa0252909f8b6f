// UPS for C#: a glTF 2.0 file becomes the content of a scene. Programs use GltfImport; see Ups.cs. The library is
// libups_gltf, loaded at first use.
using System;

namespace Ups
{
    /// <summary>What a file named: sensors, sources, warnings; immutable.</summary>
    public sealed unsafe class GltfImport : IDisposable
    {
        internal readonly GltfImportHandle Handle;

        private GltfImport(GltfImportHandle handle) { Handle = handle; }

        private static Status Check(Status status)
        {
            if (status < 0) throw new UpsException(status, Library.Utf8(Native.ups_gltf_last_error()));
            return status;
        }

        /// <summary>Adds everything in the file (.gltf, .glb) to the scene, which the caller commits. After an error
        /// the scene holds part of the file: dispose of it.</summary>
        public static GltfImport File(Context context, string path, Scene scene)
        {
            return File(context, path, scene, GltfImportDesc.Create());
        }

        public static GltfImport File(Context context, string path, Scene scene, GltfImportDesc desc)
        {
            Library.Given(context, "context");
            Library.Given(scene, "scene");
            GltfImportHandle handle;
            fixed (byte* p = Library.Utf8(path, "path"))
                Check(Native.ups_gltf_import_file(context.Handle, p, &desc, scene.Handle, out handle));
            return new GltfImport(handle);
        }

        /// <summary>Cameras, meters, goniometers and observers in the order of the node hierarchy.</summary>
        public GltfSensorInfo[] Sensors()
        {
            uint count;
            Check(Native.ups_gltf_get_sensor_count(Handle, &count));
            var all = new GltfSensorInfo[count];
            for (uint i = 0; i < count; ++i)
            {
                var info = GltfSensorInfo.Sized();
                Check(Native.ups_gltf_get_sensor(Handle, i, &info));
                all[i] = info;
            }
            return all;
        }

        /// <summary>Unique in the file and fit for a file name; index: in Sensors().</summary>
        public string SensorName(int index)
        {
            return Library.Text((p, capacity, needed) =>
                Native.ups_gltf_get_sensor_name(Handle, checked((uint)index), p, capacity, needed), Check);
        }

        /// <summary>Name of a source as Result.Sources() tells it.</summary>
        public string SourceName(SourceKind kind, uint id)
        {
            return Library.Text((p, capacity, needed) =>
                Native.ups_gltf_get_source_name(Handle, kind, id, p, capacity, needed), Check);
        }

        /// <summary>The photometric file of a luminaire; "": it has none, or it lies within the scene file.</summary>
        public string SourceFile(SourceKind kind, uint id)
        {
            return Library.Text((p, capacity, needed) =>
                Native.ups_gltf_get_source_file(Handle, kind, id, p, capacity, needed), Check);
        }

        /// <summary>Where in the file a part of the scene stands, such as: node 7 "Tap"; id: its own, or its number in a
        /// message of the core.</summary>
        public string Place(GltfPart part, uint id)
        {
            return Library.Text((p, capacity, needed) =>
                Native.ups_gltf_get_place(Handle, part, id, p, capacity, needed), Check);
        }

        /// <summary>Where the meters of a sensor are, xyz each, in the scene's frame.</summary>
        public void Meters(int index, out double[] positionsM, out float[] normals)
        {
            var sensor = Sensors()[index];
            var count = sensor.Kind == GltfSensorKind.Observer ? 1 : sensor.MeterCount;
            positionsM = new double[3 * count];
            normals = new float[3 * count];
            fixed (double* p = positionsM)
            fixed (float* n = normals)
                Check(Native.ups_gltf_read_meters(Handle, (uint)index, p, n, (UIntPtr)count));
        }

        /// <summary>For people, a line each: what was left out or looks wrong, and where.</summary>
        public string Warnings
        {
            get
            {
                return Library.Text((p, capacity, needed) =>
                    Native.ups_gltf_get_warnings(Handle, p, capacity, needed), Check);
            }
        }

        public void Dispose() { Handle.Dispose(); }
    }
}
