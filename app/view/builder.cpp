#include "app/view/builder.h"

#include <exception>
#include <new>

#include "app/view/background.h"

namespace ropelight::view {
namespace {

Built build(Order order) {
  giveWay();
  Built built;
  built.order = std::move(order);
  Order& o = built.order;
  try {
    if (!o.cache) o.cache = makeSceneCache(*o.scene);
    for (const Order::Item& item : o.items) {
      Scene scene = *o.scene;
      scene.camera = item.target.camera;
      built.integrators.push_back(makeIntegrator(scene, item.target.settings, o.backend, &built.backendText, o.cache));
      built.integrators.back()->timeStages(o.stageTimes);
    }
  } catch (const std::bad_alloc&) {
    built.problem = "out of memory; use a smaller film or fewer photons";
  } catch (const std::exception& error) {
    built.problem = error.what();
  }
  if (!built.problem.empty()) built.integrators.clear();
  return built;
}

}  // namespace

Builder::~Builder() {
  if (built_.valid()) built_.wait();
}

void Builder::start(Order order) { built_ = std::async(std::launch::async, build, std::move(order)); }

std::optional<Built> Builder::take() {
  if (!built_.valid() || built_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
  return built_.get();
}

}  // namespace ropelight::view
