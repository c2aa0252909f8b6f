#!/usr/bin/env bash
# The Debian packages that cpack makes of a build: which there are, what they depend on, that no file is in two, and that the
# program and the Python package run from where the four are unpacked together. Installing them for good is not tried here.
# Called by ctest, with CPACK set: debian.sh BUILD VERSION PYTHON LIBDIR
set -euo pipefail
build=$1 version=$2 python=$3 libdir=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sanitizer=${LD_PRELOAD:-} # for what loads the library; with it cpack waits for ever for what it runs
unset PYTHONPATH UPS_LIBRARY LD_LIBRARY_PATH LD_PRELOAD

options=()
if [ -n "$sanitizer" ]; then options=(-D CPACK_STRIP_FILES=OFF); fi # what is suppressed has names
"$CPACK" --config "$build/CPackConfig.cmake" "${options[@]}" -B "$work" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
depends() { # FILE WORD ...
  local found word
  found=$(dpkg-deb -f "$1" Depends)
  for word in "${@:2}"; do
    [[ ", $found," == *", $word"[\ ,]* ]] || { echo "$1 depends on $found, not on $word" >&2; exit 1; }
  done
}
shopt -s nullglob
tools=("$work"/ups-tools_"${version}"_*.deb)
depends "$work"/libups0_"${version}"_*.deb libc6 libtbb12 libstdc++6
depends "$work"/libups-dev_"${version}"_*.deb libups0 libembree-dev libtbb-dev
depends "$work/python3-ups_${version}_all.deb" libups0 python3-numpy
if [ ${#tools[@]} = 1 ]; then depends "${tools[0]}" libups0 libcairo2; fi

packages=("$work"/*.deb)
for package in "${packages[@]}"; do
  dpkg-deb -c "$package" | awk '$1 !~ /^d/ { print $6 }' >>"$work/files"
  dpkg-deb -x "$package" "$work/root"
  [ -s "$work/root/usr/share/doc/$(dpkg-deb -f "$package" Package)/copyright" ]
done
twice=$(sort "$work/files" | uniq -d)
[ -z "$twice" ] || { echo "in two packages: $twice" >&2; exit 1; }
dpkg-deb -I "$work"/libups0_*.deb triggers | grep -q ldconfig
dpkg-deb -I "$work"/libups0_*.deb shlibs | grep -q "^libups ${version%.*} libups0 (>= $version), libups0 (<< 0\.[0-9]*)$"

if [ ${#tools[@]} = 1 ]; then [ "$("$work/root/usr/bin/ups" --version)" = "ups $version" ]; fi
mkdir "$work/out"
LD_PRELOAD=$sanitizer UPS_LIBRARY=$work/root/usr/$libdir PYTHONPATH=$work/root/usr/lib/python3/dist-packages \
  "$python" "$here/../../samples/python/first_room.py" "$work/out"
echo "${#packages[@]} packages of $(wc -l <"$work/files") files"
