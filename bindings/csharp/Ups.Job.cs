// UPS for C#: how far is a render? Programs use Job, which Scene.Start makes, or Scene.RenderAsync; see Ups.cs.
using System;
using System.Threading;
using System.Threading.Tasks;

namespace Ups
{
    /// <summary>A render or a commit on the library's own threads; any thread may call. Disposing of it cancels
    /// it.</summary>
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

        /// <summary>The task ends as Wait does: Ok, Cancelled, or the job's own error. Cancelling the token cancels
        /// the job, whose Result() still has every finished iteration.</summary>
        public Task<Status> WaitAsync(CancellationToken cancel = default)
        {
            return WaitAsync(Waiting.Nobody, cancel);
        }

        /// <summary>The same; progress is told 20 times a second and at the end, from a thread of its own
        /// (System.Progress hands it on to the one that made it). What it throws cancels the job and is the task's
        /// error.</summary>
        public Task<Status> WaitAsync(IProgress<Progress> progress, CancellationToken cancel = default)
        {
            Library.Given(progress, "progress");
            return Task.Factory.StartNew(() => Waiting.Watch(this, progress, cancel), CancellationToken.None,
                                         TaskCreationOptions.LongRunning, TaskScheduler.Default);
        }

        public void Cancel() { Native.ups_job_cancel(Handle); }

        /// <summary>What is there after the last whole iteration.</summary>
        public Result Result()
        {
            ResultHandle result;
            Library.Check(Native.ups_job_result(Handle, out result));
            return new Result(result);
        }

        /// <summary>Who waits in another thread gets Cancelled.</summary>
        public void Dispose()
        {
            CancelIfThere();
            Handle.Dispose();
        }

        internal bool IsDisposed { get { return Handle.IsClosed; } }

        internal void CancelIfThere()
        {
            try { Cancel(); }
            catch (ObjectDisposedException) { }
        }
    }

    /// <summary>Waits for jobs; apart from Job because code that awaits may not be unsafe.</summary>
    internal static class Waiting
    {
        private const uint ReportEveryMs = 50;

        private sealed class Silent : IProgress<Progress>
        {
            public void Report(Progress value) { }
        }

        internal static readonly IProgress<Progress> Nobody = new Silent();

        internal static Status Watch(Job job, IProgress<Progress> progress, CancellationToken cancel)
        {
            using (cancel.Register(job.CancelIfThere))
            {
                try
                {
                    Status status;
                    while ((status = job.Wait(ReportEveryMs)) == Status.Timeout) progress.Report(job.Poll());
                    progress.Report(job.Poll());
                    return status;
                }
                catch (ObjectDisposedException) when (job.IsDisposed)
                {
                    return Status.Cancelled;  // by Dispose, in another thread
                }
                catch
                {
                    job.CancelIfThere();
                    throw;
                }
            }
        }

        internal static async Task<T> Finish<T>(Job job, IProgress<Progress> progress, Func<Job, T> result,
                                                CancellationToken cancel)
        {
            using (job)
            {
                var unwanted = cancel.IsCancellationRequested;  // whose job may be over before it hears
                if (await job.WaitAsync(progress, cancel).ConfigureAwait(false) == Status.Cancelled || unwanted)
                    throw new OperationCanceledException(cancel);
                return result(job);
            }
        }
    }
}
