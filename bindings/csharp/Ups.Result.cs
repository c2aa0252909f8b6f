// UPS for C#: what has a render found: jobs that are watched, readings, images, sources apart, distributions.
// Programs use Job and Result, which Scene makes; see Ups.cs.
using System;

namespace Ups
{
    /// <summary>A render on the library's own threads; any thread may call. Disposing of it cancels it.</summary>
    public sealed unsafe class Job : IDisposable
    {
        internal readonly JobHandle Handle;

        internal Job(JobHandle handle) { Handle = handle; }

        public Progress Poll()
        {
            var progress = Progress.Sized();
            Library.Check(Native.ups_job_poll(Handle, &progress));
            return progress;
        }

        /// <summary>Ok, Timeout or Cancelled; throws the job's own error.</summary>
        public Status Wait(uint timeoutMs = uint.MaxValue)
        {
            return Library.Check(Native.ups_job_wait(Handle, timeoutMs));
        }

        /// <summary>When the error by RenderDesc.TargetCriterion is so small, of all looks at it so far.</summary>
        public Prediction Predict(double relativeError)
        {
            var prediction = Prediction.Sized();
            Library.Check(Native.ups_job_get_prediction(Handle, relativeError, &prediction));
            return prediction;
        }

        /// <summary>What accuracy cost so far: each look at the error.</summary>
        public CurvePoint[] Curve()
        {
            uint count;
            Library.Check(Native.ups_job_get_curve_count(Handle, &count));
            var all = new CurvePoint[count];
            for (uint i = 0; i < count; ++i)
            {
                var point = CurvePoint.Sized();
                Library.Check(Native.ups_job_get_curve_point(Handle, i, &point));
                all[i] = point;
            }
            return all;
        }

        /// <summary>The meter that had it at the last look.</summary>
        public LargestError LargestError()
        {
            var error = Ups.LargestError.Sized();
            Library.Check(Native.ups_job_get_largest_error(Handle, &error));
            return error;
        }

        /// <summary>What the render takes, as estimated once it was prepared.</summary>
        public MemoryEstimate Memory()
        {
            var estimate = MemoryEstimate.Sized();
            Library.Check(Native.ups_job_get_memory_estimate(Handle, &estimate));
            return estimate;
        }

        public void Cancel() { Native.ups_job_cancel(Handle); }

        /// <summary>What is there after the last whole iteration.</summary>
        public Result Result()
        {
            ResultHandle result;
            Library.Check(Native.ups_job_result(Handle, out result));
            return new Result(result);
        }

        public void Dispose() { Handle.Dispose(); }
    }

    /// <summary>What a render has found so far; immutable.</summary>
    public sealed unsafe class Result : IDisposable
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
            var readings = new MeterReading[Statistics(sensor).Count];
            fixed (MeterReading* r = readings)
                Library.Check(Native.ups_result_read_meters(Handle, sensor, r, (UIntPtr)readings.Length));
            return readings;
        }

        /// <summary>Direct or indirect light of each meter, with errors of its own.</summary>
        public MeterPartReading[] MeterPart(SensorId sensor, LightPart part)
        {
            var readings = new MeterPartReading[Statistics(sensor).Count];
            fixed (MeterPartReading* r = readings)
                Library.Check(Native.ups_result_read_meter_part(Handle, sensor, part, r, (UIntPtr)readings.Length));
            return readings;
        }

        /// <summary>Of each meter: is its reading exact, hardly found, its interval unreliable?</summary>
        public Reading[] MeterFlags(SensorId sensor)
        {
            var flags = new Reading[Statistics(sensor).Count];
            fixed (Reading* f = flags)
                Library.Check(Native.ups_result_read_meter_flags(Handle, sensor, (uint*)f, (UIntPtr)flags.Length));
            return flags;
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
            var ratios = new Interval[Statistics(numerator).Count];
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
                all[i] = new MeterReading[Statistics(sensor).Count];
                fixed (MeterReading* r = all[i])
                    Library.Check(Native.ups_result_read_source_meters(Handle, i, sensor, r, (UIntPtr)all[i].Length));
            }
            return all;
        }

        /// <summary>Flux, light output ratio and accuracy.</summary>
        public GoniometerInfo GoniometerInfo(SensorId sensor)
        {
            var info = Ups.GoniometerInfo.Sized();
            Library.Check(Native.ups_result_get_goniometer_info(Handle, sensor, &info));
            return info;
        }

        /// <summary>CCount * GammaCount readings, gamma fastest.</summary>
        public IntensityReading[] Goniometer(SensorId sensor)
        {
            var info = GoniometerInfo(sensor);
            var readings = new IntensityReading[(long)info.CCount * info.GammaCount];
            fixed (IntensityReading* r = readings)
                Library.Check(Native.ups_result_read_goniometer(Handle, sensor, r, (UIntPtr)readings.Length));
            return readings;
        }

        /// <summary>The angles of the readings: CCount planes, GammaCount angles in each.</summary>
        public void GoniometerAngles(SensorId sensor, out float[] cDeg, out float[] gammaDeg)
        {
            var info = GoniometerInfo(sensor);
            cDeg = new float[info.CCount];
            gammaDeg = new float[info.GammaCount];
            fixed (float* c = cDeg, gamma = gammaDeg)
                Library.Check(Native.ups_result_get_goniometer_angles(Handle, sensor, c, (UIntPtr)info.CCount, gamma,
                                                                      (UIntPtr)info.GammaCount));
        }

        /// <summary>The beam angle (fraction 0.5) or field angle (0.1) in the plane C / C + 180, with its
        /// error.</summary>
        public GoniometerBeam GoniometerBeam(SensorId sensor, float cDeg = 0, float fraction = 0.5f)
        {
            var beam = Ups.GoniometerBeam.Sized();
            Library.Check(Native.ups_result_get_goniometer_beam(Handle, sensor, cDeg, fraction, &beam));
            return beam;
        }

        /// <summary>For luminaires, and to write a photometric file. The caller disposes of it.</summary>
        public Profile GoniometerProfile(SensorId sensor)
        {
            ProfileHandle profile;
            Library.Check(Native.ups_result_get_goniometer_profile(Handle, sensor, out profile));
            return new Profile(profile);
        }

        /// <summary>Rows from the top, tight: 3 floats a pixel, 1 for Illuminance and its error, Bias and
        /// ErrorBound. The camera's own size.</summary>
        public float[] Image(SensorId camera, int width, int height, Channel channel = Channel.LuminanceRgb)
        {
            bool single = channel == Channel.Illuminance || channel == Channel.IlluminanceStandardError
                || channel == Channel.Bias || channel == Channel.ErrorBound;
            var values = new float[(long)width * height * (single ? 1 : 3)];
            fixed (float* v = values)
                Library.Check(Native.ups_result_read_image(Handle, camera, channel, v, UIntPtr.Zero,
                                                           (UIntPtr)(sizeof(float) * (ulong)values.Length)));
            return values;
        }

        /// <summary>Each technique that has an image; none unless RenderDesc.TechniqueImages was set.</summary>
        public TechniqueInfo[] Techniques(SensorId camera)
        {
            uint count;
            Library.Check(Native.ups_result_get_technique_count(Handle, camera, &count));
            var all = new TechniqueInfo[count];
            for (uint i = 0; i < count; ++i)
            {
                var info = TechniqueInfo.Sized();
                Library.Check(Native.ups_result_get_technique(Handle, camera, i, &info));
                all[i] = info;
            }
            return all;
        }

        /// <summary>Of the technique at that place in Techniques(); 3 floats a pixel, as Image().</summary>
        public float[] TechniqueImage(SensorId camera, uint index, int width, int height,
                                      Contribution contribution = Contribution.Weighted)
        {
            var values = new float[(long)width * height * 3];
            fixed (float* v = values)
                Library.Check(Native.ups_result_read_technique(Handle, camera, index, contribution, v, UIntPtr.Zero,
                                                               (UIntPtr)(sizeof(float) * (ulong)values.Length)));
            return values;
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
                Native.ups_result_get_text(Handle, topic, p, capacity, needed)) ?? "";
        }

        public void Dispose() { Handle.Dispose(); }
    }

    /// <summary>A sample of a render, traced again by Scene.Replay.</summary>
    public sealed unsafe class ReplayedPath : IDisposable
    {
        internal readonly PathHandle Handle;

        internal ReplayedPath(PathHandle handle) { Handle = handle; }

        public PathInfo Info
        {
            get
            {
                var info = PathInfo.Sized();
                Library.Check(Native.ups_path_get_info(Handle, &info));
                return info;
            }
        }

        /// <summary>Walk by walk, each from its start.</summary>
        public PathVertex[] Vertices()
        {
            UIntPtr needed;
            Library.Check(Native.ups_path_read_vertices(Handle, null, UIntPtr.Zero, &needed));
            var vertices = new PathVertex[(int)needed];
            fixed (PathVertex* v = vertices)
                Library.Check(Native.ups_path_read_vertices(Handle, v, needed, &needed));
            return vertices;
        }

        /// <summary>The largest first.</summary>
        public PathContribution[] Contributions()
        {
            UIntPtr needed;
            Library.Check(Native.ups_path_read_contributions(Handle, null, UIntPtr.Zero, &needed));
            var contributions = new PathContribution[(int)needed];
            fixed (PathContribution* c = contributions)
                Library.Check(Native.ups_path_read_contributions(Handle, c, needed, &needed));
            return contributions;
        }

        /// <summary>All that is known of the path, for people.</summary>
        public string Text()
        {
            return Library.Text((p, capacity, needed) => Native.ups_path_get_text(Handle, p, capacity, needed)) ?? "";
        }

        public void Dispose() { Handle.Dispose(); }
    }
}
