#include "app/view.h"

#include "app/view/viewer.h"

namespace ropelight {

int runView(const ViewOptions& options) { return view::Viewer(options).run(); }

}  // namespace ropelight
