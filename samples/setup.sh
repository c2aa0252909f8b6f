#!/usr/bin/env bash
# Installs what building UPS needs on Debian 12, Debian 13 or Ubuntu 24.04; packages that are there are left alone.
#   samples/setup.sh run           to build the library, its extras, the program and the samples
#   samples/setup.sh test          the same and what the tests need
#   samples/setup.sh benchmarks    the first and what the benchmarks need
set -euo pipefail

run_packages=(cmake ninja-build g++ pkgconf libembree-dev libtbb-dev libopenexr-dev libimath-dev libopencolorio-dev
  libtinygltf-dev libstb-dev nlohmann-json3-dev libcli11-dev python3-numpy)
test_packages=(libgtest-dev python3-pytest python3-matplotlib mono-mcs mono-runtime abigail-tools clang libclang-rt-dev)
benchmark_packages=(libbenchmark-dev)

case "${1-}" in
  run) wanted=("${run_packages[@]}") ;;
  test) wanted=("${run_packages[@]}" "${test_packages[@]}") ;;
  benchmarks) wanted=("${run_packages[@]}" "${benchmark_packages[@]}") ;;
  *)
    echo "usage: $0 run|test|benchmarks" >&2
    exit 2
    ;;
esac

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "setup: this is not Debian or Ubuntu; install the equivalents of: ${wanted[*]}" >&2
  exit 1
fi

missing=()
for package in "${wanted[@]}"; do
  state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "setup: all ${#wanted[@]} packages are there"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: not root and no sudo; as root, run: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "setup: installing ${missing[*]}"
# "env" because sudo clears the environment.
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
