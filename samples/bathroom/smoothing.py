#!/usr/bin/env python3
"""What `ups render --smooth` does to the bathroom's picture: without it and with it side by side, and how far both are
from a long render.

    samples/bathroom/smoothing.py --build build/release --out out/smoothing [--time 60 | --iterations 152]
                                  [--size 640x480] [--reference-time 3000] [--reference IMAGE.exr]

Writes with_and_without.png (left as rendered, right smoothed). With a reference it prints the RMSE of both against it,
cd/m2 over pixels and channels, without the noise of the reference itself (by its standard errors), of all pixels and of
those without the thousandth that differs most; exit code 1 where that of all pixels is not halved. numpy and matplotlib
are needed.
"""
import argparse
import ctypes
import json
import shutil
import struct
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "scenes_common"))
import need_numpy  # noqa: E402, F401
import numpy as np  # noqa: E402
from matplotlib.image import imread  # noqa: E402

import exr  # noqa: E402
import png  # noqa: E402

SCENE = Path(__file__).resolve().parent / "bathroom.glb"
JSON_CHUNK = 0x4E4F534A


def scene_with_layers(path):
    """The bathroom, its camera asked for the layers that steer the filter; `--smooth` keeps them to itself."""
    data = SCENE.read_bytes()
    size, = struct.unpack_from("<I", data, 12)
    scene = json.loads(data[20:20 + size])
    for node in scene["nodes"]:
        if "camera" in node:
            node["extras"]["ups"]["layers"] = ["albedo", "normal", "depth"]
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + size:]
    head = struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), JSON_CHUNK)
    path.write_bytes(head + text + rest)
    shutil.copy(SCENE.parent / "wall_light.ies", path.parent)  # which it names
    return path


def render(build, scene, out, *options):
    done = subprocess.run([build / "bin/ups", "render", scene, "--out", out, "--json", *map(str, options)], check=True,
                          stdout=subprocess.PIPE)
    return json.loads(done.stdout)


class Image:
    def __init__(self, path):
        values, names = exr.read_channels(path)
        planes = dict(zip(names, values.transpose(1, 0, 2)))

        def plane(layer, components="RGB"):
            prefix = layer + "." if layer else ""
            if prefix + components[0] not in planes:
                return None
            return np.ascontiguousarray(np.stack([planes[prefix + c] for c in components], axis=2))
        self.luminance, self.error = plane(""), plane("standard_error")
        self.albedo, self.normal, self.depth = plane("albedo"), plane("normal", "XYZ"), plane("depth", "Z")


class SmoothDesc(ctypes.Structure):  # ups_ocio_smooth_desc
    _fields_ = [(name, ctypes.c_uint32) for name in ("struct_size", "width", "height", "reserved")] + [
        (name, ctypes.c_void_p) for name in ("luminance", "error", "albedo", "normal", "depth")]


class PictureDesc(ctypes.Structure):  # ups_ocio_picture_desc
    _fields_ = [(name, ctypes.c_uint32) for name in ("struct_size", "width", "height", "smoothed")] + [
        ("luminance", ctypes.c_void_p), ("exposure", ctypes.c_double), ("chosen", ctypes.c_int32),
        ("reserved", ctypes.c_uint32)]


class Ocio:
    """What the program calls for --smooth."""

    def __init__(self, build):
        self._library = ctypes.CDLL(str(build / "src/extras/ocio/libups_ocio.so"))
        self._library.ups_ocio_last_error.restype = ctypes.c_char_p

    def _check(self, status):
        if status:
            sys.exit(self._library.ups_ocio_last_error().decode())

    def smoothed(self, image):
        height, width, _ = image.luminance.shape
        arrays = (image.luminance, image.error, image.albedo, image.normal, image.depth)
        desc = SmoothDesc(ctypes.sizeof(SmoothDesc), width, height, 0, *[a.ctypes.data for a in arrays])
        out = np.empty_like(image.luminance)
        self._check(self._library.ups_ocio_smooth(ctypes.byref(desc), ctypes.c_void_p(out.ctypes.data)))
        return out

    def write(self, path, shown, exposed_for):
        height, width, _ = shown.shape
        exposure = ctypes.c_double()
        self._check(self._library.ups_ocio_choose_exposure(ctypes.c_void_p(exposed_for.ctypes.data), width, height,
                                                           ctypes.byref(exposure)))
        desc = PictureDesc(ctypes.sizeof(PictureDesc), width, height, 1, shown.ctypes.data, exposure.value, 1, 0)
        self._check(self._library.ups_ocio_write_picture_png(str(path).encode(), ctypes.byref(desc)))


def distances(image, reference):
    """RMSE over all pixels, and without the thousandth that differs most; less the reference's own noise."""
    squares = ((image - reference.luminance).astype(float) ** 2).mean(axis=2).ravel()
    noise = (np.maximum(reference.error, 0).astype(float) ** 2).mean(axis=2).ravel()
    kept = np.argsort(squares)[:len(squares) - len(squares) // 1000]
    return [np.sqrt(max(0.0, squares[i].mean() - noise[i].mean())) for i in (slice(None), kept)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=Path("build/release"))
    parser.add_argument("--out", type=Path, default=Path("out/smoothing"))
    parser.add_argument("--time", type=float, default=60)
    parser.add_argument("--iterations", type=int)
    parser.add_argument("--size", default="640x480")
    parser.add_argument("--reference-time", type=float)
    parser.add_argument("--reference", type=Path)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    scene = scene_with_layers(options.out / "bathroom.glb")
    limit = ("--iterations", options.iterations) if options.iterations else ("--time", options.time)
    made = render(options.build, scene, options.out / "raw", "--size", options.size, *limit)
    raw, ocio = Image(options.out / "raw/view.exr"), Ocio(options.build)
    smoothed = ocio.smoothed(raw)
    ocio.write(options.out / "smoothed.png", smoothed, raw.luminance)
    halves = [imread(path)[..., :3] for path in (options.out / "raw/view.png", options.out / "smoothed.png")]
    both = (np.concatenate(halves, axis=1) * 255 + 0.5).astype(np.uint8)
    (options.out / "with_and_without.png").write_bytes(png.encode(both))
    print(f"{made['iterations']} iterations in {made['time_s']:.1f} s")
    if options.reference_time:
        render(options.build, SCENE, options.out / "reference", "--size", options.size, "--seed", 777, "--time",
               options.reference_time)
        options.reference = options.out / "reference/view.exr"
    if not options.reference:
        return
    reference = Image(options.reference)
    of_raw, of_smoothed = distances(raw.luminance, reference), distances(smoothed, reference)
    for name, a, b in zip(("all pixels", "without the worst 0.1 %"), of_raw, of_smoothed):
        print(f"RMSE, {name}: {a:.3f} cd/m2 as rendered, {b:.3f} smoothed: {a / b:.2f} times less")
    sys.exit(0 if 2 * of_smoothed[0] <= of_raw[0] else 1)


if __name__ == "__main__":
    main()
