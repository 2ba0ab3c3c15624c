#include "render/backend/cuda_scan.h"
// the drivers, on that backend:
#include "render/integrators/modes.h"
