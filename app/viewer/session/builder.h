#pragma once
// Makes integrators on a thread of its own, one order after the other, while the present ones continue.

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/session/estimate.h"

namespace ropelight::view {

/// A new scene, or other integrators for the one there is.
struct Order {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<SceneCache> cache;  ///< null: a new scene
  BackendChoice backend;
  bool stageTimes = false;
  struct Item {
    int which = 0;
    Target target;
  };
  std::vector<Item> items;
};

struct Built {
  Order order;                                           ///< its cache made
  std::vector<std::unique_ptr<Integrator>> integrators;  ///< one an item; null where it failed
  std::vector<std::string> problems;                     ///< one an item
  std::string problem;                                   ///< of the scene itself, or of the first item
  std::string backendText;
};

class Builder {
 public:
  ~Builder();
  bool busy() const { return built_.valid(); }
  /// Must not be busy.
  void start(Order order);
  /// The result, once, when it is done.
  std::optional<Built> take();

 private:
  std::future<Built> built_;
};

}  // namespace ropelight::view
