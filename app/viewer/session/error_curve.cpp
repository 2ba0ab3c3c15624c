#include "app/viewer/session/error_curve.h"

#include <limits>

#include "app/plot/plot_math.h"
#include "render/film/metrics.h"

namespace ropelight::view {
namespace {

constexpr std::size_t budget = std::size_t(256) << 20;

}  // namespace

void ErrorCurve::clear() {
  entries_.clear();
  schedule_.restart();
}

void ErrorCurve::add(double seconds, double iterations, Image picture) {
  schedule_.taken(seconds);
  entries_.push_back({{seconds, iterations, 0}, std::move(picture), 0});
  thin();
}

void ErrorCurve::thin() {
  std::size_t const each = entries_.back().picture.pixels.size() * sizeof(Rgb);
  std::size_t const most = std::max<std::size_t>(budget / std::max<std::size_t>(each, 1), 8);
  if (entries_.size() <= most) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (i % 2 == 1 || i >= entries_.size() / 2) std::swap(entries_[kept++], entries_[i]);
  entries_.resize(kept);
}

void ErrorCurve::measure(const Image& truth, std::uint64_t version) {
  version_ = version;
  for (Entry& e : entries_) {
    if (e.measured == version || e.picture.width != truth.width || e.picture.height != truth.height) continue;
    e.point.relMse = compareImages(e.picture, truth).relMse;
    e.measured = version;
  }
}

std::vector<ErrorPoint> ErrorCurve::points() const {
  std::vector<ErrorPoint> points;
  for (const Entry& e : entries_)
    if (e.measured && e.measured == version_) points.push_back(e.point);
  return points;
}

double ErrorCurve::slope() const {
  std::vector<PlotPoint> logs;
  for (const ErrorPoint& p : points()) logs.push_back({p.seconds, p.relMse});
  auto const law = fitLastDecade(logs);
  return law ? law->exponent : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace ropelight::view
