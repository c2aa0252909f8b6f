#!/usr/bin/env python3
"""What do 10,000 readings and a 4K image cost from Python, beside what they cost from C? Each into an array, in turns,
in one process; the shortest of many turns counts. C copies them; Python views them, without a copy, or copies them into
the same memory. Fails where a view takes Python more than 2 % longer than the copy takes C. A call costs Python some
2 us more than C, whatever it reads: beside a view from C, which takes less than one, that is much. Half a minute, on a
machine that does nothing else, with 4 GB free; needs numpy and a C compiler. A busy machine varies by more than is
measured:

    tests/bindings/read_speed.py build/release
"""
import ctypes
import os
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
METERS, WIDTH, HEIGHT = 10000, 3840, 2160


def c_calls(library):
    """The loops in C, on the same libups."""
    with tempfile.TemporaryDirectory() as folder:
        file = f"{folder}/libread_speed.so"
        subprocess.run(["cc", "-O2", "-std=gnu99", "-shared", "-fPIC", f"-I{ROOT}/include",
                        HERE / "csharp" / "speed" / "read_speed.c", "-o", file, f"-L{library}", "-lups"], check=True)
        loaded = ctypes.CDLL(file)
    for name in ("read_meters_s", "read_image_s"):
        function = getattr(loaded, name)
        function.restype = ctypes.c_double
        function.argtypes = [ctypes.c_void_p, ctypes.c_uint32, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int]
    return loaded


def rendered(ups, np):
    scene = ups.Scene(ups.Context())
    square = [(-5, -5, 0), (5, -5, 0), (5, 5, 0), (-5, 5, 0)]
    floor = scene.add_mesh(square, [(0, 1, 2), (0, 2, 3)], scene.add_material())
    scene.add_instance(floor)
    scene.add_light(intensity_rgb=(100, 100, 100), to_world=ups.translation(0, 0, 2.5))
    i = np.arange(METERS)
    meters = scene.add_meters(np.column_stack([0.02 * (i % 100), 0.02 * (i // 100), np.full(METERS, 0.5)]), (0, 0, 1))
    camera = scene.add_camera(WIDTH, HEIGHT, to_world=ups.translation(0, 0, 2))
    scene.commit()
    return scene.render(method=ups.Method.PATH_TRACING, iteration_count=1), meters, camera


def compare(what, turns, calls, in_c, in_python):
    """Seconds of a call: (C, Python). Each goes first in half of the turns, drawn by lot: memory and caches are as the
    one before has left them."""
    def python(calls):
        start = time.perf_counter()
        for _ in range(calls):
            in_python()
        return time.perf_counter() - start
    took = {in_c: [], python: []}
    for _ in range(turns):
        for read in random.sample([in_c, python], 2):
            took[read].append(read(calls) / calls)
    assert min(took[in_c]) >= 0, f"{what}: a call from C failed"
    c, p = min(took[in_c]), min(took[python])
    print(f"{what}: C {1e6 * c:.2f} us, Python {1e6 * p:.2f} us, {p / c - 1:+.2%}")
    return c, p


def main():
    library = Path(sys.argv[1], "src", "api").resolve() if len(sys.argv) == 2 else sys.exit(__doc__)
    os.environ["UPS_LIBRARY"] = str(library)
    sys.path[:0] = [str(ROOT / "bindings" / "python"), str(ROOT / "samples" / "scenes_common")]
    import need_numpy  # noqa: F401
    import numpy as np
    import ups
    c = c_calls(library)
    result, meters, camera = rendered(ups, np)
    handle = result._as_parameter_
    readings, image = result.meters(meters), result.image(camera)

    def meters_in_c(calls):
        return c.read_meters_s(handle, meters.v, readings.ctypes.data, METERS, calls)

    def image_in_c(calls):
        return c.read_image_s(handle, camera.v, image.ctypes.data, image.nbytes, calls)

    compare("10,000 readings, copied", 400, 20, meters_in_c, lambda: result.meters(meters, out=readings))
    compare("4K image, copied", 300, 1, image_in_c, lambda: result.image(camera, out=image))
    reads = [compare("10,000 readings", 400, 20, meters_in_c, lambda: result.view_meters(meters)),
             compare("4K image", 100, 1, image_in_c, lambda: result.view_image(camera))]
    sys.exit(0 if all(in_python <= 1.02 * in_c for in_c, in_python in reads) else 1)


if __name__ == "__main__":
    main()
