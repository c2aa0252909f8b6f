#!/usr/bin/env python3
"""What each technique of Unified Path Sampling brings to a picture: one picture, out/techniques/techniques.png.

  show_techniques.py --ups build/release/bin/ups

renders the statue of samples/evaluation (or --scene) with --technique-images and shows, from top to bottom: what path
integration and density estimation bring and both together, as figure 9 of Hachisuka, Pantaleoni and Jensen (2012); the
share of each family, as their figure 10; and each technique (s, t) with its weight and without, by the length of its
paths. All panels are in cd/m2 at one exposure.

Merging starts at one radius for all pixels, picked by hand as in the paper and many pixels wide. Left to itself
(--merge-radius 0) the library starts at one and a half pixels: merging and joining light paths to the camera (t = 1)
then share the caustic's light, and path integration shows yellow too.
"""
import argparse
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import matplotlib  # noqa: E402
import numpy as np  # noqa: E402
from exr import read_layers, read_rgb  # noqa: E402
from png import srgb  # noqa: E402

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

STATUE = os.path.join(HERE, "..", "evaluation", "statue.glb")
Y = np.array([0.2126, 0.7152, 0.0722])


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ups", required=True, help="the program")
    parser.add_argument("--scene", help="with one camera; default: the statue, which is made")
    parser.add_argument("--camera", default="view", help="its name")
    parser.add_argument("--merge-radius", type=float, default=0.02, help="m; 0: the library's own")
    parser.add_argument("--time", type=float, default=60, help="seconds")
    parser.add_argument("--edges", type=int, default=4, help="of the longest paths whose techniques are shown")
    parser.add_argument("--size", default="256x256")
    parser.add_argument("--out", default="out/techniques")
    return parser.parse_args()


def render(arguments):
    scene = arguments.scene
    if not scene:
        scene = STATUE
        subprocess.run([sys.executable, os.path.join(HERE, "..", "evaluation", "make_statue.py")], check=True)
    radius = ["--merge-radius", str(arguments.merge_radius)] if arguments.merge_radius > 0 else []
    subprocess.run([arguments.ups, "render", scene, "--method", "ups", "--time", str(arguments.time), "--size",
                    arguments.size, "--technique-images", str(arguments.edges), "--out", arguments.out, *radius],
                   check=True)


def exposed(image, white):
    """sRGB of luminances; `white` cd/m2 is the brightest."""
    return srgb(image / white)


def show(axes, image, title, **options):
    axes.imshow(image, **options)
    axes.set_title(title, fontsize=7, pad=3)


def techniques(edges):
    """Rows of (layer, label): paths of 2 edges, of 3 ...; path integration first."""
    for k in range(2, edges + 1):
        yield ([(f"connect_s{s}_t{k + 1 - s}", f"s = {s}, t = {k + 1 - s}") for s in range(k + 1)]
               + [(f"merge_s{s}_t{k + 2 - s}", f"merge s = {s}, t = {k + 2 - s}") for s in range(2, k + 1)])


def draw(arguments, image, layers, out):
    rows = list(techniques(arguments.edges))
    columns = max(len(row) for row in rows)
    side = 1.3
    figure = plt.figure(figsize=(side * columns, side * (columns / 5 + 0.4 + 2.5 * len(rows))), dpi=110)
    white = np.quantile(image @ Y, 0.98)
    top, grid = figure.subfigures(2, 1, height_ratios=[columns / 5 + 0.4, 2.5 * len(rows)])
    path, density = layers["path_integration"], layers["density_estimation"]
    titles = ["path integration", "density estimation", "both", "share of path integration",
              "share of density estimation"]
    whole = np.maximum(image @ Y, 1e-9)
    pictures = [exposed(p, white) for p in (path, density, image)]
    pictures += [np.clip(p @ Y / whole, 0, 1) for p in (path, density)]
    for axes, picture, title in zip(top.subplots(1, 5), pictures, titles):
        show(axes, picture, title, cmap="gray", vmin=0, vmax=1)
    top.subplots_adjust(left=0.02, right=0.99, bottom=0.02, top=0.9, wspace=0.04)
    panels = grid.subplots(2 * len(rows), columns, squeeze=False)
    grid.subplots_adjust(left=0.04, right=0.99, bottom=0.01, top=0.97, wspace=0.04, hspace=0.22)
    for k, row in enumerate(rows):
        for j in range(columns):
            for i, kind in enumerate(("weighted", "unweighted")):
                axes = panels[2 * k + i, j]
                if j < len(row):
                    layer, label = row[j]
                    show(axes, exposed(layers[f"{layer}.{kind}"], white), f"{label}\n{kind}")
                else:
                    axes.set_visible(False)
        panels[2 * k, 0].set_ylabel(f"{k + 2} edges", fontsize=8)
    for axes in figure.axes + [a for s in figure.subfigs for a in s.axes]:
        axes.set_xticks([])
        axes.set_yticks([])
    figure.savefig(out)
    plt.close(figure)


def main():
    arguments = parse()
    render(arguments)
    image = read_rgb(os.path.join(arguments.out, arguments.camera + ".exr"))
    layers = read_layers(os.path.join(arguments.out, arguments.camera + "_techniques.exr"))
    out = os.path.join(arguments.out, "techniques.png")
    draw(arguments, image, layers, out)
    total = image.sum()
    for name in ("path_integration", "density_estimation"):
        r, g, b = layers[name].mean((0, 1))
        print(f"{name}: {100 * layers[name].sum() / total:.1f} % of the picture; "
              f"mean R, G, B {r:.3g}, {g:.3g}, {b:.3g} cd/m2")
    print(f"picture: {out}")


if __name__ == "__main__":
    main()
