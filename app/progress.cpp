#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace ropelight {
namespace {

constexpr int barWidth = 30;
constexpr double barInterval = 0.1;  // seconds
constexpr double lineInterval = 5;   // seconds
constexpr double firstLine = 1;      // seconds; a shorter run needs none

}  // namespace

std::string formatDuration(double seconds) {
  if (!(seconds < 1e9)) return "-:--";
  auto const whole = static_cast<long>(seconds + 0.5);
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

Progress::Progress(const Goal& goal, bool quiet)
    : goal_(goal),
      style_(quiet                   ? Style::none
             : isatty(STDERR_FILENO) ? Style::bar
                                     : Style::lines) {
  nextShown_ = style_ == Style::bar ? 0 : firstLine;
}

Progress::~Progress() {
  if (barOpen_) std::fputs("\r\x1b[K", stderr);
}

void Progress::update(std::uint64_t iterations, double seconds) {
  if (style_ == Style::none || seconds < nextShown_) return;
  nextShown_ = seconds + (style_ == Style::bar ? barInterval : lineInterval);
  show(iterations, seconds);
}

void Progress::show(std::uint64_t iterations, double seconds) {
  double const rate = seconds > 0 ? double(iterations) / seconds : 0;
  double share = 0;
  if (goal_.iterations > 0) share = double(iterations) / double(goal_.iterations);
  if (goal_.seconds > 0) share = std::max(share, seconds / goal_.seconds);
  share = std::min(share, 1.0);
  std::string const left = share > 0 ? formatDuration(seconds * (1 - share) / share) : "-:--";
  std::string const count =
      goal_.iterations > 0 ? fmt::format("{}/{}", iterations, goal_.iterations) : fmt::format("{}", iterations);
  std::string const text = fmt::format("{:3.0f}%  {} iterations  {:.3g} it/s  {} left", 100 * share, count, rate, left);
  if (style_ == Style::lines) {
    fmt::print(stderr, "{}\n", text);
    return;
  }
  int const filled = int(share * barWidth);
  fmt::print(stderr, "\r[{:#>{}}{:->{}}] {}\x1b[K", "", filled, "", barWidth - filled, text);
  std::fflush(stderr);
  barOpen_ = true;
}

}  // namespace ropelight
