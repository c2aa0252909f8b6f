#!/usr/bin/env bash
# Everything, from a bare Debian 12, Debian 13 or Ubuntu 24.04 (root or sudo): installs what is missing, configures the
# preset "release" in build/release, builds, runs every test. Arguments go to ctest: tests/run.sh -R install
# Ends with ctest's summary; its exit code is ctest's.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
cores=$(nproc)

step() { printf '\n== %s\n' "$*"; }

step "Packages (samples/setup.sh test)"
bash samples/setup.sh test

step "Configure (cmake --preset release)"
cmake --preset release

step "Build on $cores cores"
cmake --build --preset release --parallel "$cores"

step "Test (ctest --preset release)"
ctest --preset release --parallel "$cores" "$@"
