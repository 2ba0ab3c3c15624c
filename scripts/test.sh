#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test, two suites at a time (cmake/suites.cmake). The last line is the
# count: 'N passed, N failed, N skipped'.
# Usage: scripts/test.sh [--preset NAME] [--quick] [OPTIONS of doctest, such as --test-case='*rope*']
#   --quick: without what is slow; options of doctest: the chosen tests one after the other
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

preset="" choice=()
if [[ ${1:-} == --preset ]]; then
  preset="${2:?--preset needs a name from CMakePresets.json}"
  shift 2
fi
if [[ ${1:-} == --quick ]]; then
  choice=(--test-suite-exclude=slow)
  shift
fi

"$root/scripts/setup.sh"
preset="${preset:-$(default_preset)}"
build "$preset" ropelight_tests
program="$root/build/$preset/ropelight_tests"

# cases OPTIONS: how many test cases these options of doctest leave.
cases() { "$program" --count "$@" | sed -nE 's/.*current filters: ([0-9]+)$/\1/p'; }

if (($# == 0)); then
  results="$root/build/$preset/tests.xml"
  rm -f "$results"
  ((${#choice[@]})) && without=(--label-exclude '^slow$') || without=()
  # The preset says how many run at a time; whole outputs, since the sums are read from them.
  (cd "$root" && ctest --preset "$preset" "${without[@]}" --no-tests=error --output-junit "$results" \
    --test-output-size-passed 100000000 --test-output-size-failed 100000000) || true
  exec "$root/scripts/test-summary.py" "$results" "$(cases)" "$(cases "${choice[@]}")"
fi

log="$(mktemp)"
trap 'rm -f "$log"' EXIT
status=0
"$program" "${choice[@]}" "$@" 2>&1 | tee "$log" || status="${PIPESTATUS[0]}"

# doctest counts by test case: "[doctest] test cases: 3 | 2 passed | 1 failed | 0 skipped".
count() { sed -nE "s/^\[doctest\] test cases:.* ([0-9]+) $1.*/\1/p" "$log" | tail -n 1; }
passed="$(count passed)" failed="$(count failed)" skipped="$(count skipped)"
if [[ -z $passed || ($status -ne 0 && $failed -eq 0) ]]; then
  echo "test: the test program ended with status $status and no failed test case: it crashed, or a sanitizer spoke"
  failed=1
fi
echo "${passed:-0} passed, $failed failed, ${skipped:-0} skipped"
exit "$status"
