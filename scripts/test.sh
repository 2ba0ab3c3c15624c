#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. The last line is the count: 'N passed, N failed, N skipped'.
# Usage: scripts/test.sh [--preset NAME] [OPTIONS of doctest, such as --test-case='*rope*']
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

preset=""
if [[ ${1:-} == --preset ]]; then
  preset="${2:?--preset needs a name from CMakePresets.json}"
  shift 2
fi

"$root/scripts/setup.sh"
preset="${preset:-$(default_preset)}"
build "$preset" ropelight_tests

log="$(mktemp)"
trap 'rm -f "$log"' EXIT
status=0
"$root/build/$preset/ropelight_tests" "$@" 2>&1 | tee "$log" || status="${PIPESTATUS[0]}"

# doctest counts by test case: "[doctest] test cases: 3 | 2 passed | 1 failed | 0 skipped".
count() { sed -nE "s/^\[doctest\] test cases:.* ([0-9]+) $1.*/\1/p" "$log" | tail -n 1; }
passed="$(count passed)" failed="$(count failed)" skipped="$(count skipped)"
if [[ -z $passed || ($status -ne 0 && $failed -eq 0) ]]; then
  echo "test: the test program ended with status $status and no failed test case: it crashed, or a sanitizer spoke"
  failed=1
fi
echo "${passed:-0} passed, $failed failed, ${skipped:-0} skipped"
exit "$status"
