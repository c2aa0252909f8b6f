"""Writes a luminous intensity distribution with an axis of symmetry as an IES LM-63-2002 file, absolute photometry.

Called by the scene generators.
"""


def write_axial(path, gamma_degrees, candela, comments, opening_diameter=0.0, watts=1, digits=3, opening=None):
    """`comments`: (keyword, text) pairs. An opening of diameter 0 is a point; one with a diameter is a disc. `opening`
    instead: width (along C90), length (along C0) and height as LM-63-2002 writes them, m; negative is round."""
    width, length, height = opening or (-opening_diameter or 0, -opening_diameter or 0, 0)
    lines = ["IESNA:LM-63-2002", *(f"[{keyword}] {text}" for keyword, text in comments), "TILT=NONE",
             f"1 -1 1 {len(gamma_degrees)} 1 1 2 {width} {length} {height}", f"1 1 {watts}"]
    for values, form in ((gamma_degrees, "{:.1f}"), ([0.0], "{:.1f}"), (candela, f"{{:.{digits}f}}")):
        words = [form.format(v) for v in values]
        lines += [" ".join(words[k:k + 12]) for k in range(0, len(words), 12)]
    with open(path, "w", newline="\r\n") as file:
        file.write("\n".join(lines) + "\n")
