#pragma once
// The path that works everywhere: the buffer mapped into the program's memory.

#include "app/viewer/draw/pixel_path.h"

namespace ropelight::view {

class CopyPath final : public PixelPath {
 public:
  /// `why` it was taken, for describe().
  explicit CopyPath(std::string why) : why_(std::move(why)) {}

  Filled fill(GlBuffer& buffer, std::size_t bytes, const std::function<bool(void*)>& write) override;
  std::string describe() const override { return "copy: " + why_; }
  const std::string& problem() const override { return problem_; }

 private:
  std::string why_, problem_;
};

}  // namespace ropelight::view
