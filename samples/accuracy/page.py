"""The report's page: page.html with the figures and sentences of the measurements in it. Called by accuracy.py.

Whatever is a figure here comes from the tables; a sentence that depends on one is chosen by it.
"""
import base64
import html
import math
import os
import string

import errors
import measure
from plots import number

HERE = os.path.dirname(os.path.abspath(__file__))
FEW = 0.8  # of the bounds: a method of which fewer hold has hardly found some light
WHAT = {"light_paths": "paths", "alpha": "alpha", "threads": "threads", "meters": "meters", "pixels": "pixels",
        "path_length": "pieces"}
METHODS = {
    "auto": "The program tries out which techniques pay in the room, and takes those.",
    "ups": "Unified Path Sampling: paths from the luminaires and from the meters, joined, and photons; all at once.",
    "bpt": "Bidirectional path tracing: paths from the luminaires and from the meters, joined. No photons.",
    "pt": "Path tracing: paths from the meters only. Fast in plain rooms, blind to much that glass and mirrors gather.",
    "ppm": "Progressive photon mapping: light that lands near a meter counts as its own, within a circle that shrinks.",
    "sppm": "Stochastic progressive photon mapping: as ppm, with glossy surfaces looked through."}
KNOBS = {
    "light_paths": "How many paths start at the luminaires in each iteration (<code>--light-paths</code>). More of "
                   "them make an iteration dearer and the light of caustics smoother.",
    "alpha": "How slowly the circle shrinks within which photons count (<code>--alpha</code>). Small: it shrinks fast, "
             "less blur and more noise. Large: the reverse.",
    "threads": "How many parts of the processor work at once (<code>--threads</code>). The numbers do not change with "
               "it, only the time. An iteration's processor time should stay the same; where it rises, the cores "
               "hinder each other.",
    "meters": "How many points are computed. Where an iteration costs the same with more of them, its paths are shared "
              "out: each point gets fewer.",
    "pixels": "How large the image is that is computed beside the meters (<code>--size</code>).",
    "path_length": "After how many straight pieces a path of light is cut off (<code>--max-path-length</code>). "
                   "Cutting saves time and leaves light out: the stated error, which knows only of noise, does not see "
                   "it; the true error does."}


def percent(value):
    return f"{number(100 * value, 2)}&nbsp;%" if value >= 0 else "not known"


def codes(methods):
    return " and ".join(f"<code>{m}</code>" for m in methods)


def duration(status, seconds):
    if status == "unknown":
        return "not known"
    return {"sooner": "&lt;&nbsp;", "later": "&gt;&nbsp;", "reached": ""}[status] + number(seconds, 2) + "&nbsp;s"


def table(header, rows, caption, chosen=()):
    """Rows of cells that are HTML already; `chosen`: numbers of marked rows. On a phone each row is a block, its cells
    one below another with the names of their columns."""
    lines = [f'<p class="facts">{caption}</p><div class="scroll"><table><thead><tr>',
             *(f'<th scope="col">{cell}</th>' for cell in header), "</tr></thead><tbody>"]
    for k, (first, *rest) in enumerate(rows):
        cells = (f'<td data-name="{name}">{cell}</td>' for name, cell in zip(header[1:], rest))
        lines.append(f'<tr{" class=chosen" if k in chosen else ""}><th scope="row">{first}</th>{"".join(cells)}</tr>')
    return "".join(lines) + "</tbody></table></div>"


def picture(data, kind, text, caption="", style=""):
    coded = base64.b64encode(data).decode("ascii")
    image = f'<img src="data:{kind};base64,{coded}" alt="{html.escape(text)}">'
    return (f'<figure{f" class={style}" if style else ""}>' + image
            + (f"<figcaption>{caption}</figcaption>" if caption else "") + "</figure>")


class Report:
    def __init__(self, settings, tables, scenes, pictures):
        self.settings, self.tables, self.scenes, self.pictures = settings, tables, scenes, pictures

    def svg(self, name, text, caption=""):
        return picture(self.pictures[name], "image/svg+xml", text, caption)

    def errors_of(self, scene, method):
        """Rows by budget; the longest is the last."""
        return [r for r in self.tables["errors"] if (r["scene"], r["method"]) == (scene, method)]

    def time(self, scene, method, kind, level):
        row = next(r for r in self.tables["times"]
                   if (r["scene"], r["method"], r["kind"], r["error"]) == (scene, method, kind, level))
        return duration(row["status"], row["seconds"])

    def title(self, scene):
        return measure.SCENES[scene][0]

    # ---- in short ---------------------------------------------------------------------------------------------------

    def complete(self, scene):
        """Fixed methods that can find all the light of the scene, and their rows with the longest budget."""
        last = {m: self.errors_of(scene, m)[-1] for m in self.settings.methods if m != "auto"}
        return {m: row for m, row in last.items() if not row["light_missing"]}

    def answer_of(self, scene):
        auto = self.errors_of(scene, "auto")[-1]
        text = (f"<strong>{self.title(scene)}:</strong> after {number(auto['seconds'], 2)}&nbsp;s of "
                f"<code>auto</code>, 95&nbsp;% of the meters are within {percent(auto['true_p95'])} of the reference, "
                f"and the mean illuminance is {percent(abs(auto['mean_off']))} off")
        others = self.complete(scene)
        if not others:
            return text + "."
        if min(r["true_p95"] for r in (auto, *others.values())) < self.reference_error(scene):
            return text + ("; methods cannot be compared, as the reference itself is no better known: more "
                           "<code>--seconds</code>.")
        # Errors fall with the square root of time: what they would be at the same time.
        scaled = {m: r["true_p95"] * math.sqrt(r["seconds"]) for m, r in others.items()}
        best = min(scaled, key=scaled.get)
        ratio = auto["true_p95"] * math.sqrt(auto["seconds"]) / scaled[best]
        verdict = ("as good as" if 0.8 <= ratio <= 1.25 else "better than" if ratio < 1 else
                   f"{number(ratio, 2)} times the error of")
        return text + f"; at equal time {verdict} the best method chosen by hand, <code>{best}</code>."

    def summary_table(self):
        rows = [[self.title(scene), *(self.time(scene, "auto", kind, level) for kind in ("true", "stated")
                                      for level in errors.LEVELS)] for scene in self.scenes]
        words = {"true": "true error", "stated": "stated"}
        header = ["", *(f"{percent(level)} {words[kind]}" for kind in words for level in errors.LEVELS)]
        return table(header, rows, "Time until method <code>auto</code> is within 5, 2 and 1 %. &gt;: not within the "
                                   "longest render; &lt;: already in the shortest.")

    # ---- rooms ------------------------------------------------------------------------------------------------------

    def facts(self, scene):
        f = self.scenes[scene].facts
        size = " × ".join(f"{high - low:.1f}" for low, high in zip(f["bounds_min_m"], f["bounds_max_m"]))
        counts = ((f["luminaires"], "IES luminaires"), (f["emitting_instances"], "luminous bodies"),
                  (f["triangles"], "triangles"), (f["meters"], "meters"))
        error, count = self.reference_error(scene), self.scenes[scene].reference_summary["iterations"]
        known = f"its typical meter: {percent(error)}" if error >= 0 else "its meters: not known"
        return (f"{size} m, {f['emitted_lm']:,.0f} lm; "
                + ", ".join(f"{count:,} {what}" for count, what in counts if count)
                + f". Iterations of the reference: {count:,}. Stated error of {known}.")

    def reference_error(self, scene):
        return next(r["stated_median"] for r in self.tables["references"] if r["scene"] == scene)

    def map(self, scene):
        """The false-colour picture of the largest grid, as the reference has it."""
        summary, folder = self.scenes[scene].reference_summary, self.scenes[scene].reference_dir
        sets = {name: len(rows) for name, rows in self.scenes[scene].reference.items()}
        name = max(sets, key=sets.get)
        with open(os.path.join(folder, name + ".png"), "rb") as file:
            data = file.read()
        mean = summary["meters"][name]["mean_lx"]
        return picture(data, "image/png", f"False-colour map of the illuminance on {name} in the {scene}",
                       f"Illuminance at the {sets[name]} meters “{html.escape(name)}”, mean {mean:,.0f} lx.", "map")

    def room(self, scene):
        title, words, _ = measure.SCENES[scene]
        rows = []
        for method in self.settings.methods:
            last = self.errors_of(scene, method)[-1]
            star = "*" if last["light_missing"] else ""
            held = f"{100 * last['bounds_held']:.0f}&nbsp;%" if last["bounds_held"] >= 0 else "not known"
            rows.append([f"<code>{method}</code>{star}",
                         *(self.time(scene, method, "true", level) for level in errors.LEVELS),
                         percent(last["true_p95"]), percent(last["stated_median"]), held,
                         f"{100 * last['mean_off']:+.2f}&nbsp;%".replace("-", "−")])
        header = ["method", *(f"time to {percent(level)} true error" for level in errors.LEVELS),
                  "true error at the end", "stated at the end", "meters whose bound holds", "mean off"]
        seconds = [self.errors_of(scene, m)[-1]["seconds"] for m in self.settings.methods]
        caption = (f"At the end: of the longest renders, {number(min(seconds), 2)} to {number(max(seconds), 2)} s. A "
                   "bound should hold for about 95 % of the meters. &gt;: not within the longest render; &lt;: already "
                   "in the shortest.")
        missing = [m for m in self.settings.methods if self.errors_of(scene, m)[-1]["light_missing"]]
        warning = ("" if not missing else
                   f"<p>* The program warns that {codes(missing)} cannot find all the light of this room. The "
                   "stated error knows nothing of light that is never found.</p>")
        for method in self.settings.methods:
            last = self.errors_of(scene, method)[-1]
            if 0 <= last["bounds_held"] < FEW and not last["light_missing"]:
                held = f"{100 * last['bounds_held']:.0f}&nbsp;%"
                warning += (f"<p>Of the bounds of <code>{method}</code>, {held} hold: it finds some of the light of "
                            "this room so rarely that its stated error does not know of it yet.</p>")
        floor = "" if self.reference_error(scene) < 0 else (
            " Hatched, where it shows: errors that the reference itself may have.")
        return (f'<h3>{title}</h3><div class="figures"><div><p>{words[0].upper()}{words[1:]}.</p>'
                f'<p class="facts">{self.facts(scene)}</p></div>{self.map(scene)}</div><div class="figures">'
                + self.svg(f"true_{scene}", f"True error against time in the {scene}, one line a method; the table "
                           "below has the figures", f"What is true: distance to the reference.{floor}")
                + self.stated(scene) + "</div>" + table(header, rows, caption, (0,)) + warning)

    def stated(self, scene):
        if f"stated_{scene}" not in self.pictures:
            return "<p>The renders were too short for a stated error: the program gives one from 16 iterations on.</p>"
        return self.svg(f"stated_{scene}", f"Stated error against time in the {scene}, one line a method",
                        "What the program says of itself. A line begins with the 16th iteration, the first that has an "
                        "error; methods without a line made fewer.")

    # ---- predictions ------------------------------------------------------------------------------------------------

    def predictions(self):
        rows = self.tables["predictions"]
        if not rows:
            return ("<p>Not available: the renders gave no prediction of what later ones could check"
                    f" (no <code>prediction</code> in the output of {html.escape(measure.version(self.settings.ups))}, "
                    "or renders too short for one).</p>")
        checked = [r for r in rows if errors.came_true(r) is not None]
        verdict = (f"Of {len(rows)} predictions, {len(checked)} could be checked: in "
                   f"{sum(map(errors.came_true, checked))} the actual time was within the limits that the program "
                   "gave. The others lie beyond the end of the longer render.")
        cells = []
        for r in checked:
            low, high = (number(r[key], 2) for key in ("low_seconds", "high_seconds"))
            limits = f"{low} to {high}&nbsp;s" if r["high_seconds"] >= 0 else f"from {low}&nbsp;s"
            cells.append([self.title(r["scene"]), f"<code>{r['method']}</code>", percent(r["relative_error"]),
                          f"{number(r['made_at_seconds'], 2)}&nbsp;s",
                          f"{number(r['predicted_seconds'], 2)}&nbsp;s" if r["predicted_seconds"] >= 0 else "never",
                          limits if r["low_seconds"] >= 0 else "none", html.escape(r["limited_by"]),
                          duration(r["status"], r["actual_seconds"])])
        drawn = "" if "predictions" not in self.pictures else '<div class="figures">' + self.svg(
            "predictions", "Predicted against actual time; on the diagonal a prediction came true",
            "On the grey diagonal the prediction came true. Bars: the limits that the program gave.") + "</div>"
        which = {"worst": "worst", "median": "typical (median)"}[rows[0]["criterion"]]
        return (f"<p>While it runs, the program foretells when the stated error of the <em>{which}</em> meter will be "
                "5, 2, 1 and 0.5&nbsp;%. Here stands what a short render foretold, and when a longer one, with other "
                f"random numbers, got there. {verdict}</p>{drawn}"
                + (table(["room", "method", "stated error", "foretold after", "foretold", "limits", "limited by",
                          "actual"], cells, "&gt;: not reached by the end of the longer render.") if cells else ""))

    # ---- knobs ------------------------------------------------------------------------------------------------------

    def verdict(self, knob, rows):
        """What the measurement says; by the true error where it is known, else by the stated one."""
        key = "true_p95" if all(r["true_p95"] >= 0 for r in rows) else "stated_median"
        known = [r for r in rows if r[key] >= 0]
        kind = {"true_p95": "true", "stated_median": "stated"}[key]
        cheap, dear = (f(r["cpu_ms_per_iteration"] for r in rows) for f in (min, max))
        text = f"An iteration costs {number(cheap)} to {number(dear)}&nbsp;ms. "
        if len(known) < 2:
            return text + "The renders were too short for an error at equal time."
        best, worst = (f(known, key=lambda r: r[key]) for f in (min, max))
        if worst[key] <= 1.15 * best[key]:
            return text + (f"At equal time the {kind} error hardly depends on it: {percent(best[key])} to "
                           f"{percent(worst[key])}.")
        text += (f"At equal time the {kind} error is smallest with {best['value']} ({percent(best[key])}) and largest "
                 f"with {worst['value']} ({percent(worst[key])}).")
        default = next((r for r in known if r["value"] == knob.default), None)
        if default is not None and default is not best:
            text += (f" The program's own choice, {knob.default}, has {percent(default[key])}"
                     + (": no reason to change it." if default[key] <= 1.15 * best[key] else "."))
        if kind == "true" and self.reference_error(knob.scene) > best[key] / 2:
            text += (f" The reference itself is known to {percent(self.reference_error(knob.scene))}: small differences "
                     "say nothing.")
        return text

    def knob(self, knob):
        rows = [r for r in self.tables["knobs"] if r["knob"] == knob.name]
        clock, true = knob.name == "threads", knob.same_meters
        header = [WHAT[knob.name], "ms an iteration", *(["ms by the clock"] if clock else []), "itera&shy;tions",
                  "time", "stated error", *(["true error"] if true else []),
                  *(["noise of the image"] if knob.image else [])]
        cells = [[r["value"], number(r["cpu_ms_per_iteration"]),
                  *([number(r["clock_ms_per_iteration"])] if clock else []), f"{r['iterations']:,}",
                  f"{number(r['seconds'], 2)}&nbsp;s", percent(r["stated_median"]),
                  *([percent(r["true_p95"])] if true else []), *([percent(r["image_noise"])] if knob.image else [])]
                 for r in rows]
        equal = rows[0]["equal_seconds"]
        caption = (f"{self.title(knob.scene)}, method <code>{knob.method}</code>."
                   + (f" Stated error: of the typical meter, after {number(equal, 2)} s each." if equal >= 0 else "")
                   + (" True error: what 95 % of the meters are within, after the time beside it." if true else ""))
        chosen = [k for k, r in enumerate(rows) if r["value"] == knob.default]
        drawn = self.svg(f"knob_{knob.name}", f"{knob.title}: processor time of an iteration and error at equal time; "
                         "the table has the figures")
        return (f"<h3>{knob.title}</h3><p>{KNOBS[knob.name]}</p><p><strong>Measured:</strong> "
                f'{self.verdict(knob, rows)}</p><div class="figures knob">{drawn}'
                + f"<div>{table(header, cells, caption, chosen)}</div></div>")

    # ---- all --------------------------------------------------------------------------------------------------------

    def machine(self):
        references = [scene.reference_summary for scene in self.scenes.values()]
        rows = self.tables["errors"]
        busy = sum(r["cpu_s"] for r in rows) / sum(r["time_s"] * r["threads"] for r in rows)
        text = (f"{html.escape(measure.version(self.settings.ups))}, {references[0]['threads']} threads"
                + (f", {html.escape(measure.processor_model())}" if measure.processor_model() else "")
                + f". Renders of up to {number(self.settings.seconds)} s.")
        if busy < 0.8:
            text += (f" Other programs ran meanwhile: the renders got {100 * busy:.0f} % of the processor. Times here "
                     "are processor time over threads, which this hardly changes; times by the clock were longer.")
        return text

    def how(self):
        s = self.settings
        return "\n".join(f"<li>{line}</li>" for line in (
            f"Every method renders every room {s.rungs} times, for about "
            f"{', '.join(number(b, 2) for b in measure.budgets(s))} s, each time with other random numbers; where that "
            f"is too short for {s.least} iterations the last has these. One render a point: a line may lie some "
            "percent too high or too low.",
            "Time is processor time divided by threads, without reading the file: what the render takes on a machine "
            "that does nothing else. The tables beside this page have the time by the clock, too.",
            f"The reference is a render of about {number(s.reference * s.seconds)} s by method "
            f"{measure.REFERENCE_METHOD}, again with other random numbers. Its own error is contained in the true "
            "errors; where a method is nearly as good as the reference, it looks worse than it is.",
            "A time to 5, 2 or 1&nbsp;% is read between two measured points, on logarithmic scales, from where the "
            "error stays below. Nothing is extrapolated.",
            f"Images are made small ({measure.SIZE.replace('x', ' × ')} pixels), except where pixels are the question: "
            "the meters are what is judged.",
            "Three rooms are not all rooms. What is dear in yours, the program says itself: "
            "<code>ups info ROOM.glb</code> names the effects, and every render states its errors."))

    def page(self):
        with open(os.path.join(HERE, "page.html"), encoding="utf-8") as file:
            template = string.Template(file.read())
        answers = "".join(f"<li>{self.answer_of(scene)}</li>" for scene in self.scenes)
        return template.substitute(
            machine=self.machine(), answer=f"<ul>{answers}</ul>", summary_table=self.summary_table(),
            rooms="\n".join(self.room(scene) for scene in self.scenes), predictions=self.predictions(),
            knobs="\n".join(self.knob(knob) for knob in measure.knobs()), how=self.how(),
            methods="\n".join(f"<dt><code>{m}</code></dt><dd>{text}</dd>" for m, text in METHODS.items()
                              if m in self.settings.methods))


def page(settings, tables, scenes, pictures):
    return Report(settings, tables, scenes, pictures).page()
