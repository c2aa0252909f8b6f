#!/usr/bin/env bash
# What accuracy costs in time, from a bare Debian 12, Debian 13 or Ubuntu 24.04 (root or sudo): installs what is
# missing, builds the program in build/release, measures for ten minutes, writes out/accuracy/report.html and what it
# is made of.
#   bash samples/accuracy/run.sh                        --seconds 20: longer renders, finer figures; --fast: a minute
#   bash samples/accuracy/run.sh --ups /path/to/ups     measures a program that is there; --out DIR: another folder
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
given=
for word in "$@"; do
  case "$word" in --ups | --ups=* | -h | --help) given=1 ;; esac
done

words=(--out "$root/out/accuracy")
if [ -z "$given" ]; then
  bash "$root/samples/setup.sh" report
  if [ -f "$root/build/release/CMakeCache.txt" ]; then # keeps its options
    cmake -S "$root" -B "$root/build/release"
  else
    (cd "$root" && cmake --preset release -DUPS_BUILD_TESTS=OFF)
  fi
  cmake --build "$root/build/release" --parallel "$(nproc)" --target ups_program
  words+=(--ups "$root/build/release/bin/ups")
fi

# The system's python3 has the system's packages; the one on PATH may not.
for python in /usr/bin/python3 python3; do
  if "$python" -c 'import numpy, matplotlib' 2>/dev/null; then
    exec "$python" "$root/samples/accuracy/accuracy.py" "${words[@]}" "$@"
  fi
done
echo "run: no python3 imports numpy and matplotlib (Debian, Ubuntu: python3-numpy, python3-matplotlib)" >&2
exit 1
