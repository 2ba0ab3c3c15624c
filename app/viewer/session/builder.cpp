#include "app/viewer/session/builder.h"

#include <exception>
#include <new>

#include "app/viewer/session/background.h"

namespace ropelight::view {
namespace {

/// What `make` throws, in words; empty: nothing.
template <class Make>
std::string problemOf(Make&& make) {
  try {
    make();
    return {};
  } catch (const std::bad_alloc&) {
    return "out of memory; use a smaller film or fewer photons";
  } catch (const std::exception& error) {
    return error.what();
  }
}

Built build(Order order) {
  giveWay();
  Built built;
  built.order = std::move(order);
  Order& o = built.order;
  built.problem = problemOf([&] {
    if (!o.cache) o.cache = makeSceneCache(*o.scene);
  });
  for (const Order::Item& item : o.items) {
    std::unique_ptr<Integrator> made;
    std::string const problem = !built.problem.empty() ? built.problem : problemOf([&] {
      Scene scene = *o.scene;
      scene.camera = item.target.camera;
      made = makeIntegrator(scene, item.target.settings, o.backend, &built.backendText, o.cache);
      made->timeStages(o.stageTimes);
    });
    built.integrators.push_back(std::move(made));
    built.problems.push_back(problem);
  }
  if (!built.problems.empty()) built.problem = built.problems[0];
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
