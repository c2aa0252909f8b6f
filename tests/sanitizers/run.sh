#!/usr/bin/env bash
# All tests under sanitizers, from a bare Debian 12, Debian 13 or Ubuntu 24.04 (root or sudo): installs what is missing,
# configures, builds, runs every test, judges by what the sanitizers found. See README.md.
#   tests/sanitizers/run.sh address            address, undefined behaviour, float traps
#   tests/sanitizers/run.sh thread             races
#   tests/sanitizers/run.sh traps -R Torture   float traps alone, which slow nothing down: scenes at full size, by UPS_STABILITY=full
#   tests/sanitizers/run.sh address -R Replay  arguments go to ctest
# UPS_TEST_EFFORT=full: renders of tests with all their iterations. Exit code 1 where something was found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
cores=$(nproc)
case ${1:-} in
  address) preset=asan ;;
  thread) preset=tsan ;;
  traps) preset=traps ;;
  *)
    sed -n '2,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
    exit 2
    ;;
esac
shift

step() { printf '\n== %s\n' "$*"; }

step "Packages (samples/setup.sh test)"
bash samples/setup.sh test
step "Configure (cmake --preset $preset)"
cmake --preset "$preset"
step "Build on $cores cores"
cmake --build --preset "$preset" --parallel "$cores" --target all fuzzers
step "Build without sanitizers, for the judgement"
cmake --preset release
cmake --build --preset release --parallel "$cores" --target all fuzzers
step "Test (ctest --preset $preset)"
export UPS_TEST_EFFORT=${UPS_TEST_EFFORT:-low}
in_place=()  # the thread sanitizer finds no room for its memory where addresses are spread at random
if setarch "$(uname -m)" --addr-no-randomize true 2>/dev/null; then in_place=(setarch "$(uname -m)" --addr-no-randomize); fi
results=$PWD/build/$preset/results.xml
rm -f "$results"
"${in_place[@]}" ctest --preset "$preset" --parallel "$cores" --output-junit "$results" "$@" || true # what failed is judged below
step "Judge (tests/sanitizers/judge.py)"
"${in_place[@]}" python3 tests/sanitizers/judge.py "build/$preset" build/release
