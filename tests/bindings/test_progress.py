"""How far a render is, on a terminal, in a file, in a notebook; and does Ctrl-C keep what there is? Programs run by
themselves here, as people run them."""
import io
import os
import re
import signal
import subprocess
import sys
import textwrap
import threading
import time

import nbclient
import nbformat
import pytest
import ups
from rooms import box

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from terminal import drawn_by  # noqa: E402

SECONDS = 3 if os.environ.get("UPS_TEST_EFFORT") == "low" else 1.5  # of a render; sanitizers take long to begin one
IMPORTS = "import ups, os, signal, sys, threading\nfrom rooms import box\nscene, meters = box(ups.Context(2))\n"


def start(program, env=None, **streams):
    path = os.pathsep.join([os.path.dirname(__file__), os.environ["PYTHONPATH"]])
    return subprocess.Popen([sys.executable, "-c", IMPORTS + textwrap.dedent(program)], text=True,
                            env={**os.environ, "PYTHONPATH": path, **(env or {})}, **streams)


def output(program):
    """What a program wrote that ran to its end: (standard output, errors)."""
    out, err = start(program, stdout=subprocess.PIPE, stderr=subprocess.PIPE).communicate(timeout=60)
    return out, err


def test_a_terminal_has_a_bar_that_is_written_over():
    process, shown = drawn_by(lambda stream: start(f"scene.render(time_limit_s={SECONDS}, progress=True)", stderr=stream))
    assert process.wait(60) == 0
    lines = shown.decode().split("\r")
    bars = [re.fullmatch(r"\[(#*) *\] (\d+)%, (\d+) iterations.*", line.rstrip()) for line in lines if "[" in line]
    assert len(bars) >= 2 and all(bars)
    percents = [int(bar[2]) for bar in bars]
    assert percents == sorted(percents) and percents[-1] == 100 and len(bars[-1][1]) == 30
    assert shown.endswith(b"\r\n") and shown.count(b"\n") == 1


@pytest.mark.parametrize("columns", [80, 30, 0])  # 0: it does not say
def test_the_bar_fits_the_terminal(columns):
    """What wraps could not be written over."""
    program = f"scene.render(time_limit_s={SECONDS}, progress=True)"
    process, drawn = drawn_by(lambda stream: start(program, stderr=stream), columns)
    assert process.wait(60) == 0
    lines = [line for line in re.split(rb"[\r\n]", drawn) if line.startswith(b"[")]
    assert len(lines) > 1 and max(map(len, lines)) < (columns or 80)


def test_a_stream_that_is_no_file_has_80_columns(context, monkeypatch):
    class Window(io.StringIO):
        def isatty(self):
            return True

    scene, _ = box(context)
    window = Window()
    monkeypatch.setattr(sys, "stderr", window)
    monkeypatch.setattr(ups._progress, "text_of", lambda progress: 80 * "x")
    scene.render(iteration_count=4, progress=True)
    assert {len(line) for line in window.getvalue().rstrip("\n").split("\r")[1:]} == {79}


def test_a_file_gets_a_line_now_and_then(monkeypatch, capsys, context):
    scene, _ = box(context)
    monkeypatch.setattr(ups._progress, "_LINE_INTERVAL_S", 0.2)
    start = time.monotonic()
    scene.render(time_limit_s=SECONDS, progress=True)
    elapsed = time.monotonic() - start
    lines = capsys.readouterr().err.splitlines()
    assert 1 <= len(lines) <= elapsed / 0.2 + 1 and all(re.match(r"\d+%, \d+ iterations", line) for line in lines)
    scene.render(time_limit_s=SECONDS)
    assert capsys.readouterr() == ("", "")


def test_a_function_is_told(context):
    scene, _ = box(context)
    seen = []
    result = scene.render(time_limit_s=SECONDS, progress=lambda p: seen.append((p.iterations_done, p.fraction, p.state)))
    assert len(seen) >= 2 and seen == sorted(seen) and seen[-1][0] == result.info.iterations
    assert seen[-1][2] == ups.JobState.FINISHED and not result.interrupted
    with pytest.raises(ZeroDivisionError):
        scene.render(time_limit_s=60, progress=lambda p: 1 / 0)


def test_a_notebook_replaces_one_output(tmp_path, monkeypatch):
    for folder in ("JUPYTER_RUNTIME_DIR", "IPYTHONDIR"):  # where there is no home to write to
        monkeypatch.setenv(folder, str(tmp_path / folder))
    cell = nbformat.v4.new_code_cell(
        f"result = scene.render(time_limit_s={2 * SECONDS}, progress=True)\nresult.info.iterations")
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(
        f"import sys; sys.path.insert(0, {os.path.dirname(__file__)!r})\n" + IMPORTS), cell])
    nbclient.NotebookClient(notebook, timeout=60, kernel_name="python3").execute()
    shown, answer = notebook.cells[1].outputs
    assert shown.output_type == "display_data" and answer.output_type == "execute_result"
    iterations = int(answer.data["text/plain"])
    assert shown.data["text/plain"].startswith(f"100%, {iterations} iterations")
    assert shown.data["text/html"].startswith('<progress max="1" value="1.000"></progress> 100%')


def test_ctrl_c_keeps_the_results_so_far():
    process = start("""
        result = scene.render(time_limit_s=600, seed=5, progress=lambda p: print(p.iterations_done, flush=True))
        kept = result.info.iterations
        again = scene.render(iteration_count=kept, seed=5)
        print("kept", kept > 0, result.interrupted, again.interrupted,
              result.meters(meters).tobytes() == again.meters(meters).tobytes())
        """, stdout=subprocess.PIPE)
    while int(process.stdout.readline()) == 0:
        pass
    process.send_signal(signal.SIGINT)
    rest = process.communicate(timeout=60)[0]
    assert process.returncode == 0 and rest.splitlines()[-1] == "kept True True False True"


def test_ctrl_c_before_there_is_anything_is_an_interrupt(context, monkeypatch):
    scene, _ = box(context)
    fired = []

    def interrupt(job, timeout_s=None):  # as if it came while the first slice of time is waited for
        if not fired:
            fired.append(job.poll().iterations_done)
            raise KeyboardInterrupt
        return wait(job, timeout_s)

    wait = ups.Job.wait
    monkeypatch.setattr(ups.Job, "wait", interrupt)
    monkeypatch.setattr(ups.Job, "result", lambda job: (_ for _ in ()).throw(
        ups.Error(ups.Status.ERROR_INVALID_STATE, "no iteration is done")))
    with pytest.raises(KeyboardInterrupt):
        scene.render(time_limit_s=60)
    assert fired


def test_a_second_ctrl_c_is_raised(context, monkeypatch):
    scene, _ = box(context)
    monkeypatch.setattr(ups.Job, "wait", lambda job, timeout_s=None: (_ for _ in ()).throw(KeyboardInterrupt))
    with pytest.raises(KeyboardInterrupt):
        scene.render(time_limit_s=60)


def test_ctrl_c_just_as_a_render_ends_is_told(context, monkeypatch):
    scene, _ = box(context)
    wait, fired = ups.Job.wait, []

    def wait_and_interrupt(job, timeout_s=None):
        status = wait(job)
        if not fired:
            fired.append(status)
            raise KeyboardInterrupt
        return status

    monkeypatch.setattr(ups.Job, "wait", wait_and_interrupt)
    result = scene.render(iteration_count=1)
    assert fired == [ups.Status.OK] and result.interrupted and result.info.iterations == 1


def test_a_child_of_fork_does_not_wait_for_its_parents_jobs():
    process = start("""
        job = scene.start(time_limit_s=600)
        child = os.fork()
        if child == 0:
            os._exit(len(ups._job._running))
        print(os.waitpid(child, 0)[1], len(ups._job._running))
        """, stdout=subprocess.PIPE)
    assert process.communicate(timeout=60)[0] == "0 1\n"


def test_other_threads_render_meanwhile(context):
    scene, meters = box(context)
    found = []
    thread = threading.Thread(target=lambda: found.append(scene.render(iteration_count=4, seed=1).meters(meters)))
    thread.start()
    own = scene.render(iteration_count=4, seed=1).meters(meters)
    thread.join()
    assert found[0].tobytes() == own.tobytes()


def test_a_program_may_end_beside_threads_that_wait():
    # Its job's thread has ended, but nobody joined it: the thread sanitizer would call that a leak.
    options = os.environ.get("TSAN_OPTIONS", "") + ":report_thread_leaks=0"
    for _ in range(10):
        process = start("""
            job = scene.start(time_limit_s=600)
            for timeout in (None, 100):
                threading.Thread(target=job.wait, args=(timeout,), daemon=True).start()
            while job.poll().fraction == 0:
                pass
            """, {"TSAN_OPTIONS": options})
        assert process.wait(60) == 0
