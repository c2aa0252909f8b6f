#!/usr/bin/env bash
# What each effect costs, from a bare Debian 12, Debian 13 or Ubuntu 24.04 (root or sudo): installs what is missing,
# builds the program in build/release, measures for five minutes, prints the table of README.md beside this script.
#   bash samples/effects/run.sh                         options go to cost_of_effects.py
#   UPS_PROGRAM=/path/to/ups bash samples/effects/run.sh    measures a program that is there
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
mkdir -p out/effects
/usr/bin/python3 samples/effects/cost_of_effects.py --ups "$ups" "$@" | tee out/effects/table.md
