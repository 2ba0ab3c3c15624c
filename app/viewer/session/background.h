#pragma once
// Threads that give way to the window: at a lower priority the interface stays fluent while all cores render.

namespace ropelight::view {

/// Lowers the priority of the calling thread alone.
void giveWay();

/// From now on the scheduler's workers give way.
void workersGiveWay();

}  // namespace ropelight::view
