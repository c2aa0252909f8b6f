#!/usr/bin/env bash
# A report to hand in, of a small office, from a bare Debian 12, Debian 13 or Ubuntu 24.04 (root or sudo): installs what is
# missing, builds the program in build/release, renders for a minute, writes out/report/report.html.
#   UPS_PROGRAM=/path/to/ups bash samples/report/run.sh    takes a program that is there
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
ups=${UPS_PROGRAM:-build/release/bin/ups}

if [ -z "${UPS_PROGRAM-}" ]; then
  bash samples/setup.sh run
  if [ -f build/release/CMakeCache.txt ]; then # keeps its options
    cmake -S . -B build/release
  else
    cmake --preset release -DUPS_BUILD_TESTS=OFF
  fi
  cmake --build build/release --parallel "$(nproc)" --target ups_program
fi
mkdir -p out/report
/usr/bin/python3 samples/report/make_office.py --out out/report/office.glb
"$ups" render out/report/office.glb --time 60 --out out/report --report --targets samples/report/targets.json "$@"
echo "out/report/report.html"
