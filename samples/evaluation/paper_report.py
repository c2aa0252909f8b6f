"""Tables and pictures of paper.py: ratios of errors in Markdown, curves of the error, images side by side."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import matplotlib  # noqa: E402
import numpy as np  # noqa: E402
from exr import read_rgb  # noqa: E402
from png import srgb  # noqa: E402

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

COLOURS = {"bpt": "tab:blue", "ppm": "tab:orange", "sppm": "tab:green", "ups": "tab:red"}
BASE = "ups"


def _markdown(rows):
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join([lines[0], "|" + "---|" * len(rows[0]), *lines[1:]]) + "\n"


def _number(value):
    return "-" if value is None or not value == value else f"{value:.3g}"


def _over(of, other, name):
    """Of `of[name]` to `other[name]`; None where one of them is not known."""
    return of[name] / other[name] if other[name] and of[name] == of[name] and other[name] == other[name] else None


def ratios(name, scene, methods, times, points):
    """Errors over those of `ups` at each time, and every method at the longest one, with the paper's figures beside."""
    text = f"### {name}\n\n"
    others = [m for m in methods if m != BASE] if BASE in methods else []
    if others:
        rows = [["time", *(f"{m.upper()}/UPS" for m in others)]]
        for time in times:
            base = points[BASE, time]
            pairs = [[_number(_over(points[m, time], base, e)) for e in ("rmse", "trimmed_rmse")] for m in others]
            rows.append([f"{time:.3g} s", *(f"{whole} ({trimmed})" for whole, trimmed in pairs)])
        if scene.rmse:
            rows.append([f"the paper, {scene.minutes:g} min",
                         *(_number(scene.rmse[m] / scene.rmse[BASE]) if m in scene.rmse else "-" for m in others)])
        text += "RMSE over that of UPS at equal time (in brackets: without the worst 0.1 % of the pixels):\n\n"
        text += _markdown(rows) + "\n"
    rows = [["method", "time", "iterations", "samples/pixel", "to UPS", "paper's", "RMSE", "median", "trimmed",
             "relative MSE", "reference's share"]]
    for m in methods:
        p = points[m, times[-1]]
        to_base = _over(p, points[BASE, times[-1]], "samples_per_pixel") if BASE in methods else None
        rows.append([m, f"{p['time_s']:.2f} s", f"{p['iterations']:.0f}", f"{p['samples_per_pixel']:.1f}",
                     _number(to_base), _number(scene.samples[m] / scene.samples[BASE] if m in scene.samples else None),
                     *(_number(p[error]) for error in ("rmse", "median_rmse", "trimmed_rmse", "relative_mse")),
                     f"{100 * p['reference_share']:.1f} %"])
    text += (f"At {times[-1]:g} s; samples per pixel over those of UPS beside the paper's (table 2); RMSE in cd/m²;\n"
             "the reference's share of the squared difference, which is subtracted:\n\n")
    return text + _markdown(rows)


def plot(path, name, methods, times, points, lines):
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.2), sharey=True)
    # The time that the iterations were meant for: that which was measured shows what else the machine did.
    abscissae = {"time [s]": lambda time, line: time, "samples per pixel": lambda time, line: line["samples_per_pixel"]}
    for axis, (label, x) in zip(axes, abscissae.items()):
        for method in methods:
            colour = COLOURS.get(method, "black")
            of = [(time, points[method, time]) for time in times]
            axis.loglog([x(*p) for p in of], [p["rmse"] for _, p in of], "o-", color=colour, label=method.upper())
            seeds = [(time, line) for time in times for line in lines[method, time] if line["rmse"] > 0]
            axis.loglog([x(*s) for s in seeds], [s["rmse"] for _, s in seeds], ".", color=colour, alpha=0.4,
                        markersize=4)
        axis.set_xlabel(label)
        axis.grid(True, which="both", alpha=0.25)
    axes[0].set_ylabel("RMSE [cd/m²]")
    axes[0].legend()
    figure.suptitle(f"{name}: error against time and samples")
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def _exposure(rgb):
    """Shows the geometric mean of the lit pixels as middle grey."""
    luminance = rgb @ np.array([0.2126, 0.7152, 0.0722])
    lit = luminance[luminance > 1e-6 * luminance.max()]
    return 0.25 / np.exp(np.log(lit).mean())


def _shown(rgb, exposure):
    """Rolls off bright light, then sRGB."""
    return srgb(1 - np.exp(-np.clip(rgb * exposure, 0, None)))


def panel(path, name, scene, methods, time, points, lines, reference_dir, camera):
    """The images of the first seed at the longest time, and the reference, at one exposure."""
    reference = read_rgb(os.path.join(reference_dir, camera + ".exr"))
    exposure = _exposure(reference)
    images = [(m.upper(), read_rgb(os.path.join(lines[m, time][0]["out"], camera + ".exr"))) for m in methods]
    images.append(("reference", reference))
    height, width = reference.shape[:2]
    figure, axes = plt.subplots(1, len(images), figsize=(3.2 * len(images), 3.2 * height / width + 0.75))
    for axis, (title, image), method in zip(axes, images, [*methods, None]):
        axis.imshow(_shown(image, exposure), interpolation="nearest")
        axis.set_xticks([])
        axis.set_yticks([])
        note = title
        if method:
            p = points[method, time]
            note += f"  {p['samples_per_pixel']:.0f} spp\nRMSE {p['rmse']:.3g} cd/m²"
            if method in scene.rmse:
                note += f"  (the paper's: {scene.rmse[method]:g})"
        axis.set_title(note, fontsize=9)
    figure.suptitle(f"{name}: {time:g} s each", fontsize=10)
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)
