// Which medium a line of sight meets first.
#pragma once

#include <optional>
#include <string>

#include "core/scene/frame.h"
#include "core/scene/snapshot.h"

namespace plinian::window {

/// Whether a ray meets an axis-parallel box, and where: in lengths of its direction, >= 0 (0 from inside).
std::optional<double> box_ahead(const dvec3& origin, const dvec3& direction, const dvec3& minimum,
                                const dvec3& maximum);

/// The index of the medium whose box [world] is met first; none where none is.
std::optional<std::size_t> medium_ahead(const SceneSnapshot& scene, const dvec3& origin,
                                        const dvec3& direction);

/// The medium that a picture shows at a place: none where it shows none there or right beside it; where the
/// picture tells how far away it is, the one that is there, else the one whose box is met first. at: [-] of
/// the picture, from its upper left.
std::optional<std::size_t> medium_seen(const SceneSnapshot& scene, const Frame& frame, vec2 at,
                                       const dvec3& origin, const dvec3& direction);

}  // namespace plinian::window
