#!/usr/bin/env bash
# Installs what building UPS needs on Debian 12, Debian 13 or Ubuntu 24.04; packages that are there are left alone.
#   samples/setup.sh run           to build the library, its extras, the program and the samples
#   samples/setup.sh report        the same and what draws the report of samples/accuracy
#   samples/setup.sh test          the same and what the tests need
#   samples/setup.sh benchmarks    the first and what the benchmarks need
set -euo pipefail

run_packages=(cmake ninja-build g++ pkgconf libembree-dev libtbb-dev libopenexr-dev libimath-dev libopencolorio-dev
  libtinygltf-dev libstb-dev nlohmann-json3-dev libcli11-dev libcairo2-dev python3-numpy)
report_packages=(python3-matplotlib)
test_packages=(libgtest-dev python3-pytest mypy python3-ipykernel python3-nbclient python3-pip python3-setuptools
  python3-wheel python3-venv patchelf dpkg-dev mono-mcs mono-runtime abigail-tools clang libclang-rt-dev doxygen
  g++-mingw-w64-x86-64-posix locales libbenchmark-dev)
optional_packages=() # installed with the others where there is such a package: Ubuntu has no chromium
benchmark_packages=(libbenchmark-dev)

case "${1-}" in
  run) wanted=("${run_packages[@]}") ;;
  report) wanted=("${run_packages[@]}" "${report_packages[@]}") ;;
  test)
    wanted=("${run_packages[@]}" "${report_packages[@]}" "${test_packages[@]}")
    optional_packages=(chromium)
    ;;
  benchmarks) wanted=("${run_packages[@]}" "${benchmark_packages[@]}") ;;
  *)
    echo "usage: $0 run|report|test|benchmarks" >&2
    exit 2
    ;;
esac

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "setup: this is not Debian or Ubuntu; install the equivalents of: ${wanted[*]}" >&2
  exit 1
fi

# The NuGet packages that the tests of the C# binding restore, where there is a .NET SDK: they need no network afterwards.
fetch_nuget_packages() {
  command -v dotnet >/dev/null || { echo "setup: no .NET SDK: the tests of the C# binding run on Mono alone"; return; }
  local work
  work=$(mktemp -d)
  dotnet restore "$(dirname "${BASH_SOURCE[0]}")/../tests/bindings/csharp/Tests.csproj" -p:NuGetAudit=false \
    --artifacts-path "$work" >"$work/log" 2>&1 || { cat "$work/log"; echo "setup: the tests of C# on .NET will be skipped"; }
  rm -rf "$work"
}
if [ "$1" = test ]; then fetch_nuget_packages; fi

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
# "env" because sudo clears the environment.
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q
for package in ${optional_packages[@]+"${optional_packages[@]}"}; do
  if apt-cache show "$package" >/dev/null 2>&1; then missing+=("$package"); fi
done
echo "setup: installing ${missing[*]}"
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
