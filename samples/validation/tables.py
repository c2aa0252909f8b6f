"""The rows of harness.run as text, Markdown and JSON."""
import json
from dataclasses import asdict


def worst(rows):
    """The largest deviation, with its sign; of dark meters, whether they are."""
    lit = [r.deviation for r in rows if r.deviation is not None]
    return f"{max(lit, key=abs):+.3f} %" if lit else "dark" if all(r.E == 0 for r in rows) else "not dark"


def largest_noise(rows):
    """The largest standard error."""
    lit = [100 * r.standard_error / r.E_ref for r in rows if r.E_ref]
    return f"{max(lit):.3f} %" if lit else "-"


def progress_line(case, method, rows):
    failed = sum(r.passed is False for r in rows)
    return (f"{case.name:>17} {method:>4} {len(rows):3} checks, worst {worst(rows):>9}, noise "
            f"{largest_noise(rows):>7}, {rows[0].iterations:6} iterations {rows[0].time_s:6.1f} s"
            + (f", {failed} FAILED" if failed else ""))


def text_table(head, lines):
    """Columns aligned, for Markdown as for a terminal."""
    lines = [head, *lines]
    widths = [max(len(str(line[i])) for line in lines) for i in range(len(head))]
    text = ["| " + " | ".join(str(c).ljust(w) for c, w in zip(line, widths)) + " |" for line in lines]
    text.insert(1, "|" + "|".join("-" * (w + 2) for w in widths) + "|")
    return "\n".join(text)


def groups_of(cases):
    """[(name, title, cases)]; the title of several cases is what stands before their last comma."""
    groups = {}
    for case in cases:
        groups.setdefault(case.group, []).append(case)
    return [(name, members[0].title if len(members) == 1 else members[0].title.rpartition(",")[0], members)
            for name, members in groups.items()]


def summary_table(cases, rows, methods):
    """Groups of cases times methods: the worst deviation, FAILED where a check did, or `cannot sample`."""
    lines = []
    for name, title, members in groups_of(cases):
        names = [c.name for c in members]
        cells = []
        for method in methods:
            mine = [r for r in rows if r.case in names and r.method == method]
            if mine:
                cells.append(worst(mine) + (" FAILED" if any(r.passed is False for r in mine) else ""))
            else:
                cells.append("cannot sample" if method in dict(members[0].cannot) else "-")
        lines.append([name, title, sum(len(c.checks) for c in members), *cells])
    return text_table(["case", "what", "checks", *(m.upper() for m in methods)], lines)


def check_cells(row):
    noise = f"{100 * row.standard_error / row.E_ref:.3f} %" if row.E_ref else f"{row.standard_error:.2g} lx"
    deviation = "-" if row.deviation is None else f"{row.deviation:+.3f} %"
    bias = "-" if row.bias is None else f"{row.bias:.2g}"
    return [f"{row.E:.6g}", noise, deviation, bias, {True: "yes", False: "NO", None: "not judged"}[row.passed]]


def check_table(case, rows, methods):
    """One line a check."""
    mine = {(r.check, r.method): r for r in rows if r.case == case.name}
    used = [m for m in methods if any(method == m for _, method in mine)]
    noted = any(c.note for c in case.checks)
    head = ["check", "E_ref, lx", *(["note"] if noted else [])]
    for method in used:
        head += [f"{method.upper()}, lx", "standard error", "deviation", "bias, lx", "passed"]
    lines = [[check.label, f"{check.reference:.6g}", *([check.note] if noted else []),
              *(cell for method in used for cell in check_cells(mine[check.label, method]))] for check in case.checks]
    reasons = [f"{method.upper()} cannot sample this case: {why}.\n"
               for method, why in case.cannot if method in methods]
    return "\n".join([f"## {case.name}: {case.title}\n", *reasons, text_table(head, lines), ""])


def write_markdown(path, cases, rows, methods):
    with open(path, "w", encoding="utf-8") as file:
        file.write("# Validation\n\nThe worst deviation of each case:\n\n")
        file.write(summary_table(cases, rows, methods) + "\n\n")
        file.write("\n".join(check_table(case, rows, methods) for case in cases))


def write_json(path, cases, rows, methods):
    document = {"methods": list(methods),
                "cases": [{"name": c.name, "group": c.group, "title": c.title, "cannot": c.cannot} for c in cases],
                "rows": [asdict(r) for r in rows]}
    with open(path, "w", encoding="utf-8") as file:
        json.dump(document, file, indent=1)
