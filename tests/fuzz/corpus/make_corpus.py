#!/usr/bin/env python3
"""Writes the small files of the fuzz corpora that are not copies of the tests' data: every type, symmetry and odd range
in few numbers. tests/fuzz/corpus/make_corpus.py writes beside itself."""
from pathlib import Path

HERE = Path(__file__).resolve().parent


def table(planes, rows):
    return "\n".join(" ".join(str(1 + (7 * i + 3 * j) % 11) for j in range(rows)) for i in range(planes))


def ies(version, kind, vertical, horizontal, tilt="NONE", opening=".2 .3 0", extra=""):
    return (f"{version}\n[TEST] x\n{extra}TILT={tilt}\n1 900 1 {len(vertical)} {len(horizontal)} {kind} 2 {opening}\n"
            f"1 1 10\n{' '.join(map(str, vertical))}\n{' '.join(map(str, horizontal))}\n"
            f"{table(len(horizontal), len(vertical))}\n")


def eulumdat(isym, c_angles, stored, gamma, lamps=("1\nLED\n1000\n3000\n80\n10",), area="600\n300",
             heights="0\n0\n0\n0"):
    head = f"maker\n1\n{isym}\n{len(c_angles)}\n0\n{len(gamma)}\n0\nreport\nname\nno\nfile\ndate\n600\n300\n50\n"
    values = [1 + (7 * i) % 11 for i in range(stored * len(gamma))]
    return (head + f"{area}\n{heights}\n100\n0\n1\n0\n{len(lamps)}\n" + "".join(lamp + "\n" for lamp in lamps) +
            "0.5\n" * 10 + "".join(f"{v}\n" for v in [*c_angles, *gamma, *values]))


FOUR = [0, 90, 180, 270]
FILES = {
    "ies/c_quadrants.ies": ies("IESNA:LM-63-2002", 1, [0, 45, 90], [0, 30, 90]),
    "ies/c_lateral.ies": ies("IES:LM-63-2019", 1, [90, 135, 180], [0, 60, 180], opening="-.2 -.2 .3"),
    "ies/c_90_270.ies": ies("IESNA:LM-63-1995", 1, [0, 90], [90, 180, 240, 270], opening="0 1.2 -.1"),
    "ies/c_full.ies": ies("IESNA91", 1, [0, 90, 180], [0, 120, 240, 360], opening="-.2 .3 .1"),
    "ies/c_open.ies": ies("IESNA:LM-63-2002", 1, [0, 65], [0, 120, 240]),
    "ies/c_minus_90_90.ies": ies("IESNA:LM-63-2002", 1, [90, 0], [-90, -60, 60, 90]),
    "ies/b_full.ies": ies("IESNA:LM-63-2002", 2, [-90, 0, 90], [-90, -20, 40, 90]),
    "ies/b_halves.ies": ies("IESNA:LM-63-2002", 2, [0, 40, 90], [0, 20, 90]),
    "ies/a_full.ies": ies("IESNA:LM-63-2002", 3, [-90, 0, 90], [-90, -20, 40, 90], opening="-.2 0 -.3"),
    "ies/a_half.ies": ies("IESNA:LM-63-2002", 3, [-30, 0, 30], [0, 20, 60]),
    "ies/tilt.ies": ies("IESNA:LM-63-2002", 1, [0, 90], [0], tilt="INCLUDE\n1\n3\n0 45 90\n1 .9 .8"),
    "ies/keywords.ies": ies("IESNA:LM-63-2002", 1, [0, 90], [0], tilt="x.tlt",
                            extra="[MANUFAC] a, b\n[MORE] c\nfree\n[_INTENSITYUNITS] mW/sr\n[OTHER] TILT=NONE\n"),
    "eulumdat/isym0.ldt": eulumdat(0, FOUR, 4, [0, 90]),
    "eulumdat/isym0_closed.ldt": eulumdat(0, [0, 120, 360], 3, [0, 90, 180]),
    "eulumdat/isym2.ldt": eulumdat(2, FOUR, 3, [0, 45, 90], area="600\n0"),
    "eulumdat/isym3.ldt": eulumdat(3, [0, 10, 90, 170, 180, 190, 270, 350], 5, [0, 90], heights="50\n50\n50\n0"),
    "eulumdat/isym4.ldt": eulumdat(4, FOUR, 2, [90, 180], area="600\n0", heights="9\n9\n9\n9"),
    "eulumdat/two_sets.ldt": eulumdat(1, [0], 1, [0, 90], ("-1\na\n500\n3000\n80\n5", "2\nb\n900\n4000\n90\n9")),
    "eulumdat/by_field.ldt": eulumdat(1, [0], 1, [0, 90], ("1\n2\na\nb\n500\n900", "3000\n4000\n80\n90\n5\n9")),
}

for name, text in FILES.items():
    (HERE / name).write_bytes(text.encode("ascii"))
print(f"{len(FILES)} files")
