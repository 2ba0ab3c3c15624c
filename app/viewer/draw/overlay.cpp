#include "app/viewer/draw/overlay.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <vector>

#include "accel/kdtree/cells.h"

namespace ropelight::view {
namespace {

struct LineVertex {
  float position[3];
  float depth;
};

constexpr std::size_t cellVertices = 24;

/// The twelve edges of a box as pairs of corners. Bit a of a corner: it is at the upper end of axis a.
std::array<int, cellVertices> boxEdges() {
  std::array<int, cellVertices> edges{};
  std::size_t next = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int corner = 0; corner < 8; ++corner) {
      if (corner & 1 << axis) continue;
      edges[next++] = corner;
      edges[next++] = corner | 1 << axis;
    }
  return edges;
}

std::vector<LineVertex> cellEdges(const std::vector<KdCell>& cells) {
  static const auto edges = boxEdges();
  std::vector<LineVertex> vertices;
  vertices.reserve(cells.size() * cellVertices);
  for (const KdCell& cell : cells)
    for (int corner : edges) {
      const float* b = cell.bounds;
      vertices.push_back({{b[corner & 1 ? 3 : 0], b[corner & 2 ? 4 : 1], b[corner & 4 ? 5 : 2]}, float(cell.depth)});
    }
  return vertices;
}

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

std::array<float, 3> rounded(Vec3d v) { return {float(v.x), float(v.y), float(v.z)}; }

void setCamera(GlProgram& program, const OverlayCamera& camera) {
  program.set("cameraHigh", camera.positionHigh);
  program.set("cameraLow", camera.positionLow);
  program.set("cameraRight", camera.right);
  program.set("cameraUp", camera.up);
  program.set("cameraForward", camera.forward);
  program.set("near", camera.near);
}

}  // namespace

OverlayCamera overlayCamera(const CameraDesc& c, int width, int height) {
  Vec3d const forward = glm::normalize(c.target - c.position);
  Vec3d const right = glm::normalize(glm::cross(forward, c.up));
  Vec3d const up = glm::cross(right, forward);
  double const tangent = std::tan(glm::radians(c.verticalFov) / 2);
  OverlayCamera camera;
  camera.positionHigh = rounded(c.position);
  Vec3d const high(camera.positionHigh[0], camera.positionHigh[1], camera.positionHigh[2]);
  camera.positionLow = rounded(c.position - high);
  camera.right = rounded(right / (tangent * width / height));
  camera.up = rounded(up / tangent);
  camera.forward = rounded(forward);
  camera.near = float(1e-5 * glm::length(c.target - c.position));
  return camera;
}

Overlay::Overlay() : pointProgram_("points"), lineProgram_("lines") {}

void Overlay::update(PixelSource& source, Picture& picture, const EstimateStatus& status, const ViewState& state) {
  if (state.photons.shown && status.photonCount > 0 && state.photons.most > 0) {
    updatePoints(source, picture, status, std::uint32_t(state.photons.most));
  } else {
    points_.reset();
    pointCount_ = 0;
  }
  if (state.tree.shown && status.tree) {
    updateCells(status, state.tree);
  } else {
    lines_.reset();
    tree_.reset();
    cellCount_ = 0;
  }
}

void Overlay::updatePoints(PixelSource& source, Picture& picture, const EstimateStatus& status, std::uint32_t most) {
  // Their number changes with every iteration; the buffer, and what CUDA knows of it, should not.
  std::uint32_t const capacity = std::min(most, std::bit_ceil(std::min(status.photonCount, 1u << 30)));
  std::size_t const bytes = std::size_t(capacity) * sizeof(PhotonPoint);
  if (points_ && status.photonVersion == photonVersion_ && points_->size() >= bytes) return;
  if (!points_) points_.emplace();
  std::uint32_t count = 0;
  Filled const filled = picture.fill(*points_, bytes, [&](void* to) {
    count = source.copyPhotons(estimateA, static_cast<PhotonPoint*>(to), capacity);
    return count > 0;
  });
  pointCount_ = filled == Filled::done ? count : 0;
  if (pointCount_ == 0) return;
  photonVersion_ = status.photonVersion;
  meanFlux_ = meanFlux();
}

/// From the first of them: which are brighter than most does not change from photon to photon.
float Overlay::meanFlux() const {
  std::vector<PhotonPoint> sample(std::min(pointCount_, 1024u));
  glBindBuffer(GL_COPY_READ_BUFFER, points_->name());
  glGetBufferSubData(GL_COPY_READ_BUFFER, 0, GLsizeiptr(sample.size() * sizeof(PhotonPoint)), sample.data());
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  double sum = 0;
  int count = 0;
  for (const PhotonPoint& photon : sample) {
    float const largest = std::max({photon.flux[0], photon.flux[1], photon.flux[2]});
    if (!std::isfinite(largest) || largest <= 0) continue;
    sum += double(largest);
    ++count;
  }
  return count > 0 ? std::max(float(sum / count), 1e-37f) : 1.0f;
}

void Overlay::updateCells(const EstimateStatus& status, const TreeOverlay& tree) {
  if (lines_ && tree_ == status.tree && cellsOf_.depth == tree.depth && cellsOf_.onlyDeepest == tree.onlyDeepest)
    return;
  tree_ = status.tree;
  cellsOf_ = tree;
  std::vector<LineVertex> const vertices = cellEdges(cellLines(*tree_, tree.depth, tree.onlyDeepest));
  lines_.emplace();
  std::size_t const bytes = vertices.size() * sizeof(LineVertex);
  cellCount_ = lines_->resize(bytes, GL_STATIC_DRAW) ? vertices.size() / cellVertices : 0;
  if (cellCount_ == 0) return;
  glBindBuffer(GL_COPY_WRITE_BUFFER, lines_->name());
  glBufferSubData(GL_COPY_WRITE_BUFFER, 0, GLsizeiptr(bytes), vertices.data());
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

void Overlay::draw(const Picture& picture, const CameraDesc& desc, const ViewState& state, int framebufferHeight,
                   float scale) {
  Rect const whole = picture.pictureRect(0), visible = picture.visibleRect(0);
  if (visible.empty() || (pointCount_ == 0 && cellCount_ == 0)) return;
  OverlayCamera const camera = overlayCamera(desc, picture.width(estimateA), picture.height(estimateA));
  glViewport(whole.x, whole.bottom(framebufferHeight), whole.width, whole.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(visible.x, visible.bottom(framebufferHeight), visible.width, visible.height);
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(vertices_.name());
  if (cellCount_ > 0) drawCells(camera, state.tree);
  if (pointCount_ > 0) drawPoints(camera, state.photons, scale);
  glBindVertexArray(0);
  glDisable(GL_SCISSOR_TEST);
}

void Overlay::drawPoints(const OverlayCamera& camera, const PhotonOverlay& photons, float scale) {
  pointProgram_.use();
  setCamera(pointProgram_, camera);
  pointProgram_.set("pointSize", std::max(photons.size * scale, 1.0f));
  pointProgram_.set("fluxScale", std::exp2(photons.brightness) / meanFlux_);
  pointProgram_.set("fewestBounces", photons.fewestBounces);
  pointProgram_.set("mostBounces", photons.mostBounces);
  pointProgram_.set("showGlobal", int(photons.global));
  pointProgram_.set("showCaustic", int(photons.caustic));
  constexpr GLsizei stride = sizeof(PhotonPoint);
  glBindBuffer(GL_ARRAY_BUFFER, points_->name());
  for (GLuint i = 0; i < 4; ++i) glEnableVertexAttribArray(i);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(PhotonPoint, position)));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(PhotonPoint, flux)));
  glVertexAttribIPointer(2, 1, GL_UNSIGNED_INT, stride, offset(offsetof(PhotonPoint, bounce)));
  glVertexAttribIPointer(3, 1, GL_UNSIGNED_INT, stride, offset(offsetof(PhotonPoint, caustic)));
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArrays(GL_POINTS, 0, GLsizei(std::min(pointCount_, std::uint32_t(std::max(photons.most, 0)))));
  glDisable(GL_PROGRAM_POINT_SIZE);
  for (GLuint i = 0; i < 4; ++i) glDisableVertexAttribArray(i);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void Overlay::drawCells(const OverlayCamera& camera, const TreeOverlay& tree) {
  lineProgram_.use();
  setCamera(lineProgram_, camera);
  lineProgram_.set("deepest", float(std::max(tree.depth, 1)));
  glBindBuffer(GL_ARRAY_BUFFER, lines_->name());
  for (GLuint i = 0; i < 2; ++i) glEnableVertexAttribArray(i);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(LineVertex), offset(offsetof(LineVertex, position)));
  glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, sizeof(LineVertex), offset(offsetof(LineVertex, depth)));
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDrawArrays(GL_LINES, 0, GLsizei(cellCount_ * cellVertices));
  glDisable(GL_BLEND);
  for (GLuint i = 0; i < 2; ++i) glDisableVertexAttribArray(i);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

}  // namespace ropelight::view
