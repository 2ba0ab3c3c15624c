#!/usr/bin/env bash
# Checks our C++ and CUDA files against .clang-format (clang-format 14, as in Debian 12).
# Usage: scripts/check-format.sh [--fix]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh checks
action=(--dry-run -Werror)
[[ ${1:-} == --fix ]] && action=(-i)
find accel app measure render tests -name '*.h' -o -name '*.cpp' -o -name '*.cu' | sort | xargs -r clang-format "${action[@]}"
