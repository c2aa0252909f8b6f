#!/usr/bin/env bash
# The table of README.md: builds the preset "release", runs every test that the table names, prints what each measured.
#   tests/stability/run.sh             the full form: under 20 minutes on two cores
#   tests/stability/run.sh -R Hazard05 arguments go to ctest: some of it
# Exit code: ctest's.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
cores=$(nproc)
named='Hazard|Taught|SetsEmittersBack|AimsHaveAShare|RepeatItsRays|MeetAllBatches'
named+='|TellsPathsThatAreDropped|TellsEachKind|Distribution[.]Samples|TechniqueSubsets'
case " $* " in
  *" -R "*) ;;
  *) set -- -R "$named" "$@" ;;
esac

bash samples/setup.sh test
cmake --preset release
cmake --build --preset release --parallel "$cores"
log=build/release/Testing/Temporary/LastTest.log
rm -f "$log"
began=$(date +%s) result=0
UPS_STABILITY=full ctest --preset release --parallel "$cores" "$@" || result=$?
if [ -f "$log" ]; then python3 tests/stability/figures.py "$log" || result=1; fi
printf '%s minutes\n' "$(((($(date +%s) - began) * 10 / 60 + 5) / 10))"
exit "$result"
