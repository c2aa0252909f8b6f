#!/usr/bin/env bash
# Renders the bathroom from a bare Debian 12, Debian 13 or Ubuntu 24.04 (root or sudo): installs what is missing, builds
# the program in build/release, renders samples/bathroom/bathroom.glb into out/bathroom/, prints the main figures.
#   bash samples/bathroom/run.sh                        a minute of rendering
#   bash samples/bathroom/run.sh --time 600 --size 1280x960
# Options go to `ups render`, after --time 60 and --out out/bathroom; an option given again replaces that value.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
cores=$(nproc)
scene=samples/bathroom/bathroom.glb
out=out/bathroom
limits=(--time 60)

step() { printf '\n== %s\n' "$*"; }

# The caller's own limit or folder takes the place of the default one; --json is always asked for, and read below.
options=()
while [ $# -gt 0 ]; do
  case "${1%%=*}" in --time | --iterations | --target-error) limits=() ;; esac
  case "$1" in
    --out)
      out=${2:?run: --out needs a folder}
      shift
      ;;
    --out=*) out=${1#--out=} ;;
    --json) ;;
    *) options+=("$1") ;;
  esac
  shift
done

step "Packages (samples/setup.sh run)"
bash samples/setup.sh run

# A configuration that is there keeps its options: tests/run.sh may have made it, with tests.
step "Configure build/release"
if [ -f build/release/CMakeCache.txt ]; then
  cmake -S . -B build/release
else
  cmake --preset release -DUPS_BUILD_TESTS=OFF
fi

step "Build the program ups on $cores cores"
cmake --build build/release --parallel "$cores" --target ups_program
ups=build/release/bin/ups

step "Render: ups render $scene ${limits[*]-} --out $out ${options[*]-}"
mkdir -p "$out"
"$ups" render "$scene" ${limits[@]+"${limits[@]}"} --out "$out" --json ${options[@]+"${options[@]}"} >"$out/render.json"

step "Result"
/usr/bin/python3 samples/bathroom/summary.py "$out/render.json"
echo "images and tables are in $out:"
find "$out" -maxdepth 1 -type f | sort | sed 's/^/  /'
