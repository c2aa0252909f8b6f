#!/usr/bin/env bash
# Breaks the engine in one place at a time and shows which test finds it, from a bare Debian 12, Debian 13 or Ubuntu
# 24.04 (root or sudo): installs what is missing, builds all mutants at once, runs the tests on each. See README.md.
#   tests/mutation/run.sh                       all: half an hour
#   tests/mutation/run.sh weights merge_sign 7  some: regular expressions of file and name, names, numbers
#   tests/mutation/run.sh --list                what there is
# Exit code 1 where fewer than 95 % are found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
case " $* " in
  *" --list "* | *" --help "* | *" -h "*) ;;
  *)
    printf '\n== %s\n' "Packages (samples/setup.sh test)"
    bash samples/setup.sh test
    ;;
esac
exec python3 tests/mutation/mutation.py "$@"
