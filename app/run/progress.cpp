#include "app/run/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "app/run/standard_streams.h"

namespace ropelight {
namespace {

constexpr int barWidth = 30;
constexpr double barInterval = 0.1;  // seconds
constexpr double lineInterval = 5;   // seconds
constexpr double firstLine = 1;      // seconds; a shorter run needs none

ProgressStyle styleFor(bool quiet) {
  if (quiet) return ProgressStyle::none;
  return isatty(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::lines;
}

double intervalOf(ProgressStyle style) { return style == ProgressStyle::bar ? barInterval : lineInterval; }

void clearBar() { std::fputs("\r\x1b[K", stderr); }

/// A line, or a bar over the one before.
void show(ProgressStyle style, double share, const std::string& text) {
  if (style == ProgressStyle::lines) return printError(text);
  int const filled = int(share * barWidth);
  std::fputs(fmt::format("\r[{:#>{}}{:->{}}] {}\x1b[K", "", filled, "", barWidth - filled, text).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

std::string formatDuration(double seconds) {
  if (!(seconds < 1e9)) return "-:--";
  auto const whole = static_cast<long>(seconds + 0.5);
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

Progress::Progress(const Goal& goal, bool quiet)
    : goal_(goal), style_(styleFor(quiet)), nextShown_(style_ == ProgressStyle::bar ? 0 : firstLine) {}

Progress::~Progress() {
  if (barOpen_) clearBar();
}

void Progress::update(std::uint64_t iterations, double seconds) {
  if (style_ == ProgressStyle::none || seconds < nextShown_) return;
  nextShown_ = seconds + intervalOf(style_);
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
  ropelight::show(style_, share,
                  fmt::format("{:3.0f}%  {} iterations  {:.3g} it/s  {} left", 100 * share, count, rate, left));
  barOpen_ = style_ == ProgressStyle::bar;
}

ShareProgress::ShareProgress(std::string what, bool quiet) : what_(std::move(what)), style_(styleFor(quiet)) {}

ShareProgress::~ShareProgress() {
  if (barOpen_) clearBar();
}

void ShareProgress::update(double share) {
  double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  if (style_ == ProgressStyle::none || seconds < nextShown_) return;
  nextShown_ = seconds + intervalOf(style_);
  show(style_, share,
       fmt::format("{:3.0f}%  {}  {} left", 100 * share, what_,
                   share > 0 ? formatDuration(seconds * (1 - share) / share) : "-:--"));
  barOpen_ = style_ == ProgressStyle::bar;
}

}  // namespace ropelight
