"""Scene files that another process truncates and rewrites while they are read: a scene that is whole, or an error that
says which file; never a crash.
Usage: test_changing_files.py PATH_TO_UPS [unittest options]"""
import collections
import os
import subprocess
import threading

import faults


class ChangingFiles(faults.FaultTest):
    def disturb(self, path, content, stop):
        """In place, as careless programs do: shorter, empty, other bytes, gone, back again."""
        while not stop.is_set():
            kind = self.random.randrange(4)
            try:
                if kind == 0:
                    os.truncate(path, self.random.randrange(len(content)))
                elif kind == 1:
                    with open(path, "r+b") as file:
                        file.seek(self.random.randrange(len(content)))
                        file.write(bytes(self.random.randrange(256) for _ in range(16)))
                elif kind == 2:
                    path.unlink()
                else:
                    with open(path, "wb") as file:  # in two parts
                        half = self.random.randrange(len(content))
                        file.write(content[:half])
                        file.flush()
                        file.write(content[half:])
            except OSError:
                pass
            if self.random.random() < 0.5:
                path.write_bytes(content)
                stop.wait(self.random.uniform(0, 0.1))

    def test_a_whole_scene_or_an_error(self):
        scene, files = self.write_scene()
        # Buffers and profiles of more than a page, so that reading takes more than one step.
        large = {"room.bin": files["room.bin"] + bytes(300000),
                 "lamp.ies": files["lamp.ies"].replace(b"[TEST] none", b"[TEST] none\n[MORE] " + b"x" * 100 +
                                                       b"\n[MORE] y" * 5000)}
        for name, content in large.items():
            (self.folder / name).write_bytes(content)
        files.update(large)
        seen = collections.Counter()
        for name, content in files.items():
            stop = threading.Event()
            thread = threading.Thread(target=self.disturb, args=(self.folder / name, content, stop))
            thread.start()
            try:
                for k in range(faults.rounds(20, 300)):
                    command = [faults.program, "info", str(scene)] if k % 4 else \
                        [faults.program, "render", str(scene), "--iterations", "1", "--size", "8x8"]
                    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=faults.HANG_S)
                    text = (done.stdout + done.stderr).decode(errors="replace")
                    self.assertIn(done.returncode, (0, 1), msg=f"{name}: {faults.died_of(done.returncode)}\n{text}")
                    if done.returncode == 1:
                        self.assertRegex(text, r"room\.gltf|room\.bin|lamp\.ies")
                    seen[done.returncode] += 1
            finally:
                stop.set()
                thread.join()
            (self.folder / name).write_bytes(content)
        print(f"read whole {seen[0]} times, refused {seen[1]} times")  # as chance has it
        for name, content in files.items():
            (self.folder / name).write_bytes(content[:8])
            self.run_program([faults.program, "info", str(scene)], code=1)
            (self.folder / name).write_bytes(content)
        self.run_program([faults.program, "info", str(scene)])


if __name__ == "__main__":
    faults.main()
