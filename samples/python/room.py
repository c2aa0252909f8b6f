#!/usr/bin/env python3
"""The room of samples/c in Python: a job whose progress is shown, then the same render in one call: the same bits.

    UPS_LIBRARY=build/release/src/api PYTHONPATH=bindings/python samples/python/room.py [iterations]
"""
import sys

import numpy as np
import ups

DOWNLIGHT_IES = b"""IESNA:LM-63-2002
[TEST] none
[TESTLAB] none
[ISSUEDATE] 2026-01-01
[MANUFAC] UPS samples
TILT=NONE
1 -1 1 10 1 1 2 0 0 0
1 1 20
0 10 20 30 40 50 60 70 80 90
0
1000 970 880 740 560 370 190 70 15 0
"""


def add_room(scene, size):
    """A box of matte quads around the origin's octant; bits 0, 1, 2 of a corner: at the far x, y, z."""
    corners = np.array([[(c >> axis & 1) * size[axis] for axis in range(3)] for c in range(8)])
    surfaces = ((0.2, [(0, 1, 3, 2)]),  # floor
                (0.8, [(4, 6, 7, 5)]),  # ceiling
                (0.5, [(0, 4, 5, 1), (1, 5, 7, 3), (3, 7, 6, 2), (2, 6, 4, 0)]))
    for reflectance, quads in surfaces:
        material = scene.add_material(reflectance_rgb=[reflectance] * 3)
        triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
        scene.add_instance(scene.add_mesh(corners, triangles, material))


def render_with_progress(scene, **limits):
    with scene.start(**limits) as job:
        while job.wait(0.1) == ups.Status.TIMEOUT:
            progress = job.poll()
            print(f"\r{progress.fraction:4.0%}, {progress.iterations_done} iterations, {progress.elapsed_s:.1f} s ",
                  end="", file=sys.stderr, flush=True)
        print(file=sys.stderr)
        return job.result()


def main():
    iterations = int(sys.argv[1]) if len(sys.argv) > 1 else 32
    size = (4.0, 3.0, 2.6)
    context = ups.Context()
    scene = ups.Scene(context)
    add_room(scene, size)
    profile = ups.Profile.parse(context, DOWNLIGHT_IES)
    scene.add_luminaire(profile, to_world=ups.translation(size[0] / 2, size[1] / 2, size[2] - 0.1))
    x, y = np.meshgrid((np.arange(8) + 0.5) * size[0] / 8, (np.arange(6) + 0.5) * size[1] / 6)
    meters = scene.add_meters(np.column_stack((x.ravel(), y.ravel(), np.full(x.size, 0.75))), normals=(0, 0, 1))
    scene.commit()
    print(f"{profile.format}, {profile.info.flux_lm:.0f} lm; effects and techniques:")
    print(scene.text(ups.SceneText.EFFECTS) + scene.text(ups.SceneText.TECHNIQUES))

    result = render_with_progress(scene, iteration_count=iterations, seed=7)
    readings = result.meters(meters)
    for row in readings.reshape(6, 8)[::-1]:
        print("  ".join(f"{r['illuminance_lx']:6.1f} ±{r['error_bound_lx']:5.1f}" for r in row))
    statistics = result.statistics(meters)
    print(f"mean {statistics.mean_lx:.1f} lx, uniformity {statistics.uniformity:.2f}")
    for error in (0.02, 0.01, 0.005):
        p = result.predict(error)  # of the worst meter; target_criterion says otherwise
        when = f"{p.seconds:.1f} s ({p.seconds_low:.1f} to {p.seconds_high:.1f})" if p.seconds >= 0 else "not known"
        print(f"time for {error:.1%}: {when}")

    # The same seed and the same iterations give the same bits, whoever waits for them.
    again = scene.render(iteration_count=iterations, seed=7).meters(meters)
    if readings.tobytes() != again.tobytes():
        sys.exit("two renders with the same seed differ")
    print("rendered again with the same seed: the same bits")


if __name__ == "__main__":
    main()
