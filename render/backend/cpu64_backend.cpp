// The CPU backend in double precision: CMake defines ROPELIGHT_DOUBLE for this file.
#include "render/backend/cpu_backend.cpp"
