#!/usr/bin/env bash
# From a bare Debian 12, Debian 13 or Ubuntu 24.04 (root or sudo): installs what is missing, configures the preset
# "release" in build/release, builds, tests.
#   tests/run.sh               all tests but those in thorough.txt: about 25 minutes on two cores
#   tests/run.sh -R .          all tests: a quarter of an hour more
#   tests/run.sh -R install    arguments go to ctest, which then leaves none out by itself
# Ends with ctest's summary; its exit code is ctest's.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
cores=$(nproc)
targets=(all)
if [ $# -gt 0 ]; then targets+=(fuzzers); fi

step() { printf '\n== %s\n' "$*"; }

step "Packages (samples/setup.sh test)"
bash samples/setup.sh test

step "Configure (cmake --preset release)"
cmake --preset release

step "Build on $cores cores"
cmake --build --preset release --parallel "$cores" --target "${targets[@]}"

if [ $# = 0 ]; then
  thorough=$(sed '/^#/d; /^$/d' tests/thorough.txt)
  echo "left out: $(wc -l <<<"$thorough") tests that take long; all: tests/run.sh -R ."
  # A name that has changed would leave nothing out; without .NET or Mono there are no tests of theirs.
  tests=$(ctest --preset release -N | sed -n 's/^ *Test *#[0-9]*: //p' | sed 's/ (Disabled)$//')
  if unknown=$(grep -vxF "$tests" <<<"$thorough"); then
    printf 'tests/thorough.txt names what is no test here:\n%s\n' "$unknown"
  fi
  set -- -E "^($(sed 's/[.()]/\\&/g' <<<"$thorough" | paste -sd '|'))\$"
fi

step "Test (ctest --preset release)"
ctest --preset release --parallel "$cores" "$@"
