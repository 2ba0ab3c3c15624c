#pragma once
// The stages that are compiled once for each kernel row: X(stage, header). A new one is its header in render/kernels/,
// with the stage Name<F> and its arguments NameArgs, and a word here. CMake reads the list (cmake/instantiate.cmake).

#define RL_STAGES(X)             \
  X(TraceCamera, trace_camera)   \
  X(TracePath, trace_path)       \
  X(TracePhotons, trace_photons) \
  X(TraceTails, trace_photons)   \
  X(GatherGlossy, gather_glossy) \
  X(TraceAov, trace_aov)
