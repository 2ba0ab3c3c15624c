#include "app/viewer/gl/frame_timer.h"

#include <algorithm>
#include <vector>

namespace ropelight::view {

void releaseQuery(GLuint name) {
  if (name) glDeleteQueries(1, &name);
}

void LatestMedian::add(double value) {
  values_.push_back(value);
  if (values_.size() > 120) values_.pop_front();
}

double LatestMedian::median() const {
  if (values_.empty()) return 0;
  std::vector<double> sorted(values_.begin(), values_.end());
  auto const middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

GpuTimer::GpuTimer() {
  for (Query& query : queries_) {
    GLuint name = 0;
    glGenQueries(1, &name);
    query.name = GlName<releaseQuery>(name);
  }
}

void GpuTimer::begin() {
  collect();
  running_ = !queries_[next_].pending;
  if (running_) glBeginQuery(GL_TIME_ELAPSED, queries_[next_].name.name());
}

void GpuTimer::end() {
  if (!running_) return;
  glEndQuery(GL_TIME_ELAPSED);
  running_ = false;
  queries_[next_].pending = true;
  next_ = (next_ + 1) % queries_.size();
}

void GpuTimer::collect() {
  for (Query& query : queries_) {
    if (!query.pending) continue;
    GLuint ready = GL_FALSE;
    glGetQueryObjectuiv(query.name.name(), GL_QUERY_RESULT_AVAILABLE, &ready);
    if (!ready) continue;
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query.name.name(), GL_QUERY_RESULT, &nanoseconds);
    query.pending = false;
    times_.add(double(nanoseconds) * 1e-6);
  }
}

void CpuTimer::endFrame() {
  times_.add(frame_);
  frame_ = 0;
}

}  // namespace ropelight::view
