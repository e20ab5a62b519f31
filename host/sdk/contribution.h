// What a shape adds to the picture, on the host's side: the value of its output `contribution`.
//
// Everything is in the object space of the shape; who assembles a picture applies the world matrix.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/lights/light.h"
#include "core/media/medium.h"
#include "core/scene/camera.h"
#include "host/graph/types/node_type.h"

namespace plinian::sdk {

struct ContributedCamera {
  std::string name;  // behind the node's own; may be empty
  Camera camera;     // world_from_camera is object_from_camera
};

struct ContributedBounds {
  dvec3 minimum{0.0}, maximum{0.0};  // [object]
};

struct ShapeContribution {
  std::vector<Medium> media;  // names go behind the node's own; world_from_medium is object_from_medium
  std::vector<Light> lights;  // likewise; position and toward (unit) are of object space
  vec3 ambient{0.0f};         // [radiance] of all ambient lights
  std::vector<ContributedCamera> cameras;
  std::optional<ContributedBounds> bounds;  // beside those of the media
};
using ShapeContributionPtr = std::shared_ptr<const ShapeContribution>;

inline constexpr const char* contribution_type = "plinian.contribution";
inline constexpr const char* contribution_output = "contribution";

/// The rotation and translation in a matrix that may scale and shear as well: the way it looks (z) stays, and
/// up (y) as far as it can. A mirrored one stays so. matrix: one that could be taken back.
dmat4 rigid_part(const dmat4& matrix);

/// The output of a type that contributes to the picture, or no_attribute where it is no shape.
graph::AttributeIndex contribution_of(const graph::NodeType& type);
/// What the value of that output holds, or null.
ShapeContributionPtr contribution_in(const graph::Value& value);

}  // namespace plinian::sdk
