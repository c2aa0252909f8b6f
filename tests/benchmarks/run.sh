#!/usr/bin/env bash
# Measures speed, from a bare Debian 12, Debian 13 or Ubuntu 24.04 (root or sudo): installs what is missing, builds the
# benchmarks in build/benchmarks, runs them: whole renders (throughput.py), then the parts by themselves. Run nothing else
# beside them. Arguments that begin with --benchmark are Google Benchmark's, the others throughput.py's:
#   tests/benchmarks/run.sh --against /other/tree/build/release/bin/ups --json figures.json
#   tests/benchmarks/run.sh --only rooms --rounds 5 --benchmark_filter=geometry
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

step() { printf '\n== %s\n' "$*"; }

of_parts=() of_renders=()
for argument in "$@"; do
  case "$argument" in
    --benchmark*) of_parts+=("$argument") ;;
    *) of_renders+=("$argument") ;;
  esac
done

step "Packages (samples/setup.sh benchmarks)"
bash samples/setup.sh benchmarks

step "Configure (cmake --preset benchmarks)"
cmake --preset benchmarks

step "Build (cmake --build --preset benchmarks)"
cmake --build --preset benchmarks --parallel "$(nproc)"

step "Run tests/benchmarks/throughput.py ${of_renders[*]}"
python3 tests/benchmarks/throughput.py --ups build/benchmarks/bin/ups "${of_renders[@]}"

step "Run build/benchmarks/bin/ups_benchmarks ${of_parts[*]}"
build/benchmarks/bin/ups_benchmarks "${of_parts[@]}"

step "Run build/benchmarks/bin/ups_commit_benchmark"
build/benchmarks/bin/ups_commit_benchmark
