#!/usr/bin/env bash
# Installs a build into a temporary prefix, moves the prefix, and builds the small rooms of samples/ in C and C++ and
# consumer/extras.c against it: with CMake's find_package(ups) and with pkg-config, with the shared and with the static
# libraries. All must run and print the version that was installed, the rooms all the same illuminance to the last digit;
# so must the program `ups` where it was built, its version. The rest of what is installed: installed.py.
# Called by ctest, with CMAKE, PKG_CONFIG, GENERATOR, CC, CXX and FLAGS set: run.sh BUILD LIBDIR VERSION PYTHON
set -euo pipefail
build=$1 libdir=$2 version=$3 python=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
samples=$here/../../samples
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Moved, because a prefix that only works where it was first installed fails in every package.
"$CMAKE" --install "$build" --prefix "$work/first" >"$work/install.log" || { cat "$work/install.log"; exit 1; }
mv "$work/first" "$work/prefix"
"$python" "$here/installed.py" "$work/prefix" "$libdir" "$build"

extras=OFF
if [ -e "$work/prefix/$libdir/pkgconfig/ups_gltf.pc" ] && [ -e "$work/prefix/$libdir/pkgconfig/ups_exr.pc" ] &&
  [ -e "$work/prefix/$libdir/pkgconfig/ups_ocio.pc" ] && [ -e "$work/prefix/$libdir/pkgconfig/ups_report.pc" ]; then
  extras=ON
fi

expect() { # PROGRAM NAME ENDING
  local printed
  printed=$(cd "$work" && "$1" | tail -n 1)
  echo "$2: $printed"
  [[ $printed == "UPS $version: "*" $3" ]] || { echo "expected 'UPS $version: ... $3'" >&2; exit 1; }
  if [ "$3" = lx ]; then
    room=${room:-$printed}
    [ "$printed" = "$room" ] || { echo "the same room was: $room" >&2; exit 1; }
  fi
}

needs_no_library() { # PROGRAM
  if readelf -d "$1" | grep -q 'NEEDED.*libups'; then echo "$1 needs a shared library of UPS" >&2; exit 1; fi
}

with_cmake() { # NAME, more options
  local folder=$work/$1
  "$CMAKE" -S "$here/consumer" -B "$folder" -G "$GENERATOR" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_C_COMPILER="$CC" \
    -DCMAKE_C_FLAGS="$FLAGS" -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_CXX_FLAGS="$FLAGS" -DEXTRAS=$extras \
    "${@:2}" >"$work/cmake.log" || { cat "$work/cmake.log"; exit 1; }
  "$CMAKE" --build "$folder" >"$work/build.log" || { cat "$work/build.log"; exit 1; }
  expect "$folder/consumer" "find_package, $1" lx
  expect "$folder/consumer_cpp" "find_package, $1, C++" lx
  if [ $extras = ON ]; then expect "$folder/extras" "find_package, $1" sensors; fi
}

# Without the links that a linker finds a shared library by it takes the static ones: PREFIX is then a copy without.
with_pkgconfig() { # NAME PREFIX OPTIONS
  local program sources=("$samples/c/small_room")
  if [ $extras = ON ]; then sources+=("$here/consumer/extras"); fi
  for program in "${sources[@]}"; do
    local packages=(ups) flags
    if [ "${program##*/}" = extras ]; then packages=(ups_gltf ups_exr ups_ocio ups_report); fi
    # shellcheck disable=SC2086  # OPTIONS and FLAGS are lists
    {
      read -ra flags <<<"$(PKG_CONFIG_PATH=$2/$libdir/pkgconfig "$PKG_CONFIG" $3 --cflags --libs "${packages[@]}")"
      "$CC" $FLAGS -std=c99 -pedantic -Wall -Wextra -Werror "$program.c" "${flags[@]}" -o "$work/$1.${program##*/}"
    }
  done
  LD_LIBRARY_PATH=$2/$libdir expect "$work/$1.small_room" "pkg-config, $1" lx
  if [ $extras = ON ]; then LD_LIBRARY_PATH=$2/$libdir expect "$work/$1.extras" "pkg-config, $1" sensors; fi
}

with_cmake shared
with_pkgconfig shared "$work/prefix" ""
read -ra flags <<<"$(PKG_CONFIG_PATH=$work/prefix/$libdir/pkgconfig "$PKG_CONFIG" --cflags --libs ups)"
# shellcheck disable=SC2086  # FLAGS is a list
"$CXX" $FLAGS -std=c++17 -pedantic -Wall -Wextra -Werror "$samples/cpp/small_room.cpp" "${flags[@]}" -o "$work/shared.cpp"
LD_LIBRARY_PATH=$work/prefix/$libdir expect "$work/shared.cpp" "pkg-config, C++" lx
if [ -e "$work/prefix/$libdir/libups.a" ]; then
  with_cmake static -DSTATIC=ON
  cp -r "$work/prefix" "$work/archives"
  rm "$work/archives/$libdir"/*.so*
  with_pkgconfig static "$work/archives" --static
  for program in "$work"/static/consumer "$work"/static.small_room; do needs_no_library "$program"; done
  if [ $extras = ON ]; then
    for program in "$work"/static/extras "$work"/static.extras; do needs_no_library "$program"; done
  fi
fi

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
