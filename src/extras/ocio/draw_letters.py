#!/usr/bin/env python3
"""Writes letters.h: the printable letters of ASCII and one sign more, drawn from DejaVu Sans as matplotlib ships it.

    python3 src/extras/ocio/draw_letters.py > src/extras/ocio/letters.h
"""
import os

import matplotlib
from matplotlib import ft2font

EM = 28  # pixels; pictures scale from here
CAPITAL = EM * 1493 / 2048  # the font's own figure (OS/2 sCapHeight)
CODES = [(chr(code), code) for code in range(0x21, 0x7F)] + [("\1", 0x2265)]
LINE = 116

HEAD = f"""// Letters of DejaVu Sans (THIRD-PARTY.md) at {EM} pixels an em, written by draw_letters.py: do not edit. Drawn by
// font.cpp.
#pragma once
#include <cstdint>

#include "ocio/picture.h"

namespace ups::ocio {{

inline constexpr float capital_height = {CAPITAL:.2f}f;  // pixels
inline constexpr float blank_advance = %sf;  // pixels: of a space, and of what is not here

struct Letter {{
  char letter;
  int8_t left, top;  // of its pixels, from the pen's place on the baseline, up
  uint8_t width, height;
  float advance;   // of the pen
  uint32_t first;  // of its pixels, row by row, in `coverage`
}};

// clang-format off
inline constexpr Letter letters[] = {{  // by their codes"""


def quoted(letter):
    return {"'": "'\\''", "\\": "'\\\\'", "\1": "at_least_sign"}.get(letter, f"'{letter}'")


def main():
    font = ft2font.FT2Font(os.path.join(matplotlib.get_data_path(), "fonts/ttf/DejaVuSans.ttf"))
    font.set_size(EM, 72)
    rows, pixels = [], []
    for letter, code in sorted(CODES):
        font.clear()
        font.set_text(chr(code), 0, flags=ft2font.LOAD_NO_HINTING)
        glyph = font.load_char(code, flags=ft2font.LOAD_NO_HINTING)
        font.draw_glyphs_to_bitmap(antialiased=True)
        image = font.get_image()
        left, top = glyph.bbox[0] // 64, -(-glyph.bbox[3] // 64)  # of the image
        used = [any(row) for row in image]
        begin, end = used.index(True), len(used) - used[::-1].index(True)
        columns = [any(column) for column in image.T]
        first, last = columns.index(True), len(columns) - columns[::-1].index(True)
        rows.append(f"    {{{quoted(letter)}, {left + first}, {top - begin}, {last - first}, {end - begin}, "
                    f"{glyph.linearHoriAdvance / 65536:.2f}f, {len(pixels)}}},")
        pixels += [f"{(int(p) * 15 + 127) // 255:x}" for row in image[begin:end, first:last] for p in row]
    space = font.load_char(0x20, flags=ft2font.LOAD_NO_HINTING).linearHoriAdvance / 65536
    print(HEAD % f"{space:.2f}")
    print("\n".join(rows))
    print("};\n\n// Hexadecimal digits: 0 paper, f ink.\ninline constexpr char coverage[] =")
    text = "".join(pixels)
    lines = [f'    "{text[i:i + LINE - 6]}"' for i in range(0, len(text), LINE - 6)]
    print("\n".join(lines) + ";\n// clang-format on\n\n}  // namespace ups::ocio")


main()
