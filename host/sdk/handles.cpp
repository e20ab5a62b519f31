#include "host/sdk/handles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"
#include "host/sdk/plain_text.h"

namespace plinian::sdk {

using graph::AttributeType;
using graph::GraphError;

namespace {

constexpr int circle_segments = 48;
constexpr double point_size = 6.0;  // [pixels] from the middle of a point's cross to its ends

bool is_vector(AttributeType type) {
  return type == AttributeType::float3;
}

dvec3 transformed(const dmat4& matrix, const dvec3& point) {
  return dvec3(matrix * dvec4(point, 1.0));
}

// Two directions that stand upright on an axis and on each other.
std::pair<dvec3, dvec3> across(const dvec3& axis) {
  const dvec3 u = normalize(cross(axis, std::abs(axis.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
  return {u, cross(axis, u)};
}

// Reads attributes of a node by name; throws GraphError where one has failed.
class Reader {
 public:
  Reader(graph::Session& session, graph::NodeId node) : session_(session), node_(node) {}

  graph::Value value(const std::string& name) {
    const graph::Plug plug = graph::Graph::plug(*session_.graph().find(node_), name);
    const graph::ResultPtr result = session_.evaluator().evaluate({node_, plug.attribute});
    if (result->error) throw GraphError(result->error->message);
    return result->value;
  }
  dvec3 vector(const std::string& name, const dvec3& otherwise) {
    return name.empty() ? otherwise : dvec3(std::get<vec3>(value(name)));
  }
  double number(const std::string& name, double otherwise) {
    return name.empty() ? otherwise : graph::number_of(value(name));
  }

 private:
  graph::Session& session_;
  graph::NodeId node_;
};

double distance_to(const ScreenLine& line, const dvec2& pixel) {
  const dvec2 along = line.end - line.begin, to = pixel - line.begin;
  const double length2 = dot(along, along);
  const double t = length2 > 0.0 ? std::clamp(dot(to, along) / length2, 0.0, 1.0) : 0.0;
  return length(to - t * along);
}

struct Ray {
  dvec3 origin, direction;
};

// The line of sight through a pixel, in the handle's space.
Ray ray_through(const PlacedHandle& handle, const HandleView& view, const dvec2& pixel) {
  const dmat4 to_handle = inverse(handle.world_from_handle);
  const dvec3 near = transformed(to_handle, view.world(dvec3(pixel, -1.0))),
              far = transformed(to_handle, view.world(dvec3(pixel, 1.0)));
  return {near, normalize(far - near)};
}

// How far along the handle's axis the line of sight comes nearest to it; none where it looks along it.
std::optional<double> along_axis(const PlacedHandle& handle, const Ray& ray) {
  const double b = dot(handle.axis, ray.direction), d = 1.0 - b * b;
  if (d < 1e-6) return std::nullopt;
  const dvec3 offset = ray.origin - handle.origin;
  return (dot(handle.axis, offset) - b * dot(ray.direction, offset)) / d;
}

// How far from the axis the line of sight meets the plane of the cone's circle.
std::optional<double> from_axis(const PlacedHandle& handle, const Ray& ray) {
  const double slope = dot(handle.axis, ray.direction);
  if (std::abs(slope) < 1e-3) {
    // Seen from the side: where it comes nearest to the circle's middle.
    const dvec3 offset = handle.tip - ray.origin;
    return length(offset - dot(offset, ray.direction) * ray.direction);
  }
  const dvec3 met = ray.origin + ray.direction * (dot(handle.tip - ray.origin, handle.axis) / slope);
  return length(met - handle.tip);
}

std::string written(const dvec3& vector) {
  return graph::write_number(float(vector.x)) + " " + graph::write_number(float(vector.y)) + " " +
         graph::write_number(float(vector.z));
}

}  // namespace

HandleSpec handle_from(const PlinianHandle& plain, const std::vector<graph::AttributeSpec>& attributes) {
  HandleSpec spec;
  spec.name = text_of(plain.name);
  const auto wrong = [&](const std::string& why) {
    throw GraphError("the handle " + graph::shown(spec.name) + " " + why);
  };
  const auto attribute = [&](const char* name, const char* what, auto fits) {
    if (!name) return std::string();
    std::vector<std::string> known;
    for (const graph::AttributeSpec& found : attributes) {
      if (found.name == name && !found.array && fits(found.type)) return std::string(name);
      if (found.name == name) wrong(std::string("needs ") + what + ", which '" + name + "' is not");
      known.push_back(found.name);
    }
    wrong("names '" + std::string(name) + "', which is no attribute" + did_you_mean(name, known));
    return std::string();
  };
  if (spec.name.empty() || !plain.attribute) wrong("needs a name and an attribute");
  if (plain.kind > PLINIAN_HANDLE_CONE) wrong("is of no kind that is known");
  spec.kind = HandleKind(plain.kind);
  const bool vector = spec.kind == HandleKind::point || spec.kind == HandleKind::direction;
  spec.attribute = vector ? attribute(plain.attribute, "a float3", is_vector)
                          : attribute(plain.attribute, "a number", graph::is_number);
  spec.origin = attribute(plain.origin, "a float3", is_vector);
  spec.along = attribute(plain.along, "a float3", is_vector);
  spec.length = attribute(plain.length, "a number", graph::is_number);
  spec.transform = attribute(plain.transform, "a matrix",
                             [](AttributeType type) { return type == AttributeType::matrix; });
  spec.axis = vec3(plain.axis[0], plain.axis[1], plain.axis[2]);
  if (spec.along.empty() && !vector && !(dot(spec.axis, spec.axis) > 0.0f)) wrong("needs an axis");
  spec.colour = vec3(plain.colour[0], plain.colour[1], plain.colour[2]);
  return spec;
}

std::optional<dvec3> HandleView::pixel(const dvec3& world) const {
  const dvec4 clip = clip_from_world * dvec4(world, 1.0);
  if (!(clip.w > 0.0)) return std::nullopt;
  const dvec3 unit = dvec3(clip) / clip.w;
  return dvec3(viewport.x + (0.5 * unit.x + 0.5) * viewport.z, viewport.y + (0.5 * unit.y + 0.5) * viewport.w,
               unit.z);
}

dvec3 HandleView::world(const dvec3& p) const {
  const dvec4 unit((p.x - viewport.x) / viewport.z * 2.0 - 1.0, (p.y - viewport.y) / viewport.w * 2.0 - 1.0,
                   p.z, 1.0);
  const dvec4 point = inverse(clip_from_world) * unit;
  return dvec3(point) / point.w;
}

std::vector<PlacedHandle> place_handles(graph::Session& session, graph::NodeId node,
                                        std::span<const HandleSpec> specs, const dmat4& world_from_object) {
  std::vector<PlacedHandle> handles;
  Reader read(session, node);
  for (const HandleSpec& spec : specs) {
    PlacedHandle handle;
    handle.spec = spec;
    handle.plug = graph::Graph::plug(*session.graph().find(node), spec.attribute);
    handle.plug.node = node;
    handle.is_free = session.editor().set_problem(handle.plug).empty();
    try {
      handle.world_from_handle = world_from_object;
      if (!spec.transform.empty())
        handle.world_from_handle *= *std::get<graph::Boxed<dmat4>>(read.value(spec.transform));
      handle.origin = read.vector(spec.origin, dvec3(0.0));
      const double shown = read.number(spec.length, 1.0);
      dvec3 along = read.vector(spec.along, dvec3(spec.axis));
      if (spec.kind == HandleKind::direction) along = read.vector(spec.attribute, along);
      if (spec.kind == HandleKind::point) {
        handle.origin = handle.tip = read.vector(spec.attribute, dvec3(0.0));
      } else {
        if (!(dot(along, along) > 0.0)) continue;  // it points nowhere
        handle.axis = normalize(along);
        if (spec.kind != HandleKind::direction) handle.value = read.number(spec.attribute, 0.0);
        handle.tip = handle.origin + handle.axis * (spec.kind == HandleKind::distance ? handle.value : shown);
      }
    } catch (const GraphError&) {
      continue;
    }
    handles.push_back(std::move(handle));
  }
  return handles;
}

std::vector<ScreenLine> handle_lines(const PlacedHandle& handle, const HandleView& view) {
  std::vector<ScreenLine> lines;
  const auto pixel = [&](const dvec3& point) {
    return view.pixel(transformed(handle.world_from_handle, point));
  };
  const auto add = [&](const dvec3& begin, const dvec3& end) {
    const auto a = pixel(begin), b = pixel(end);
    if (a && b) lines.push_back({dvec2(*a), dvec2(*b)});
  };
  const auto add_cross = [&](const dvec3& point) {
    if (const auto p = pixel(point)) {
      const dvec2 at(*p);
      lines.push_back({at - dvec2(point_size, 0.0), at + dvec2(point_size, 0.0)});
      lines.push_back({at - dvec2(0.0, point_size), at + dvec2(0.0, point_size)});
    }
  };
  if (handle.spec.kind != HandleKind::point) add(handle.origin, handle.tip);
  if (handle.spec.kind != HandleKind::cone) {
    add_cross(handle.tip);
    return lines;
  }
  const double half = std::clamp(0.5 * glm::radians(handle.value), 0.0, 0.499 * std::numbers::pi);
  const double radius = length(handle.tip - handle.origin) * std::tan(half);
  const auto [u, v] = across(handle.axis);
  const auto rim = [&](int i) {
    const double angle = 2.0 * std::numbers::pi * i / circle_segments;
    return handle.tip + radius * (std::cos(angle) * u + std::sin(angle) * v);
  };
  for (int i = 0; i < circle_segments; ++i) add(rim(i), rim(i + 1));
  return lines;
}

std::optional<std::size_t> hit_handle(std::span<const PlacedHandle> handles, const HandleView& view,
                                      const dvec2& pixel, double reach) {
  std::optional<std::size_t> best;
  double best_distance = reach, best_depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const auto tip = view.pixel(transformed(handles[i].world_from_handle, handles[i].tip));
    if (!tip) continue;
    double distance = std::numeric_limits<double>::infinity();
    for (const ScreenLine& line : handle_lines(handles[i], view))
      distance = std::min(distance, distance_to(line, pixel));
    // Half a pixel is nothing that a hand could mean.
    const bool nearer = distance < best_distance - 0.5,
               as_near = distance <= best_distance + 0.5 && distance <= reach;
    if (!nearer && !(as_near && tip->z < best_depth)) continue;
    best = i;
    best_distance = distance;
    best_depth = tip->z;
  }
  return best;
}

std::string drag_command(const graph::Graph& graph, const PlacedHandle& handle, const HandleView& view,
                         const dvec2& from, const dvec2& to) {
  const auto tip = view.pixel(transformed(handle.world_from_handle, handle.tip));
  if (!handle.is_free || !tip) return "";
  const std::string set = "setAttr " + graph.name_of(handle.plug) + " ";
  const Ray before = ray_through(handle, view, from), after = ray_through(handle, view, to);
  switch (handle.spec.kind) {
    case HandleKind::point:
    case HandleKind::direction: {
      // Across the picture, as deep in it as the handle is.
      const dvec3 moved =
          transformed(inverse(handle.world_from_handle), view.world(*tip + dvec3(to - from, 0.0)));
      if (handle.spec.kind == HandleKind::point) return set + written(moved);
      const dvec3 along = moved - handle.origin;
      if (!(dot(along, along) > 0.0)) return "";
      const auto* old = std::get_if<vec3>(&graph.find(handle.plug.node)->value(handle.plug.attribute));
      const double kept = old && dot(*old, *old) > 0.0f ? length(dvec3(*old)) : 1.0;
      return set + written(kept * normalize(along));
    }
    case HandleKind::distance: {
      // The handle moves as far as the cursor, wherever on it the cursor took hold.
      const auto a = along_axis(handle, before), b = along_axis(handle, after);
      return a && b ? set + graph::write_number(float(std::max(0.0, handle.value + *b - *a))) : "";
    }
    case HandleKind::cone: {
      const auto a = from_axis(handle, before), b = from_axis(handle, after);
      const double reach = length(handle.tip - handle.origin);
      if (!a || !b || !(reach > 0.0)) return "";
      const double old = reach * std::tan(0.5 * glm::radians(std::clamp(handle.value, 0.0, 179.0)));
      const double angle = 2.0 * glm::degrees(std::atan2(std::max(0.0, old + *b - *a), reach));
      return set + graph::write_number(float(angle));
    }
  }
  return "";
}

}  // namespace plinian::sdk
