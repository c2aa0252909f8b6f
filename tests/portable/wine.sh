#!/usr/bin/env bash
# Runs the tests of src/platform on its Windows side, under Wine; a minute. Not part of the tests: it installs Wine and
# the sources of GoogleTest where they are missing (Debian; root or sudo). Builds into the folder given, or build/wine.
# A real Windows has never seen it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=${1-build/wine}
packages=(g++-mingw-w64-x86-64-posix wine64 wine googletest)

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
  as_root=(); [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get install -q -y --no-install-recommends "${missing[@]}"
fi

mkdir -p "$folder"
googletest=/usr/src/googletest/googletest
x86_64-w64-mingw32-g++-posix -std=c++20 -O1 -Wall -Wextra -static -Isrc -Iinclude -Itests/platform \
  -isystem $googletest/include -isystem $googletest src/platform/paths.cpp src/platform/windows/*.cpp \
  tests/platform/{files,paths,process,threads}_test.cpp $googletest/src/gtest-all.cc $googletest/src/gtest_main.cc \
  -o "$folder/platform_tests.exe"
export WINEDEBUG=-all WINEPREFIX=$PWD/$folder/prefix
case $folder in /*) WINEPREFIX=$folder/prefix ;; esac
wine "$folder/platform_tests.exe" "Büro Φ 照明 💡"
