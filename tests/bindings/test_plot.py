"""Do the pictures on matplotlib show the numbers? Looked at as what is drawn: lines, their places, colours."""
import matplotlib
import numpy as np
import pytest
import ups

matplotlib.use("Agg")
import ups.plot  # noqa: E402
from matplotlib import pyplot  # noqa: E402
from rooms import box  # noqa: E402


@pytest.fixture(autouse=True)
def close_figures():
    yield
    pyplot.close("all")


def lamp_2_m_above(points):
    """Of 400 cd over the origin: 800 / (4 + r^2)^1.5 lx."""
    return 800 / (4 + (points[:, :2] ** 2).sum(axis=1)) ** 1.5


def grid(step=0.1):
    x, y = np.meshgrid(np.arange(-2, 2 + step / 2, step), np.arange(-2, 2 + step / 2, step))
    return np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])


def radii(ax, level):
    """Of the line of that level: the distances of its points from the origin."""
    lines = [c for c in ax.collections if getattr(c, "colorbar", None) is None]
    paths = [p.vertices for c in lines for p in c.get_paths() if len(p.vertices)]
    found = [np.hypot(*p.T) for p in paths]
    wanted = ((800 / level) ** (2 / 3) - 4) ** 0.5
    return min((r for r in found), key=lambda r: abs(np.median(r) - wanted)), wanted


@pytest.mark.parametrize("turned", [False, True])
def test_isolux_lines_are_where_the_illuminance_is(turned):
    points = grid()
    values = lamp_2_m_above(points)
    if turned:  # not in rows along the axes
        points[:, :2] = points[:, :2] @ [[0.8, 0.6], [-0.6, 0.8]]
    ax = ups.plot.isolux(points, values, levels=[40, 60, 80], filled=False)
    for level in (40, 60, 80):
        found, wanted = radii(ax, level)
        assert len(found) > 20 and np.allclose(found, wanted, atol=0.01)


def test_isolux_leaves_out_what_is_not_there():
    points = grid()
    values = lamp_2_m_above(points)
    inside = ~((points[:, 0] > 0.05) & (points[:, 1] > 0.05))  # an L
    values[(points[:, 0] < -0.05) & (points[:, 1] < -0.05)] = -1  # and not known
    ax = ups.plot.isolux(points[inside], values[inside], levels=[60], filled=False)
    drawn = np.concatenate([p.vertices for c in ax.collections for p in c.get_paths()])
    assert len(drawn) > 10 and not (np.prod(drawn, axis=1) > 0.02).any()
    with pytest.raises(ValueError, match="two rows"):
        ups.plot.isolux(points[:5], values[:5])


def test_false_colours_mark_what_is_not_known():
    values = np.array([[1, 10, 100], [-1, np.nan, 0]])
    image, = ups.plot.false_color(values, scale=(0, 50)).images
    known = ~np.ma.getmaskarray(image.get_array())
    assert known.tolist() == [[True, True, True], [False, False, True]]
    assert tuple(image.cmap(np.ma.masked)) == matplotlib.colors.to_rgba("0.6")
    assert image.colorbar.extend == "max" and image.get_clim() == (0, 50)
    image, = ups.plot.false_color(values, log=True, first_row_at_bottom=True).images
    assert image.get_clim()[0] == 1 and image.origin == "lower"
    assert np.ma.getmaskarray(image.get_array())[1].all()


def test_a_polar_diagram_has_the_intensities(context):
    table = [[100, 80, 20, 0], [100, 60, 10, 0], [100, 40, 5, 0]]
    profile = ups.Profile.from_table(context, [0, 90, 180], [0, 30, 60, 90], table)
    ax = ups.plot.polar(profile)
    assert [line.get_label() for line in ax.lines] == ["C0 / C180", "C90 / C270"]
    angles, intensities = ax.lines[0].get_data()
    at = {round(float(np.degrees(a)), 1): i for a, i in zip(angles, intensities)}
    assert [at[g] for g in (-60, -30, 0, 30, 60)] == pytest.approx([5, 40, 100, 80, 20], rel=1e-4)
    per_klm = ups.plot.polar(profile, [0], per_klm=True).lines[0].get_ydata()
    assert per_klm.max() == pytest.approx(100 * 1000 / profile.info.flux_lm, rel=1e-4)
    # Of the lamps' flux, as in data sheets (before: of the luminaire's).
    ies = b"IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n1 2000 1 3 1 1 2 0 0 0\n1 1 9\n0 45 90\n0\n300 200 0\n"
    lamps = ups.plot.polar(ups.Profile.parse(context, ies), [0], per_klm=True).lines[0].get_ydata()
    assert lamps.max() == pytest.approx(150, rel=1e-4)


def test_convergence_has_every_look(context):
    scene, _ = box(context)
    result = scene.render(iteration_count=40)
    ax = ups.plot.convergence(result, target=0.02)
    looks = result.curve()
    assert [line.get_label() for line in ax.lines] == ["worst", "p95", "mean", "median", "target"]
    time, worst = ax.lines[0].get_data()
    assert len(looks) == 5 and list(time) == [look.elapsed_s for look in looks]
    assert list(worst) == pytest.approx([100 * look.worst_relative_error for look in looks])
    assert ax.lines[4].get_ydata()[0] == 2


def test_plan_and_picture(context):
    scene, _ = box(context)
    ax = ups.plot.plan(scene, 1)
    drawn = np.concatenate([np.column_stack(line.get_data()) for line in ax.lines])
    assert drawn.min(axis=0) == pytest.approx([0, 0]) and drawn.max(axis=0) == pytest.approx([4, 4])
    image, = ups.plot.picture(np.full((4, 6, 3), 50.0)).images
    grey = np.asarray(image.get_array())[..., :3]
    assert grey.shape == (4, 6, 3) and np.ptp(grey) < 0.05 and 0.3 < grey.mean() < 0.6
