// Do renders that are awaited end, tell how far they are, and stop when asked to? And do readings arrive in spans?
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Ups;
using Xunit;

public sealed class AsyncTest : IDisposable
{
    private readonly Context context = new Context(2);
    private readonly Scene scene;
    private readonly SensorId meters;

    private sealed class Told : IProgress<Progress>
    {
        internal readonly List<Progress> All = new List<Progress>();
        internal Action<Progress> Then = p => { };

        public void Report(Progress value)
        {
            lock (All) All.Add(value);
            Then(value);
        }
    }

    public AsyncTest()
    {
        scene = new Scene(context);
        var white = scene.AddMaterial(MaterialDesc.Create());
        Span<float> floor = new float[] { -5, -5, 0, 5, -5, 0, 5, 5, 0, -5, 5, 0 };
        ReadOnlySpan<uint> triangles = new uint[] { 9, 0, 1, 2, 0, 2, 3, 9 };
        var instance = InstanceDesc.Create();
        instance.Mesh = scene.AddMesh(floor, triangles.Slice(1, 6), white);
        scene.AddInstance(instance);
        var light = LightDesc.Create();
        light.IntensityRgb = new float[] { 400, 400, 400 };
        light.ToWorld[11] = 2.5;
        scene.AddLight(light);
        meters = scene.AddMeters(new[] { 0, 0, 0.5, 1, 0, 0.5 }, new float[] { 0, 0, 1, 0, 0, -1 });
        scene.Commit();
    }

    public void Dispose()
    {
        scene.Dispose();
        context.Dispose();
    }

    private static RenderDesc Iterations(uint count)
    {
        var desc = RenderDesc.Create();
        desc.IterationCount = count;
        desc.Seed = 3;
        return desc;
    }

    private static RenderDesc Endless()
    {
        var desc = RenderDesc.Create();
        desc.TimeLimitS = 600;
        return desc;
    }

    [Fact]
    public async Task TestAwaitedRender()
    {
        var told = new Told();
        using (var result = await scene.RenderAsync(Iterations(64), told))
        using (var same = scene.Render(Iterations(64)))
        {
            Assert.Equal(same.Meters(meters), result.Meters(meters));
            var last = told.All[told.All.Count - 1];
            Assert.True(last.State == JobState.Finished && last.IterationsDone == 64 && last.Fraction == 1,
                        "the last progress: " + last.State + " " + last.IterationsDone + " " + last.Fraction);
        }
    }

    [Fact]
    public async Task TestAwaitedRenderIsCancelled()
    {
        using (var cancel = new CancellationTokenSource())
        {
            var told = new Told { Then = p => { if (p.IterationsDone > 0) cancel.Cancel(); } };
            var task = scene.RenderAsync(Endless(), told, cancel.Token);
            OperationCanceledException thrown = await Caught<OperationCanceledException>(task);
            Assert.True(thrown.CancellationToken == cancel.Token && task.IsCanceled, "the task is cancelled");
        }
        using (var before = new CancellationTokenSource())
        {
            before.Cancel();
            await Caught<OperationCanceledException>(scene.RenderAsync(Endless(), before.Token));
            for (var i = 0; i < 20; ++i)
                await Caught<OperationCanceledException>(scene.RenderAsync(Iterations(1), before.Token));
        }
    }

    [Fact]
    public async Task TestCancelledJobKeepsItsResult()
    {
        using (var cancel = new CancellationTokenSource())
        using (var job = scene.Start(Endless()))
        {
            var told = new Told { Then = p => { if (p.IterationsDone > 0) cancel.Cancel(); } };
            Assert.Equal(Status.Cancelled, await job.WaitAsync(told, cancel.Token));
            Assert.Equal(JobState.Cancelled, told.All[told.All.Count - 1].State);
            using (var result = job.Result())
                Assert.True(result.Info.Iterations > 0 && result.Meters(meters)[0].IlluminanceLx >= 99.9,
                            "what was found before");
        }
    }

    [Fact]
    public async Task TestDisposingAJobEndsItForWhoWaits()
    {
        var job = scene.Start(Endless());
        var waits = new TaskCompletionSource<bool>();
        var waiter = Task.Run(() =>
        {
            waits.SetResult(true);
            try { return job.Wait(); }
            catch (ObjectDisposedException) { return Status.Cancelled; }  // a busy machine came to it late
        });
        await waits.Task;
        await Task.Delay(50);
        job.Dispose();
        job.Dispose();
        Assert.Equal(Status.Cancelled, await waiter);
    }

    [Fact]
    public async Task TestDisposingAJobEndsItsTask()
    {
        for (var i = 0; i < 8; ++i)  // between two looks of it, and within one
        {
            var job = scene.Start(Endless());
            using (var cancel = new CancellationTokenSource())
            {
                var task = job.WaitAsync(cancel.Token);
                await Task.Delay(10 + 15 * i);
                job.Dispose();
                Assert.Equal(Status.Cancelled, await task);
                cancel.Cancel();
            }
        }
    }

    [Fact]
    public async Task TestErrorsAreTheTasks()
    {
        var told = new Told { Then = p => { throw new InvalidOperationException("a listener's own"); } };
        using (var job = scene.Start(Endless()))
        {
            await Caught<InvalidOperationException>(job.WaitAsync(told));
            Assert.Equal(Status.Cancelled, job.Wait());
        }
        using (var uncommitted = new Scene(context))
            Assert.Equal(Status.ErrorInvalidState,
                         Assert.Throws<UpsException>(() => { uncommitted.RenderAsync(Iterations(1)); }).Status);
        var refused = Iterations(1);
        refused.MemoryLimitBytes = 1;
        Assert.Equal(Status.ErrorOutOfMemory,
                     Assert.Throws<UpsException>(() => { scene.RenderAsync(refused); }).Status);
    }

    private static async Task<T> Caught<T>(Task task) where T : Exception
    {
        try
        {
            await task;
        }
        catch (T e)
        {
            return e;
        }
        throw new InvalidOperationException("no " + typeof(T));
    }

    [Fact]
    public void TestSpans()
    {
        using (var result = scene.Render(Iterations(4)))
        {
            var all = new MeterReading[4];
            result.ReadMeters(meters, new Span<MeterReading>(all, 1, 2));
            Assert.Equal(result.Meters(meters), new[] { all[1], all[2] });
            Assert.True(all[0].Equals(new MeterReading()) && all[3].Equals(new MeterReading()), "nothing beside");
            Assert.True(all[1].IlluminanceLx > 99 && all[2].IlluminanceLx < all[1].IlluminanceLx, "the readings");
            var wrong = Assert.Throws<UpsException>(() => result.ReadMeters(meters, new MeterReading[3]));
            Assert.Equal(Status.ErrorInvalidArgument, wrong.Status);
            var flags = new Reading[2];
            result.ReadMeterFlags(meters, flags);
            Assert.Equal(result.MeterFlags(meters), flags);
        }
        var argument = Assert.Throws<ArgumentException>(() => scene.AddMeters(new double[4], new float[3]));
        Assert.Contains("multiple of 3 values, got 4", argument.Message);
        argument = Assert.Throws<ArgumentException>(() =>
            scene.AddMesh(new float[9], new uint[3], new MaterialId(), normals: new float[8]));
        Assert.Contains("expected 9 values, got 8", argument.Message);
    }
}
