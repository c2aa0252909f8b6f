"""`ups compare` on images whose errors are known by hand. Usage: test_compare.py PATH_TO_UPS [unittest options]"""
import json
import os
import struct
import sys
import unittest

import test_program


def write_exr(path, width, height, channels):
    """Float channels, row by row, uncompressed (https://openexr.com/en/latest/OpenEXRFileLayout.html)."""
    names = sorted(channels)

    def attribute(name, kind, data):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data

    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    listed = b"".join(name.encode() + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for name in names) + b"\0"
    header = struct.pack("<ii", 20000630, 2) + b"".join((
        attribute("channels", "chlist", listed), attribute("compression", "compression", b"\0"),
        attribute("dataWindow", "box2i", window), attribute("displayWindow", "box2i", window),
        attribute("lineOrder", "lineOrder", b"\0"), attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
        attribute("screenWindowWidth", "float", struct.pack("<f", 1)))) + b"\0"
    row_bytes = 4 * width * len(names)
    start = len(header) + 8 * height
    with open(path, "wb") as file:
        file.write(header + struct.pack(f"<{height}Q", *(start + y * (8 + row_bytes) for y in range(height))))
        for y in range(height):
            row = [v for name in names for v in channels[name][y * width:(y + 1) * width]]
            file.write(struct.pack(f"<ii{len(row)}f", y, row_bytes, *row))


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


if __name__ == "__main__":
    test_program.PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
