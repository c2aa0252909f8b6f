"""A disk that is full, a limit of file sizes, a closed pipe: an error that names the file, and older files stay, whoever
writes: renders, reports, maps, goniometers, replays.
Usage: test_full_disk.py PATH_TO_UPS PATH_TO_LIBDISTURBANCES [unittest options]"""
import os
import resource
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import faults
from preload import preloaded

DISTURBANCES = None
PAGE = 4096


def mount(folder, *options):
    """False where this user may not."""
    try:
        return subprocess.run(["mount", *options, str(folder)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=20).returncode == 0
    except OSError:
        return False


def small_files(most):
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)  # which would end a program that does not mind it
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
    return limit


class FullDisk(faults.FaultTest):
    made = None  # the scene, samples of it and what each writer writes by either seed: the same for all tests

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="ups-faults-")
        cls.addClassCleanup(folder.cleanup)
        cls.shared = Path(folder.name)

    def setUp(self):
        self.folder = self.shared
        if self.made is None:
            self.prepare_writers()
            both = [{writer: self.written_by(writer, seed) for writer in faults.WRITERS} for seed in (1, 2)]
            type(self).made = self.scene, self.samples, *both
        self.scene, self.samples, self.old, self.new = self.made

    def written_by(self, writer, seed):
        with tempfile.TemporaryDirectory(dir=self.folder) as out:
            self.run_program(self.write_command(writer, seed), cwd=out)
            return self.results(out)

    def write_old(self, writer, out):
        old = self.old[writer]
        self.assertEqual(old.keys(), self.new[writer].keys())
        self.assertNotEqual(old, self.new[writer])
        for name, content in old.items():
            (out / name).write_bytes(content)
        return old

    def expect_old_files(self, writer, out, old, word, **options):
        """Files that are named, and all where the first cannot be written, byte for byte; others may be new, never in
        between."""
        done = self.run_program(self.write_command(writer, seed=2), code=1, cwd=out, **options)
        named = [name for name in old if name in done.stderr]
        self.assertTrue(named, msg=f"{writer}: {done.stderr}")
        self.assertIn(word, done.stderr)
        if writer in ("images and tables", "report"):
            self.assertIn('"iterations": 4', done.stdout)  # what was found is told all the same
        found = self.results(out)
        self.assertEqual(found.keys(), old.keys())
        for name, content in found.items():
            self.expect_whole(name, content, old[name], self.new[writer][name])
        for name in named:
            self.assertEqual(found[name], old[name], msg=f"{writer}: {name}")
        self.assertEqual([p.name for p in out.iterdir() if p.name.endswith(".tmp")], [])
        for name, content in old.items():
            (out / name).write_bytes(content)
        return found

    def expect_new_files(self, writer, out):
        self.run_program(self.write_command(writer, seed=2), cwd=out)
        for name, content in self.results(out).items():
            if name != "report.html":
                self.assertEqual(content, self.new[writer][name], msg=f"{writer}: {name}")

    def written_once(self, folder):
        """Each writer with a folder of its own and the older files there; after its turn it writes the new ones."""
        for number, writer in enumerate(faults.WRITERS):
            out = folder / str(number)
            out.mkdir(parents=True)
            yield writer, out, self.write_old(writer, out)
            self.expect_new_files(writer, out)

    def test_no_space_left_on_a_small_disk(self):
        disk = self.folder / "disk"
        disk.mkdir()
        if not mount(disk, "-t", "tmpfs", "-o", "size=64m", "none"):
            self.skipTest("this user cannot mount a small disk; writes that find no space stand for it")
        self.addCleanup(subprocess.run, ["umount", str(disk)], timeout=20)
        for writer, out, old in self.written_once(disk):
            usage = os.statvfs(disk)
            free = max(map(len, self.new[writer].values())) // 2 // PAGE * PAGE
            used = (usage.f_blocks - usage.f_bfree) * usage.f_frsize
            self.assertTrue(mount(disk, "-o", f"remount,size={used + free}"))
            self.expect_old_files(writer, out, old, "No space left on device")
            self.assertTrue(mount(disk, "-o", "remount,size=64m"))

    def test_writes_that_find_no_space(self):
        for writer, out, old in self.written_once(self.folder / "full"):
            total = sum(map(len, self.new[writer].values()))
            for space in (0, *faults.rounds((), (total // 4, total // 2)), int(0.95 * total)):
                environment = preloaded(DISTURBANCES) | {"UPS_DISTURB": "full", "UPS_DISTURB_BYTES": str(space)}
                found = self.expect_old_files(writer, out, old, "No space left on device", env=environment)
                if space == 0:
                    self.assertEqual(found, old)

    def test_space_that_is_missed_late(self):
        """As file systems do that find room for what was written when they have to, or have a limit elsewhere."""
        for writer, out, old in self.written_once(self.folder / "late"):
            for call in ("fsync", "close", "rename"):
                environment = preloaded(DISTURBANCES) | {"UPS_DISTURB": call}
                found = self.expect_old_files(writer, out, old, "No space left on device", env=environment)
                self.assertEqual(found, old, msg=f"{writer}: {call}")

    def test_limit_of_file_sizes(self):
        # TMPDIR, where the thread sanitizer writes a file before the program's main has let large files fail.
        nowhere = os.environ | {"TMPDIR": str(self.folder / "nowhere")}
        for writer, out, old in self.written_once(self.folder / "limited"):
            largest = max(map(len, self.new[writer].values()))
            for most in (0, *faults.rounds((), (largest // 4, largest // 2)), int(0.95 * largest)):
                found = self.expect_old_files(writer, out, old, "File too large", env=nowhere,
                                            preexec_fn=small_files(most))
                if most == 0:
                    self.assertEqual(found, old)

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_output_that_cannot_be_written_is_an_error(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run(self.command(self.scene, self.folder / "out", "--json"), stdout=full,
                                  stderr=subprocess.PIPE, text=True, timeout=faults.HANG_S)
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot write to standard output", done.stderr)
        self.assertIn("view.exr", os.listdir(self.folder / "out"))


if __name__ == "__main__":
    DISTURBANCES = os.path.abspath(sys.argv.pop(2))
    faults.main()
