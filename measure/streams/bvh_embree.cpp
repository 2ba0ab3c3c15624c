#include "measure/streams/bvh_embree.h"

#include "render/core/error.h"

#if defined(ROPELIGHT_EMBREE) && ROPELIGHT_EMBREE

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <chrono>

namespace ropelight {
namespace {

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using DeviceHandle = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release>;
using SceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;

void fillGeometry(RTCGeometry geometry, const std::vector<FlatTriangle>& triangles) {
  std::size_t const n = triangles.size();
  auto* const vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * n));
  auto* const indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), n));
  if (!vertices || !indices) throw std::bad_alloc();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t k = 9 * i;
    for (Vec3d p : {triangles[i].a, triangles[i].b, triangles[i].c})
      for (int a = 0; a < 3; ++a) vertices[k++] = float(p[a]);
    for (std::size_t v = 3 * i; v < 3 * i + 3; ++v) indices[v] = std::uint32_t(v);
  }
}

RTCRay toEmbree(const EmbreeRay& r) {
  RTCRay out{};
  out.org_x = r.origin[0];
  out.org_y = r.origin[1];
  out.org_z = r.origin[2];
  out.dir_x = r.direction[0];
  out.dir_y = r.direction[1];
  out.dir_z = r.direction[2];
  out.tfar = r.tMax;
  out.mask = 0xFFFFFFFFu;
  return out;
}

}  // namespace

struct EmbreeScene::Impl {
  DeviceHandle device;
  SceneHandle scene;
  double seconds = 0;
  std::uint32_t first = 0;  ///< number of the first triangle

  void check() const {
    RTCError const error = rtcGetDeviceError(device.get());
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    if (error != RTC_ERROR_NONE)
      throw Error(fmt::format("Embree failed with error {}", int(error)), ExitCode::internal);
  }
};

bool EmbreeScene::supported() { return true; }

double EmbreeScene::buildSeconds() const { return impl_->seconds; }

EmbreeScene::EmbreeScene(const FlatScene& flat, bool robust, int threads) : impl_(std::make_unique<Impl>()) {
  impl_->device.reset(rtcNewDevice(threads > 0 ? fmt::format("threads={}", threads).c_str() : nullptr));
  if (!impl_->device) throw Error("Embree has no device", ExitCode::internal);
  impl_->scene.reset(rtcNewScene(impl_->device.get()));
  impl_->first = std::uint32_t(flat.quads.size() + flat.spheres.size());
  RTCGeometry const geometry = rtcNewGeometry(impl_->device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  if (!flat.triangles.empty()) fillGeometry(geometry, flat.triangles);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(impl_->scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  if (robust) rtcSetSceneFlags(impl_->scene.get(), RTC_SCENE_FLAG_ROBUST);
  auto const start = std::chrono::steady_clock::now();
  rtcCommitScene(impl_->scene.get());
  impl_->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  impl_->check();
}

EmbreeHit EmbreeScene::closest(const EmbreeRay& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray = toEmbree(ray);
  query.hit.geomID = query.hit.primID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(impl_->scene.get(), &context, &query);
  bool const found = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  return {query.ray.tfar, found ? impl_->first + query.hit.primID : 0xFFFFFFFFu};
}

bool EmbreeScene::occluded(const EmbreeRay& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay query = toEmbree(ray);
  rtcOccluded1(impl_->scene.get(), &context, &query);
  return query.tfar < 0;
}

#else

namespace ropelight {

struct EmbreeScene::Impl {};

bool EmbreeScene::supported() { return false; }

double EmbreeScene::buildSeconds() const { return 0; }

EmbreeScene::EmbreeScene(const FlatScene&, bool, int) {
  throw Error("this program was built without Embree: install libembree-dev and build again", ExitCode::usage);
}

EmbreeHit EmbreeScene::closest(const EmbreeRay& ray) const { return {ray.tMax, 0xFFFFFFFFu}; }

bool EmbreeScene::occluded(const EmbreeRay&) const { return false; }

#endif

EmbreeScene::~EmbreeScene() = default;

}  // namespace ropelight
