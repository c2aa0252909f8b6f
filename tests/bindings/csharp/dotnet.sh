#!/usr/bin/env bash
# The C# binding with the .NET SDK. Called by ctest: dotnet.sh xunit|package BUILD WORK EXTRAS
#   xunit      builds and runs Tests.csproj
#   package    makes the NuGet package of BUILD, and from an empty folder, which knows nothing but the package, a program
#              of sixty lines that uses it
# Works in WORK; EXTRAS OFF: without the tests of files. Exit code 77, with the reason: skipped, as there is no SDK, or
# its packages cannot be had. Where there is no network, the environment variable RestoreAdditionalProjectSources may name a
# folder of packages; samples/setup.sh test fetches those that are needed while there is one.
set -euo pipefail
part=$1 build=$2 work=$3 extras=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)

sanitizer=${LD_PRELOAD:-} # for what loads the library: the SDK has no need of it
unset LD_PRELOAD

skip() { echo "SKIPPED: $*"; exit 77; }

command -v dotnet >/dev/null || skip "no .NET SDK: dotnet is not on PATH"
mkdir -p "$work"
if [ ! -w "${HOME:-/nonexistent}" ]; then export HOME=$work/home; mkdir -p "$HOME"; fi
sdk=$(dotnet --version) || skip "dotnet has no SDK"
[ "${sdk%%.*}" -ge 8 ] || skip "the .NET SDK is $sdk, and 8 is needed"
export DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_NOLOGO=1 NuGetAudit=false RunAnalyzers=false
export PYTHONDONTWRITEBYTECODE=1 MSBUILDDISABLENODEREUSE=1  # no process outlives the test

# quietly COMMAND...: what it prints is shown when it fails.
quietly() {
  "$@" >"$work/$part.log" 2>&1 && return
  cat "$work/$part.log"
  if grep -qE 'NU1(100|101|102|301)' "$work/$part.log"; then
    skip "packages that the SDK needs cannot be had, see above"
  fi
  exit 1
}

run_xunit() {
  quietly dotnet build "$here/Tests.csproj" -c Release -warnaserror --artifacts-path "$work/artifacts" \
    "-p:UpsExtras=$extras"
  LD_PRELOAD=$sanitizer dotnet test "$work/artifacts/bin/Tests/release/Tests.dll"
}

# The program's folder: a project, a list of sources that holds the package's folder alone, and the sample.
make_room() {
  mkdir "$work/room"
  cp "$root/samples/csharp/SmallRoom.cs" "$work/room/Program.cs"
  cat >"$work/room/nuget.config" <<XML
<configuration>
  <packageSources><clear /><add key="local" value="$work/packages" /></packageSources>
</configuration>
XML
  cat >"$work/room/room.csproj" <<'XML'
<Project Sdk="Microsoft.NET.Sdk">
  <PropertyGroup>
    <OutputType>Exe</OutputType>
    <TargetFramework>net$(BundledNETCoreAppTargetFrameworkVersion)</TargetFramework>
    <Nullable>enable</Nullable>
    <TreatWarningsAsErrors>true</TreatWarningsAsErrors>
  </PropertyGroup>
  <ItemGroup><PackageReference Include="Ups" Version="*" /></ItemGroup>
</Project>
XML
}

expect_lux() {
  LD_PRELOAD=$sanitizer "$@" | tee "$work/room.txt"
  local readings
  local error='[0-9]+\.[0-9]'
  # -1.0: with a sanitizer the sample's five seconds may have no four batches, which an error needs.
  [ -z "$sanitizer" ] || error="($error|-1\.0)"
  readings=$(grep -cE "^ *[0-9]+\.[0-9] ± $error lx\$" "$work/room.txt" || true)
  [ "$readings" -eq 12 ] || { echo "expected 12 readings, got $readings"; exit 1; }
}

# What the libraries in the package need lies beside them or is the system's: zlib, the run-time libraries of C and C++.
check_libraries() {
  local folder=$1 library strangers
  for library in "$folder"/libups*; do
    strangers=$(ldd "$library" | awk '/=>/ { print $1, $3 }' | grep -v " $folder/" |
      grep -vE '^lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+|z|asan|tsan|ubsan)\.so' || true)
    [ -z "$strangers" ] || { echo "$library needs what is not in the package: $strangers"; exit 1; }
  done
}

run_package() {
  unset LD_LIBRARY_PATH
  rm -rf "$work/packages" "$work/cache" "$work/room"
  quietly "$root/bindings/csharp/pack.py" "$build" "$work/packages" --artifacts "$work/artifacts"
  ls -l "$work/packages"
  make_room
  cd "$work/room"
  export NUGET_PACKAGES=$work/cache
  dotnet build -c Release -o out
  expect_lux dotnet out/room.dll
  local installed
  installed=$(echo "$NUGET_PACKAGES"/ups/*)
  [ "$extras" = OFF ] || ls "$installed"/runtimes/linux-x64/native/libups_{gltf,exr,ocio,report}.so.*
  check_libraries "$installed/runtimes/linux-x64/native"
  echo "the same with the assembly for .NET Standard:"
  cp "$installed/lib/netstandard2.0/Ups.dll" out/
  expect_lux dotnet out/room.dll
}

"run_$part"
