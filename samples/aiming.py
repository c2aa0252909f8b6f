"""Draws aiming.png: where H and V of a table of type A and of type B point in the frame of a luminaire's node.

    python3 samples/aiming.py        writes samples/aiming.png; needs numpy and matplotlib
"""
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

PLANES, GREY, LIGHT, FIRST, SECOND = "#8aa0b8", "#555555", "#e08a00", "#005caf", "#b03060"
H, V = 40.0, 30.0  # of the direction that is drawn


def type_a(h, v):
    """Right, forward, up of LM-63's type A: planes H through the upright axis, V above the horizon in each."""
    h, v = np.radians(h), np.radians(v)
    return np.array([np.cos(v) * np.sin(h), np.cos(v) * np.cos(h), np.sin(v)])


def type_b(h, v):
    """Of type B: planes V through the axis from left to right, H from the middle to the right in each."""
    h, v = np.radians(h), np.radians(v)
    return np.array([np.sin(h), np.cos(h) * np.cos(v), np.cos(h) * np.sin(v)])


def arrow(axes, tip, text, colour, offset):
    axes.quiver(0, 0, 0, *tip, color=colour, linewidth=2, arrow_length_ratio=0.09)
    axes.text(*(np.array(tip) + offset), text, color=colour, fontsize=9, ha="center", va="center")


def draw(axes, direction, is_a, title):
    ends = np.linspace(-90, 90, 91)
    for plane in range(-60, 61, 20):
        curve = np.array([direction(plane, e) if is_a else direction(e, plane) for e in ends])
        axes.plot(*curve.T, color=PLANES, linewidth=1.6 if plane == 0 else 0.7)
    first, second = ("H", "V") if is_a else ("V", "H")
    turn = np.linspace(0, H if is_a else V, 30)  # from plane 0 to the plane, then along it
    rise = np.linspace(0, V if is_a else H, 30)
    to_plane = np.array([direction(t, 0) if is_a else direction(0, t) for t in turn])
    in_plane = np.array([direction(H, r) if is_a else direction(r, V) for r in rise])
    axes.plot(*to_plane.T, color=FIRST, linewidth=3)
    axes.plot(*in_plane.T, color=SECOND, linewidth=3)
    axes.text(*(to_plane[15] * 1.14), f"+{first}", color=FIRST, fontsize=12, weight="bold", ha="center")
    beside = in_plane[12] + (-0.07, 0.1, 0) if is_a else in_plane[15] * 1.14
    axes.text(*beside, f"+{second}", color=SECOND, fontsize=12, weight="bold", ha="center")
    tip = direction(H, V)
    axes.quiver(0, 0, 0, *tip, color=LIGHT, linewidth=2.5, arrow_length_ratio=0.1)
    arrow(axes, (0, 1.6, 0), "forward: H 0, V 0\nnode -Z, gamma 0", GREY, (0, 0.12, 0.3))
    arrow(axes, (1.35, 0, 0), "right\nnode -Y, C270", GREY, (0.12, 0, 0.22))
    arrow(axes, (0, 0, 1.3), "up\nnode +X, C0", GREY, (0, 0, 0.17))
    axes.set_title(title, fontsize=11)
    axes.set_xlim(-0.55, 1.15), axes.set_ylim(-0.2, 1.5), axes.set_zlim(-0.75, 0.95)
    axes.set_box_aspect((1, 1, 1))
    axes.view_init(elev=24, azim=-146)
    axes.set_axis_off()


def main():
    figure = plt.figure(figsize=(11, 5.4), dpi=100)
    for place, (direction, is_a, title) in enumerate((
            (type_a, True, "Type A: planes H about the upright axis, V in each plane"),
            (type_b, False, "Type B: planes V about the axis to the right, H in each plane"))):
        draw(figure.add_subplot(1, 2, place + 1, projection="3d"), direction, is_a, title)
    figure.subplots_adjust(left=0, right=1, bottom=0, top=0.93, wspace=0)
    figure.savefig(Path(__file__).with_suffix(".png"), metadata={"Software": None})


if __name__ == "__main__":
    main()
