#include "render/film/plane.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cassert>

namespace ropelight {
namespace {

void addScaled(double* sum, const double* values, double weight, int count) {
  for (int i = 0; i < count; ++i) sum[i] += weight * values[i];
}

Plane filterRows(const Plane& in, const Kernel& kernel) {
  const int radius = int(kernel.size() / 2);
  Plane out(in.width, in.height);
  oneapi::tbb::parallel_for(0, in.height, [&](int y) {
    const double* row = in.row(y);
    std::vector<double> padded(std::size_t(in.width) + kernel.size() - 1);
    for (int i = 0; i < int(padded.size()); ++i) padded[std::size_t(i)] = row[std::clamp(i - radius, 0, in.width - 1)];
    for (std::size_t k = 0; k < kernel.size(); ++k) addScaled(out.row(y), padded.data() + k, kernel[k], in.width);
  });
  return out;
}

Plane filterColumns(const Plane& in, const Kernel& kernel) {
  const int radius = int(kernel.size() / 2);
  Plane out(in.width, in.height);
  oneapi::tbb::parallel_for(0, in.height, [&](int y) {
    for (int k = 0; k < int(kernel.size()); ++k)
      addScaled(out.row(y), in.row(std::clamp(y + k - radius, 0, in.height - 1)), kernel[std::size_t(k)], in.width);
  });
  return out;
}

}  // namespace

Plane filterPlane(const Plane& in, const Kernel& alongX, const Kernel& alongY) {
  assert(alongX.size() % 2 == 1 && alongY.size() % 2 == 1);
  if (in.values.empty()) return in;
  return filterColumns(filterRows(in, alongX), alongY);
}

}  // namespace ropelight
