// UPS for C#: what was described is built, asked for and rendered. The third part of Scene; see Ups.Scene.cs.
using System;
using System.Threading;
using System.Threading.Tasks;

namespace Ups
{
    public sealed unsafe partial class Scene
    {
        /// <summary>Builds what the edits since the last commit touch. Renders that run keep the earlier
        /// build.</summary>
        public void Commit() { Library.Check(Native.ups_scene_commit(Handle)); }

        /// <summary>The same as a job: watched, waited for and cancelled as a render's; it has no Result().</summary>
        public Job StartCommit() { return StartCommit(CommitDesc.Create()); }

        /// <summary>On so many threads, of that priority, within that memory.</summary>
        public Job StartCommit(CommitDesc desc)
        {
            JobHandle job;
            Library.Check(Native.ups_scene_start_commit_with(Handle, &desc, out job));
            return new Job(job);
        }

        /// <summary>The same, awaited. Cancelled, the task throws OperationCanceledException and the scene stays as it
        /// was committed before. Edits made meanwhile belong to the next commit.</summary>
        public Task CommitAsync(CancellationToken cancel = default) { return CommitAsync(Waiting.Nobody, cancel); }

        public Task CommitAsync(IProgress<Progress> progress, CancellationToken cancel = default)
        {
            Library.Given(progress, "progress");
            if (cancel.IsCancellationRequested) return Task.FromCanceled(cancel);  // a job may be over before it hears
            return Waiting.Finish(StartCommit(), progress, job => 0, cancel);
        }

        /// <summary>There are edits that no commit has taken, or there was none.</summary>
        public bool IsDirty
        {
            get
            {
                int dirty;
                Library.Check(Native.ups_scene_is_dirty(Handle, &dirty));
                return dirty != 0;
            }
        }

        public SceneInfo Info
        {
            get
            {
                var info = SceneInfo.Sized();
                Library.Check(Native.ups_scene_get_info(Handle, &info));
                return info;
            }
        }

        public string Text(SceneText topic)
        {
            return Library.Text((p, capacity, needed) =>
                Native.ups_scene_get_text(Handle, topic, p, capacity, needed));
        }

        /// <summary>Where a plane cuts the committed scene's surfaces.</summary>
        public Segment[] Section(ReadOnlySpan<double> pointM, ReadOnlySpan<double> normal)
        {
            return Segments((p, n, s, capacity, needed) =>
                Native.ups_scene_read_section(Handle, p, n, s, capacity, needed), pointM, normal);
        }

        /// <summary>Edges of surfaces that are seen beneath a plane, as ups_scene_read_outlines.</summary>
        public Segment[] Outlines(ReadOnlySpan<double> pointM, ReadOnlySpan<double> normal,
                                  double depthM = double.PositiveInfinity)
        {
            return Segments((p, n, s, capacity, needed) =>
                Native.ups_scene_read_outlines(Handle, p, n, depthM, s, capacity, needed), pointM, normal);
        }

        private delegate Status ReadSegments(double* point, double* normal, Segment* segments, UIntPtr capacity,
            UIntPtr* needed);

        private static Segment[] Segments(ReadSegments read, ReadOnlySpan<double> pointM, ReadOnlySpan<double> normal)
        {
            Elements.Expect(pointM.Length, 3, "pointM");
            Elements.Expect(normal.Length, 3, "normal");
            fixed (double* p = pointM, n = normal)
            {
                for (;;)
                {
                    UIntPtr needed;
                    Library.Check(read(p, n, null, UIntPtr.Zero, &needed));
                    var segments = new Segment[(int)needed];
                    Status status;
                    fixed (Segment* s = segments) status = read(p, n, s, (UIntPtr)segments.Length, &needed);
                    if (!Library.Fits(status)) continue;
                    Array.Resize(ref segments, (int)needed);
                    return segments;
                }
            }
        }

        /// <summary>Each luminaire, light and emissive instance of the committed scene: what it is, where, its
        /// flux.</summary>
        public SceneSource[] Sources()
        {
            for (;;) // a commit that comes between may number them anew
            {
                ulong revision = Info.Revision;
                try
                {
                    SceneSource[] all = SourcesAsTheyStand();
                    if (Info.Revision == revision) return all;
                }
                catch (UpsException)
                {
                    if (Info.Revision == revision) throw;
                }
            }
        }

        private SceneSource[] SourcesAsTheyStand()
        {
            uint count;
            Library.Check(Native.ups_scene_get_source_count(Handle, &count));
            var all = new SceneSource[count];
            for (uint i = 0; i < count; ++i)
            {
                var source = Ups.SceneSource.Sized();
                Library.Check(Native.ups_scene_get_source(Handle, i, &source));
                all[i] = source;
            }
            return all;
        }

        /// <summary>The profile of a luminaire, by its index in Sources().</summary>
        public Profile SourceProfile(int index)
        {
            ProfileHandle profile;
            Library.Check(Native.ups_scene_get_source_profile(Handle, (uint)index, out profile));
            return new Profile(profile);
        }

        /// <summary>Traces one of Result.LargestSamples again; desc: that of the render that it is of.</summary>
        public ReplayedPath Replay(RenderDesc desc, Sample sample)
        {
            PathHandle path;
            Library.Check(Native.ups_replay(Handle, &desc, &sample, out path));
            return new ReplayedPath(path);
        }

        /// <summary>Blocks until a limit or the target is met.</summary>
        public Result Render(RenderDesc desc)
        {
            ResultHandle result;
            Library.Check(Native.ups_render(Handle, &desc, out result));
            return new Result(result);
        }

        /// <summary>The same as a job, which can be watched and cancelled.</summary>
        public Job Start(RenderDesc desc)
        {
            JobHandle job;
            Library.Check(Native.ups_job_start(Handle, &desc, out job));
            return new Job(job);
        }

        /// <summary>As Start, Job.WaitAsync and Job.Result in one. Cancelled, the task throws
        /// OperationCanceledException and what was found is lost; to keep it, use these three. What Start refuses is
        /// thrown at once. The scene may be changed and disposed of as soon as this returns.</summary>
        public Task<Result> RenderAsync(RenderDesc desc, CancellationToken cancel = default)
        {
            return Waiting.Finish(Start(desc), Waiting.Nobody, job => job.Result(), cancel);
        }

        public Task<Result> RenderAsync(RenderDesc desc, IProgress<Progress> progress,
                                        CancellationToken cancel = default)
        {
            Library.Given(progress, "progress");
            return Waiting.Finish(Start(desc), progress, job => job.Result(), cancel);
        }

        /// <summary>What such a render will take; takes as long as its preparations.</summary>
        public MemoryEstimate EstimateMemory(RenderDesc desc)
        {
            var estimate = MemoryEstimate.Sized();
            Library.Check(Native.ups_scene_estimate_memory(Handle, &desc, &estimate));
            return estimate;
        }
    }
}
