#!/usr/bin/env bash
# Measures reading from C# against reading from C, on .NET where there is an SDK and on Mono where it is; a minute, on a
# machine that does nothing else, with 4 GB free:
#
#   tests/bindings/csharp/speed/read_speed.sh build/release
set -euo pipefail
[ $# -eq 1 ] || { sed -n '2,5s/^# \{0,1\}//p' "$0"; exit 2; }
build=$(cd "$1" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")"
root=$(cd ../../../.. && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LD_LIBRARY_PATH=$build/src/api:$work

cc -O2 -std=gnu99 -Wall -Wextra -shared -fPIC -I"$root/include" read_speed.c -o "$work/libread_speed.so" \
  -L"$build/src/api" -lups
failed=0
if command -v dotnet >/dev/null; then
  dotnet build ReadSpeed.csproj -c Release -v quiet --nologo --artifacts-path "$work/artifacts"
  echo ".NET $(dotnet --version)"
  dotnet "$work/artifacts/bin/ReadSpeed/release/ReadSpeed.dll" || failed=1
else
  echo "read_speed: .NET is left out: dotnet not found"
fi
if command -v mcs >/dev/null && command -v mono >/dev/null; then
  mcs -unsafe -optimize -langversion:latest -out:"$work/ReadSpeed.exe" ReadSpeed.cs "$root"/bindings/csharp/*.cs
  echo "Mono"
  mono "$work/ReadSpeed.exe" || failed=1
else
  echo "read_speed: Mono is left out: mcs or mono not found"
fi
exit $failed
