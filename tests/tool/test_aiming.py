"""Where tables of type A and B shine in a scene: what samples/scene_files.md says of it, rendered. Usage:
test_aiming.py PATH_TO_UPS [unittest options]"""
import csv
import math
import os
import re
import sys
import unittest

import test_program

GUIDE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "samples", "scene_files.md")
DISTANCE = 10
H, V = 40, 30  # where the table has its only light
# Right, forward, up of each row of the guide's table, in the results' frame.
FRAMES = {"down": ((0, -1, 0), (0, 0, -1), (1, 0, 0)), "north": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
          "east": ((0, -1, 0), (1, 0, 0), (0, 0, 1)), "south": ((-1, 0, 0), (0, -1, 0), (0, 0, 1)),
          "west": ((0, 1, 0), (-1, 0, 0), (0, 0, 1))}


def table(photometric_type):
    """1000 cd at one node of an IES file."""
    angles = list(range(-90, 91, 10))
    rows = [[1000 if (h, v) == (H, V) else 0 for v in angles] for h in angles]
    numbers = " ".join(map(str, angles))
    return ("IESNA:LM-63-2002\n[TEST] none\n[MANUFAC] this project\nTILT=NONE\n"
            f"1 -1 1 19 19 {photometric_type} 2 0 0 0\n1 1 10\n{numbers}\n{numbers}\n" +
            "\n".join(" ".join(map(str, row)) for row in rows) + "\n")


def type_a(h, v):
    h, v = math.radians(h), math.radians(v)
    return math.cos(v) * math.sin(h), math.cos(v) * math.cos(h), math.sin(v)


def type_b(h, v):
    h, v = math.radians(h), math.radians(v)
    return math.sin(h), math.cos(h) * math.cos(v), math.cos(h) * math.sin(v)


def rotations():
    """The guide's rows: "north (+Y), upright" | `[...]`."""
    with open(GUIDE, encoding="utf-8") as file:
        rows = re.findall(r"^\| (down|north|east|south|west)\b.*\| `\[(.*)\]` \|$", file.read(), re.MULTILINE)
    return {name: [float(x) for x in rotation.split(",")] for name, rotation in rows}


class Aiming(test_program.ProgramTest):
    def readings(self, photometric_type, direction):
        """Of each luminaire of the guide alone: lx where its light should be, and at H mirrored, facing it."""
        self.write("lamp.ies", table(photometric_type))
        nodes = [{"name": name, "rotation": rotation, "extras": {"ups": {"luminaire": {"file": "lamp.ies"}}}}
                 for name, rotation in rotations().items()]
        points = []
        for name in rotations():
            for h in (H, -H):
                parts = zip(direction(h, V), FRAMES[name])
                world = [sum(terms) for terms in zip(*([p * a for a in axis] for p, axis in parts))]
                points.append([DISTANCE * world[0], DISTANCE * world[2], -DISTANCE * world[1]])  # as glTF has it
        nodes.append({"name": "eyes", "extras": {"ups": {"meters": {
            "points_m": points, "normals": [[-x for x in p] for p in points]}}}})
        scene = {"asset": {"version": "2.0"}, "scene": 0, "nodes": nodes,
                 "scenes": [{"nodes": list(range(len(nodes)))}]}
        self.run_program("render", self.write("scene.gltf", scene), "--method", "pt", "--iterations", 16, "--seed", 1,
                         "--separate", "luminaires", "--out", self.path("out"))
        with open(self.path("out/eyes_luminaires.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        return {name: [[float(rows[2 * i + k][name + column]) for column in ("_lx", "_standard_error_lx")]
                       for k in range(2)] for i, name in enumerate(rotations())}

    def test_the_frame_of_the_guide(self):
        self.assertEqual(set(rotations()), set(FRAMES))
        for photometric_type, direction in ((3, type_a), (2, type_b)):  # LM-63: 1 is C, 2 is B, 3 is A
            for name, ((lit, error), (dark, _)) in self.readings(photometric_type, direction).items():
                with self.subTest(type=direction.__name__, aimed=name):
                    # Exact: points straight to points, no chance, and so no standard error. The node's light falls to
                    # nothing within 10 degrees: 1e-4, the smallest error found, are a thousandth of a degree.
                    self.assertLess(error, 1e-6)
                    self.assertAlmostEqual(lit, 1000 / DISTANCE**2, delta=1e-4 * 1000 / DISTANCE**2)
                    self.assertEqual(dark, 0)


if __name__ == "__main__":
    test_program.PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
