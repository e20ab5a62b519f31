// Calm ones, of about one brightness.
#include "host/window/nodes/node_colours.h"

namespace plinian::window {

unsigned node_colour(const std::string& type) {
  if (type.find("Light") != type.npos) return 0xff5fc3ee;
  if (type == "camera") return 0xffd0a878;
  if (type == "atfmVolume" || type.find("Volume") != type.npos) return 0xffb4b4c8;
  if (type == "medium") return 0xff7e9ad8;
  if (type.starts_with("volume")) return 0xff9ac09a;
  if (type == "transform") return 0xff8c8c8c;
  return 0xff6f6b68;
}

unsigned plug_colour(graph::AttributeType type) {
  using enum graph::AttributeType;
  switch (type) {
    case data:
      return 0xff5ab8dc;
    case colour:
    case ramp:
      return 0xff7a8ce6;
    case string:
    case path:
    case node:
      return 0xff8cc88c;
    case matrix:
    case compound:
      return 0xffc8a0b4;
    default:
      return 0xffd2b48c;
  }
}

}  // namespace plinian::window
