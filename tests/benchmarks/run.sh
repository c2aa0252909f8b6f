#!/usr/bin/env bash
# Measures speed, from a bare Debian 12, Debian 13 or Ubuntu 24.04 (root or sudo): installs what is missing, builds the
# benchmarks in build/benchmarks, runs them. Run nothing else beside them. Arguments are Google Benchmark's:
#   tests/benchmarks/run.sh --benchmark_filter=geometry --benchmark_repetitions=9
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

step() { printf '\n== %s\n' "$*"; }

step "Packages (samples/setup.sh benchmarks)"
bash samples/setup.sh benchmarks

step "Configure (cmake --preset benchmarks)"
cmake --preset benchmarks

step "Build (cmake --build --preset benchmarks)"
cmake --build --preset benchmarks --parallel "$(nproc)"

step "Run build/benchmarks/bin/ups_benchmarks $*"
build/benchmarks/bin/ups_benchmarks "$@"
