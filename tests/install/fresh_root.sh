#!/usr/bin/env bash
# A build's Debian packages and its bundle in a fresh root of the release that this machine has: two minutes, as root,
# with debootstrap, patchelf and Debian's mirror. Not part of tests/run.sh.
#   tests/install/fresh_root.sh build/release
# The packages are installed there, and the program, two programs in C and a sample in Python run; then they
# and all that they brought along are purged, and the same C programs run with the bundle's libraries beside them.
set -euo pipefail
build=$(cd "$1" && pwd)
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
project=$here/../..
work=$(mktemp -d)
root=$work/root
leave() {
  if mountpoint -q "$root/proc"; then umount "$root/proc"; fi
  rm -rf --one-file-system "$work"
}
trap leave EXIT
quietly() { "$@" >"$work/log" 2>&1 || { tail -n 30 "$work/log" >&2; exit 1; }; }
step() { printf '\n== %s\n' "$*"; }

step "Packages and bundle"
quietly cpack --config "$build/CPackConfig.cmake" -B "$work/packages"
archive=$("$project/src/api/package/make_bundle.py" "$build" "$work")
mkdir "$work/bundle"
tar -xzf "$archive" -C "$work/bundle" --strip-components=1

# shellcheck source=/dev/null
release=$(. /etc/os-release && echo "$VERSION_CODENAME")
step "A root of $release"
quietly debootstrap --variant=minbase "$release" "$root"
mount -t proc proc "$root/proc" # the loader asks it for $ORIGIN
mkdir "$root/try" "$root/try/out" "$root/vendor"
cp "$work"/packages/*.deb "$here/consumer/extras.c" "$project"/samples/{c/small_room.c,python/first_room.py} "$root/try"
inside() { chroot "$root" env DEBIAN_FRONTEND=noninteractive sh -ec "cd /try; $1"; }

step "Installed from the packages"
quietly inside 'apt-get update && apt-get install -y --no-install-recommends ./*.deb gcc libc6-dev pkgconf'
inside 'gcc -std=c99 small_room.c $(pkg-config --cflags --libs ups) -o small_room
        gcc -std=c99 extras.c $(pkg-config --cflags --libs ups_gltf ups_exr ups_ocio ups_report) -o extras
        ups --version; ./small_room; ./extras; python3 first_room.py out
        test -s out/room.exr; test -s /usr/share/man/man1/ups.1'

step "Purged, and the bundle beside the programs"
quietly inside 'apt-get purge -y --autoremove libups0 libups-dev ups-tools python3-ups'
if inside 'ldconfig -p' | grep -E 'libups|embree|libtbb|OpenEXR|OpenColorIO'; then
  echo "these are left in the root" >&2
  exit 1
fi
cp -P "$work"/bundle/lib/*.so.* "$root/vendor"
inside 'if ./small_room 2>/dev/null; then exit 1; fi' # for want of libraries
for program in small_room extras; do
  cp "$root/try/$program" "$root/vendor"
  patchelf --set-rpath '$ORIGIN' "$root/vendor/$program"
  inside "/vendor/$program"
done
