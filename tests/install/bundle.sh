#!/usr/bin/env bash
# The archive for those who ship their own program (make_bundle.py), opened in a folder of another name: programs are
# built against it with pkg-config, its libraries copied to where a vendor would put them. Every library that they load has
# to be from there, but for the C and C++ run time and zlib.
# Called by ctest, with PKG_CONFIG, CC and FLAGS set: bundle.sh BUILD PYTHON
set -euo pipefail
build=$1 python=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset LD_LIBRARY_PATH

archive=$("$python" "$here/../../src/api/package/make_bundle.py" "$build" "$work/made")
mkdir "$work/opened elsewhere"
tar -xzf "$archive" -C "$work/opened elsewhere" --strip-components=1
bundle=$work/opened\ elsewhere
product=$work/product
mkdir -p "$product/bin" "$product/lib"
cp -P "$bundle"/lib/*.so.* "$product/lib"
for file in LICENSE THIRD-PARTY.md ups.spdx.json; do [ -s "$bundle/share/doc/ups/$file" ]; done
[ -s "$bundle/licences/libtbb12" ]

# Of the bundle's own pkg-config files alone: nothing of the system's is needed. The folder's name has a space.
ln -s "$bundle" "$work/bundle"
export PKG_CONFIG_LIBDIR=$work/bundle/lib/pkgconfig
try() { # SOURCE ENDING PACKAGES
  local flags loaded outside printed program=$product/bin/${1##*/}
  read -ra flags <<<"$("$PKG_CONFIG" --cflags --libs "${@:3}")"
  # shellcheck disable=SC2016  # $ORIGIN is the loader's
  # shellcheck disable=SC2086  # FLAGS is a list
  "$CC" $FLAGS -std=c99 "$1.c" "${flags[@]}" -Wl,-rpath,'$ORIGIN/../lib' -o "$program"
  printed=$(cd "$product" && env -i "LSAN_OPTIONS=${LSAN_OPTIONS:-}" "TSAN_OPTIONS=${TSAN_OPTIONS:-}" "$program" |
    tail -n 1)
  echo "${1##*/}: $printed"
  [[ $printed == "UPS "*" $2" ]]
  loaded=$(ldd "$program" | awk '$2 == "=>" { print $3 }')
  outside=$(grep -v "^$product/bin/../lib/" <<<"$loaded" |
    grep -vE '/(lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s|z|asan|tsan|ubsan)|ld-linux[^/]*)\.so\.[0-9]+$' || true)
  [ -z "$outside" ] || { echo "loaded from outside the bundle: $outside" >&2; exit 1; }
}
try "$here/../../samples/c/small_room" lx ups
if [ -e "$bundle/lib/pkgconfig/ups_gltf.pc" ] && [ -e "$bundle/lib/pkgconfig/ups_exr.pc" ] &&
  [ -e "$bundle/lib/pkgconfig/ups_ocio.pc" ] && [ -e "$bundle/lib/pkgconfig/ups_report.pc" ]; then
  try "$here/consumer/extras" sensors ups_gltf ups_exr ups_ocio ups_report
fi
