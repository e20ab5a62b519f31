// Manipulator handles: where they are, which one is under the cursor, and what dragging it does.
//
// Who draws them asks for lines, who clicks asks for a hit, and dragging answers with a command, so that it
// is undone and echoed like any edit.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/graph/commands/session.h"
#include "host/sdk/abi.h"

namespace plinian::sdk {

enum class HandleKind { point, direction, distance, cone };

/// As a node type declares it; fields as in PlinianHandle, empty where that has null.
struct HandleSpec {
  std::string name;
  HandleKind kind = HandleKind::point;
  std::string attribute, origin, along;
  vec3 axis{0.0f, 0.0f, 1.0f};
  std::string length, transform;
  vec3 colour{1.0f};
};

/// Throws GraphError, naming the handle, where an attribute is missing or of another type than the handle
/// needs.
HandleSpec handle_from(const PlinianHandle& plain, const std::vector<graph::AttributeSpec>& attributes);

/// The picture in which handles are seen.
struct HandleView {
  dmat4 clip_from_world{1.0};
  ivec4 viewport{0, 0, 1, 1};  // [pixels] x, y (of the lower edge), width, height

  /// Pixel and depth [-1, 1] of a point; none behind the camera.
  std::optional<dvec3> pixel(const dvec3& world) const;
  /// The point of that pixel and depth.
  dvec3 world(const dvec3& pixel_and_depth) const;
};

/// A handle of one node, as its attributes say at the moment.
struct PlacedHandle {
  HandleSpec spec;
  graph::Plug plug;     // that it sets
  bool is_free = true;  // not driven nor locked, so that it can be dragged
  dmat4 world_from_handle{1.0};
  dvec3 origin{0.0}, tip{0.0}, axis{0.0, 0.0, 1.0};  // [handle] axis: unit
  double value = 0.0;                                // distance, or the angle of a cone [degrees]
};

/// The handles of a node. Where an input that they need has failed, there is none.
std::vector<PlacedHandle> place_handles(graph::Session& session, graph::NodeId node,
                                        std::span<const HandleSpec> specs, const dmat4& world_from_object);

/// A line on the screen. [pixels]
struct ScreenLine {
  dvec2 begin{0.0}, end{0.0};
};
/// What to draw of a handle: a cross for a point, a line to the tip, a circle for a cone.
std::vector<ScreenLine> handle_lines(const PlacedHandle& handle, const HandleView& view);

/// The handle that is nearest to a pixel, not further than `reach` [pixels]: its index. Of several as near
/// the one in front.
std::optional<std::size_t> hit_handle(std::span<const PlacedHandle> handles, const HandleView& view,
                                      const dvec2& pixel, double reach = 6.0);

/// The command that drags a handle, as it was when the mouse was pressed at `from`, to the pixel `to`; empty
/// where it cannot be dragged. Run it with a merge key, and the drag is one step of undo.
std::string drag_command(const graph::Graph& graph, const PlacedHandle& handle, const HandleView& view,
                         const dvec2& from, const dvec2& to);

}  // namespace plinian::sdk
