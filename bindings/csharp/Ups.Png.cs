// UPS for C#: pictures for people, as 8-bit PNG files: luminance through OpenColorIO, values in false colour. Programs
// use Png; see Ups.cs. The library is libups_ocio, loaded at first use. Images: rows from the top, as Result.Image().
using System;

namespace Ups
{
    /// <summary>What Png.Smooth looks at to tell which neighbours a pixel is averaged with, beside the image.</summary>
    public sealed class SmoothLayers
    {
        /// <summary>3 floats a pixel, as Channel.StandardErrorRgb; needed. Below: empty: not used.</summary>
        public float[] StandardErrorRgb = new float[0];
        public float[] AlbedoRgb = new float[0];
        public float[] Normal = new float[0];
        /// <summary>1 float a pixel.</summary>
        public float[] Depth = new float[0];
    }

    public static unsafe class Png
    {
        private static Status Check(Status status)
        {
            if (status < 0) throw new UpsException(status, Library.Utf8(Native.ups_ocio_last_error()));
            return status;
        }

        private static void ExpectImage(int length, int width, int height, int floats, string name)
        {
            if (width < 1 || height < 1) throw new ArgumentException(width + " x " + height + " pixels");
            Elements.Expect(length, (long)floats * width * height, name);
        }

        /// <summary>The factor from cd/m² to what the view transform takes, chosen from the image.</summary>
        public static double ChooseExposure(ReadOnlySpan<float> luminanceRgb, int width, int height)
        {
            ExpectImage(luminanceRgb.Length, width, height, 3, "luminanceRgb");
            double exposure;
            fixed (float* l = luminanceRgb)
                Check(Native.ups_ocio_choose_exposure(l, (uint)width, (uint)height, &exposure));
            return exposure;
        }

        /// <summary>The exposure value at ISO 100 of such a factor.</summary>
        public static double Ev100(double exposure)
        {
            double ev100;
            Check(Native.ups_ocio_get_ev100(exposure, &ev100));
            return ev100;
        }

        /// <summary>The other way round.</summary>
        public static double Exposure(double ev100)
        {
            double exposure;
            Check(Native.ups_ocio_get_exposure(ev100, &exposure));
            return exposure;
        }

        /// <summary>exposure 0: chosen from the image. The file appears whole or not at all.</summary>
        public static void Write(string path, ReadOnlySpan<float> luminanceRgb, int width, int height,
                                 double exposure = 0)
        {
            ExpectImage(luminanceRgb.Length, width, height, 3, "luminanceRgb");
            fixed (byte* p = Library.Utf8(path, "path"))
            fixed (float* l = luminanceRgb)
                Check(Native.ups_ocio_write_png(p, l, (uint)width, (uint)height, exposure));
        }

        /// <summary>The same of an image that Smooth made: the picture and the file say so.</summary>
        public static void WriteSmoothed(string path, ReadOnlySpan<float> luminanceRgb, int width, int height,
                                         double exposure = 0)
        {
            ExpectImage(luminanceRgb.Length, width, height, 3, "luminanceRgb");
            var desc = OcioPictureDesc.Create();
            desc.Width = (uint)width;
            desc.Height = (uint)height;
            desc.Exposure = exposure;
            desc.Smoothed = 1;
            fixed (byte* p = Library.Utf8(path, "path"))
            fixed (float* l = luminanceRgb)
            {
                desc.LuminanceRgb = l;
                Check(Native.ups_ocio_write_picture_png(p, &desc));
            }
        }

        /// <summary>An image with less noise, for looking at, never for numbers. Takes about 10 s a million
        /// pixels.</summary>
        public static float[] Smooth(ReadOnlySpan<float> luminanceRgb, int width, int height, SmoothLayers layers)
        {
            ExpectImage(luminanceRgb.Length, width, height, 3, "luminanceRgb");
            Library.Given(layers, "layers");
            ExpectImage(layers.StandardErrorRgb.Length, width, height, 3, "StandardErrorRgb");
            Elements.ExpectIfAny(layers.AlbedoRgb.Length, luminanceRgb.Length, "AlbedoRgb");
            Elements.ExpectIfAny(layers.Normal.Length, luminanceRgb.Length, "Normal");
            Elements.ExpectIfAny(layers.Depth.Length, luminanceRgb.Length / 3, "Depth");
            var desc = OcioSmoothDesc.Create();
            desc.Width = (uint)width;
            desc.Height = (uint)height;
            var smooth = new float[luminanceRgb.Length];
            fixed (float* l = luminanceRgb, e = layers.StandardErrorRgb, a = layers.AlbedoRgb, n = layers.Normal,
                   d = layers.Depth, s = smooth)
            {
                desc.LuminanceRgb = l;
                desc.StandardErrorRgb = e;
                desc.AlbedoRgb = a;
                desc.Normal = n;
                desc.Depth = d;
                Check(Native.ups_ocio_smooth(&desc, s));
            }
            return smooth;
        }

        /// <summary>Values by colour beside a labelled scale; below 0 or not finite: not known, grey. title, unit:
        /// ASCII. Both ends of the scale 0: chosen from the values.</summary>
        public static void WriteFalseColor(string path, ReadOnlySpan<float> values, int columns, int rows,
                                           string title = "", string unit = "lx", double scaleMin = 0,
                                           double scaleMax = 0, bool firstRowAtBottom = false)
        {
            ExpectImage(values.Length, columns, rows, 1, "values");
            var desc = OcioFalseColorDesc.Create();
            desc.Columns = (uint)columns;
            desc.Rows = (uint)rows;
            desc.FirstRowAtBottom = firstRowAtBottom ? 1 : 0;
            desc.ScaleMin = scaleMin;
            desc.ScaleMax = scaleMax;
            fixed (byte* p = Library.Utf8(path, "path"), t = Library.Utf8(title, "title"),
                   u = Library.Utf8(unit, "unit"))
            fixed (float* v = values)
            {
                desc.Values = v;
                desc.Title = title.Length == 0 ? null : t;
                desc.Unit = u;
                Check(Native.ups_ocio_write_false_color_png(p, &desc));
            }
        }

        /// <summary>8-bit pixels as they are: 3 bytes each, sRGB.</summary>
        public static void WritePixels(string path, ReadOnlySpan<byte> rgb, int width, int height)
        {
            ExpectImage(rgb.Length, width, height, 3, "rgb");
            fixed (byte* p = Library.Utf8(path, "path"), pixels = rgb)
                Check(Native.ups_ocio_write_pixels_png(p, pixels, (uint)width, (uint)height));
        }
    }
}
