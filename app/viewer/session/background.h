#pragma once
// Lower priority for rendering threads, so that the interface stays fluent while all cores render.

namespace ropelight::view {

/// Lowers the priority of the calling thread alone.
void giveWay();

/// From now on the scheduler's workers run at a lower priority.
void workersGiveWay();

}  // namespace ropelight::view
