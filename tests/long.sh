#!/usr/bin/env bash
# The checks of accuracy in samples/evaluation/README.md, one after another, then all cases of samples/validation, and a
# summary: about four hours.
# Not part of tests/run.sh: they compare at equal time, so nothing else may run beside them. Exit code 1 where one
# fails.
#   tests/long.sh                       all
#   tests/long.sh office spheres        some of: office caustic spheres agreement bathroom kinds smoothing
#                                       validation asymptotics calibration
# UPS_PROGRAM: a program `ups` that is there; without it the one in build/release is built, after what it needs.
# UPS_TIME_SCALE: multiplies every time. Below 1 the limits cannot be kept: it shows only that the checks run.
# shellcheck disable=SC2317  # the checks are called by name
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scale=${UPS_TIME_SCALE:-1}
# References of full length are kept where the README's commands keep them, and used again.
out=out
[ "$scale" = 1 ] || out=out/scaled
names=()
results=()
failed=0

step() { printf '\n== %s\n' "$*"; }

seconds() { awk -v s="$1" -v f="$scale" 'BEGIN { printf "%g", s * f }'; }

build() {
  step "Packages (samples/setup.sh test)"
  bash samples/setup.sh test # matplotlib for the asymptotics
  step "Build the program ups in build/release"
  if [ -f build/release/CMakeCache.txt ]; then # keeps its options
    cmake -S . -B build/release
  else
    cmake --preset release -DUPS_BUILD_TESTS=OFF
  fi
  cmake --build build/release --parallel "$(nproc)" --target ups_program
}

# The system's python3 has the system's numpy; the one on PATH may not.
python=python3
if /usr/bin/python3 -c 'import numpy' 2>/dev/null; then python=/usr/bin/python3; fi

# An unchanged scene keeps its file, and so its reference.
make_scene() {
  local scene=samples/evaluation/$1.glb fresh=$out/$1.glb
  "$python" "samples/evaluation/make_$1.py" --out "$fresh" >/dev/null
  if cmp -s "$fresh" "$scene"; then rm "$fresh"; else mv "$fresh" "$scene"; fi
}

compare() { # scene, options of compare_methods.py
  local scene=$1
  shift
  "$python" samples/evaluation/compare_methods.py --ups "$ups" --scene "$scene" "$@"
}

# The mean of all meters' errors is a bound of that of their mean: no error of 0.5 % of all readings passes.
office() {
  make_scene office
  compare samples/evaluation/office.glb --methods auto --time "$(seconds 10)" --reference-method pt \
    --reference-time "$(seconds 1000)" --out "$out/office" --max-error 0.005
}

# No test of accuracy, but of the noise after 20 s: of single cells, the reference's within it. Errors of caustics from
# 1 % on are found by tests/analytic/caustic_test.cpp.
caustic() {
  make_scene caustic
  compare samples/evaluation/caustic.glb --methods auto --time "$(seconds 20)" --reference-method lt \
    --reference-time "$(seconds 600)" --out "$out/caustic" --max-error 0.03
}

spheres() { "$python" samples/evaluation/check_sphere.py --ups "$ups" --time "$(seconds 10)"; }

# Path tracing hardly finds the bathroom's light, but what it finds is beyond doubt.
agreement() {
  "$python" samples/bathroom/make_bathroom.py --check --out "$out/check/bathroom.glb" >/dev/null
  "$python" samples/evaluation/check_reference.py --ups "$ups" --scene "$out/check/bathroom.glb" \
    --time "$(seconds 60)" --reference-time "$(seconds 900)" --out "$out/check"
}

bathroom() {
  compare samples/bathroom/bathroom.glb --methods ups bpt ppm --time "$(seconds 10)" --seeds 8 --size 320x240 \
    --min-rmse-ratio 2 --out "$out/bathroom_methods"
}

# What meters of all kinds take beside planar ones.
kinds() { "$python" samples/evaluation/meter_kinds.py --ups "$ups"; }

# Is the bathroom's picture nearer to a long render where it is smoothed for display?
smoothing() {
  "$python" samples/bathroom/smoothing.py --build build/release --time "$(seconds 60)" --reference-time "$(seconds 600)" \
    --out "$out/smoothing"
}

# As many iterations as its noise asks for, whatever the scale of times.
validation() { "$python" samples/validation/validate.py --ups "$ups" --out "$out/validation"; }

# Not at equal time, but against theory. UPS_LIBRARY: the folder of a libups.so that is there.
asymptotics() {
  UPS_LIBRARY=${UPS_LIBRARY:-build/release/src/api} "$python" samples/evaluation/asymptotics.py --out "$out/asymptotics"
}

# With seeds that no run had before, and as many iterations as ever.
calibration() {
  local status=0
  "$python" samples/accuracy/calibrate.py --ups "$ups" --jobs "$(nproc)" --out "$out/calibration" || status=1
  "$python" samples/accuracy/calibrate.py --ups "$ups" --target --jobs "$(nproc)" --out "$out/calibration" || status=1
  return "$status"
}

# Runs one check; the table that it prints is kept for the summary.
check() {
  local name=$1 log=$out/long_$1.txt result=passed
  step "$name"
  # A shell of its own: `set -e` would not hold within a condition.
  set +e
  (
    set -e
    "$name"
  ) | tee "$log"
  [ "${PIPESTATUS[0]}" = 0 ] || result=FAILED
  set -e
  [ "$result" = passed ] || failed=1
  names+=("$name")
  results+=("$result")
}

summary() {
  step "Summary"
  local i
  for i in "${!names[@]}"; do
    printf '%-11s %s\n' "${names[i]}" "${results[i]}"
    sed 's/^/    /' "$out/long_${names[i]}.txt"
  done
  [ "$scale" = 1 ] || echo "All times were multiplied by $scale: what failed above may only have had too little of it."
}

wanted=("$@")
[ $# -gt 0 ] || wanted=(office caustic spheres agreement bathroom kinds smoothing validation asymptotics calibration)
for name in "${wanted[@]}"; do
  case "$name" in
    office | caustic | spheres | agreement | bathroom | kinds | smoothing | validation | asymptotics | calibration) ;;
    *)
      echo "usage: $0 [office] [caustic] [spheres] [agreement] [bathroom] [kinds]" \
        "[smoothing] [validation] [asymptotics] [calibration]" >&2
      exit 2
      ;;
  esac
done
ups=${UPS_PROGRAM:-build/release/bin/ups}
if [ -z "${UPS_PROGRAM-}" ]; then build; fi
mkdir -p "$out"
for name in "${wanted[@]}"; do check "$name"; done
summary
exit "$failed"
