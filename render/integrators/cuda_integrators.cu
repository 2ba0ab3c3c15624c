#include "render/backend/cuda_backend.h"
// the drivers, on that backend:
#include "render/integrators/modes.h"
