"""Pictures of what a render found, on matplotlib: luminance, false colours, isolux lines, polar diagrams, convergence.

    import ups.plot
    ups.plot.isolux(positions_m, result.meters(sensor)["illuminance_lx"])
    matplotlib.pyplot.show()

Each function draws into `ax`, by default of a new figure, and returns it.
"""
from __future__ import annotations

import os
import tempfile
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Union

import matplotlib.colors
import matplotlib.image
import matplotlib.pyplot
import numpy as np

from . import _images
from ._convert import as_array
from ._job import Job
from ._profile import Profile
from ._result import Result
from ._scene import Scene

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

Axes = Any  # matplotlib has no types

_UNKNOWN = "0.6"  # grey


def _axes(ax: Axes | None, **subplot: Any) -> Axes:
    return matplotlib.pyplot.subplots(subplot_kw=subplot)[1] if ax is None else ax


def _known(values: ArrayLike, shape: Sequence[int], name: str) -> NDArray[np.float64]:
    """NaN, which matplotlib leaves out, where they are below 0 or not finite: not known."""
    a = as_array(values, np.float64, shape, name)
    return np.where(np.isfinite(a) & (a >= 0), a, np.nan)


def picture(luminance_rgb: ArrayLike, exposure: float = 0, ax: Axes | None = None) -> Axes:
    """Luminance (height, width, 3), cd/m^2, as ups.write_png shows it. exposure 0: chosen from the image."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "picture.png")
        _images.write_png(path, luminance_rgb, exposure)
        pixels = matplotlib.image.imread(path)
    ax = _axes(ax)
    ax.imshow(pixels)
    ax.set_axis_off()
    return ax


def false_color(values: ArrayLike, unit: str = "lx", scale: tuple[float, float] | None = None, log: bool = False,
                first_row_at_bottom: bool = False, ax: Axes | None = None) -> Axes:
    """Values (rows, columns) with a scale: illuminance or luminance of an image, or a grid of meters with its
    first_row_at_bottom. Below 0 or not finite: not known, grey, as is 0 with log. scale: its ends; None: 0 (with log
    the least) to the 99th percentile."""
    a = _known(values, (-1, -1), "values")
    if log:
        a[a == 0] = np.nan
    known = a[np.isfinite(a)]
    if scale is None:
        scale = (float(known.min()) if log else 0.0, float(np.percentile(known, 99))) if len(known) else (0.1, 1.0)
    ax = _axes(ax)
    colours = matplotlib.pyplot.get_cmap("viridis").copy()
    colours.set_bad(_UNKNOWN)
    norm = (matplotlib.colors.LogNorm if log else matplotlib.colors.Normalize)(*scale)
    image = ax.imshow(a, cmap=colours, norm=norm, origin="lower" if first_row_at_bottom else "upper")
    extend = "max" if len(known) and known.max() > scale[1] else "neither"
    ax.figure.colorbar(image, ax=ax, label=unit, extend=extend)
    ax.set_xticks([])
    ax.set_yticks([])
    return ax


def _on_lattice(x: NDArray[np.float64], y: NDArray[np.float64], values: NDArray[np.float64]) -> Any:
    """(xs, ys, values (ys, xs)) of points in rows along the axes, NaN where a place has none, as in the notch of an L;
    None where they are not in rows."""
    xs, column = np.unique(np.round(x, 6), return_inverse=True)
    ys, row = np.unique(np.round(y, 6), return_inverse=True)
    if len(xs) * len(ys) > 4 * len(x):
        return None
    table = np.full((len(ys), len(xs)), np.nan)
    table[row, column] = values
    return xs, ys, table


def isolux(positions_m: ArrayLike, illuminance_lx: ArrayLike, levels: Sequence[float] | int | None = None,
           filled: bool = True, ax: Axes | None = None) -> Axes:
    """Lines of equal illuminance over x and y, from meters at positions (n, 3). levels: in lx, ascending, or about how
    many; None: chosen. Meters whose value is not known (< 0) are left out. Between meters that stand in rows along the
    axes it is linear within each cell of four, elsewhere within triangles."""
    p = as_array(positions_m, np.float64, (-1, 3), "positions_m")
    values = _known(illuminance_lx, (len(p),), "illuminance_lx")
    ax = _axes(ax)
    lattice = _on_lattice(p[:, 0], p[:, 1], values)
    if lattice is None:
        use = np.isfinite(values)
        arguments, plain, fill = (p[use, 0], p[use, 1], values[use]), ax.tricontour, ax.tricontourf
    else:
        arguments, plain, fill = lattice, ax.contour, ax.contourf
        if min(lattice[2].shape) < 2:
            raise ValueError("positions_m: isolux lines need at least two rows and two columns of meters")
    if filled:
        filling = fill(*arguments, levels=levels, cmap="viridis", extend="both" if np.iterable(levels) else "neither")
        ax.figure.colorbar(filling, ax=ax, label="lx")
        levels = filling.levels
    lines = plain(*arguments, levels=levels, colors="black", linewidths=0.7)
    ax.clabel(lines, fmt="%g", fontsize="small")
    ax.set_aspect("equal")
    ax.set_xlabel("x, m")
    ax.set_ylabel("y, m")
    return ax


def plan(scene: Scene, height_m: float, ax: Axes | None = None) -> Axes:
    """What a horizontal plane cuts of the committed scene, thick, and the edges beneath it, thin."""
    ax = _axes(ax)
    at, up = (0, 0, height_m), (0, 0, 1)
    for segments, width in ((scene.outlines(at, up), 0.5), (scene.section(at, up), 2)):
        if len(segments):
            ax.plot(*np.moveaxis(segments[..., :2], 2, 0).swapaxes(1, 2), color="0.3", linewidth=width)
    ax.set_aspect("equal")
    return ax


def polar(profile: Profile, planes_deg: Sequence[float] = (0, 90), per_klm: bool = False,
          ax: Axes | None = None) -> Axes:
    """Luminous intensity in each plane C / C + 180 over gamma, 0 downwards, C to the right. per_klm: of 1000 lm of
    the lamps, of what comes without any (absolute photometry) of its own light. An `ax` of the caller's must be
    polar."""
    ax = _axes(ax, projection="polar")
    gamma = np.radians(np.linspace(-180, 180, 721))
    info = profile.info
    factor = 1000 / (info.rated_flux_lm if info.light_output_ratio >= 0 else info.flux_lm) if per_klm else 1
    for c_deg in planes_deg:
        c = np.radians(c_deg)
        directions = np.column_stack([np.sin(gamma) * np.cos(c), np.sin(gamma) * np.sin(c), -np.cos(gamma)])
        ax.plot(gamma, factor * profile.intensity_cd(directions), label=f"C{c_deg:g} / C{(c_deg + 180) % 360:g}")
    ax.set_theta_zero_location("S")
    ax.set_thetagrids(range(0, 360, 30), [f"{min(g, 360 - g)}°" for g in range(0, 360, 30)])
    ax.set_title("cd/klm" if per_klm else "cd")
    ax.legend(loc="lower right", bbox_to_anchor=(1.2, -0.1), fontsize="small")
    return ax


def convergence(render: Union[Result, Job], target: float | None = None, ax: Axes | None = None) -> Axes:
    """The relative errors of each look at them against time. target: drawn as a line, 0.02 is 2 %."""
    looks = render.curve()
    ax = _axes(ax)
    time = [look.elapsed_s for look in looks]
    for name in ("worst", "p95", "mean", "median"):
        errors = [getattr(look, f"{name}_relative_error") for look in looks]
        ax.plot(time, [100 * e if e >= 0 else np.nan for e in errors], marker=".", label=name)
    if target is not None:
        ax.axhline(100 * target, color="0.5", linestyle="--", label="target")
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel("time, s")
    ax.set_ylabel("relative error, %")
    ax.legend()
    return ax
