// UPS for C#: what has a render found: readings of meters and observers, statistics, sources apart, what it cost.
// Programs use Result, which Scene and Job make; Ups.Images.cs has images and distributions. See Ups.cs.
using System;

namespace Ups
{
    /// <summary>What a render has found so far; immutable.</summary>
    public sealed unsafe partial class Result : IDisposable
    {
        internal readonly ResultHandle Handle;

        internal Result(ResultHandle handle) { Handle = handle; }

        public ResultInfo Info
        {
            get
            {
                var info = ResultInfo.Sized();
                Library.Check(Native.ups_result_get_info(Handle, &info));
                return info;
            }
        }

        /// <summary>How the light of a camera, a meter set or a goniometer is found.</summary>
        public SensorChoice Choice(SensorId sensor)
        {
            var choice = SensorChoice.Sized();
            Library.Check(Native.ups_result_get_choice(Handle, sensor, &choice));
            return choice;
        }

        /// <summary>Light that no path has found, or few, has standard error -1 beside a positive bound; both are -1
        /// where nothing is known yet.</summary>
        public MeterReading[] Meters(SensorId sensor)
        {
            var readings = new MeterReading[MeterCount(sensor)];
            ReadMeters(sensor, readings);
            return readings;
        }

        private ulong MeterCount(SensorId sensor)
        {
            MeterReading* readings;
            UIntPtr count;
            Library.Check(Native.ups_result_view_meters(Handle, sensor, &readings, &count));
            return (ulong)count;
        }

        /// <summary>The same into memory of the caller's, one element a meter.</summary>
        public void ReadMeters(SensorId sensor, Span<MeterReading> readings)
        {
            fixed (MeterReading* r = readings)
                Library.Check(Native.ups_result_read_meters(Handle, sensor, r, (UIntPtr)readings.Length));
        }

        /// <summary>Direct or indirect light of each meter, with errors of its own.</summary>
        public MeterPartReading[] MeterPart(SensorId sensor, LightPart part)
        {
            var readings = new MeterPartReading[MeterCount(sensor)];
            ReadMeterPart(sensor, part, readings);
            return readings;
        }

        public void ReadMeterPart(SensorId sensor, LightPart part, Span<MeterPartReading> readings)
        {
            fixed (MeterPartReading* r = readings)
                Library.Check(Native.ups_result_read_meter_part(Handle, sensor, part, r, (UIntPtr)readings.Length));
        }

        /// <summary>Of meters of kind MeterKind.Vector: three components, x, y and z of the world, with their errors.
        /// Meters() has the vectors' lengths.</summary>
        public VectorReading[] Vectors(SensorId sensor)
        {
            var readings = new VectorReading[MeterCount(sensor)];
            ReadVectors(sensor, readings);
            return readings;
        }

        public void ReadVectors(SensorId sensor, Span<VectorReading> readings)
        {
            fixed (VectorReading* r = readings)
                Library.Check(Native.ups_result_read_vectors(Handle, sensor, r, (UIntPtr)readings.Length));
        }

        /// <summary>As Vectors, of direct, indirect or all light, with the bias besides.</summary>
        public VectorPartReading[] VectorPart(SensorId sensor, LightPart part)
        {
            var readings = new VectorPartReading[MeterCount(sensor)];
            ReadVectorPart(sensor, part, readings);
            return readings;
        }

        public void ReadVectorPart(SensorId sensor, LightPart part, Span<VectorPartReading> readings)
        {
            fixed (VectorPartReading* r = readings)
                Library.Check(Native.ups_result_read_vector_part(Handle, sensor, part, r, (UIntPtr)readings.Length));
        }

        /// <summary>Of each meter: is its reading exact, hardly found, its interval unreliable?</summary>
        public Reading[] MeterFlags(SensorId sensor)
        {
            var flags = new Reading[MeterCount(sensor)];
            ReadMeterFlags(sensor, flags);
            return flags;
        }

        public void ReadMeterFlags(SensorId sensor, Span<Reading> flags)
        {
            fixed (Reading* f = flags)
                Library.Check(Native.ups_result_read_meter_flags(Handle, sensor, (uint*)f, (UIntPtr)flags.Length));
        }

        public MeterStatistics Statistics(SensorId sensor)
        {
            var statistics = MeterStatistics.Sized();
            Library.Check(Native.ups_result_get_meter_statistics(Handle, sensor, &statistics));
            return statistics;
        }

        /// <summary>lx: `share` (0 to 1) of the meters are below. 0.5: the median.</summary>
        public Interval Percentile(SensorId sensor, double share)
        {
            Interval interval;
            Library.Check(Native.ups_result_get_meter_percentile(Handle, sensor, share, &interval));
            return interval;
        }

        /// <summary>0 to 1: of the meters with at least so much.</summary>
        public Interval ShareAbove(SensorId sensor, double thresholdLx)
        {
            Interval interval;
            Library.Check(Native.ups_result_get_meter_share(Handle, sensor, thresholdLx, &interval));
            return interval;
        }

        /// <summary>The mean of one set of meters over that of another; -1 where it is not known.</summary>
        public Interval Ratio(SensorId numerator, SensorId denominator)
        {
            Interval interval;
            Library.Check(Native.ups_result_get_meter_ratio(Handle, numerator, denominator, &interval));
            return interval;
        }

        /// <summary>Meter by meter; of cylindrical ones over horizontal ones at the same places: the modelling
        /// index.</summary>
        public Interval[] Ratios(SensorId numerator, SensorId denominator)
        {
            var ratios = new Interval[MeterCount(numerator)];
            fixed (Interval* r = ratios)
                Library.Check(Native.ups_result_read_meter_ratios(Handle, numerator, denominator, r,
                    (UIntPtr)ratios.Length));
            return ratios;
        }

        /// <summary>What RenderDesc.Separation tells apart: kind, id (of a luminaire or instance, or the group), flux;
        /// else none.</summary>
        public SourceInfo[] Sources()
        {
            uint count;
            Library.Check(Native.ups_result_get_source_count(Handle, &count));
            var all = new SourceInfo[count];
            for (uint i = 0; i < count; ++i)
            {
                var info = SourceInfo.Sized();
                Library.Check(Native.ups_result_get_source(Handle, i, &info));
                all[i] = info;
            }
            return all;
        }

        /// <summary>What each source, in the order of Sources(), contributes to each meter: [source][meter]. Over the
        /// sources they add up to Meters().</summary>
        public MeterReading[][] SourceMeters(SensorId sensor)
        {
            uint count;
            Library.Check(Native.ups_result_get_source_count(Handle, &count));
            var all = new MeterReading[count][];
            for (uint i = 0; i < count; ++i)
            {
                all[i] = new MeterReading[MeterCount(sensor)];
                ReadSourceMeters(i, sensor, all[i]);
            }
            return all;
        }

        /// <summary>Of one source alone, into memory of the caller's.</summary>
        public void ReadSourceMeters(uint source, SensorId sensor, Span<MeterReading> readings)
        {
            fixed (MeterReading* r = readings)
                Library.Check(Native.ups_result_read_source_meters(Handle, source, sensor, r,
                                                                   (UIntPtr)readings.Length));
        }

        /// <summary>UGR with its error and background.</summary>
        public ObserverReading Observer(SensorId sensor)
        {
            var reading = ObserverReading.Sized();
            Library.Check(Native.ups_result_get_observer(Handle, sensor, &reading));
            return reading;
        }

        /// <summary>The sources of an observer's rating, the worst first.</summary>
        public GlareSource[] GlareSources(SensorId sensor)
        {
            var all = new GlareSource[Observer(sensor).SourceCount];
            for (uint i = 0; i < all.Length; ++i)
            {
                var source = GlareSource.Sized();
                Library.Check(Native.ups_result_get_glare_source(Handle, sensor, i, &source));
                all[i] = source;
            }
            return all;
        }

        /// <summary>As Job.Predict.</summary>
        public Prediction Predict(double relativeError)
        {
            var prediction = Prediction.Sized();
            Library.Check(Native.ups_result_get_prediction(Handle, relativeError, &prediction));
            return prediction;
        }

        /// <summary>What accuracy cost: each look at the error.</summary>
        public CurvePoint[] Curve()
        {
            uint count;
            Library.Check(Native.ups_result_get_curve_count(Handle, &count));
            var all = new CurvePoint[count];
            for (uint i = 0; i < count; ++i)
            {
                var point = CurvePoint.Sized();
                Library.Check(Native.ups_result_get_curve_point(Handle, i, &point));
                all[i] = point;
            }
            return all;
        }

        /// <summary>The meter that had it at the last look.</summary>
        public LargestError LargestError()
        {
            var error = Ups.LargestError.Sized();
            Library.Check(Native.ups_result_get_largest_error(Handle, &error));
            return error;
        }

        /// <summary>The part of Curve() that there has always been.</summary>
        public ConvergencePoint[] Convergence()
        {
            UIntPtr needed;
            Library.Check(Native.ups_result_read_convergence(Handle, null, UIntPtr.Zero, &needed));
            var points = new ConvergencePoint[(int)needed];
            fixed (ConvergencePoint* p = points)
                Library.Check(Native.ups_result_read_convergence(Handle, p, needed, &needed));
            return points;
        }

        /// <summary>The samples that weigh most in a camera's image or a set of meters, the largest share first.
        /// Scene.Replay traces one of them again.</summary>
        public Sample[] LargestSamples(SensorId sensor)
        {
            UIntPtr needed;
            Library.Check(Native.ups_result_read_largest_samples(Handle, sensor, null, UIntPtr.Zero, &needed));
            var samples = new Sample[(int)needed];
            fixed (Sample* s = samples)
                Library.Check(Native.ups_result_read_largest_samples(Handle, sensor, s, needed, &needed));
            return samples;
        }

        public string Text(ResultText topic)
        {
            return Library.Text((p, capacity, needed) =>
                Native.ups_result_get_text(Handle, topic, p, capacity, needed));
        }

        public void Dispose() { Handle.Dispose(); }
    }
}
