# What the scripts share; sourced, not run.
# shellcheck shell=bash

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

has_nvcc() { command -v nvcc >/dev/null || [[ -x /usr/local/cuda/bin/nvcc ]]; }

# The driver's device file: NVIDIA's own, or that of Windows' Linux subsystem.
has_gpu() { [[ -e /dev/nvidiactl || -e /dev/dxg ]]; }

# Device code takes minutes to compile, so it is built where a GPU can run it.
default_preset() { if has_nvcc && has_gpu; then echo cuda-release; else echo cpu-release; fi; }

# build PRESET TARGET…: configures where that is due, then leaves it to ninja what to build.
build() {
  local preset="$1" directory="$root/build/$1"
  shift
  if ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$directory/CMakeCache.txt"; then
    (cd "$root" && cmake --fresh --preset "$preset")  # new, or the checkout was moved
  elif [[ ! -f "$directory/build.ninja" || "$root/CMakePresets.json" -nt "$directory/build.ninja" ]]; then
    (cd "$root" && cmake --preset "$preset")
  fi
  cmake --build "$directory" --parallel "$(nproc)" --target "$@"
}
