"""The program is killed (SIGKILL) at random moments of loading, rendering and writing. A file is then as it was before or
as a whole render leaves it, never in between; and the next render is not disturbed by what was left behind.
Usage: test_kills.py PATH_TO_UPS [unittest options]"""
import signal
import subprocess
import time

import faults


class Kills(faults.FaultTest):
    def test_a_file_is_whole_or_the_older_one(self):
        scene, _ = self.write_scene()
        out, other = self.folder / "out", self.folder / "other"
        self.run_program(self.command(scene, out, seed=1))
        start = time.monotonic()
        self.run_program(self.command(scene, other, seed=2))
        lasts = time.monotonic() - start
        old, new = self.results(out), self.results(other)
        self.assertEqual(old.keys(), new.keys())
        differ = [name for name in old if old[name] != new[name]]  # some light is exact
        self.assertGreater(len(differ), len(old) / 2)
        wanted = faults.rounds(12, 200)
        killed = mixed = left_behind = runs = 0
        while killed < wanted:
            runs += 1
            self.assertLess(runs, 20 * wanted, msg=f"killed {killed} times only")
            for name, content in old.items():
                (out / name).write_bytes(content)
            start = time.monotonic()
            process = self.start(self.command(scene, out, seed=2))
            # Most of the moments are the end's, when files are written. A busy machine is slow once and fast again.
            early = self.random.random() < 0.4
            try:
                process.wait(lasts * (self.random.uniform(0, 1) if early else self.random.uniform(0.7, 1)))
                lasts = time.monotonic() - start
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
                lasts *= 1.02
            process.communicate(timeout=faults.HANG_S)
            killed += process.returncode == -signal.SIGKILL
            found = self.results(out)
            self.assertEqual(found.keys(), old.keys())
            for name, content in found.items():
                self.assertIn(content, (old[name], new[name]), msg=f"{name}: neither the older file nor the new one")
            mixed += 0 < sum(found[name] == new[name] for name in differ) < len(differ)
            for path in out.glob("*.tmp"):
                left_behind += 1
                if left_behind > 3:  # the first ones stay: they must disturb nobody
                    path.unlink()
        print(f"killed {killed} times; {mixed} times between two files; {left_behind} temporary files left behind")
        self.run_program(self.command(scene, out, seed=2))
        self.assertEqual(self.results(out), new)


if __name__ == "__main__":
    faults.main()
