#!/usr/bin/env bash
# Fuzzes the readers of photometric files.
#   tests/fuzz/run.sh [EXECUTIONS] [BUILD] [READER...]   a long run: 10,000,000 executions a reader, of every reader in
#                                                        BUILD/tests/fuzz (build/release), one after the other; prints
#                                                        executions and findings, keeps what it found in
#                                                        BUILD/tests/fuzz
#   tests/fuzz/run.sh --short FUZZER CORPUS              the test's run: fixed seed; exit code 77 without the fuzzer
# Exit code 1 where a reader crashed, leaked, was slow (10 s for an input) or allocated 512 MB at once.
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
limits=(-max_len=4096 -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=512 -print_final_stats=1)
export ASAN_OPTIONS=quarantine_size_mb=32

if [ "${1:-}" = --short ]; then
  if [ ! -x "$2" ]; then
    echo "skipped: there is no $2: the target fuzzers was not built, or there was no clang++ with libFuzzer"
    exit 77
  fi
  found=$(mktemp -d)
  trap 'rm -rf "$found"' EXIT
  cd "$found" && "$2" "${limits[@]}" -seed=1 -runs=4000 "$found" "$3"
  exit
fi

executions=${1:-10000000}
build=${2:-$here/../../build/release}
if ! cmake --build "$build" --target fuzzers || ! compgen -G "$build/tests/fuzz/fuzz_*" >/dev/null; then
  echo "$build has no fuzzers: install clang, then configure the project there, as tests/run.sh does" >&2
  exit 2
fi
folder=$(cd "$build/tests/fuzz" && pwd)
shift $(($# < 2 ? $# : 2))
readers=("$@")
if [ ${#readers[@]} = 0 ]; then
  for target in "$here"/fuzz_*.cpp; do
    name=$(basename "$target" .cpp)
    readers+=("${name#fuzz_}")
  done
fi
failed=0
for reader in "${readers[@]}"; do
  work=$folder/found/$reader
  mkdir -p "$work/corpus" "$work/findings"
  "$folder/fuzz_$reader" "${limits[@]}" -runs="$executions" -artifact_prefix="$work/findings/" \
    "$work/corpus" "$here/corpus/$reader" >"$work/log" 2>&1
  status=$?
  done_runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$work/log")
  findings=$(find "$work/findings" -type f | wc -l)
  echo "$reader: ${done_runs:-?} executions, $findings findings, exit code $status (log: $work/log)"
  [ "$status" = 0 ] && [ "$findings" = 0 ] || failed=1
done
exit $failed
