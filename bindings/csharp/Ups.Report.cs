// UPS for C#: what people read of a render: maps as PNG, SVG or PDF, and the lighting report as one HTML page. Programs
// use Report, ReportNames, ReportPage and CameraPicture; see Ups.cs. The library is libups_report, loaded at first use.
// Texts that are empty are not told.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Ups
{
    /// <summary>Sensors, in the order in which they are told of, and what people call them; a name that is empty is by
    /// kind and number, "meters 1".</summary>
    public sealed class ReportNames
    {
        internal readonly List<KeyValuePair<SensorId, string>> List = new List<KeyValuePair<SensorId, string>>();

        public ReportNames Add(SensorId sensor, string name = "")
        {
            List.Add(new KeyValuePair<SensorId, string>(sensor, name));
            return this;
        }
    }

    /// <summary>A camera's image as a PNG: its file's path or, where that is empty, its bytes.</summary>
    public sealed class CameraPicture
    {
        public SensorId Camera;
        public string Path = "";
        public byte[] Png = new byte[0];
        public ReportExposure Exposure = ReportExposure.Untold;
        public double Ev100;
        public bool Smoothed;
    }

    /// <summary>What the page tells beside what was found: fields of ups_report_page_desc.</summary>
    public sealed class ReportPage
    {
        public readonly ReportNames Sensors = new ReportNames();
        public readonly List<CameraPicture> Pictures = new List<CameraPicture>();
        public readonly List<ReportRatio> Ratios = new List<ReportRatio>();
        public double[] ThresholdsLx = new double[0];
        public string Title = "", SceneName = "", Repeat = "", Date = "";
        public string TargetsJson = "", TargetsName = "", TargetsFolder = "";
        public double TargetRelativeError;
        public ReportStyleDesc Style = ReportStyleDesc.Create();
        internal readonly List<KeyValuePair<ReportSource, string[]>> Sources =
            new List<KeyValuePair<ReportSource, string[]>>();

        /// <summary>What people call a source, and its photometric file.</summary>
        public ReportPage AddSource(SourceKind kind, uint id, string name, string file = "")
        {
            Sources.Add(new KeyValuePair<ReportSource, string[]>(new ReportSource { Kind = kind, Id = id },
                                                                 new[] { name, file }));
            return this;
        }
    }

    public static unsafe class Report
    {
        // What C is to see during a call.
        private sealed class Pins : IDisposable
        {
            private readonly List<GCHandle> pins_ = new List<GCHandle>();
            private readonly List<NativeHandle> held_ = new List<NativeHandle>();

            public IntPtr Hold(NativeHandle handle)
            {
                var held = false;
                handle.DangerousAddRef(ref held);
                if (held) held_.Add(handle);
                return handle.DangerousGetHandle();
            }

            public void* Pin(Array array)
            {
                if (array.Length == 0) return null;
                pins_.Add(GCHandle.Alloc(array, GCHandleType.Pinned));
                return (void*)pins_[pins_.Count - 1].AddrOfPinnedObject();
            }
            public byte* Text(string text, string name)
            {
                return Library.Given(text, name).Length == 0 ? null : (byte*)Pin(Library.Utf8(text, name));
            }
            public void Dispose()
            {
                foreach (var pin in pins_) pin.Free();
                foreach (var handle in held_) handle.DangerousRelease();
            }
        }

        private static void Check(Status status)
        {
            if (status < 0) throw new UpsException(status, Library.Utf8(Native.ups_report_last_error()));
        }

        private static ReportSensor* Sensors(Pins pins, ReportNames names)
        {
            var sensors = new ReportSensor[names.List.Count];
            for (var i = 0; i < sensors.Length; ++i)
            {
                sensors[i].Sensor = names.List[i].Key;
                sensors[i].Name = pins.Text(names.List[i].Value, "sensors");
            }
            return (ReportSensor*)pins.Pin(sensors);
        }

        private static void WriteMap(string path, ReportMapDesc desc, string title, ReportStyleDesc? style, Pins pins)
        {
            var looks = style ?? ReportStyleDesc.Create();
            desc.Title = pins.Text(title, "title");
            desc.Style = &looks;
            fixed (byte* p = Library.Utf8(path, "path")) Check(Native.ups_report_write_map(p, &desc));
        }

        /// <summary>Of meters that lie in a plane, on the plan of the committed scene, or of a camera's image. path
        /// ends in .png, .svg or .pdf. quantity: of a camera.</summary>
        public static void Map(string path, Scene scene, Result result, SensorId sensor, string title = "",
                               ReportStyleDesc? style = null, ReportQuantity quantity = ReportQuantity.Auto)
        {
            Map(path, scene, result, sensor, new ReportNames(), title, style, quantity);
        }

        /// <summary>The same with observers.</summary>
        public static void Map(string path, Scene scene, Result result, SensorId sensor, ReportNames observers,
                               string title = "", ReportStyleDesc? style = null,
                               ReportQuantity quantity = ReportQuantity.Auto)
        {
            Library.Given(scene, "scene");
            Library.Given(result, "result");
            Library.Given(observers, "observers");
            var desc = ReportMapDesc.Create();
            desc.Sensor = sensor;
            desc.Quantity = quantity;
            desc.SensorCount = (uint)observers.List.Count;
            using (var pins = new Pins())
            {
                desc.Scene = pins.Hold(scene.Handle);
                desc.Result = pins.Hold(result.Handle);
                desc.Sensors = Sensors(pins, observers);
                WriteMap(path, desc, title, style, pins);
            }
        }

        /// <summary>Of points in a plane, 3 values each; errorBoundsLx: empty: not known. normals: empty: up. columns:
        /// of a grid, row by row; 0: found out.</summary>
        public static void PointsMap(string path, double[] positionsM, float[] normals, float[] illuminanceLx,
                                     float[] errorBoundsLx, int columns = 0, string title = "",
                                     ReportStyleDesc? style = null)
        {
            using (var pins = new Pins())
                WriteMap(path, Points(pins, positionsM, normals, illuminanceLx, errorBoundsLx, columns), title, style,
                         pins);
        }

        /// <summary>The same on the plan of a committed scene.</summary>
        public static void PointsMap(string path, Scene scene, double[] positionsM, float[] normals,
                                     float[] illuminanceLx, float[] errorBoundsLx, int columns = 0, string title = "",
                                     ReportStyleDesc? style = null)
        {
            Library.Given(scene, "scene");
            using (var pins = new Pins())
            {
                var desc = Points(pins, positionsM, normals, illuminanceLx, errorBoundsLx, columns);
                desc.Scene = pins.Hold(scene.Handle);
                WriteMap(path, desc, title, style, pins);
            }
        }

        private static ReportMapDesc Points(Pins pins, double[] positionsM, float[] normals, float[] illuminanceLx,
                                            float[] errorBoundsLx, int columns)
        {
            Library.Given(positionsM, "positionsM");
            Library.Given(normals, "normals");
            Library.Given(illuminanceLx, "illuminanceLx");
            Library.Given(errorBoundsLx, "errorBoundsLx");
            Elements.Expect(positionsM.Length, 3L * illuminanceLx.Length, "positionsM");
            Elements.ExpectIfAny(normals.Length, positionsM.Length, "normals");
            Elements.ExpectIfAny(errorBoundsLx.Length, illuminanceLx.Length, "errorBoundsLx");
            var desc = ReportMapDesc.Create();
            desc.Count = (uint)illuminanceLx.Length;
            desc.Columns = checked((uint)columns);
            desc.PositionsM = (double*)pins.Pin(positionsM);
            desc.Normals = (float*)pins.Pin(normals);
            desc.Values = (float*)pins.Pin(illuminanceLx);
            desc.ErrorBounds = (float*)pins.Pin(errorBoundsLx);
            return desc;
        }

        /// <summary>Of an image, rows from the top: luminance, cd/m², or illuminance, lx. errorBounds: empty: not
        /// known.</summary>
        public static void ImageMap(string path, float[] values, int width, float[] errorBounds,
                                    ReportQuantity quantity = ReportQuantity.Luminance, string title = "",
                                    ReportStyleDesc? style = null)
        {
            Library.Given(values, "values");
            Library.Given(errorBounds, "errorBounds");
            Elements.ExpectIfAny(errorBounds.Length, values.Length, "errorBounds");
            var desc = ReportMapDesc.Create();
            desc.Count = (uint)values.Length;
            desc.Columns = checked((uint)width);
            desc.Quantity = quantity;
            using (var pins = new Pins())
            {
                desc.Values = (float*)pins.Pin(values);
                desc.ErrorBounds = (float*)pins.Pin(errorBounds);
                WriteMap(path, desc, title, style, pins);
            }
        }

        private static ReportSource* Sources(Pins pins, ReportPage page)
        {
            var sources = new ReportSource[page.Sources.Count];
            for (var i = 0; i < sources.Length; ++i)
            {
                sources[i] = page.Sources[i].Key;
                sources[i].Name = pins.Text(page.Sources[i].Value[0], "sources");
                sources[i].File = pins.Text(page.Sources[i].Value[1], "sources");
            }
            return (ReportSource*)pins.Pin(sources);
        }

        private static ReportPicture* Pictures(Pins pins, ReportPage page)
        {
            var pictures = new ReportPicture[page.Pictures.Count];
            for (var i = 0; i < pictures.Length; ++i)
            {
                var from = Library.Given(page.Pictures[i], "pictures");
                pictures[i] = new ReportPicture { Camera = from.Camera, Exposure = from.Exposure, Ev100 = from.Ev100,
                                                  Smoothed = from.Smoothed ? 1 : 0 };
                pictures[i].Path = pins.Text(from.Path, "pictures");
                if (from.Path.Length > 0) continue;
                Library.Given(from.Png, "Png");
                pictures[i].Png = (byte*)pins.Pin(from.Png);
                pictures[i].PngSize = (UIntPtr)(ulong)from.Png.Length;
            }
            return (ReportPicture*)pins.Pin(pictures);
        }

        /// <summary>The page of a committed scene and a result of it, one HTML file.</summary>
        public static void Page(string path, Scene scene, Result result, ReportPage page)
        {
            Library.Given(scene, "scene");
            Library.Given(result, "result");
            Library.Given(page, "page");
            Library.Given(page.ThresholdsLx, "ThresholdsLx");
            var desc = ReportPageDesc.Create();
            var style = page.Style;
            desc.SensorCount = (uint)page.Sensors.List.Count;
            desc.SourceCount = (uint)page.Sources.Count;
            desc.PictureCount = (uint)page.Pictures.Count;
            desc.ThresholdCount = (uint)page.ThresholdsLx.Length;
            desc.RatioCount = (uint)page.Ratios.Count;
            desc.TargetRelativeError = page.TargetRelativeError;
            desc.Style = &style;
            using (var pins = new Pins())
            {
                desc.Scene = pins.Hold(scene.Handle);
                desc.Result = pins.Hold(result.Handle);
                desc.Sensors = Sensors(pins, page.Sensors);
                desc.Sources = Sources(pins, page);
                desc.Pictures = Pictures(pins, page);
                desc.ThresholdsLx = (double*)pins.Pin(page.ThresholdsLx);
                desc.Ratios = (ReportRatio*)pins.Pin(page.Ratios.ToArray());
                desc.Title = pins.Text(page.Title, "Title");
                desc.SceneName = pins.Text(page.SceneName, "SceneName");
                desc.Repeat = pins.Text(page.Repeat, "Repeat");
                desc.Date = pins.Text(page.Date, "Date");
                desc.TargetsJson = pins.Text(page.TargetsJson, "TargetsJson");
                desc.TargetsName = pins.Text(page.TargetsName, "TargetsName");
                desc.TargetsFolder = pins.Text(page.TargetsFolder, "TargetsFolder");
                fixed (byte* p = Library.Utf8(path, "path")) Check(Native.ups_report_write_page(p, &desc));
            }
        }
    }
}
