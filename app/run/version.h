#pragma once

namespace ropelight {

/// The project's version and the commit it was built from: "0.1.0+1a2b3c4", with "-dirty" after local changes, or
/// "0.1.0" where it was built outside a git checkout.
extern const char* const version;

}  // namespace ropelight
