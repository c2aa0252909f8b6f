"""`ups compare` on images whose errors are known by hand. Usage: test_compare.py PATH_TO_UPS [unittest options]"""
import itertools
import json
import os
import struct
import sys
import unittest

import test_program


def write_exr(path, width, height, channels, at=(0, 0), display=None, halved=()):
    """Float channels, row by row, uncompressed (https://openexr.com/en/latest/OpenEXRFileLayout.html). at: where their
    top left pixel lies in the display window; display: its width and height, if they are others; halved: channels of
    which every second pixel of every second row is kept."""
    steps = {name: 2 if name in halved else 1 for name in sorted(channels)}

    def attribute(name, kind, data):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data

    window = struct.pack("<4i", *at, at[0] + width - 1, at[1] + height - 1)
    shown = struct.pack("<4i", 0, 0, *(side - 1 for side in display or (width, height)))
    listed = b"".join(name.encode() + b"\0" + struct.pack("<iB3xii", 2, 0, k, k) for name, k in steps.items()) + b"\0"
    header = struct.pack("<ii", 20000630, 2) + b"".join((
        attribute("channels", "chlist", listed), attribute("compression", "compression", b"\0"),
        attribute("dataWindow", "box2i", window), attribute("displayWindow", "box2i", shown),
        attribute("lineOrder", "lineOrder", b"\0"), attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
        attribute("screenWindowWidth", "float", struct.pack("<f", 1)))) + b"\0"
    rows = []
    for y in range(height):
        row = [v for name, k in steps.items() if y % k == 0 for v in channels[name][y * width:(y + 1) * width:k]]
        rows.append(struct.pack(f"<ii{len(row)}f", at[1] + y, 4 * len(row), *row))
    starts = itertools.accumulate((len(row) for row in rows[:-1]), initial=len(header) + 8 * height)
    with open(path, "wb") as file:
        file.write(b"".join([header, struct.pack(f"<{height}Q", *starts), *rows]))


class Comparisons(test_program.ProgramTest):
    def test_compare_channel_by_channel(self):
        """Two images of 40 x 50 pixels whose errors are known by hand: the worst two pixels are the trimmed 0.1 %."""
        pixels = 2000
        grey = {"R": [2.0] * pixels, "G": [2.0] * pixels, "B": [2.0] * pixels}
        other = {name: list(values) for name, values in grey.items()}
        for k in range(pixels):
            other["R"][k] += 0.5 if k % 2 else -0.5
        other["G"][7] += 30
        other["B"][8] -= 60
        errors = {"standard_error.R": [0.25] * pixels, "standard_error.G": [0.5] * pixels,
                  "standard_error.B": [1.0] * pixels}
        errors["standard_error.B"][8] = 4.0
        a, b, plain = (self.path(name) for name in ("a.exr", "b.exr", "plain.exr"))
        write_exr(a, 40, 50, {**other, **{name: [2 * v for v in values] for name, values in errors.items()}})
        write_exr(b, 40, 50, {**grey, **errors})
        write_exr(plain, 40, 50, grey)
        found = json.loads(self.run_program("compare", a, b, "--json").stdout)["channels"]
        mse = (0.25 * pixels + 900 + 3600) / (3 * pixels)
        noise = ((0.0625 + 0.25 + 1) * pixels + 15) / (3 * pixels)
        expected = {"mse": mse, "trimmed_mse": 0.25 / 3, "relative_mse": mse / 4.04, "noise_a": 4 * noise,
                    "noise_b": noise, "relative_noise_b": noise / 4.04, "trimmed_noise_b": 1.3125 / 3}
        self.assertEqual(set(found), set(expected))
        for name, value in expected.items():
            self.assertAlmostEqual(found[name], value, delta=1e-6 * value, msg=name)
        found = json.loads(self.run_program("compare", b, plain, "--json").stdout)["channels"]
        self.assertEqual((found["mse"], found["noise_b"], found["trimmed_noise_b"]), (0, -1, -1))
        self.assertGreater(found["noise_a"], 0)
        errors["standard_error.G"][8] = -1  # unknown at one pixel: the mean is over the others
        write_exr(b, 40, 50, {**grey, **errors})
        found = json.loads(self.run_program("compare", a, b, "--json").stdout)["channels"]
        self.assertAlmostEqual(found["noise_b"], 1.3125 / 3, delta=1e-6)
        errors["standard_error.G"] = [-1] * pixels
        write_exr(b, 40, 50, {**grey, **errors})
        self.assertEqual(json.loads(self.run_program("compare", a, b, "--json").stdout)["channels"]["noise_b"], -1)
        write_exr(plain, 40, 50, {"Y": grey["G"]})
        mixed = json.loads(self.run_program("compare", b, plain, "--json").stdout)
        self.assertAlmostEqual(mixed["rmse"], 0, delta=1e-6)
        self.assertEqual(set(mixed["channels"].values()), {-1})

    def test_compare_cropped_files(self):
        """What a crop leaves out is black; where it lies counts. The whole image is 6 x 4, lit at (2, 1) to (3, 2)."""
        lit = {(2, 1): 1.0, (3, 1): 2.0, (2, 2): 3.0, (3, 2): 4.0}
        whole, crop, moved, beyond = (self.path(name) for name in ("whole.exr", "crop.exr", "moved.exr", "beyond.exr"))
        write_exr(whole, 6, 4, {"Y": [lit.get((x, y), 0.0) for y in range(4) for x in range(6)]})
        values = {"Y": [1.0, 2.0, 3.0, 4.0]}
        write_exr(crop, 2, 2, values, (2, 1), (6, 4))
        write_exr(moved, 2, 2, values, (3, 1), (6, 4))
        write_exr(beyond, 2, 2, values, (-1, 1), (6, 4))
        same = json.loads(self.run_program("compare", crop, whole, "--json").stdout)
        self.assertEqual(same["rmse"], 0)
        self.assertAlmostEqual(same["mean_a"], 10 / 24, delta=1e-6)
        other = json.loads(self.run_program("compare", moved, crop, "--json").stdout)
        self.assertAlmostEqual(other["rmse"], (32 / 24) ** 0.5, delta=1e-6)  # 1, 1, 2 and 3, 1, 4 in two rows
        self.assertEqual(other["worst_pixel"], [4, 2])
        self.expect_failure("compare", beyond, crop, words=["7 x 4", "6 x 4"])
        write_exr(beyond, 2, 2, values, display=(40000, 40000))  # black but for four pixels, in 400 bytes
        self.expect_failure("compare", beyond, crop, words=["beyond.exr", "40000 x 40000"])

    def test_compare_luminance_and_chroma(self):
        """Y is compared; RY and BY have a quarter of its pixels."""
        y = [float(i % 7) for i in range(24)]
        both, plain, chroma = (self.path(name) for name in ("both.exr", "plain.exr", "chroma.exr"))
        write_exr(both, 6, 4, {"Y": y, "RY": [0.5] * 24, "BY": [0.25] * 24}, halved=("RY", "BY"))
        write_exr(plain, 6, 4, {"Y": y})
        write_exr(chroma, 6, 4, {"RY": y}, halved=("RY",))
        self.assertEqual(json.loads(self.run_program("compare", both, plain, "--json").stdout)["rmse"], 0)
        self.expect_failure("compare", chroma, plain, words=["chroma.exr", "no channel"])


if __name__ == "__main__":
    test_program.PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
