#!/usr/bin/env bash
# Installs what is missing, builds, and shows a scene: in the viewer where there is a display, else as out.png and
# out.exr in the current folder.
# Usage: scripts/run.sh [SCENE] [OPTIONS of ropelight view or render]
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scene="$root/assets/cornell-caustics.json"
if [[ $# -gt 0 && $1 != -* ]]; then
  scene="$1"
  shift
fi

"$root/scripts/setup.sh"
preset="$(default_preset)"
build "$preset" ropelight
ropelight="$root/build/$preset/ropelight"

# given NAME…: whether one of these options is among the script's own.
options=("$@")
given() {
  local name argument
  for name in "$@"; do
    for argument in "${options[@]}"; do
      [[ $argument == "$name" || $argument == "$name="* ]] && return 0
    done
  done
  return 1
}

why="there is no display"
if given -o --output --iterations --time --json --quiet; then
  why="the options ask for it"
elif [[ -n ${DISPLAY:-} || -n ${WAYLAND_DISPLAY:-} ]]; then
  status=0
  "$ropelight" view "$scene" "${options[@]}" || status=$?
  ((status == 4)) || exit "$status"  # 4: no usable device or display
  why="no window could be opened"
fi

given --time --iterations || options+=(--time 20)
given -o --output || options+=(-o out.png -o out.exr)
echo "run: $why, so the scene is rendered to files: ropelight render $scene ${options[*]}"
exec "$ropelight" render "$scene" "${options[@]}"
