// The C API of UPS as P/Invoke. Written by bindings/generate.py from include/ups; do not edit.
using System;
using System.Collections;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Ups
{
    public enum Status : int
    {
        Ok = 0,
        ErrorInternal = -1,
        ErrorInvalidArgument = -2,
        ErrorInvalidState = -3,
        ErrorOutOfMemory = -4,
        ErrorParse = -5,
        ErrorUnsupported = -6,
        ErrorBufferTooSmall = -7,
        ErrorIo = -8,
        Timeout = 1,
        Cancelled = 2,
    }

    public enum Priority : int
    {
        Normal = 0,
        Low = 1,
    }

    public enum LogLevel : int
    {
        Info = 0,
        Warning = 1,
    }

    public enum ProfileFormat : int
    {
        Auto = 0,
        IesLm63 = 1,
        Eulumdat = 2,
        Tm33Xml = 3,
        Tm25Rays = 4,
        ZemaxRays = 5,
        LighttoolsRays = 6,
    }

    public enum OpeningShape : int
    {
        Point = 0,
        Rectangle = 1,
        Disc = 2,
        Box = 3,
        Cylinder = 4,
        Sphere = 5,
    }

    public enum ProfileSymmetry : int
    {
        None = 0,
        Axial = 1,
        C0C180 = 2,
        C90C270 = 3,
        Quadrants = 4,
    }

    public enum PhotometricType : int
    {
        C = 0,
        B = 1,
        A = 2,
    }

    public enum ProfileText : int
    {
        Warnings = 0,
        Keywords = 1,
        Format = 2,
        TiltFile = 3,
        TiltTable = 4,
        LampTypes = 5,
        LampColours = 6,
        LampRenderings = 7,
    }

    public enum MaterialModel : int
    {
        Matte = 0,
        Plastic = 1,
        Metal = 2,
        Mirror = 3,
        Glass = 4,
        Glazing = 5,
        Diffuser = 6,
    }

    public enum AlphaMode : int
    {
        Opaque = 0,
        Mask = 1,
        Blend = 2,
    }

    public enum LightKind : int
    {
        Point = 0,
        Spot = 1,
        Directional = 2,
    }

    [Flags]
    public enum Effect : uint
    {
        SpecularReflection = 1,
        Transmission = 2,
        Caustics = 4,
        Glossy = 8,
        Interreflection = 16,
        Colour = 32,
        Textures = 64,
    }

    public enum SceneText : int
    {
        Warnings = 0,
        Effects = 1,
        Techniques = 2,
    }

    public enum Finish : int
    {
        SpecularAluminium = 0,
        EnhancedAluminium = 1,
        SemiSpecularAluminium = 2,
        MatteWhite = 3,
        Black = 4,
        Opal = 5,
        Pmma = 6,
        Polycarbonate = 7,
        Glass = 8,
        FrostedPmma = 9,
        Custom = 10,
    }

    public enum EmitterShape : int
    {
        Disc = 0,
        Rectangle = 1,
        Sphere = 2,
        Cylinder = 3,
    }

    public enum ReflectorProfile : int
    {
        Paraboloid = 0,
        Ellipsoid = 1,
        Cone = 2,
        Cylinder = 3,
        Polyline = 4,
    }

    public enum CollimatorWall : int
    {
        Parallel = 0,
        Paraboloid = 1,
        Polyline = 2,
    }

    public enum Projection : int
    {
        Perspective = 0,
        Equidistant = 1,
        Equisolid = 2,
        Panorama = 3,
    }

    [Flags]
    public enum Layer : uint
    {
        Albedo = 1,
        Normal = 2,
        Depth = 4,
        Id = 8,
    }

    public enum MeterKind : int
    {
        Planar = 0,
        Cylindrical = 1,
        Semicylindrical = 2,
        Hemispherical = 3,
        Spherical = 4,
        Vector = 5,
    }

    public enum Method : int
    {
        Auto = 0,
        Ups = 1,
        PathTracing = 2,
        LightTracing = 3,
        Bidirectional = 4,
        Ppm = 5,
        Sppm = 6,
        BidirectionalPhotonMapping = 7,
    }

    [Flags]
    public enum Technique : uint
    {
        EmitterHit = 1,
        LightSample = 2,
        Connect = 4,
        SensorConnect = 8,
        Merge = 16,
        SensorHit = 32,
        MirrorSample = 64,
    }

    public enum Perturbation : int
    {
        Virtual = 0,
        Actual = 1,
    }

    public enum Separation : int
    {
        Nothing = 0,
        Luminaires = 1,
        Groups = 2,
    }

    public enum Criterion : int
    {
        Default = 0,
        Worst = 1,
        P95 = 2,
        Mean = 3,
        Median = 4,
    }

    public enum JobState : int
    {
        Running = 0,
        Finished = 1,
        Cancelled = 2,
        Failed = 3,
    }

    [Flags]
    public enum Reading : uint
    {
        Exact = 1,
        Unknown = 2,
        FewPaths = 4,
        SinglePath = 8,
        HeavyTail = 16,
    }

    public enum Limit : int
    {
        Unknown = 0,
        Noise = 1,
        Bias = 2,
    }

    public enum Photons : int
    {
        None = 0,
        Caustic = 1,
        All = 2,
    }

    public enum LightPart : int
    {
        Direct = 0,
        Indirect = 1,
        All = 2,
    }

    public enum SourceKind : int
    {
        Luminaire = 0,
        Instance = 1,
        Group = 2,
    }

    public enum Channel : int
    {
        LuminanceRgb = 0,
        StandardErrorRgb = 1,
        Illuminance = 2,
        PathIntegrationRgb = 3,
        DensityEstimationRgb = 4,
        Bias = 5,
        ErrorBound = 6,
        RobustRgb = 7,
        IlluminanceStandardError = 8,
        AlbedoRgb = 9,
        Normal = 10,
        Depth = 11,
        Id = 12,
        IlluminanceBias = 13,
        IlluminanceErrorBound = 14,
    }

    public enum Contribution : int
    {
        Weighted = 0,
        Unweighted = 1,
    }

    public enum ResultText : int
    {
        Warnings = 0,
        Effects = 1,
        Techniques = 2,
        Dropped = 3,
    }

    public enum Walk : int
    {
        Eye = 0,
        Light = 1,
    }

    public enum PathEvent : int
    {
        Start = 0,
        End = 1,
        Scattered = 2,
        Mirrored = 3,
        Refracted = 4,
    }

    public enum PositionIndex : int
    {
        Table = 0,
        Guth = 1,
    }

    public enum GlareMetric : int
    {
        GlareMetricUgr = 0,
    }

    [Flags]
    public enum Observer : uint
    {
        NoSource = 1,
        NoBackground = 2,
        LargeSource = 4,
        PointSource = 8,
        UnratedSource = 16,
        Fixture = 32,
        CoveredSource = 64,
    }

    [Flags]
    public enum GlareFlag : uint
    {
        Small = 1,
        Point = 2,
        Large = 4,
        Hidden = 8,
    }

    public enum GltfSensorKind : int
    {
        Camera = 0,
        Meters = 1,
        Goniometer = 2,
        Observer = 3,
    }

    public enum GltfLayout : int
    {
        Points = 0,
        Grid = 1,
        En12464 = 2,
        Line = 3,
        Surface = 4,
        Lightmap = 5,
    }

    public enum GltfPart : int
    {
        Material = 0,
        Mesh = 1,
        Instance = 2,
        Luminaire = 3,
        Fixture = 4,
    }

    public enum ReportScale : int
    {
        Linear = 0,
        Logarithmic = 1,
    }

    public enum ReportColours : int
    {
        Viridis = 0,
        Cividis = 1,
        Grey = 2,
    }

    public enum ReportQuantity : int
    {
        Auto = 0,
        Illuminance = 1,
        Luminance = 2,
    }

    public enum ReportExposure : int
    {
        Untold = 0,
        Chosen = 1,
        Given = 2,
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Double2 : IEnumerable<double>
    {
        private fixed double values_[2];
        public int Length { get { return 2; } }
        public double this[int index]
        {
            get { fixed (double* p = values_) return p[Elements.Index(index, 2)]; }
            set { fixed (double* p = values_) p[Elements.Index(index, 2)] = value; }
        }
        public double[] ToArray() { fixed (double* p = values_) return Elements.Copy(p, 2); }
        public static implicit operator double[](Double2 from) { return from.ToArray(); }
        public static implicit operator Double2(double[] from) { return new ReadOnlySpan<double>(from); }
        public static implicit operator Double2(ReadOnlySpan<double> from)
        {
            var to = new Double2();
            Elements.Set(to.values_, 2, from, "Double2");
            return to;
        }
        public IEnumerator<double> GetEnumerator() { return ((IEnumerable<double>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Double3 : IEnumerable<double>
    {
        private fixed double values_[3];
        public int Length { get { return 3; } }
        public double this[int index]
        {
            get { fixed (double* p = values_) return p[Elements.Index(index, 3)]; }
            set { fixed (double* p = values_) p[Elements.Index(index, 3)] = value; }
        }
        public double[] ToArray() { fixed (double* p = values_) return Elements.Copy(p, 3); }
        public static implicit operator double[](Double3 from) { return from.ToArray(); }
        public static implicit operator Double3(double[] from) { return new ReadOnlySpan<double>(from); }
        public static implicit operator Double3(ReadOnlySpan<double> from)
        {
            var to = new Double3();
            Elements.Set(to.values_, 3, from, "Double3");
            return to;
        }
        public IEnumerator<double> GetEnumerator() { return ((IEnumerable<double>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Double4 : IEnumerable<double>
    {
        private fixed double values_[4];
        public int Length { get { return 4; } }
        public double this[int index]
        {
            get { fixed (double* p = values_) return p[Elements.Index(index, 4)]; }
            set { fixed (double* p = values_) p[Elements.Index(index, 4)] = value; }
        }
        public double[] ToArray() { fixed (double* p = values_) return Elements.Copy(p, 4); }
        public static implicit operator double[](Double4 from) { return from.ToArray(); }
        public static implicit operator Double4(double[] from) { return new ReadOnlySpan<double>(from); }
        public static implicit operator Double4(ReadOnlySpan<double> from)
        {
            var to = new Double4();
            Elements.Set(to.values_, 4, from, "Double4");
            return to;
        }
        public IEnumerator<double> GetEnumerator() { return ((IEnumerable<double>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Double12 : IEnumerable<double>
    {
        private fixed double values_[12];
        public int Length { get { return 12; } }
        public double this[int index]
        {
            get { fixed (double* p = values_) return p[Elements.Index(index, 12)]; }
            set { fixed (double* p = values_) p[Elements.Index(index, 12)] = value; }
        }
        public double[] ToArray() { fixed (double* p = values_) return Elements.Copy(p, 12); }
        public static implicit operator double[](Double12 from) { return from.ToArray(); }
        public static implicit operator Double12(double[] from) { return new ReadOnlySpan<double>(from); }
        public static implicit operator Double12(ReadOnlySpan<double> from)
        {
            var to = new Double12();
            Elements.Set(to.values_, 12, from, "Double12");
            return to;
        }
        public IEnumerator<double> GetEnumerator() { return ((IEnumerable<double>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Float2 : IEnumerable<float>
    {
        private fixed float values_[2];
        public int Length { get { return 2; } }
        public float this[int index]
        {
            get { fixed (float* p = values_) return p[Elements.Index(index, 2)]; }
            set { fixed (float* p = values_) p[Elements.Index(index, 2)] = value; }
        }
        public float[] ToArray() { fixed (float* p = values_) return Elements.Copy(p, 2); }
        public static implicit operator float[](Float2 from) { return from.ToArray(); }
        public static implicit operator Float2(float[] from) { return new ReadOnlySpan<float>(from); }
        public static implicit operator Float2(ReadOnlySpan<float> from)
        {
            var to = new Float2();
            Elements.Set(to.values_, 2, from, "Float2");
            return to;
        }
        public IEnumerator<float> GetEnumerator() { return ((IEnumerable<float>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Float3 : IEnumerable<float>
    {
        private fixed float values_[3];
        public int Length { get { return 3; } }
        public float this[int index]
        {
            get { fixed (float* p = values_) return p[Elements.Index(index, 3)]; }
            set { fixed (float* p = values_) p[Elements.Index(index, 3)] = value; }
        }
        public float[] ToArray() { fixed (float* p = values_) return Elements.Copy(p, 3); }
        public static implicit operator float[](Float3 from) { return from.ToArray(); }
        public static implicit operator Float3(float[] from) { return new ReadOnlySpan<float>(from); }
        public static implicit operator Float3(ReadOnlySpan<float> from)
        {
            var to = new Float3();
            Elements.Set(to.values_, 3, from, "Float3");
            return to;
        }
        public IEnumerator<float> GetEnumerator() { return ((IEnumerable<float>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Float4 : IEnumerable<float>
    {
        private fixed float values_[4];
        public int Length { get { return 4; } }
        public float this[int index]
        {
            get { fixed (float* p = values_) return p[Elements.Index(index, 4)]; }
            set { fixed (float* p = values_) p[Elements.Index(index, 4)] = value; }
        }
        public float[] ToArray() { fixed (float* p = values_) return Elements.Copy(p, 4); }
        public static implicit operator float[](Float4 from) { return from.ToArray(); }
        public static implicit operator Float4(float[] from) { return new ReadOnlySpan<float>(from); }
        public static implicit operator Float4(ReadOnlySpan<float> from)
        {
            var to = new Float4();
            Elements.Set(to.values_, 4, from, "Float4");
            return to;
        }
        public IEnumerator<float> GetEnumerator() { return ((IEnumerable<float>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Float5 : IEnumerable<float>
    {
        private fixed float values_[5];
        public int Length { get { return 5; } }
        public float this[int index]
        {
            get { fixed (float* p = values_) return p[Elements.Index(index, 5)]; }
            set { fixed (float* p = values_) p[Elements.Index(index, 5)] = value; }
        }
        public float[] ToArray() { fixed (float* p = values_) return Elements.Copy(p, 5); }
        public static implicit operator float[](Float5 from) { return from.ToArray(); }
        public static implicit operator Float5(float[] from) { return new ReadOnlySpan<float>(from); }
        public static implicit operator Float5(ReadOnlySpan<float> from)
        {
            var to = new Float5();
            Elements.Set(to.values_, 5, from, "Float5");
            return to;
        }
        public IEnumerator<float> GetEnumerator() { return ((IEnumerable<float>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Float10 : IEnumerable<float>
    {
        private fixed float values_[10];
        public int Length { get { return 10; } }
        public float this[int index]
        {
            get { fixed (float* p = values_) return p[Elements.Index(index, 10)]; }
            set { fixed (float* p = values_) p[Elements.Index(index, 10)] = value; }
        }
        public float[] ToArray() { fixed (float* p = values_) return Elements.Copy(p, 10); }
        public static implicit operator float[](Float10 from) { return from.ToArray(); }
        public static implicit operator Float10(float[] from) { return new ReadOnlySpan<float>(from); }
        public static implicit operator Float10(ReadOnlySpan<float> from)
        {
            var to = new Float10();
            Elements.Set(to.values_, 10, from, "Float10");
            return to;
        }
        public IEnumerator<float> GetEnumerator() { return ((IEnumerable<float>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Float15 : IEnumerable<float>
    {
        private fixed float values_[15];
        public int Length { get { return 15; } }
        public float this[int index]
        {
            get { fixed (float* p = values_) return p[Elements.Index(index, 15)]; }
            set { fixed (float* p = values_) p[Elements.Index(index, 15)] = value; }
        }
        public float[] ToArray() { fixed (float* p = values_) return Elements.Copy(p, 15); }
        public static implicit operator float[](Float15 from) { return from.ToArray(); }
        public static implicit operator Float15(float[] from) { return new ReadOnlySpan<float>(from); }
        public static implicit operator Float15(ReadOnlySpan<float> from)
        {
            var to = new Float15();
            Elements.Set(to.values_, 15, from, "Float15");
            return to;
        }
        public IEnumerator<float> GetEnumerator() { return ((IEnumerable<float>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Float19 : IEnumerable<float>
    {
        private fixed float values_[19];
        public int Length { get { return 19; } }
        public float this[int index]
        {
            get { fixed (float* p = values_) return p[Elements.Index(index, 19)]; }
            set { fixed (float* p = values_) p[Elements.Index(index, 19)] = value; }
        }
        public float[] ToArray() { fixed (float* p = values_) return Elements.Copy(p, 19); }
        public static implicit operator float[](Float19 from) { return from.ToArray(); }
        public static implicit operator Float19(float[] from) { return new ReadOnlySpan<float>(from); }
        public static implicit operator Float19(ReadOnlySpan<float> from)
        {
            var to = new Float19();
            Elements.Set(to.values_, 19, from, "Float19");
            return to;
        }
        public IEnumerator<float> GetEnumerator() { return ((IEnumerable<float>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Float30 : IEnumerable<float>
    {
        private fixed float values_[30];
        public int Length { get { return 30; } }
        public float this[int index]
        {
            get { fixed (float* p = values_) return p[Elements.Index(index, 30)]; }
            set { fixed (float* p = values_) p[Elements.Index(index, 30)] = value; }
        }
        public float[] ToArray() { fixed (float* p = values_) return Elements.Copy(p, 30); }
        public static implicit operator float[](Float30 from) { return from.ToArray(); }
        public static implicit operator Float30(float[] from) { return new ReadOnlySpan<float>(from); }
        public static implicit operator Float30(ReadOnlySpan<float> from)
        {
            var to = new Float30();
            Elements.Set(to.values_, 30, from, "Float30");
            return to;
        }
        public IEnumerator<float> GetEnumerator() { return ((IEnumerable<float>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Float95 : IEnumerable<float>
    {
        private fixed float values_[95];
        public int Length { get { return 95; } }
        public float this[int index]
        {
            get { fixed (float* p = values_) return p[Elements.Index(index, 95)]; }
            set { fixed (float* p = values_) p[Elements.Index(index, 95)] = value; }
        }
        public float[] ToArray() { fixed (float* p = values_) return Elements.Copy(p, 95); }
        public static implicit operator float[](Float95 from) { return from.ToArray(); }
        public static implicit operator Float95(float[] from) { return new ReadOnlySpan<float>(from); }
        public static implicit operator Float95(ReadOnlySpan<float> from)
        {
            var to = new Float95();
            Elements.Set(to.values_, 95, from, "Float95");
            return to;
        }
        public IEnumerator<float> GetEnumerator() { return ((IEnumerable<float>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    /// <summary>An array that C keeps inside a struct: elements are set in place, an array is assigned whole.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Float100 : IEnumerable<float>
    {
        private fixed float values_[100];
        public int Length { get { return 100; } }
        public float this[int index]
        {
            get { fixed (float* p = values_) return p[Elements.Index(index, 100)]; }
            set { fixed (float* p = values_) p[Elements.Index(index, 100)] = value; }
        }
        public float[] ToArray() { fixed (float* p = values_) return Elements.Copy(p, 100); }
        public static implicit operator float[](Float100 from) { return from.ToArray(); }
        public static implicit operator Float100(float[] from) { return new ReadOnlySpan<float>(from); }
        public static implicit operator Float100(ReadOnlySpan<float> from)
        {
            var to = new Float100();
            Elements.Set(to.values_, 100, from, "Float100");
            return to;
        }
        public IEnumerator<float> GetEnumerator() { return ((IEnumerable<float>)ToArray()).GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TextureId
    {
        public uint V;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MaterialId
    {
        public uint V;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MeshId
    {
        public uint V;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct InstanceId
    {
        public uint V;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct LuminaireId
    {
        public uint V;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SensorId
    {
        public uint V;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ContextDesc
    {
        public uint StructSize;
        public int ThreadCount;
        /// <summary>With the library's defaults.</summary>
        public static ContextDesc Create()
        {
            var d = new ContextDesc();
            Native.ups_context_desc_init(&d, (uint)sizeof(ContextDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ProfileDesc
    {
        public uint StructSize;
        public uint CCount;
        public uint GammaCount;
        public uint Reserved;
        internal float* CDeg;
        internal float* GammaDeg;
        internal float* IntensityCd;
        public OpeningShape OpeningShape;
        public Float3 OpeningM;
        public int OpeningAxis;
        public float InputPowerW;
        /// <summary>With the library's defaults.</summary>
        public static ProfileDesc Create()
        {
            var d = new ProfileDesc();
            Native.ups_profile_desc_init(&d, (uint)sizeof(ProfileDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ProfileParseDesc
    {
        public uint StructSize;
        public ProfileFormat Format;
        internal void* Bytes;
        public UIntPtr Size;
        internal void* TiltFile;
        public UIntPtr TiltFileSize;
        public float TiltDeg;
        public uint LampSet;
        /// <summary>With the library's defaults.</summary>
        public static ProfileParseDesc Create()
        {
            var d = new ProfileParseDesc();
            Native.ups_profile_parse_desc_init(&d, (uint)sizeof(ProfileParseDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ProfileInfo
    {
        public uint StructSize;
        public uint WarningCount;
        public double FluxLm;
        public double InterpolatedFluxLm;
        public double RatedFluxLm;
        public double InputPowerW;
        public float PeakCd;
        public float PeakCDeg;
        public float PeakGammaDeg;
        public Float3 OpeningM;
        public OpeningShape OpeningShape;
        public ProfileSymmetry Symmetry;
        public uint CCount;
        public uint GammaCount;
        public PhotometricType PhotometricType;
        public uint RayCount;
        public double UpFluxLm;
        public double DownFluxLm;
        public double LightOutputRatio;
        public Float2 BeamAngleDeg;
        public Float2 FieldAngleDeg;
        public int OpeningAxis;
        public uint LampSetCount;
        internal static ProfileInfo Sized()
        {
            return new ProfileInfo { StructSize = (uint)sizeof(ProfileInfo) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ProfileBeam
    {
        public uint StructSize;
        public float PeakCd;
        public float PeakDeg;
        public float FromDeg;
        public float ToDeg;
        public float AngleDeg;
        internal static ProfileBeam Sized()
        {
            return new ProfileBeam { StructSize = (uint)sizeof(ProfileBeam) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ProfileLampSet
    {
        public uint StructSize;
        public int Count;
        public double FluxLm;
        public float InputPowerW;
        public float ColourTemperatureK;
        public float ColourRenderingIndex;
        public int Chosen;
        internal static ProfileLampSet Sized()
        {
            return new ProfileLampSet { StructSize = (uint)sizeof(ProfileLampSet) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TextureDesc
    {
        public uint StructSize;
        public uint Width;
        public uint Height;
        public uint ChannelCount;
        internal float* Texels;
        public UIntPtr RowStrideBytes;
        /// <summary>With the library's defaults.</summary>
        public static TextureDesc Create()
        {
            var d = new TextureDesc();
            Native.ups_texture_desc_init(&d, (uint)sizeof(TextureDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MaterialDesc
    {
        public uint StructSize;
        public MaterialModel Model;
        public Float3 ReflectanceRgb;
        public Float3 TransmittanceRgb;
        public float Roughness;
        public float Ior;
        public Float3 IorRgb;
        public Float3 IorKRgb;
        public Float3 AbsorptionPerMRgb;
        public float Metallic;
        public AlphaMode AlphaMode;
        public float Alpha;
        public float AlphaCutoff;
        public Float3 LuminanceCdM2;
        public int EmitsBothSides;
        public float NormalScale;
        public TextureId ReflectanceTexture;
        public TextureId RoughnessTexture;
        public TextureId MetallicTexture;
        public TextureId NormalTexture;
        public TextureId AlphaTexture;
        public int Priority;
        internal float* PaneAngleDeg;
        internal float* PaneTransmittance;
        internal float* PaneReflectance;
        public uint PaneAngleCount;
        public uint Reserved;
        /// <summary>With the library's defaults.</summary>
        public static MaterialDesc Create()
        {
            var d = new MaterialDesc();
            Native.ups_material_desc_init(&d, (uint)sizeof(MaterialDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MeshDesc
    {
        public uint StructSize;
        public uint VertexCount;
        public uint TriangleCount;
        public MaterialId Material;
        internal float* PositionsM;
        public UIntPtr PositionStrideBytes;
        internal float* Normals;
        public UIntPtr NormalStrideBytes;
        internal float* Uvs;
        public UIntPtr UvStrideBytes;
        internal float* Tangents;
        public UIntPtr TangentStrideBytes;
        internal uint* Indices;
        /// <summary>With the library's defaults.</summary>
        public static MeshDesc Create()
        {
            var d = new MeshDesc();
            Native.ups_mesh_desc_init(&d, (uint)sizeof(MeshDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct InstanceDesc
    {
        public uint StructSize;
        public MeshId Mesh;
        public Double12 ToWorld;
        public uint Group;
        public uint Reserved;
        /// <summary>With the library's defaults.</summary>
        public static InstanceDesc Create()
        {
            var d = new InstanceDesc();
            Native.ups_instance_desc_init(&d, (uint)sizeof(InstanceDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct LightDesc
    {
        public uint StructSize;
        public LightKind Kind;
        public Double12 ToWorld;
        public Float3 IntensityRgb;
        public float InnerConeRad;
        public float OuterConeRad;
        public uint Group;
        /// <summary>With the library's defaults.</summary>
        public static LightDesc Create()
        {
            var d = new LightDesc();
            Native.ups_light_desc_init(&d, (uint)sizeof(LightDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct LuminaireDesc
    {
        public uint StructSize;
        public int UseOpening;
        internal IntPtr Profile;
        public Double12 ToWorld;
        public Float3 ColorRgb;
        public float FluxLm;
        public float Dimming;
        public float IntensityScale;
        public uint Group;
        public uint Reserved;
        /// <summary>With the library's defaults.</summary>
        public static LuminaireDesc Create()
        {
            var d = new LuminaireDesc();
            Native.ups_luminaire_desc_init(&d, (uint)sizeof(LuminaireDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct CommitDesc
    {
        public uint StructSize;
        public uint ThreadLimit;
        public Priority Priority;
        public uint Reserved;
        public ulong MemoryLimitBytes;
        /// <summary>With the library's defaults.</summary>
        public static CommitDesc Create()
        {
            var d = new CommitDesc();
            Native.ups_commit_desc_init(&d, (uint)sizeof(CommitDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SceneInfo
    {
        public uint StructSize;
        public uint Effects;
        public uint Techniques;
        public int Method;
        public ulong TriangleCount;
        public ulong LuminaireCount;
        public ulong LightCount;
        public ulong EmissiveInstanceCount;
        public ulong MeterCount;
        public ulong PixelCount;
        public double EmittedFluxLm;
        public Double3 BoundsMinM;
        public Double3 BoundsMaxM;
        public double MaintenanceFactor;
        public ulong Revision;
        internal static SceneInfo Sized()
        {
            return new SceneInfo { StructSize = (uint)sizeof(SceneInfo) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Segment
    {
        public Double3 FromM;
        public Double3 ToM;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct FixturePartId
    {
        public uint V;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct FixtureId
    {
        public uint V;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct FixtureEmitterDesc
    {
        public uint StructSize;
        public EmitterShape Shape;
        public Double12 ToFixture;
        public double RadiusM;
        public double WidthM;
        public double LengthM;
        public double ChordToleranceM;
        public float FluxLm;
        public Float3 ColorRgb;
        public float Reflectance;
        public float Reserved;
        /// <summary>With the library's defaults.</summary>
        public static FixtureEmitterDesc Create()
        {
            var d = new FixtureEmitterDesc();
            Native.ups_fixture_emitter_desc_init(&d, (uint)sizeof(FixtureEmitterDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ReflectorDesc
    {
        public uint StructSize;
        public ReflectorProfile Profile;
        public Double12 ToFixture;
        public double FocalLengthM;
        public double SemiAxisM;
        public double HalfDistanceM;
        public double InnerRadiusM;
        public double ApertureRadiusM;
        public double DepthM;
        internal double* ProfileRzM;
        public uint ProfilePointCount;
        public int Smooth;
        public uint FacetsAround;
        public uint FacetsAlong;
        public double ChordToleranceM;
        public double NormalToleranceRad;
        public Finish Finish;
        public float FinishReflectance;
        public float FinishTransmittance;
        public float FinishRoughness;
        internal MaterialDesc* Material;
        /// <summary>With the library's defaults.</summary>
        public static ReflectorDesc Create()
        {
            var d = new ReflectorDesc();
            Native.ups_reflector_desc_init(&d, (uint)sizeof(ReflectorDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct LensDesc
    {
        public uint StructSize;
        public Finish Finish;
        public Double12 ToFixture;
        public double RadiusM;
        public double ThicknessM;
        public double EntryRadiusM;
        public double EntryConic;
        public Double4 EntryCoefficients;
        public double ExitRadiusM;
        public double ExitConic;
        public Double4 ExitCoefficients;
        public double ChordToleranceM;
        public double NormalToleranceRad;
        public uint FacetsAround;
        public float FinishRoughness;
        public float FinishAbsorptionPerM;
        public float FinishIor;
        internal MaterialDesc* Material;
        /// <summary>With the library's defaults.</summary>
        public static LensDesc Create()
        {
            var d = new LensDesc();
            Native.ups_lens_desc_init(&d, (uint)sizeof(LensDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct CollimatorDesc
    {
        public uint StructSize;
        public Finish Finish;
        public Double12 ToFixture;
        public double CavityRadiusM;
        public double CavityDepthM;
        public double LensRadiusM;
        public double LensConic;
        public CollimatorWall Wall;
        public int Smooth;
        public double WallThicknessM;
        public double WallFocalLengthM;
        public double HeightM;
        internal double* WallRzM;
        public uint WallPointCount;
        public uint FacetsAround;
        public double ExitRadiusM;
        public double ExitConic;
        public double ChordToleranceM;
        public double NormalToleranceRad;
        public uint ExitFacetsAlong;
        public float FinishRoughness;
        public float FinishAbsorptionPerM;
        public float FinishIor;
        internal MaterialDesc* Material;
        /// <summary>With the library's defaults.</summary>
        public static CollimatorDesc Create()
        {
            var d = new CollimatorDesc();
            Native.ups_collimator_desc_init(&d, (uint)sizeof(CollimatorDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct FixturePartDesc
    {
        public uint StructSize;
        public Finish Finish;
        public Double12 ToFixture;
        internal MeshDesc* Mesh;
        public float FinishReflectance;
        public float FinishTransmittance;
        public float FinishRoughness;
        public float FinishAbsorptionPerM;
        public float FinishIor;
        public float Reserved;
        internal MaterialDesc* Material;
        /// <summary>With the library's defaults.</summary>
        public static FixturePartDesc Create()
        {
            var d = new FixturePartDesc();
            Native.ups_fixture_part_desc_init(&d, (uint)sizeof(FixturePartDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct FixtureInfo
    {
        public uint StructSize;
        public uint PartCount;
        public ulong TriangleCount;
        public double FluxLm;
        public double EmitterAreaM2;
        internal static FixtureInfo Sized()
        {
            return new FixtureInfo { StructSize = (uint)sizeof(FixtureInfo) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct FixtureInstanceDesc
    {
        public uint StructSize;
        public float Dimming;
        public Double12 ToWorld;
        public float FluxLm;
        public uint Group;
        /// <summary>With the library's defaults.</summary>
        public static FixtureInstanceDesc Create()
        {
            var d = new FixtureInstanceDesc();
            Native.ups_fixture_instance_desc_init(&d, (uint)sizeof(FixtureInstanceDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct CameraDesc
    {
        public uint StructSize;
        public Projection Projection;
        public uint Width;
        public uint Height;
        public Double12 ToWorld;
        public float VerticalFovRad;
        public int Illuminance;
        public uint Layers;
        public uint Reserved;
        /// <summary>With the library's defaults.</summary>
        public static CameraDesc Create()
        {
            var d = new CameraDesc();
            Native.ups_camera_desc_init(&d, (uint)sizeof(CameraDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MeterDesc
    {
        public uint StructSize;
        public MeterKind Kind;
        internal double* PositionsM;
        internal float* Normals;
        internal float* Tangents;
        public Float2 CellSizeM;
        public uint Count;
        public uint Reserved;
        public float FootprintM;
        public uint Reserved2;
        /// <summary>With the library's defaults.</summary>
        public static MeterDesc Create()
        {
            var d = new MeterDesc();
            Native.ups_meter_desc_init(&d, (uint)sizeof(MeterDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SurfaceMetersDesc
    {
        public uint StructSize;
        public uint InstanceCount;
        internal InstanceId* Instances;
        public int Back;
        public uint Reserved;
        /// <summary>With the library's defaults.</summary>
        public static SurfaceMetersDesc Create()
        {
            var d = new SurfaceMetersDesc();
            Native.ups_surface_meters_desc_init(&d, (uint)sizeof(SurfaceMetersDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct LightmapDesc
    {
        public uint StructSize;
        public uint InstanceCount;
        internal InstanceId* Instances;
        public uint Width;
        public uint Height;
        public int Back;
        public uint Reserved;
        /// <summary>With the library's defaults.</summary>
        public static LightmapDesc Create()
        {
            var d = new LightmapDesc();
            Native.ups_lightmap_desc_init(&d, (uint)sizeof(LightmapDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct En12464Desc
    {
        public uint StructSize;
        public uint CornerCount;
        internal double* CornersM;
        internal double* HoleCornersM;
        internal uint* HoleCornerCounts;
        public uint HoleCount;
        public uint Reserved;
        public double BorderM;
        /// <summary>With the library's defaults.</summary>
        public static En12464Desc Create()
        {
            var d = new En12464Desc();
            Native.ups_en12464_desc_init(&d, (uint)sizeof(En12464Desc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct En12464Info
    {
        public uint StructSize;
        public uint Columns;
        public uint Rows;
        public uint PointCount;
        public Double2 OriginM;
        public Double2 CellM;
        public double LargestSpacingM;
        internal static En12464Info Sized()
        {
            return new En12464Info { StructSize = (uint)sizeof(En12464Info) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct En12464Point
    {
        public double XM;
        public double YM;
        public uint Column;
        public uint Row;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MeterPlace
    {
        public Double3 PositionM;
        public Float3 Normal;
        public float AreaM2;
        public int Valid;
        public uint Triangle;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct GoniometerDesc
    {
        public uint StructSize;
        public ProfileSymmetry Symmetry;
        internal float* CDeg;
        internal float* GammaDeg;
        public uint CCount;
        public uint GammaCount;
        public Double12 ToWorld;
        public OpeningShape OpeningShape;
        public Float3 OpeningM;
        /// <summary>With the library's defaults.</summary>
        public static GoniometerDesc Create()
        {
            var d = new GoniometerDesc();
            Native.ups_goniometer_desc_init(&d, (uint)sizeof(GoniometerDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct RenderDesc
    {
        public uint StructSize;
        public Method Method;
        public ulong Seed;
        public double TimeLimitS;
        public float TargetRelativeError;
        public float MergeRadiusM;
        public uint IterationCount;
        public uint MaxPathLength;
        public uint LightPathsPerIteration;
        public uint Techniques;
        public float RadiusAlpha;
        public float GlossyAlpha;
        public Perturbation Perturbation;
        public uint TechniqueImages;
        public Separation Separation;
        public uint Reserved;
        public ulong FluxPaths;
        public Criterion TargetCriterion;
        public uint Reserved2;
        public ulong MemoryLimitBytes;
        public uint ThreadLimit;
        public Priority Priority;
        /// <summary>With the library's defaults.</summary>
        public static RenderDesc Create()
        {
            var d = new RenderDesc();
            Native.ups_render_desc_init(&d, (uint)sizeof(RenderDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Progress
    {
        public uint StructSize;
        public JobState State;
        public double ElapsedS;
        public double RemainingS;
        public uint IterationsDone;
        public float Fraction;
        public float WorstRelativeError;
        public float MedianRelativeError;
        internal static Progress Sized()
        {
            return new Progress { StructSize = (uint)sizeof(Progress) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ResultInfo
    {
        public uint StructSize;
        public uint Iterations;
        public double ElapsedS;
        public ulong Rays;
        public ulong LightPaths;
        public ulong EyePaths;
        public ulong Merges;
        public ulong Connections;
        public double EmittedFluxLm;
        public double AbsorbedFluxLm;
        public double EscapedFluxLm;
        public ulong Seed;
        public ulong DroppedSamples;
        public Method Method;
        public uint Techniques;
        public uint Effects;
        public int Threads;
        public double FluxBalanceStandardErrorLm;
        public double MaintenanceFactor;
        public ulong Revision;
        internal static ResultInfo Sized()
        {
            return new ResultInfo { StructSize = (uint)sizeof(ResultInfo) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MeterReading
    {
        public float IlluminanceLx;
        public float StandardErrorLx;
        public float BiasLx;
        public float ErrorBoundLx;
        public float DirectLx;
        public float IndirectLx;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct VectorReading
    {
        public Float3 VectorLx;
        public Float3 StandardErrorLx;
        public Float3 ErrorBoundLx;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MeterPartReading
    {
        public float IlluminanceLx;
        public float StandardErrorLx;
        public float BiasLx;
        public float ErrorBoundLx;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct VectorPartReading
    {
        public Float3 VectorLx;
        public Float3 StandardErrorLx;
        public Float3 BiasLx;
        public Float3 ErrorBoundLx;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ConvergencePoint
    {
        public double ElapsedS;
        public uint Iterations;
        public uint Reserved;
        public float MedianRelativeError;
        public float P95RelativeError;
        public float WorstRelativeError;
        public float BiasShare;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MeterStatistics
    {
        public uint StructSize;
        public uint Count;
        public double MeanLx;
        public double MinLx;
        public double MaxLx;
        public double Uniformity;
        public double MeanStandardErrorLx;
        public double MedianRelativeErrorBound;
        public double P95RelativeErrorBound;
        public double WorstRelativeErrorBound;
        public double MeanBiasLx;
        public double MeanErrorBoundLx;
        public double MinLowLx;
        public double MinHighLx;
        public double MaxLowLx;
        public double MaxHighLx;
        public double UniformityLow;
        public double UniformityHigh;
        public double Percentile5Lx;
        public double Percentile5LowLx;
        public double Percentile5HighLx;
        public double Diversity;
        public double DiversityLow;
        public double DiversityHigh;
        internal static MeterStatistics Sized()
        {
            return new MeterStatistics { StructSize = (uint)sizeof(MeterStatistics) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct CurvePoint
    {
        public uint StructSize;
        public uint Iterations;
        public double ElapsedS;
        public float MedianRelativeError;
        public float P95RelativeError;
        public float WorstRelativeError;
        public float MeanRelativeError;
        public float BiasShare;
        public uint Reserved;
        public ulong Rays;
        public ulong LightPaths;
        public ulong EyePaths;
        public ulong ResidentBytes;
        internal static CurvePoint Sized()
        {
            return new CurvePoint { StructSize = (uint)sizeof(CurvePoint) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Prediction
    {
        public uint StructSize;
        public Limit LimitedBy;
        public double Seconds;
        public double SecondsLow;
        public double SecondsHigh;
        public double Iterations;
        internal static Prediction Sized()
        {
            return new Prediction { StructSize = (uint)sizeof(Prediction) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct LargestError
    {
        public uint StructSize;
        public SensorId Sensor;
        public uint Index;
        public float RelativeError;
        public float BiasShare;
        public uint Reserved;
        public Double3 PositionM;
        internal static LargestError Sized()
        {
            return new LargestError { StructSize = (uint)sizeof(LargestError) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MemoryEstimate
    {
        public uint StructSize;
        public uint Reserved;
        public ulong SceneBytes;
        public ulong WorkingBytes;
        public ulong LightBytes;
        public ulong ResultBytes;
        public ulong PeakBytes;
        public ulong AllowedBytes;
        internal static MemoryEstimate Sized()
        {
            return new MemoryEstimate { StructSize = (uint)sizeof(MemoryEstimate) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SensorChoice
    {
        public uint StructSize;
        public uint Techniques;
        public uint LightPathsPerIteration;
        public Photons Photons;
        public double PredictedGain;
        internal static SensorChoice Sized()
        {
            return new SensorChoice { StructSize = (uint)sizeof(SensorChoice) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SourceInfo
    {
        public uint StructSize;
        public SourceKind Kind;
        public uint Id;
        public uint Reserved;
        public double FluxLm;
        internal static SourceInfo Sized()
        {
            return new SourceInfo { StructSize = (uint)sizeof(SourceInfo) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SceneSource
    {
        public uint StructSize;
        public SourceKind Kind;
        public uint Id;
        public uint Group;
        public int LightKind;
        public uint Maintained;
        public double FluxLm;
        public Double12 ToWorld;
        public Double3 BoundsMinM;
        public Double3 BoundsMaxM;
        internal static SceneSource Sized()
        {
            return new SceneSource { StructSize = (uint)sizeof(SceneSource) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct GoniometerInfo
    {
        public uint StructSize;
        public uint CCount;
        public uint GammaCount;
        public uint Reserved;
        public double FluxLm;
        public double FluxStandardErrorLm;
        public double OutsideFluxLm;
        public double EmittedFluxLm;
        public double AbsorbedFluxLm;
        public double LightOutputRatio;
        public double LightOutputRatioStandardError;
        public double WorstRelativeErrorBound;
        public double MedianRelativeErrorBound;
        internal static GoniometerInfo Sized()
        {
            return new GoniometerInfo { StructSize = (uint)sizeof(GoniometerInfo) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct IntensityReading
    {
        public float IntensityCd;
        public float StandardErrorCd;
        public float BiasCd;
        public float ErrorBoundCd;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct GoniometerBeam
    {
        public uint StructSize;
        public float AngleDeg;
        public float StandardErrorDeg;
        public float BiasDeg;
        public float LowDeg;
        public float HighDeg;
        internal static GoniometerBeam Sized()
        {
            return new GoniometerBeam { StructSize = (uint)sizeof(GoniometerBeam) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct TechniqueInfo
    {
        public uint StructSize;
        public uint Technique;
        public uint LightVertices;
        public uint EyeVertices;
        public uint Edges;
        internal static TechniqueInfo Sized()
        {
            return new TechniqueInfo { StructSize = (uint)sizeof(TechniqueInfo) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Sample
    {
        public ulong Seed;
        public SensorId Sensor;
        public uint Index;
        public uint Iteration;
        public Walk Walk;
        public uint Path;
        public float Value;
        public float Share;
        public uint Reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct PathInfo
    {
        public uint StructSize;
        public uint Walks;
        public double Value;
        public uint Contributions;
        public uint Reserved;
        internal static PathInfo Sized()
        {
            return new PathInfo { StructSize = (uint)sizeof(PathInfo) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct PathVertex
    {
        public Double3 PositionM;
        public Float3 Normal;
        public float Throughput;
        public float Pdf;
        public float PdfReverse;
        public float Survival;
        public uint Walk;
        public InstanceId Instance;
        public PathEvent Event;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct PathContribution
    {
        public Double3 FromM;
        public Double3 ToM;
        public float Value;
        public float Weight;
        public uint Technique;
        public uint Edges;
        public uint LightVertices;
        public uint Walk;
        public uint LightPath;
        public SourceKind SourceKind;
        public uint Source;
        public uint Reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Interval
    {
        public double Value;
        public double Low;
        public double High;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct UgrTable
    {
        public uint StructSize;
        public float LampFluxLm;
        public Float19 RoomAcrossH;
        public Float19 RoomAlongH;
        public Float15 Reflectances;
        public Float95 Crosswise;
        public Float95 Endwise;
        internal static UgrTable Sized()
        {
            return new UgrTable { StructSize = (uint)sizeof(UgrTable) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct DataSheet
    {
        public uint StructSize;
        public Float5 FluxCode;
        public Float3 LuminanceCdM2;
        public float HighestLuminanceCdM2;
        public float HighestLuminanceCDeg;
        public float HighestLuminanceGammaDeg;
        public Float3 SpacingCriterion;
        public int NemaHorizontal;
        public int NemaVertical;
        public Float4 FrontLm;
        public Float4 BackLm;
        public Float2 UpLm;
        public int BacklightRating;
        public int UplightRating;
        public int GlareRating;
        public int BugTypeV;
        internal static DataSheet Sized()
        {
            return new DataSheet { StructSize = (uint)sizeof(DataSheet) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct UtilisationTable
    {
        public uint StructSize;
        public Float10 RoomIndex;
        public Float30 Reflectances;
        public Float100 Factors;
        internal static UtilisationTable Sized()
        {
            return new UtilisationTable { StructSize = (uint)sizeof(UtilisationTable) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ObserverDesc
    {
        public uint StructSize;
        public GlareMetric Metric;
        public PositionIndex PositionIndex;
        public float CeilingAreaM2;
        public Double12 ToWorld;
        /// <summary>With the library's defaults.</summary>
        public static ObserverDesc Create()
        {
            var d = new ObserverDesc();
            Native.ups_observer_desc_init(&d, (uint)sizeof(ObserverDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ObserverReading
    {
        public uint StructSize;
        public uint Flags;
        public float Ugr;
        public float UgrStandardError;
        public float UgrLow;
        public float UgrHigh;
        public float BackgroundCdM2;
        public float BackgroundStandardErrorCdM2;
        public float BackgroundErrorBoundCdM2;
        public uint SourceCount;
        public float CeilingCoverage;
        public float Ggr;
        public float GgrLow;
        public float GgrHigh;
        internal static ObserverReading Sized()
        {
            return new ObserverReading { StructSize = (uint)sizeof(ObserverReading) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct GlareSource
    {
        public uint StructSize;
        public SourceKind Kind;
        public uint Id;
        public uint Flags;
        public float LuminanceCdM2;
        public float SolidAngleSr;
        public float IntensityCd;
        public float DistanceM;
        public float VisibleShare;
        public float PositionIndex;
        public float Share;
        public Float3 Direction;
        internal static GlareSource Sized()
        {
            return new GlareSource { StructSize = (uint)sizeof(GlareSource) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct GltfImportDesc
    {
        public uint StructSize;
        public uint CameraWidth;
        public uint CameraHeight;
        public uint Reserved;
        public int AllowOutside;
        public uint CameraLayers;
        /// <summary>With the library's defaults.</summary>
        public static GltfImportDesc Create()
        {
            var d = new GltfImportDesc();
            Native.ups_gltf_import_desc_init(&d, (uint)sizeof(GltfImportDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct GltfSensorInfo
    {
        public uint StructSize;
        public GltfSensorKind Kind;
        public SensorId Sensor;
        public uint Width;
        public uint Height;
        public int Illuminance;
        public uint MeterCount;
        public uint Columns;
        public uint Rows;
        public uint Reserved;
        public GltfLayout Layout;
        public Float2 CellSizeM;
        public Float3 CellSide;
        public MeterKind MeterKind;
        public Projection Projection;
        public uint Layers;
        internal static GltfSensorInfo Sized()
        {
            return new GltfSensorInfo { StructSize = (uint)sizeof(GltfSensorInfo) };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ExrChannel
    {
        internal byte* Name;
        internal float* Data;
        public UIntPtr PixelStrideBytes;
        public UIntPtr RowStrideBytes;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ExrAttribute
    {
        internal byte* Name;
        internal byte* Value;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct OcioPictureDesc
    {
        public uint StructSize;
        public uint Width;
        public uint Height;
        public int Smoothed;
        internal float* LuminanceRgb;
        public double Exposure;
        public int ExposureChosen;
        public uint Reserved;
        /// <summary>With the library's defaults.</summary>
        public static OcioPictureDesc Create()
        {
            var d = new OcioPictureDesc();
            Native.ups_ocio_picture_desc_init(&d, (uint)sizeof(OcioPictureDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct OcioSmoothDesc
    {
        public uint StructSize;
        public uint Width;
        public uint Height;
        public uint Reserved;
        internal float* LuminanceRgb;
        internal float* StandardErrorRgb;
        internal float* AlbedoRgb;
        internal float* Normal;
        internal float* Depth;
        /// <summary>With the library's defaults.</summary>
        public static OcioSmoothDesc Create()
        {
            var d = new OcioSmoothDesc();
            Native.ups_ocio_smooth_desc_init(&d, (uint)sizeof(OcioSmoothDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct OcioFalseColorDesc
    {
        public uint StructSize;
        public uint Columns;
        public uint Rows;
        public int FirstRowAtBottom;
        internal float* Values;
        internal byte* Title;
        internal byte* Unit;
        public double ScaleMin;
        public double ScaleMax;
        /// <summary>With the library's defaults.</summary>
        public static OcioFalseColorDesc Create()
        {
            var d = new OcioFalseColorDesc();
            Native.ups_ocio_false_color_desc_init(&d, (uint)sizeof(OcioFalseColorDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ReportStyleDesc
    {
        public uint StructSize;
        public ReportScale Scale;
        public ReportColours Colours;
        public int Isolines;
        public int Numbers;
        public int Cells;
        public double Low;
        public double High;
        public double ThresholdLx;
        public double ThresholdCdM2;
        public double Width;
        public double Height;
        public double Zoom;
        /// <summary>With the library's defaults.</summary>
        public static ReportStyleDesc Create()
        {
            var d = new ReportStyleDesc();
            Native.ups_report_style_desc_init(&d, (uint)sizeof(ReportStyleDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ReportSensor
    {
        public SensorId Sensor;
        public uint Reserved;
        internal byte* Name;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ReportMapDesc
    {
        public uint StructSize;
        public ReportQuantity Quantity;
        internal IntPtr Scene;
        internal IntPtr Result;
        public SensorId Sensor;
        public uint SensorCount;
        internal ReportSensor* Sensors;
        internal byte* Title;
        internal ReportStyleDesc* Style;
        internal double* PositionsM;
        internal float* Normals;
        internal float* Values;
        internal float* ErrorBounds;
        public uint Count;
        public uint Columns;
        /// <summary>With the library's defaults.</summary>
        public static ReportMapDesc Create()
        {
            var d = new ReportMapDesc();
            Native.ups_report_map_desc_init(&d, (uint)sizeof(ReportMapDesc));
            return d;
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ReportSource
    {
        public SourceKind Kind;
        public uint Id;
        internal byte* Name;
        internal byte* File;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ReportPicture
    {
        public SensorId Camera;
        public ReportExposure Exposure;
        public double Ev100;
        public int Smoothed;
        public uint Reserved;
        internal byte* Path;
        internal byte* Png;
        public UIntPtr PngSize;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ReportRatio
    {
        public SensorId Numerator;
        public SensorId Denominator;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ReportPageDesc
    {
        public uint StructSize;
        public uint SensorCount;
        public uint SourceCount;
        public uint PictureCount;
        public uint ThresholdCount;
        public uint RatioCount;
        internal IntPtr Scene;
        internal IntPtr Result;
        internal ReportSensor* Sensors;
        internal ReportSource* Sources;
        internal ReportPicture* Pictures;
        internal byte* Title;
        internal byte* SceneName;
        internal byte* Repeat;
        internal byte* Date;
        internal byte* TargetsJson;
        internal byte* TargetsName;
        internal byte* TargetsFolder;
        internal ReportStyleDesc* Style;
        internal double* ThresholdsLx;
        internal ReportRatio* Ratios;
        public double TargetRelativeError;
        /// <summary>With the library's defaults.</summary>
        public static ReportPageDesc Create()
        {
            var d = new ReportPageDesc();
            Native.ups_report_page_desc_init(&d, (uint)sizeof(ReportPageDesc));
            return d;
        }
    }

    public sealed class ContextHandle : NativeHandle
    {
        protected override bool ReleaseHandle() { Native.ups_context_destroy(handle); return true; }
    }

    public sealed class ProfileHandle : NativeHandle
    {
        protected override bool ReleaseHandle() { Native.ups_profile_destroy(handle); return true; }
    }

    public sealed class SceneHandle : NativeHandle
    {
        protected override bool ReleaseHandle() { Native.ups_scene_destroy(handle); return true; }
    }

    public sealed class JobHandle : NativeHandle
    {
        protected override bool ReleaseHandle() { Native.ups_job_destroy(handle); return true; }
    }

    public sealed class ResultHandle : NativeHandle
    {
        protected override bool ReleaseHandle() { Native.ups_result_destroy(handle); return true; }
    }

    public sealed class FixtureHandle : NativeHandle
    {
        protected override bool ReleaseHandle() { Native.ups_fixture_destroy(handle); return true; }
    }

    public sealed class PathHandle : NativeHandle
    {
        protected override bool ReleaseHandle() { Native.ups_path_destroy(handle); return true; }
    }

    public sealed class GltfImportHandle : NativeHandle
    {
        protected override bool ReleaseHandle() { Native.ups_gltf_import_destroy(handle); return true; }
    }

    public sealed class ExrImageHandle : NativeHandle
    {
        protected override bool ReleaseHandle() { Native.ups_exr_image_destroy(handle); return true; }
    }

    internal static unsafe class Native
    {
        private const string Library = "libups.so.0.1";
        private const string GltfLibrary = "libups_gltf.so.0.1";
        private const string ExrLibrary = "libups_exr.so.0.1";
        private const string OcioLibrary = "libups_ocio.so.0.1";
        private const string ReportLibrary = "libups_report.so.0.1";
        internal const uint HeaderVersion = 100;

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern uint ups_version();
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern IntPtr ups_status_name(Status status);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern IntPtr ups_last_error();
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_context_desc_init(ContextDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_context_create(ContextDesc* desc, out ContextHandle @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_context_destroy(IntPtr context);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_context_get_thread_count(ContextHandle context, int* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_context_pop_log(ContextHandle context, byte* text, UIntPtr capacity, UIntPtr*
            needed, LogLevel* level);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_profile_desc_init(ProfileDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_create(ContextHandle context, ProfileDesc* desc, out ProfileHandle
            @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_parse(ContextHandle context, void* bytes, UIntPtr size, ProfileFormat
            format, out ProfileHandle @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_profile_parse_desc_init(ProfileParseDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_parse_with(ContextHandle context, ProfileParseDesc* desc, out
            ProfileHandle @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_write(ProfileHandle profile, ProfileFormat format, byte* bytes,
            UIntPtr capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_get_write_warnings(ProfileHandle profile, ProfileFormat format, byte*
            text, UIntPtr capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_get_info(ProfileHandle profile, ProfileInfo* info);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_get_lamp_set(ProfileHandle profile, uint index, ProfileLampSet* set);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_get_text(ProfileHandle profile, ProfileText topic, byte* text, UIntPtr
            capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_get_keyword(ProfileHandle profile, byte* name, byte* text, UIntPtr
            capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_with_keyword(ProfileHandle profile, byte* name, byte* value, out
            ProfileHandle @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_eval(ProfileHandle profile, float* directions_xyz, UIntPtr count,
            float* intensity_cd);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_get_luminance(ProfileHandle profile, float* directions_xyz, UIntPtr
            count, float* luminance_cd_m2);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_get_zonal_flux(ProfileHandle profile, float* gamma_deg, UIntPtr count,
            double* flux_lm);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_get_beam(ProfileHandle profile, float c_deg, float fraction,
            ProfileBeam* beam);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_profile_destroy(IntPtr profile);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_texture_desc_init(TextureDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_material_desc_init(MaterialDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_mesh_desc_init(MeshDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_instance_desc_init(InstanceDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_light_desc_init(LightDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_luminaire_desc_init(LuminaireDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_create(ContextHandle context, out SceneHandle @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_scene_destroy(IntPtr scene);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_texture(SceneHandle scene, TextureDesc* desc, TextureId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_material(SceneHandle scene, MaterialDesc* desc, MaterialId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_mesh(SceneHandle scene, MeshDesc* desc, MeshId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_instance(SceneHandle scene, InstanceDesc* desc, InstanceId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_light(SceneHandle scene, LightDesc* desc, LuminaireId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_luminaire(SceneHandle scene, LuminaireDesc* desc, LuminaireId*
            @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_texture(SceneHandle scene, TextureId id, TextureDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_material(SceneHandle scene, MaterialId id, MaterialDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_mesh(SceneHandle scene, MeshId id, MeshDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_mesh_vertices(SceneHandle scene, MeshId id, float* positions_m,
            float* normals, uint vertex_count);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_instance(SceneHandle scene, InstanceId id, InstanceDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_transform(SceneHandle scene, InstanceId id, double* to_world);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_light(SceneHandle scene, LuminaireId id, LightDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_luminaire(SceneHandle scene, LuminaireId id, LuminaireDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_luminaire_transform(SceneHandle scene, LuminaireId id, double*
            to_world);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_dimming(SceneHandle scene, LuminaireId id, float dimming);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_maintenance_factor(SceneHandle scene, double factor);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_texture(SceneHandle scene, TextureId id, TextureDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_read_texture(SceneHandle scene, TextureId id, float* texels, UIntPtr
            capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_material(SceneHandle scene, MaterialId id, MaterialDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_mesh(SceneHandle scene, MeshId id, MeshDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_instance(SceneHandle scene, InstanceId id, InstanceDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_light(SceneHandle scene, LuminaireId id, LightDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_luminaire(SceneHandle scene, LuminaireId id, LuminaireDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_luminaire_profile(SceneHandle scene, LuminaireId id, out
            ProfileHandle @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_dimming(SceneHandle scene, LuminaireId id, float* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_maintenance_factor(SceneHandle scene, double* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_remove_texture(SceneHandle scene, TextureId id);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_remove_material(SceneHandle scene, MaterialId id);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_remove_mesh(SceneHandle scene, MeshId id);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_remove_instance(SceneHandle scene, InstanceId id);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_remove_luminaire(SceneHandle scene, LuminaireId id);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_remove_sensor(SceneHandle scene, SensorId id);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_commit(SceneHandle scene);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_start_commit(SceneHandle scene, out JobHandle @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_commit_desc_init(CommitDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_start_commit_with(SceneHandle scene, CommitDesc* desc, out JobHandle
            @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_is_dirty(SceneHandle scene, int* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_info(SceneHandle scene, SceneInfo* info);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_text(SceneHandle scene, SceneText topic, byte* text, UIntPtr
            capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_read_section(SceneHandle scene, double* point_m, double* normal,
            Segment* segments, UIntPtr capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_read_outlines(SceneHandle scene, double* point_m, double* normal, double
            depth_m, Segment* segments, UIntPtr capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_fixture_emitter_desc_init(FixtureEmitterDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_reflector_desc_init(ReflectorDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_lens_desc_init(LensDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_collimator_desc_init(CollimatorDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_fixture_part_desc_init(FixturePartDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_fixture_instance_desc_init(FixtureInstanceDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_fixture_create(ContextHandle context, out FixtureHandle @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_fixture_destroy(IntPtr fixture);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_fixture_add_emitter(FixtureHandle fixture, FixtureEmitterDesc* desc,
            FixturePartId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_fixture_add_reflector(FixtureHandle fixture, ReflectorDesc* desc,
            FixturePartId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_fixture_add_lens(FixtureHandle fixture, LensDesc* desc, FixturePartId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_fixture_add_collimator(FixtureHandle fixture, CollimatorDesc* desc,
            FixturePartId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_fixture_add_part(FixtureHandle fixture, FixturePartDesc* desc, FixturePartId*
            @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_fixture_get_info(FixtureHandle fixture, FixtureInfo* info);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_fixture(SceneHandle scene, FixtureHandle fixture,
            FixtureInstanceDesc* desc, FixtureId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_fixture_instance(SceneHandle scene, FixtureId id, FixturePartId
            part, InstanceId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_fixture(SceneHandle scene, FixtureId id, FixtureInstanceDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_fixture(SceneHandle scene, FixtureId id, FixtureInstanceDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_fixture_dimming(SceneHandle scene, FixtureId id, float dimming);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_fixture_transform(SceneHandle scene, FixtureId id, double*
            to_world);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_remove_fixture(SceneHandle scene, FixtureId id);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_camera_desc_init(CameraDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_meter_desc_init(MeterDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_surface_meters_desc_init(SurfaceMetersDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_lightmap_desc_init(LightmapDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_camera(SceneHandle scene, CameraDesc* desc, SensorId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_meters(SceneHandle scene, MeterDesc* desc, SensorId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_surface_meters(SceneHandle scene, SurfaceMetersDesc* desc, SensorId*
            @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_lightmap(SceneHandle scene, LightmapDesc* desc, SensorId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_camera(SceneHandle scene, SensorId id, CameraDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_meters(SceneHandle scene, SensorId id, MeterDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_surface_meters(SceneHandle scene, SensorId id, SurfaceMetersDesc*
            desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_lightmap(SceneHandle scene, SensorId id, LightmapDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_goniometer(SceneHandle scene, SensorId id, GoniometerDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_camera(SceneHandle scene, SensorId id, CameraDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_meters(SceneHandle scene, SensorId id, MeterDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_surface_meters(SceneHandle scene, SensorId id, SurfaceMetersDesc*
            desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_lightmap(SceneHandle scene, SensorId id, LightmapDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_goniometer(SceneHandle scene, SensorId id, GoniometerDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_read_meter_places(SceneHandle scene, SensorId meters, MeterPlace*
            places, UIntPtr capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_en12464_desc_init(En12464Desc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_en12464_grid(En12464Desc* desc, En12464Info* info, En12464Point* points,
            UIntPtr capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_goniometer_desc_init(GoniometerDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_goniometer(SceneHandle scene, GoniometerDesc* desc, SensorId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_render_desc_init(RenderDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_estimate_memory(SceneHandle scene, RenderDesc* desc, MemoryEstimate*
            @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_render(SceneHandle scene, RenderDesc* desc, out ResultHandle @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_job_start(SceneHandle scene, RenderDesc* desc, out JobHandle @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_job_poll(JobHandle job, Progress* progress);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_job_wait(JobHandle job, uint timeout_ms);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_job_get_prediction(JobHandle job, double relative_error, Prediction*
            prediction);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_job_get_memory_estimate(JobHandle job, MemoryEstimate* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_job_get_curve_count(JobHandle job, uint* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_job_get_curve_point(JobHandle job, uint index, CurvePoint* point);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_job_get_largest_error(JobHandle job, LargestError* error);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_job_cancel(JobHandle job);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_job_result(JobHandle job, out ResultHandle @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_job_destroy(IntPtr job);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_info(ResultHandle result, ResultInfo* info);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_choice(ResultHandle result, SensorId sensor, SensorChoice* choice);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_read_meters(ResultHandle result, SensorId sensor, MeterReading* @out,
            UIntPtr count);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_view_meters(ResultHandle result, SensorId sensor, MeterReading**
            readings, UIntPtr* count);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_read_vectors(ResultHandle result, SensorId sensor, VectorReading* @out,
            UIntPtr count);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_read_meter_part(ResultHandle result, SensorId sensor, LightPart part,
            MeterPartReading* @out, UIntPtr count);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_read_vector_part(ResultHandle result, SensorId sensor, LightPart part,
            VectorPartReading* @out, UIntPtr count);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_read_meter_flags(ResultHandle result, SensorId sensor, uint* @out,
            UIntPtr count);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_meter_statistics(ResultHandle result, SensorId sensor,
            MeterStatistics* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_source_count(ResultHandle result, uint* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_source(ResultHandle result, uint index, SourceInfo* info);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_read_source_meters(ResultHandle result, uint source, SensorId sensor,
            MeterReading* @out, UIntPtr count);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_source_count(SceneHandle scene, uint* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_source(SceneHandle scene, uint index, SceneSource* source);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_source_profile(SceneHandle scene, uint index, out ProfileHandle
            @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_goniometer_info(ResultHandle result, SensorId sensor,
            GoniometerInfo* info);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_read_goniometer(ResultHandle result, SensorId sensor, IntensityReading*
            @out, UIntPtr count);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_goniometer_angles(ResultHandle result, SensorId sensor, float*
            c_deg, UIntPtr c_count, float* gamma_deg, UIntPtr gamma_count);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_goniometer_beam(ResultHandle result, SensorId sensor, float c_deg,
            float fraction, GoniometerBeam* beam);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_goniometer_profile(ResultHandle result, SensorId sensor, out
            ProfileHandle @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_read_image(ResultHandle result, SensorId camera, Channel channel,
            float* @out, UIntPtr row_stride_bytes, UIntPtr size_bytes);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_view_image(ResultHandle result, SensorId camera, Channel channel,
            float** pixels, uint* width, uint* height);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_technique_count(ResultHandle result, SensorId camera, uint* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_technique(ResultHandle result, SensorId camera, uint index,
            TechniqueInfo* info);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_read_technique(ResultHandle result, SensorId camera, uint index,
            Contribution contribution, float* @out, UIntPtr row_stride_bytes, UIntPtr size_bytes);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_read_convergence(ResultHandle result, ConvergencePoint* points, UIntPtr
            capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_prediction(ResultHandle result, double relative_error, Prediction*
            prediction);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_curve_count(ResultHandle result, uint* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_curve_point(ResultHandle result, uint index, CurvePoint* point);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_largest_error(ResultHandle result, LargestError* error);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_text(ResultHandle result, ResultText topic, byte* text, UIntPtr
            capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_result_destroy(IntPtr result);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_read_largest_samples(ResultHandle result, SensorId sensor, Sample*
            samples, UIntPtr capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_replay(SceneHandle scene, RenderDesc* desc, Sample* sample, out PathHandle
            @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_path_destroy(IntPtr path);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_path_get_info(PathHandle path, PathInfo* info);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_path_read_vertices(PathHandle path, PathVertex* vertices, UIntPtr capacity,
            UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_path_read_contributions(PathHandle path, PathContribution* contributions,
            UIntPtr capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_path_get_text(PathHandle path, byte* text, UIntPtr capacity, UIntPtr* needed);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_meter_percentile(ResultHandle result, SensorId sensor, double
            share, Interval* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_meter_share(ResultHandle result, SensorId sensor, double
            threshold_lx, Interval* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_meter_ratio(ResultHandle result, SensorId numerator, SensorId
            denominator, Interval* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_read_meter_ratios(ResultHandle result, SensorId numerator, SensorId
            denominator, Interval* @out, UIntPtr count);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_glare_get_position_index(PositionIndex kind, float* directions_xyz, UIntPtr
            count, float* index);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_glare_get_ugr(float* luminance_cd_m2, float* solid_angle_sr, float*
            position_index, UIntPtr count, double background_cd_m2, float* ugr);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_get_ugr_table(ProfileHandle profile, UgrTable* table);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_get_data_sheet(ProfileHandle profile, float front_c_deg, DataSheet*
            sheet);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_profile_get_utilisation(ProfileHandle profile, UtilisationTable* table);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_observer_desc_init(ObserverDesc* desc, uint struct_size);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_add_observer(SceneHandle scene, ObserverDesc* desc, SensorId* @out);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_set_observer(SceneHandle scene, SensorId id, ObserverDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_scene_get_observer(SceneHandle scene, SensorId id, ObserverDesc* desc);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_observer(ResultHandle result, SensorId observer, ObserverReading*
            reading);
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_result_get_glare_source(ResultHandle result, SensorId observer, uint index,
            GlareSource* source);
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_gltf_import_desc_init(GltfImportDesc* desc, uint struct_size);
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_gltf_import_file(ContextHandle context, byte* path, GltfImportDesc* desc,
            SceneHandle scene, out GltfImportHandle @out);
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_gltf_import_destroy(IntPtr import_result);
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_gltf_get_sensor_count(GltfImportHandle import_result, uint* @out);
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_gltf_get_sensor(GltfImportHandle import_result, uint index, GltfSensorInfo*
            info);
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_gltf_get_sensor_name(GltfImportHandle import_result, uint index, byte* text,
            UIntPtr capacity, UIntPtr* needed);
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_gltf_get_source_name(GltfImportHandle import_result, SourceKind kind, uint id,
            byte* text, UIntPtr capacity, UIntPtr* needed);
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_gltf_get_source_file(GltfImportHandle import_result, SourceKind kind, uint id,
            byte* text, UIntPtr capacity, UIntPtr* needed);
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_gltf_get_place(GltfImportHandle import_result, GltfPart part, uint id, byte*
            text, UIntPtr capacity, UIntPtr* needed);
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_gltf_read_meters(GltfImportHandle import_result, uint index, double*
            positions_m, float* normals, UIntPtr count);
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_gltf_get_warnings(GltfImportHandle import_result, byte* text, UIntPtr
            capacity, UIntPtr* needed);
        [DllImport(GltfLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern IntPtr ups_gltf_last_error();
        [DllImport(ExrLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_exr_write(byte* path, uint width, uint height, ExrChannel* channels, uint
            channel_count, ExrAttribute* attributes, uint attribute_count);
        [DllImport(ExrLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_exr_read(byte* path, out ExrImageHandle @out);
        [DllImport(ExrLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_exr_image_destroy(IntPtr image);
        [DllImport(ExrLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_exr_get_size(ExrImageHandle image, uint* width, uint* height);
        [DllImport(ExrLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_exr_get_channel_count(ExrImageHandle image, uint* @out);
        [DllImport(ExrLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_exr_get_channel_name(ExrImageHandle image, uint index, byte* text, UIntPtr
            capacity, UIntPtr* needed);
        [DllImport(ExrLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_exr_get_attribute(ExrImageHandle image, byte* name, byte* text, UIntPtr
            capacity, UIntPtr* needed);
        [DllImport(ExrLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_exr_read_channel(ExrImageHandle image, byte* name, float* @out, UIntPtr
            count);
        [DllImport(ExrLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern IntPtr ups_exr_last_error();
        [DllImport(OcioLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_ocio_choose_exposure(float* luminance_rgb, uint width, uint height, double*
            @out);
        [DllImport(OcioLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_ocio_get_ev100(double exposure, double* @out);
        [DllImport(OcioLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_ocio_get_exposure(double ev100, double* @out);
        [DllImport(OcioLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_ocio_write_png(byte* path, float* luminance_rgb, uint width, uint height,
            double exposure);
        [DllImport(OcioLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_ocio_picture_desc_init(OcioPictureDesc* desc, uint struct_size);
        [DllImport(OcioLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_ocio_write_picture_png(byte* path, OcioPictureDesc* desc);
        [DllImport(OcioLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_ocio_smooth_desc_init(OcioSmoothDesc* desc, uint struct_size);
        [DllImport(OcioLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_ocio_smooth(OcioSmoothDesc* desc, float* out_rgb);
        [DllImport(OcioLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_ocio_false_color_desc_init(OcioFalseColorDesc* desc, uint struct_size);
        [DllImport(OcioLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_ocio_write_false_color_png(byte* path, OcioFalseColorDesc* desc);
        [DllImport(OcioLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_ocio_write_pixels_png(byte* path, byte* rgb, uint width, uint height);
        [DllImport(OcioLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern IntPtr ups_ocio_last_error();
        [DllImport(ReportLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_report_style_desc_init(ReportStyleDesc* desc, uint struct_size);
        [DllImport(ReportLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_report_map_desc_init(ReportMapDesc* desc, uint struct_size);
        [DllImport(ReportLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_report_write_map(byte* path, ReportMapDesc* desc);
        [DllImport(ReportLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ups_report_page_desc_init(ReportPageDesc* desc, uint struct_size);
        [DllImport(ReportLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ups_report_write_page(byte* path, ReportPageDesc* desc);
        [DllImport(ReportLibrary, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern IntPtr ups_report_last_error();
    }
}
