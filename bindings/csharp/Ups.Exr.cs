// UPS for C#: float images with named channels in OpenEXR files. Programs use ExrLayer, Exr and ExrImage; see
// Ups.cs. The library is libups_exr, loaded at first use.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Ups
{
    /// <summary>Values for one channel of a file: those of an array that lie `stride` apart, from `first` on.</summary>
    public sealed class ExrLayer
    {
        public readonly string Name;
        public readonly float[] Values;
        public readonly int First, Stride;

        public ExrLayer(string name, float[] values, int first = 0, int stride = 1)
        {
            if (name == null) throw new ArgumentNullException("name");
            if (values == null) throw new ArgumentNullException("values");
            if (first < 0 || stride < 1) throw new ArgumentException("first: 0 or more; stride: 1 or more");
            Name = name;
            Values = values;
            First = first;
            Stride = stride;
        }

        /// <summary>prefix + R, G and B of what Result.Image() gives.</summary>
        public static ExrLayer[] Rgb(float[] values, string prefix = "")
        {
            return new[] { new ExrLayer(prefix + "R", values, 0, 3), new ExrLayer(prefix + "G", values, 1, 3),
                           new ExrLayer(prefix + "B", values, 2, 3) };
        }
    }

    public static unsafe class Exr
    {
        internal static Status Check(Status status)
        {
            if (status < 0) throw new UpsException(status, Library.Utf8(Native.ups_exr_last_error()));
            return status;
        }

        /// <summary>32-bit floats, compressed without loss, row 0 at the top. The file appears whole or not at
        /// all.</summary>
        public static void Write(string path, int width, int height, params ExrLayer[] layers)
        {
            Write(path, width, height, layers, new Dictionary<string, string>());
        }

        /// <summary>attributes: strings for the file's header, such as "unit.Y" = "lx".</summary>
        public static void Write(string path, int width, int height, ExrLayer[] layers,
                                 IDictionary<string, string> attributes)
        {
            Library.Given(layers, "layers");
            Library.Given(attributes, "attributes");
            var pins = new List<GCHandle>();
            Func<object, IntPtr> pin = pinned =>
            {
                pins.Add(GCHandle.Alloc(pinned, GCHandleType.Pinned));
                return pins[pins.Count - 1].AddrOfPinnedObject();
            };
            try
            {
                var channels = new ExrChannel[layers.Length];
                for (var i = 0; i < layers.Length; ++i)
                {
                    var layer = Library.Given(layers[i], "layers");
                    var needed = layer.First + ((long)width * height - 1) * layer.Stride + 1;
                    if (layer.Values.Length < needed)
                        throw new ArgumentException("expected at least " + needed + " values, got " +
                                                    layer.Values.Length, layer.Name);
                    channels[i].Name = (byte*)pin(Library.Utf8(layer.Name, "layers"));
                    channels[i].Data = (float*)pin(layer.Values) + layer.First;
                    channels[i].PixelStrideBytes = (UIntPtr)(sizeof(float) * (ulong)layer.Stride);
                    channels[i].RowStrideBytes = (UIntPtr)(sizeof(float) * (ulong)layer.Stride * (ulong)width);
                }
                var texts = new ExrAttribute[attributes.Count];
                var count = 0;
                foreach (var attribute in attributes)
                {
                    texts[count].Name = (byte*)pin(Library.Utf8(attribute.Key, "attributes"));
                    texts[count++].Value = (byte*)pin(Library.Utf8(attribute.Value, "attributes"));
                }
                fixed (byte* p = Library.Utf8(path, "path"))
                fixed (ExrChannel* c = channels)
                fixed (ExrAttribute* a = texts)
                    Check(Native.ups_exr_write(p, checked((uint)width), checked((uint)height), c,
                                               (uint)channels.Length, a, (uint)texts.Length));
            }
            finally
            {
                foreach (var handle in pins) handle.Free();
            }
        }
    }

    /// <summary>What a file's first part holds; immutable.</summary>
    public sealed unsafe class ExrImage : IDisposable
    {
        internal readonly ExrImageHandle Handle;
        public readonly int Width, Height;

        private ExrImage(ExrImageHandle handle)
        {
            Handle = handle;
            uint width, height;
            Exr.Check(Native.ups_exr_get_size(handle, &width, &height));
            Width = (int)width;
            Height = (int)height;
        }

        public static ExrImage Read(string path)
        {
            ExrImageHandle handle;
            fixed (byte* p = Library.Utf8(path, "path")) Exr.Check(Native.ups_exr_read(p, out handle));
            return new ExrImage(handle);
        }

        public string[] Channels()
        {
            uint count;
            Exr.Check(Native.ups_exr_get_channel_count(Handle, &count));
            var names = new string[count];
            for (uint i = 0; i < count; ++i)
            {
                var index = i;
                names[i] = Library.Text((p, capacity, needed) =>
                    Native.ups_exr_get_channel_name(Handle, index, p, capacity, needed), Exr.Check);
            }
            return names;
        }

        /// <summary>A string of the file's header.</summary>
        public string Attribute(string name)
        {
            var bytes = Library.Utf8(name, "name");
            return Library.Text((p, capacity, needed) =>
            {
                fixed (byte* n = bytes) return Native.ups_exr_get_attribute(Handle, n, p, capacity, needed);
            }, Exr.Check);
        }

        /// <summary>Width * Height values, rows from the top.</summary>
        public float[] Channel(string name)
        {
            var values = new float[(long)Width * Height];
            ReadChannel(name, values);
            return values;
        }

        public void ReadChannel(string name, Span<float> values)
        {
            fixed (byte* n = Library.Utf8(name, "name"))
            fixed (float* v = values)
                Exr.Check(Native.ups_exr_read_channel(Handle, n, v, (UIntPtr)values.Length));
        }

        public void Dispose() { Handle.Dispose(); }
    }
}
