#!/usr/bin/env bash
# The Python package from an empty folder, in both ways that bindings/python/setup.py has: installed from the source tree,
# the libraries' dependencies being the system's; and as a wheel that has these inside. Each runs a sample there, without
# this tree, and is looked at by python_libraries.py. pip asks no network.
# Called by ctest: python.sh BUILD PYTHON
set -euo pipefail
build=$1 python=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
sanitizer=${LD_PRELOAD:-} # for what loads the library
unset PYTHONPATH UPS_LIBRARY LD_LIBRARY_PATH LD_PRELOAD
export UPS_BUILD=$build PIP_NO_INDEX=1 PIP_DISABLE_PIP_VERSION_CHECK=1

quietly() { "$@" >log 2>&1 || { cat log >&2; exit 1; }; }

# A virtual environment that has numpy from the system, and its folder for packages.
environment() { quietly "$python" -m venv --system-site-packages --without-pip "$1"; }

try() ( # ENVIRONMENT system|inside
  if [ -n "$sanitizer" ]; then # its dlopen asks for oneTBB's allocator in oneTBB's name, but not beside oneTBB
    export LD_PRELOAD=$sanitizer LD_LIBRARY_PATH
    LD_LIBRARY_PATH=$(dirname "$1"/lib/python3*/site-packages/ups/lib/libups.so.*)
  fi
  mkdir "$1/out"
  "$1/bin/python" "$root/samples/python/first_room.py" "$1/out"
  [ -s "$1/out/room.exr" ] && [ -s "$1/out/room.png" ]
  "$1/bin/python" "$here/python_libraries.py" "$1" "$2"
)

environment installed
pip_install() { "$python" -m pip --python installed/bin/python install --no-build-isolation "$root/bindings/python"; }
UPS_BUILD=no/such/build pip_install >log 2>&1 || true
grep -q "there is no folder $(realpath "$root")/no/such/build" log || { cat log >&2; exit 1; }
UPS_BUILD=$(realpath --relative-to="$root" "$build") quietly pip_install # as someone in the root would write it
try installed system

UPS_BUNDLE=1 quietly "$python" -m pip wheel --no-build-isolation --no-deps -w wheels "$root/bindings/python"
ls -l wheels/ups-*-manylinux_*.whl
environment from_wheel
quietly "$python" -m pip --python from_wheel/bin/python install wheels/ups-*.whl
try from_wheel inside
