#include "app/bench/results/timing.h"

namespace ropelight {
namespace {

double runAll(std::span<Contender> contenders, bool timed) {
  double sum = 0;
  for (Contender& c : contenders) {
    double const seconds = c.run();
    if (timed) c.seconds.push_back(seconds);
    sum += seconds;
  }
  return sum;
}

}  // namespace

void timeInTurn(std::span<Contender> contenders, int warmUp, int repeat, double limit) {
  double total = 0, round = 0;
  for (int i = 0; i < warmUp && total + round <= limit / 4; ++i) total += round = runAll(contenders, false);
  for (int i = 0; i < repeat && (i == 0 || total + round <= limit); ++i) total += round = runAll(contenders, true);
}

}  // namespace ropelight
