#include "app/run/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace ropelight {
namespace {

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t stopRequested = 0;

/// A terminal that closes sends SIGHUP twice, once itself and once through the shell, so another one changes nothing.
void onSignal(int) {
  stopRequested = 1;
  for (int signal : {SIGINT, SIGTERM})
    if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

StopOnSignal::StopOnSignal() {
  stopRequested = 0;
  for (int signal : signals)
    if (std::signal(signal, onSignal) == SIG_IGN) std::signal(signal, SIG_IGN);  // nohup, or a job in the background
}

StopOnSignal::~StopOnSignal() {
  for (int signal : signals)
    if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
}

bool StopOnSignal::requested() const { return stopRequested != 0; }

}  // namespace ropelight
