"""The pictures of the report, readable without colour: every method has its marker, its dashes and its name at the end
of its line. Colours of Okabe and Ito (2008), which people with any colour vision tell apart. Called by accuracy.py.
"""
import io
import math

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FuncFormatter, NullFormatter, LogLocator  # noqa: E402

from errors import LEVELS, known_points  # noqa: E402

STYLES = {  # colour, marker, dashes
    "auto": ("#000000", "o", "-"), "ups": ("#0072B2", "s", (0, (6, 2))), "bpt": ("#D55E00", "^", (0, (4, 1, 1, 1))),
    "pt": ("#009E73", "D", (0, (1, 1))), "ppm": ("#CC79A7", "v", (0, (3, 1, 1, 1, 1, 1))),
    "sppm": ("#956B00", "P", (0, (8, 2, 2, 2)))}
SCENE_MARKERS = {"office": "o", "atrium": "s", "bathroom": "^"}
plt.rcParams.update({"font.size": 9.5, "axes.spines.top": False, "axes.spines.right": False, "svg.hashsalt": "ups",
                     "axes.titlesize": 10.5, "axes.titleweight": "bold", "axes.titlelocation": "left",
                     "axes.edgecolor": "#555555", "font.family": "DejaVu Sans"})


def number(value, digits=3):
    """So many digits, at least those before the point; no exponent."""
    if value == 0:
        return "0"
    places = max(0, digits - 1 - math.floor(math.log10(abs(float(f"{value:.{digits - 1}e}")))))
    text = f"{value:,.{places}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def logarithmic(axis):
    """Ticks at 1, 2, 5 of each decade, as plain numbers."""
    axis.set_major_locator(LogLocator(subs=(1, 2, 5), numticks=30))
    axis.set_major_formatter(FuncFormatter(lambda value, _: number(value)))
    axis.set_minor_formatter(NullFormatter())


def thin_ticks(axis, limits, most=9):
    """Where 1, 2, 5 would crowd, powers of ten alone."""
    decades = math.log10(limits[1] / limits[0])
    if 3 * decades > most:
        axis.set_major_locator(LogLocator(numticks=30))


def apart(heights, distance):
    """The heights moved so that none is nearer to another than `distance`; in the order given."""
    order = sorted(range(len(heights)), key=lambda k: heights[k])
    placed = [heights[k] for k in order]
    for _ in range(200):
        moved = False
        for k in range(len(placed) - 1):
            short = distance - (placed[k + 1] - placed[k])
            if short > 1e-9:
                placed[k] -= short / 2
                placed[k + 1] += short / 2
                moved = True
        if not moved:
            break
    result = [0.0] * len(heights)
    for k, height in zip(order, placed):
        result[k] = height
    return result


def name_lines(axes, ends):
    """The name of each line right of its end, none above another. ends: [(name, x, y, colour)]."""
    low, high = (math.log10(v) for v in axes.get_ylim())
    inches = axes.get_position().height * axes.figure.get_figheight()
    step = (high - low) * (10.5 / 72) / inches
    for (name, x, y, colour), height in zip(ends, apart([math.log10(y) for _, _, y, _ in ends], step)):
        axes.annotate(name, (x, y), (1.03, (height - low) / (high - low)), "data", "axes fraction", color=colour,
                      va="center", fontsize=9.5, fontweight="bold" if name.startswith("auto") else "normal",
                      arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.5, "shrinkA": 0, "shrinkB": 3})


def error_axes(axes, lines, title, floor=None, marked=()):
    """Error, %, against seconds. lines: {method: points}, some known; floor: error of the reference; marked: methods
    with a star."""
    ends, all_points = [], []
    for method, points in lines.items():
        points = known_points(points)
        if not points:
            continue
        colour, marker, dashes = STYLES[method]
        x, y = [s for s, _ in points], [100 * e for _, e in points]
        axes.plot(x, y, color=colour, linestyle=dashes, marker=marker, markersize=5, linewidth=1.6,
                  markerfacecolor="white" if method != "auto" else colour, markevery=max(1, len(x) // 6))
        ends.append((method + ("*" if method in marked else ""), x[-1], y[-1], colour))
        all_points += list(zip(x, y))
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_title(title)
    axes.set_xlabel("time, s")
    low_x, high_x = min(x for x, _ in all_points), max(x for x, _ in all_points)
    low_y, high_y = min(y for _, y in all_points), max(y for _, y in all_points)
    x_limits, y_limits = (low_x / 1.15, high_x * 1.15), (min(low_y / 1.4, 0.8), max(high_y * 1.4, 6))
    axes.set_xlim(x_limits)
    axes.set_ylim(y_limits)
    for axis, limits in ((axes.xaxis, x_limits), (axes.yaxis, y_limits)):
        logarithmic(axis)
        thin_ticks(axis, limits)
    for level in LEVELS:
        axes.axhline(100 * level, color="#999999", linewidth=0.6, zorder=0)
        axes.text(x_limits[0] * 1.02, 100 * level, f"{100 * level:g} %", fontsize=8, color="#555555", va="bottom")
    if floor and 100 * floor > y_limits[0]:
        axes.fill_between(x_limits, y_limits[0], 100 * floor, facecolor="none", edgecolor="#bbbbbb", hatch="///",
                          linewidth=0, zorder=0)
    name_lines(axes, ends)


def svg(figure):
    """Bytes of the figure, letters as outlines, the same for the same figure."""
    out = io.BytesIO()
    figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None})
    plt.close(figure)
    return out.getvalue()


def png(figure, path):
    figure.savefig(path, dpi=130, metadata={"Software": None})


def error_figure(lines, title, quantity, floor=None, marked=()):
    """None where no error is known."""
    if not any(known_points(points) for points in lines.values()):
        return None
    figure, axes = plt.subplots(figsize=(4.7, 3.7))
    figure.subplots_adjust(left=0.15, right=0.83, top=0.90, bottom=0.14)
    error_axes(axes, lines, title, floor, marked)
    axes.set_ylabel(quantity)
    return figure


def main_figure(panels):
    """True error of every scene side by side. panels: [(title, lines, floor, marked)]."""
    figure, all_axes = plt.subplots(1, len(panels), figsize=(4.3 * len(panels), 3.8), squeeze=False)
    figure.subplots_adjust(left=0.16 / len(panels), right=1 - 0.17 / len(panels), top=0.90, bottom=0.14, wspace=0.42)
    for axes, (title, lines, floor, marked) in zip(all_axes[0], panels):
        error_axes(axes, lines, title, floor, marked)
    all_axes[0][0].set_ylabel("error that 95 % of the meters keep, %")
    return figure


def prediction_figure(rows):
    """Predicted against actual seconds; None where no prediction was of a time that was reached."""
    rows = [r for r in rows if r["status"] == "reached" and r["predicted_seconds"] > 0 and r["low_seconds"] > 0]
    if not rows:
        return None
    figure, axes = plt.subplots(figsize=(4.7, 4.1))
    figure.subplots_adjust(left=0.15, right=0.95, top=0.90, bottom=0.14)
    values = [r[key] for r in rows for key in ("actual_seconds", "predicted_seconds")]
    limits = (min(values) / 2, max(values) * 2)
    for scene, marker in SCENE_MARKERS.items():
        of_scene = [r for r in rows if r["scene"] == scene]
        if of_scene:
            x, y, low, high = ([r[f"{key}_seconds"] for r in of_scene]
                               for key in ("actual", "predicted", "low", "high"))
            axes.vlines(x, low, [h if h >= 0 else limits[1] for h in high], color="#777777", linewidth=1)
            axes.plot(x, y, marker, color="#000000", markerfacecolor="white", markersize=6, label=scene)
    axes.plot(limits, limits, color="#999999", linewidth=0.8, zorder=0)
    for axis, set_scale in ((axes.xaxis, axes.set_xscale), (axes.yaxis, axes.set_yscale)):
        set_scale("log")
        logarithmic(axis)
        thin_ticks(axis, limits)
    axes.set_xlim(limits)
    axes.set_ylim(limits)
    axes.set_xlabel("time that it took, s")
    axes.set_ylabel("time that was predicted, s")
    axes.set_title("Predicted and actual time")
    axes.legend(frameon=False, fontsize=9, loc="upper left")
    return figure


def knob_figure(title, rows):
    """Above what an iteration costs, below the error at equal time."""
    figure, (above, below) = plt.subplots(2, 1, figsize=(4.7, 4.2), sharex=True)
    figure.subplots_adjust(left=0.16, right=0.96, top=0.91, bottom=0.12, hspace=0.18)
    x = range(len(rows))
    above.bar(x, [r["cpu_ms_per_iteration"] for r in rows], width=0.5, color="#8fb8d6", edgecolor="#33566e")
    for k, row in enumerate(rows):
        above.annotate(number(row["cpu_ms_per_iteration"]), (k, row["cpu_ms_per_iteration"]), (0, 2),
                       textcoords="offset points", ha="center", fontsize=8.5)
    above.margins(y=0.18)
    above.set_ylabel("an iteration,\nms of processor")
    above.set_title(title)
    highest = 0.0
    series = (("stated", "stated_median", "o", "-", "#000000"), ("true", "true_p95", "s", (0, (4, 2)), "#D55E00"),
              ("image", "image_noise", "^", (0, (1, 1)), "#0072B2"))
    for label, key, marker, dashes, colour in series:
        points = [(k, 100 * row[key]) for k, row in enumerate(rows) if row[key] >= 0]
        if points:
            below.plot(*zip(*points), marker=marker, linestyle=dashes, color=colour, markerfacecolor="white",
                       label=label)
            highest = max(highest, *(value for _, value in points))
    below.set_ylim(0, 1.35 * highest or 1)  # room for the legend
    below.margins(x=0.12)
    below.set_ylabel("error at\nequal time, %")
    below.set_xticks(list(x), [row["value"] for row in rows])
    if below.get_legend_handles_labels()[0]:
        below.legend(frameon=False, fontsize=8.5, ncols=3, loc="upper right")
    return figure
