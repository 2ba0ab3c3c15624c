// The integrators in double precision: CMake defines ROPELIGHT_DOUBLE for this file.
#include "render/integrators/cpu_integrators.cpp"
