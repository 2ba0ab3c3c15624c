#pragma once

namespace ropelight {

/// While it lives, the first Ctrl-C, SIGTERM or SIGHUP only asks to stop; a Ctrl-C or SIGTERM after it ends the program
/// at once. Signals that are ignored stay so.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  bool requested() const;
};

}  // namespace ropelight
