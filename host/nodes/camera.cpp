// The node type "camera": Maya's.
//
// attribute               unit
// translate, rotate       as of a transform; it looks along its -z
// focal_length            mm
// film_back, film_offset  mm
// film_fit                how the film meets a picture of another shape
// pixel_aspect            -
// near_clip               m
#include "core/scene/camera.h"

#include "core/scene/scene_parameters.h"
#include "host/nodes/core_attributes.h"
#include "host/nodes/node_types.h"
#include "host/nodes/placement_attributes.h"

namespace plinian::nodes {

void add_camera(sdk::Plugin& plugin) {
  sdk::NodeType type("camera");
  type.help = "A perspective camera with Maya's parameters; it looks along its -z.";
  const plinian::Camera usual;
  const PlacementAttributes placement(type);
  const auto add = [&](const char* parameter, AttributeTouch touch) {
    touch.group = "Camera";
    return type.add(attribute_of(camera_parameters(), parameter, std::move(touch)));
  };
  const sdk::Attribute focal_length = add("focal_length", {.default_value = spelled(usual.focal_length),
                                                           .help = "Of the lens.",
                                                           .soft_minimum = 10,
                                                           .soft_maximum = 200});
  const sdk::Attribute film_back =
      add("film_back", {.default_value = "36 24", .help = "Width and height of the film."});
  const sdk::Attribute film_fit = add("film_fit", {});
  const sdk::Attribute film_offset = add("film_offset", {});
  const sdk::Attribute pixel_aspect =
      add("pixel_aspect", {.default_value = "1", .soft_minimum = 0.5, .soft_maximum = 2});
  const sdk::Attribute near_clip = add("near_clip", {.soft_maximum = 10});
  type.contribute = [=](sdk::Context& context, sdk::Contribution& contribution) {
    const auto back = context.vector(film_back), offset = context.vector(film_offset);
    sdk::Camera camera;
    camera.focal_length = float(context.number(focal_length));
    camera.film_back = {back[0], back[1]};
    camera.fit = sdk::FilmFit(int(context.number(film_fit)));
    camera.film_offset = {offset[0], offset[1]};
    camera.pixel_aspect = float(context.number(pixel_aspect));
    camera.near_clip = float(context.number(near_clip));
    contribution.add(camera);
  };
  plugin.add(type);
}

}  // namespace plinian::nodes
