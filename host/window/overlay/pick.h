// Which medium a line of sight meets first.
#pragma once

#include <optional>
#include <string>

#include "core/scene/snapshot.h"

namespace plinian::window {

/// Whether a ray meets an axis-parallel box, and where: in lengths of its direction, >= 0 (0 from inside).
std::optional<double> box_ahead(const dvec3& origin, const dvec3& direction, const dvec3& minimum,
                                const dvec3& maximum);

/// The index of the medium whose box [world] is met first; none where none is. Biased: a box is larger than
/// what is seen of the medium in it.
std::optional<std::size_t> medium_ahead(const SceneSnapshot& scene, const dvec3& origin,
                                        const dvec3& direction);

}  // namespace plinian::window
