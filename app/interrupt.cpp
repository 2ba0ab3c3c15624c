#include "app/interrupt.h"

#include <csignal>

namespace ropelight {
namespace {

volatile std::sig_atomic_t stopRequested = 0;

void restoreDefaults() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

void onSignal(int) {
  stopRequested = 1;
  restoreDefaults();
}

}  // namespace

StopOnSignal::StopOnSignal() {
  stopRequested = 0;
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

StopOnSignal::~StopOnSignal() { restoreDefaults(); }

bool StopOnSignal::requested() const { return stopRequested != 0; }

}  // namespace ropelight
