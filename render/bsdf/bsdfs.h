#pragma once
// The list of BSDFs. A new kind is its own file, NAME with NAMEParams, and one word here.

#include <variant>

#include "render/bsdf/dielectric.h"
#include "render/bsdf/diffuse.h"
#include "render/bsdf/mirror.h"
#include "render/core/list.h"

#ifndef RL_TEST_BSDFS
#define RL_TEST_BSDFS  // what a test adds to the list
#endif

#define RL_BSDFS(X) X(Diffuse) X(Mirror) X(Dielectric)

#define RL_BSDF(name) , RL_TARGET::name
#define RL_BSDF_PARAMS(name) , name##Params

namespace ropelight {

/// A material as the scene holds it; the alternative's index is its kind on every backend.
using MaterialDesc = FromWords<std::variant, void RL_BSDFS(RL_BSDF_PARAMS)>;

}  // namespace ropelight

namespace ropelight::RL_TARGET {

using Bsdfs = FromWords<List, void RL_BSDFS(RL_BSDF) RL_TEST_BSDFS>;

}  // namespace ropelight::RL_TARGET

#undef RL_BSDF
#undef RL_BSDF_PARAMS
