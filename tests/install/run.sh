#!/usr/bin/env bash
# Installs a build into a temporary prefix, moves the prefix, and builds the C and the C++ program in consumer/ against
# it twice: with CMake's find_package(ups) and with pkg-config. All programs must run and print the version that was
# installed, and so must the program `ups` where it was built.
# Called by ctest, with CMAKE, PKG_CONFIG, GENERATOR, CC, CXX and FLAGS set: run.sh BUILD LIBDIR VERSION
set -euo pipefail
build=$1 libdir=$2 version=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Moved, because a prefix that only works where it was first installed fails in every package.
"$CMAKE" --install "$build" --prefix "$work/first" >"$work/install.log" || { cat "$work/install.log"; exit 1; }
mv "$work/first" "$work/prefix"

expect() {
  local printed
  printed=$("$1")
  echo "$2: $printed"
  [[ $printed == "UPS $version: "*" lx" ]] || { echo "expected 'UPS $version: ... lx'" >&2; exit 1; }
}

"$CMAKE" -S "$here/consumer" -B "$work/with_cmake" -G "$GENERATOR" -DCMAKE_PREFIX_PATH="$work/prefix" \
  -DCMAKE_C_COMPILER="$CC" -DCMAKE_C_FLAGS="$FLAGS" -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_CXX_FLAGS="$FLAGS" \
  >"$work/cmake.log" || { cat "$work/cmake.log"; exit 1; }
"$CMAKE" --build "$work/with_cmake"
expect "$work/with_cmake/consumer" find_package
expect "$work/with_cmake/consumer_cpp" "find_package, C++"

export PKG_CONFIG_PATH=$work/prefix/$libdir/pkgconfig
read -ra flags <<<"$("$PKG_CONFIG" --cflags --libs ups)"
# shellcheck disable=SC2086  # FLAGS is a list
"$CC" $FLAGS -std=c99 -pedantic -Wall -Wextra -Werror "$here/consumer/main.c" "${flags[@]}" -o "$work/with_pkgconfig"
LD_LIBRARY_PATH=$work/prefix/$libdir expect "$work/with_pkgconfig" pkg-config
# shellcheck disable=SC2086
"$CXX" $FLAGS -std=c++17 -pedantic -Wall -Wextra -Werror "$here/consumer/main.cpp" "${flags[@]}" \
  -o "$work/with_pkgconfig"
LD_LIBRARY_PATH=$work/prefix/$libdir expect "$work/with_pkgconfig" "pkg-config, C++"

program=$work/prefix/bin/ups
if [ -x "$program" ]; then
  printed=$("$program" --version)
  echo "program: $printed"
  [ "$printed" = "ups $version" ] || { echo "expected 'ups $version'" >&2; exit 1; }
  # Targets are read before the scene; those of the standard are found from where the program now is.
  echo '{"include": "en12464-1.json", "areas": [{"meters": "a", "row": "office.writing"}]}' >"$work/targets.json"
  "$program" render "$work/none.gltf" --targets "$work/targets.json" 2>"$work/targets.log" && exit 1
  grep -q "none.gltf" "$work/targets.log" || { cat "$work/targets.log" >&2; exit 1; }
fi
