"""A disk that is full, a limit of file sizes, a closed pipe: an error that names the file, and older files stay.
Usage: test_full_disk.py PATH_TO_UPS [unittest options]"""
import os
import resource
import signal
import subprocess
import unittest

import faults


def mount_small_disk(folder, kilobytes):
    """False where this user may not."""
    try:
        return subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={kilobytes}k", "none", str(folder)],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=20).returncode == 0
    except OSError:
        return False


def small_files(kilobytes):
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)  # which would end a program that does not mind it
        resource.setrlimit(resource.RLIMIT_FSIZE, (kilobytes * 1024, kilobytes * 1024))
    return limit


class FullDisk(faults.FaultTest):
    def expect_old_files(self, scene, out, word, **options):
        old = self.results(out)
        done = self.run_program(self.command(scene, out, "--json", seed=2, size="600x400"), code=1, **options)
        self.assertIn("view.exr", done.stderr)
        self.assertIn(word, done.stderr)
        self.assertIn('"iterations": 4', done.stdout)  # what was found is told all the same
        found = self.results(out)
        self.assertEqual(found["view.exr"], old["view.exr"])
        self.assertEqual(found.keys(), old.keys())
        self.assertEqual([p.name for p in out.iterdir() if p.name.endswith(".tmp")], [])

    def test_no_space_left(self):
        scene, _ = self.write_scene()
        out = self.folder / "disk"
        out.mkdir()
        if not mount_small_disk(out, 2560):
            self.skipTest("this user cannot mount a small disk; the limit of file sizes stands for it")
        self.addCleanup(subprocess.run, ["umount", str(out)], timeout=20)
        self.run_program(self.command(scene, out, size="60x40"))
        self.expect_old_files(scene, out, "No space left on device")

    def test_limit_of_file_sizes(self):
        scene, _ = self.write_scene()
        out = self.folder / "out"
        self.run_program(self.command(scene, out, size="60x40"))
        self.expect_old_files(scene, out, "File too large", preexec_fn=small_files(300))

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_output_that_cannot_be_written_is_an_error(self):
        scene, _ = self.write_scene()
        with open("/dev/full", "w") as full:
            done = subprocess.run(self.command(scene, self.folder / "out", "--json"), stdout=full,
                                  stderr=subprocess.PIPE, text=True, timeout=faults.HANG_S)
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot write to standard output", done.stderr)
        self.assertIn("view.exr", os.listdir(self.folder / "out"))


if __name__ == "__main__":
    faults.main()
