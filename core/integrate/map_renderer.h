// The CPU renderer that reads light from transmittance maps: the GL renderer's twin, from the same shared
// maths.
#pragma once

#include <memory>

#include "core/scene/renderer.h"

namespace plinian {

/// Multi-threaded; the picture does not depend on the number of threads. Maps and their reasons for being
/// rebuilt are those of the GL renderer.
std::unique_ptr<Renderer> make_map_renderer();

}  // namespace plinian
