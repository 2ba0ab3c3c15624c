#include "app/viewer/view.h"

#include "app/viewer/viewer.h"

namespace ropelight {

int runView(const ViewOptions& options) { return view::Viewer(options).run(); }

}  // namespace ropelight
