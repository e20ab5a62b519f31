// Where in the sky a light stands: the angles that whoever lights a scene thinks in, and the rotation of its
// node that makes them.
#pragma once

#include <optional>
#include <string>

#include "core/scene/framing.h"
#include "core/scene/placement.h"

namespace plinian::window {

/// Whether lights of that type shine one way, so that they can be turned.
bool has_direction(const std::string& node_type);

/// Where a light comes from, in the world, that is placed so under a parent. None where the parent is
/// squeezed to nothing. Straight above and below, the azimuth is the one that it was turned by.
std::optional<SkyAngles> sky_angles(const Placement& placement, const dmat4& world_from_parent);

/// The rotation [degrees about x, y, z] that puts the light there: without a roll about its own direction,
/// and turned about y as often as it was. Rounded to 1e-4 degrees; what changes by less stays. Only under a
/// parent that is not squeezed.
dvec3 rotation_toward(const SkyAngles& angles, const Placement& placement, const dmat4& world_from_parent);

/// The command that turns a node so.
std::string rotate_line(const std::string& node, const dvec3& rotation);

/// The same where it is known how the node stood: none where nothing changes, and where one number does, of
/// that alone.
std::optional<std::string> rotate_line(const std::string& node, const dvec3& before, const dvec3& after);

}  // namespace plinian::window
