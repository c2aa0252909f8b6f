"""The program is killed (SIGKILL) at random moments of loading, rendering and writing, of renders, reports, maps,
goniometers and replays in turn. A file is then as it was before or as a whole run leaves it, never in between; and the
next run is not disturbed by what was left behind.
Usage: test_kills.py PATH_TO_UPS [unittest options]"""
import signal
import subprocess
import time

import faults


class Victim:
    """One of the writers: what it leaves by two seeds, and how long that takes."""

    def __init__(self, test, writer):
        self.writer, self.out, other = writer, test.folder / writer, test.folder / (writer + ", new")
        self.out.mkdir(), other.mkdir()
        test.run_program(test.write_command(writer, seed=1), cwd=self.out)
        start = time.monotonic()
        test.run_program(test.write_command(writer, seed=2), cwd=other)
        self.lasts = time.monotonic() - start
        self.old, self.new = test.results(self.out), test.results(other)
        self.runs = self.killed = self.mixed = self.left_behind = 0


class Kills(faults.FaultTest):
    def kill(self, v):
        v.runs += 1
        for name, content in v.old.items():
            (v.out / name).write_bytes(content)
        start = time.monotonic()
        process = self.start(self.write_command(v.writer, seed=2), cwd=v.out)
        # Most of the moments are the end's, when files are written. A busy machine is slow once and fast again.
        early = self.random.random() < 0.4
        try:
            process.wait(v.lasts * (self.random.uniform(0, 1) if early else self.random.uniform(0.7, 1)))
            v.lasts = time.monotonic() - start
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            v.lasts *= 1.02
        process.communicate(timeout=faults.HANG_S)
        v.killed += process.returncode == -signal.SIGKILL

    def expect_whole_files(self, v, differ):
        found = self.results(v.out)
        self.assertEqual(found.keys(), v.old.keys())
        for name, content in found.items():
            self.expect_whole(name, content, v.old[name], v.new[name])
        v.mixed += 0 < sum(found[name] != v.old[name] for name in differ) < len(differ)
        for path in v.out.glob("*.tmp"):
            v.left_behind += 1
            if v.left_behind > 3:  # the first ones stay: they must disturb nobody
                path.unlink()

    def test_a_file_is_whole_or_the_older_one(self):
        self.prepare_writers()
        wanted = faults.rounds(4, 50)
        for writer in faults.WRITERS:
            v = Victim(self, writer)
            self.assertEqual(v.old.keys(), v.new.keys())
            differ = [name for name in v.old if v.old[name] != v.new[name]]  # some light is exact
            self.assertGreater(2 * len(differ), len(v.old) - 1, msg=writer)
            while v.killed < wanted:
                self.assertLess(v.runs, 20 * wanted, msg=f"{writer}: killed {v.killed} times only")
                self.kill(v)
                self.expect_whole_files(v, differ)
            print(f"{writer}: killed {v.killed} times; {v.mixed} times between two files; {v.left_behind} temporary "
                  "files left behind", flush=True)
            self.run_program(self.write_command(writer, seed=2), cwd=v.out)
            for name, content in self.results(v.out).items():
                if name != "report.html":
                    self.assertEqual(content, v.new[name], msg=f"{writer}: {name}")


if __name__ == "__main__":
    faults.main()
