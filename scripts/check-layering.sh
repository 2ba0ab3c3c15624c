#!/usr/bin/env bash
# Checks that CUDA, GL and GLM stay where the design lets them, and that no layer includes one above it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

status=0

# forbid RULE PATTERN ALLOWED PATH…: no line under the paths matches PATTERN, but for "file:line:text" matching ALLOWED.
forbid() {
  local rule="$1" pattern="$2" allowed="$3" found
  shift 3
  found="$(grep -rnP --include='*.h' --include='*.cpp' --include='*.cu' "$pattern" "$@" | grep -vP "$allowed" || true)"
  if [[ -n $found ]]; then
    printf 'layering: %s\n%s\n' "$rule" "$found"
    status=1
  fi
}

none='(?!)'
cuda='\bcuda[A-Z]\w+|__(global|device|host|shared|constant|launch_bounds)__|__CUDA(CC|_ARCH)__|#\s*include\s*[<"](cuda|cub/|thrust/|nvtx)'
forbid "CUDA names belong in render/core/hd.h, render/backend/ and app/viewer/draw/display_cuda.cu" "$cuda" \
  '^(render/core/hd\.h|render/backend/.*|[^:]*\.cu|render/core/vec\.h:\d+:#.*__CUDACC__)\b' accel app measure render tests
forbid "GL, windows and the command line belong in app/" '#\s*include\s*[<"](GL|GLES|GLFW|EGL|imgui|CLI)\b' "$none" \
  accel render
forbid "GLM is included by render/core/vec.h alone" '#\s*include\s*[<"]glm/' '^render/core/vec\.h:' accel app measure render tests
forbid "render/ and accel/ do not include app/" '#\s*include\s*"app/' "$none" accel render
forbid "accel/ includes no backend, integrator or stream" '#\s*include\s*"render/(backend|integrator|trace)/' "$none" accel
forbid "render/core/ includes nothing of ours but itself" '#\s*include\s*"(?!render/core/)' "$none" render/core
exit "$status"
