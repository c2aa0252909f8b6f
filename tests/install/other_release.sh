#!/usr/bin/env bash
# The work tree's last commit built in a root of another Debian release, and its packages and bundle tried in a fresh
# root of that release by fresh_root.sh. Half an hour, as root, with debootstrap and Debian's mirror. Not part of
# tests/run.sh.
#   tests/install/other_release.sh trixie FOLDER
# FOLDER: where the root is made; it stays, and a second run builds there what has changed.
set -euo pipefail
[ $# -eq 2 ] || { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
release=$1
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
mkdir -p "$2"
root=$(cd "$2" && pwd)
leave() {
  for mounted in proc dev; do
    if mountpoint -q "$root/$mounted"; then umount "$root/$mounted"; fi
  done
}
trap leave EXIT
step() { printf '\n== %s\n' "$*"; }
inside() {
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive \
    bash -ec "cd /ups; $1"
}

if [ ! -e "$root/etc/debian_version" ]; then
  step "A root of $release"
  debootstrap --variant=minbase "$release" "$root"
fi
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
mkdir -p "$root/ups"
git -C "$project" archive HEAD | tar -x -C "$root/ups"

step "Packages"
inside 'apt-get update -q; apt-get install -q -y --no-install-recommends ca-certificates debootstrap dpkg-dev file patchelf
        bash samples/setup.sh run'
step "Build"
inside 'cmake --preset release -DUPS_BUILD_TESTS=OFF; cmake --build --preset release --parallel "$(nproc)"
        build/release/bin/ups --version'
step "Packages and bundle"
inside 'bash tests/install/fresh_root.sh build/release'
