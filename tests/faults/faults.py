"""What the tests of faults share: the program, a scene with its files apart, whole results to compare with.

UPS_STABILITY=full: as many rounds as it takes to be sure, in minutes; without it about a dozen of each.
"""
import base64
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parents[1] / folder) for folder in ("tool", "support")]
from test_program import IES, room  # noqa: E402

FULL = os.environ.get("UPS_STABILITY") == "full"
SEED = random.SystemRandom().randrange(1 << 32)  # printed: moments differ from run to run
HANG_S = 60  # a busy machine may be slow; what takes so long hangs

program = None
WRITERS = ("images and tables", "report", "map", "goniometer", "replay")


def main():
    global program
    program = os.path.abspath(sys.argv.pop(1))
    print(f"moments by seed {SEED}", flush=True)
    unittest.main()


def rounds(fast, full):
    return full if FULL else fast


class FaultTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="ups-faults-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.random = random.Random(SEED)

    def write_scene(self):
        """The room of the program's tests with its buffer and a luminaire's profile in files of their own."""
        scene = room()
        buffer = scene["buffers"][0]
        data = base64.b64decode(buffer["uri"].split(",")[1])
        buffer["uri"] = "room.bin"
        scene["nodes"].append({"name": "lamp", "translation": [0, 2.5, 0],
                               "extras": {"ups": {"luminaire": {"file": "lamp.ies"}}}})
        scene["scenes"][0]["nodes"].append(len(scene["nodes"]) - 1)
        files = {"room.gltf": json.dumps(scene).encode(), "room.bin": data, "lamp.ies": IES.encode()}
        for name, content in files.items():
            (self.folder / name).write_bytes(content)
        return self.folder / "room.gltf", files

    def command(self, scene, out, *options, seed=1, size="300x200"):
        return [program, "render", str(scene), "--method", "ups", "--iterations", "4", "--size", size, "--seed",
                str(seed), "--out", str(out), *options]

    def prepare_writers(self):
        """Renders by two seeds, whose images are mapped and whose samples are traced again."""
        self.scene, _ = self.write_scene()
        self.samples = {}
        for seed in (1, 2):
            done = self.run_program(self.command(self.scene, self.folder / f"seed{seed}", "--json", seed=seed,
                                                 size="60x40"))
            samples = json.loads(done.stdout)["largest_samples"]
            self.samples[seed] = next(s["address"] for s in samples if s["sensor"] == "view")

    def write_command(self, writer, seed):
        """What writes the same files into the current folder by either seed, with other bytes."""
        if writer == "map":
            return [program, "map", str(self.folder / f"seed{seed}/view.exr"),
                    "map.png", "map.svg", "map.pdf"]
        if writer == "goniometer":
            return [program, "goniometer", str(self.scene), "--iterations", "4", "--seed", str(seed), "--c-step", "45",
                    "--gamma-step", "15", "--out", "fixture.ies", "--errors", "errors.csv", "--plot", "polar.svg"]
        if writer == "replay":
            return [program, "replay", str(self.scene), "--method", "ups", "--size", "60x40", "--sample",
                    self.samples[seed], "--plot", "path.svg"]
        more = ["--report"] if writer == "report" else []
        return self.command(self.scene, ".", "--json", "--separate", "luminaires", "--technique-images", "2", *more,
                            seed=seed, size="60x40")

    def expect_whole(self, name, found, old, new):
        """A report tells how long the render took: no two are alike."""
        if name == "report.html":
            self.assertTrue(found == old or found.rstrip().endswith(b"</html>"), msg=name)
        else:
            self.assertIn(found, (old, new), msg=f"{name}: neither the older file nor the new one")

    def run_program(self, command, code=0, **options):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=HANG_S,
                              **options)
        self.assertEqual(done.returncode, code, msg=f"{command}\n{done.stdout}\n{done.stderr}")
        return done

    def start(self, command, **options):
        process = subprocess.Popen(command, **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True,
                                               **options})
        self.addCleanup(lambda: process.poll() is None and process.kill())
        return process

    def results(self, out):
        """File by file; the same seed and iterations give the same bytes."""
        return {p.name: p.read_bytes() for p in Path(out).iterdir() if not p.name.endswith(".tmp")}


def died_of(returncode):
    return signal.Signals(-returncode).name if returncode < 0 else f"exit code {returncode}"
