#!/usr/bin/env python3
"""Point meters in light that only photons find: prints each figure beside what is wanted; the exit code is 1 where one
is not reached.

  hard_meters.py --ups build/release/bin/ups [--baseline ../earlier/build/release/bin/ups] [ball image]

ball    32 x 32 meters 4 cm apart in the caustic of a ball of glass, whose folds the lamp's opening makes 8 cm soft:
        sqrt(sum (E - E_ref)^2 / sum E_ref^2), the reference's own noise taken out, after 5 s on two cores, and from 2
        million light paths over the baseline's. The reference: landings on cells of 5 mm around each meter, from 268
        million light paths
image   a lamp that only a large mirror shows to eight meters, one of them 12 cm beside the edge of its light: the
        largest error after 5 s on two cores, and of the one beside the edge after 10 s; its bound must hold

Seconds on two cores are twice as many of processor time on one thread, so that the machine may do something else too.
All is read from the worst of the seeds; of the ball's figures, from their mean.
"""
import os
import statistics
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "scenes_common"), os.path.join(HERE, "..", "evaluation")]
import need_numpy  # noqa: E402,F401
import known_light  # noqa: E402
import numpy as np  # noqa: E402
from gltf_builder import Frame, GltfBuilder  # noqa: E402
from ies import write_axial  # noqa: E402
from measuring import Candidate  # noqa: E402
from must_show import run_cases  # noqa: E402
from renders import Renderer, read_table  # noqa: E402
from shapes import check_closed, sphere  # noqa: E402

CORES = 2
GRID, PITCH, CELL = 32, 0.04, 0.005
BALL, BALL_AT, LAMP_AT = 1.2, np.array([0, 0, 1.5]), np.array([1.0, 0, 4.4])
OPENING = 0.16   # of the lamp, m: a fold moves against it by half as much, as the floor is half as far from the ball
BEAM = 22.0      # degrees; the ball is seen under 23
EQUAL = ("--light-paths", "32768", "--iterations", "64")
REFERENCE = ("--light-paths", "262144", "--iterations", "1024")
REFERENCE_SEED = 2 ** 40 + 1


def read(folder, name, column):
    return np.array([row[column] for row in read_table(folder, name)])


# ---- the caustic of a ball ------------------------------------------------------------------------------------------

def ball_scene(path, cells):
    """A ball of 1.2 m between a floor and a lamp whose beam it fills: its light falls on 1 m, with folds at the edge.
    The meters as points, or each a cell."""
    scene = GltfBuilder("UPS hard_meters.py")
    known_light.add_room(scene, (-3, -3, -0.001), (3, 3, 5))
    scene.shape("ball", check_closed(sphere(BALL, 256, 512), "ball").moved(*BALL_AT),
                scene.material("glass", {"model": "glass", "ior": 1.5}))
    axes = Frame.along(LAMP_AT - BALL_AT).axes
    scene.luminaire("lamp", Frame(LAMP_AT, axes[:, 0], axes[:, 1]), file="beam.ies")
    write_axial(os.path.join(os.path.dirname(path), "beam.ies"), (0, BEAM - 0.5, BEAM, 90),
                (known_light.CANDELA, known_light.CANDELA, 0, 0), [("TEST", "computed by hard_meters.py")],
                opening_diameter=OPENING)
    points = known_light.square_of(GRID, (-0.4, 0), PITCH, 0.0)
    if cells:
        for k, point in enumerate(points):
            scene.meters(f"{k}", Frame.upright(point), width_m=CELL, height_m=CELL, columns=1, rows=1, area=True)
    else:
        scene.meters("meters", Frame.upright((0, 0, 0)), points_m=points.tolist())
    known_light.write_quietly(scene, path)
    return path


def ball_reference(ups, out):
    """(lx, standard errors); kept as long as the scene and the words are the same."""
    folder = os.path.join(out, "reference")
    path = ball_scene(os.path.join(out, "cells.glb"), cells=True)
    Renderer(ups, path).reference("lt", REFERENCE_SEED, list(REFERENCE), folder)
    rows = [read_table(folder, str(k))[0] for k in range(GRID ** 2)]
    return tuple(np.array([row[column] for row in rows]) for column in ("illuminance_lx", "standard_error_lx"))


def distance(E, reference):
    """L2, without the reference's own noise."""
    lux, noise = reference
    known = np.maximum(noise, 0)  # of cells without light it is not known
    return float(np.sqrt(max(((E - lux) ** 2).sum() - (known ** 2).sum(), 0) / (lux ** 2).sum()))


def of_worst(E, reference):
    """The share of the squared error that the worst 1 % of the meters make; 1 % at the least."""
    squares = np.sort((E - reference[0]) ** 2)
    return float(squares[-round(0.01 * len(squares)):].sum() / squares.sum())


def ball_distances(ups, path, words, seeds, reference, out):
    found, worst = [], []
    for seed in range(1, seeds + 1):
        folder = os.path.join(out, f"{seed}")
        Renderer(ups, path, 1).render("auto", seed, list(words), folder)
        E = read(folder, "meters", "illuminance_lx")
        found.append(distance(E, reference))
        worst.append(of_worst(E, reference))
    print(f"  L2 of each seed: {', '.join(f'{d:.2%}' for d in found)} ({os.path.basename(out)}); of the squared error "
          f"{statistics.fmean(worst):.0%} from the worst 1 % of the meters", flush=True)
    return statistics.fmean(found)


def ball(arguments, figures):
    out = os.path.join(arguments.out, "ball")
    os.makedirs(out, exist_ok=True)
    path = ball_scene(os.path.join(out, "points.glb"), cells=False)
    reference = ball_reference(arguments.ups, out)
    lux, noise = reference
    print(f"  L2 of the reference's own noise: {np.sqrt((noise.clip(0) ** 2).sum() / (lux ** 2).sum()):.2%}, "
          f"{(lux > 0.01 * lux.max()).sum()} meters lit")

    def of(ups, words, name):
        return ball_distances(ups, path, words, arguments.seeds, reference, os.path.join(out, name))

    now = of(arguments.ups, EQUAL, "equal")
    if arguments.baseline:
        figures.tell("ball: L2 over the baseline's, from equally many light paths",
                     now / of(arguments.baseline, EQUAL, "baseline"), 0.6)
    iterations = Candidate(arguments.ups, "auto", path).calibrated(5 * CORES)
    figures.tell(f"ball: L2 after 5 s ({iterations} iterations), %",
                 100 * of(arguments.ups, ("--iterations", str(iterations)), "after_5_s"), 2)


# ---- a lamp in a mirror ---------------------------------------------------------------------------------------------

def image(arguments, figures):
    known = known_light.mirror_edge(0.12)
    out = os.path.join(arguments.out, "image")
    os.makedirs(out, exist_ok=True)
    candidate = Candidate(arguments.ups, "auto", known.scene(out))
    lux, edge = known.lux, known_light.AT_EDGE
    for seconds in (5, 10):
        iterations = candidate.calibrated(seconds * CORES)
        errors, held = [], []
        for seed in range(1, arguments.seeds + 1):
            candidate.render(seed, iterations, os.path.join(out, f"{seconds}"))
            E, bound = (read(os.path.join(out, f"{seconds}"), "meters", column)
                        for column in ("illuminance_lx", "error_bound_lx"))
            errors.append(np.abs(E / lux - 1))
            held.append(np.abs(E - lux) <= bound)
        errors, held = np.array(errors), np.array(held)
        of_each = ", ".join(f"{100 * e:.2f}" for e in np.sqrt((errors ** 2).mean(0)))
        print(f"  after {seconds} s ({iterations} iterations), rms of each meter over {arguments.seeds} seeds, %: "
              f"{of_each}; bounds held {held.mean():.1%}")
        if seconds == 5:
            figures.tell("image: largest error of a meter after 5 s, %", 100 * errors.max(), 1)
            figures.tell("image: seeds in which the bound beside the edge holds, %", 100 * held[:, edge].mean(), 93,
                         at_least=True)
        else:
            figures.tell("image: largest error beside the edge after 10 s, %", 100 * errors[:, edge].max(), 1)


if __name__ == "__main__":
    run_cases(__doc__, {"ball": ball, "image": image}, "out/hard_meters")
