#pragma once

namespace ropelight {

/// While it lives, the first Ctrl-C (or SIGTERM) only asks to stop; the next one ends the program at once.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  bool requested() const;
};

}  // namespace ropelight
