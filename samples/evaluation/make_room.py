#!/usr/bin/env python3
"""Writes one of the rooms of samples/scenes_common/rooms.py and the file of its luminaires beside it.

  make_room.py hall --luminaires 1024 --out out/hall.glb
  make_room.py office --effects desks gloss pane --out out/office.glb
"""
import argparse
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import rooms  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("room", choices=("office", "hall", "atrium", "glass_box"))
    parser.add_argument("--luminaires", type=int, help="of the hall: a square number (64)")
    parser.add_argument("--effects", nargs="+", default=[],
                        choices=("desks", "gloss", "pane", "mirror", "texture", "downlight", "water"),
                        help="of the office")
    parser.add_argument("--out", help="default: out/ROOM.glb")
    arguments = parser.parse_args()
    options = {}
    if arguments.effects:
        options["effects"] = arguments.effects
    if arguments.luminaires:
        options["luminaires"] = arguments.luminaires
    print(rooms.write(arguments.out or os.path.join("out", arguments.room + ".glb"), getattr(rooms, arguments.room),
                      **options))


if __name__ == "__main__":
    main()
