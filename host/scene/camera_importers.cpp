// import of cameras.
//
// A .chan file has a line for each frame: frame, translate x y z, rotate x y z [degrees] and, where there is
// one, the vertical field of view [degrees] (Blender manual, "Nuke Animation (chan)"). It says neither in
// which order it turns nor what a length is: "the rotation orders during export and import must be the same"
// (ib.). Without the flag rotateOrder it is zxy, from left to right, which is Foundry's default; without the
// flag unit a length is a metre, as all are here. Houdini writes a row of channels per frame and no number of
// the frame (SideFX, "Available channel/audio formats"), which is refused where it can be told. An EXR has
// the matrix worldToCamera, of row vectors (OpenEXR standard attributes), and, where Plinian or a program
// like it wrote the file, lens and film.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "core/image/image_io.h"
#include "core/scene/nearest_word.h"
#include "core/scene/placement.h"
#include "host/graph/files/scene_reader.h"
#include "host/graph/graph_error.h"
#include "host/graph/values/value_text.h"
#include "host/scene/file_types.h"

namespace plinian::scene {

using graph::ArgumentKind;
using graph::Arguments;
using graph::CommandResult;
using graph::GraphError;
using graph::Session;
using graph::write_number;

namespace {

// A camera named after the file.
std::string create_camera(Session& session, const Arguments& arguments) {
  std::string name = std::filesystem::path(arguments.text("file")).stem().string();
  for (char& c : name)
    if (!std::isalnum((unsigned char)c)) c = '_';
  if (name.empty() || std::isdigit((unsigned char)name[0])) name.insert(0, "camera_");
  if (const std::string space = arguments.text("namespace"); !space.empty()) name = space + ":" + name;
  return session.execute("createNode camera -name " + graph::quote(name)).front();
}

struct ChanLine {
  double frame = 0.0;
  double values[6] = {};  // translate, rotate
  double fov = 0.0;       // [degrees] vertical; 0: not given
};

std::vector<ChanLine> read_chan(const std::string& path) {
  std::istringstream text(graph::read_text_file(path));
  std::vector<ChanLine> lines;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    std::istringstream words(line);
    std::vector<double> values;
    for (std::string word; words >> word && word[0] != '#';) {
      try {
        values.push_back(graph::read_number(word));
      } catch (const GraphError& error) {
        throw GraphError(path + ":" + std::to_string(number) + ": " + error.what());
      }
    }
    if (values.empty()) continue;
    if (values.size() < 7 || values.size() > 8)
      throw GraphError(path + ":" + std::to_string(number) +
                       ": expected a frame, 3 numbers of translation, 3 of rotation and, perhaps, a field of "
                       "view, got " +
                       std::to_string(values.size()) + " numbers");
    if (!lines.empty() && values[0] <= lines.back().frame)
      throw GraphError(path + ":" + std::to_string(number) +
                       ": the first number of a line is its frame, and " + write_number(values[0]) +
                       " does not come after " + write_number(lines.back().frame));
    ChanLine& read = lines.emplace_back();
    read.frame = values[0];
    std::copy_n(values.begin() + 1, 6, read.values);
    if (values.size() == 8) read.fov = values[7];
    if (read.fov < 0.0 || read.fov >= 180.0)
      throw GraphError(path + ":" + std::to_string(number) +
                       ": a field of view is between 0 and 180 degrees");
  }
  if (lines.empty()) throw GraphError(path + ": holds no frame");
  return lines;
}

// Of the flag unit: cm and the like, or a number of metres.
double metres(const std::string& unit) {
  const graph::AttributeSpec length = {.name = "unit", .type = graph::AttributeType::distance};
  const bool named = std::ranges::all_of(unit, [](unsigned char c) { return std::isalpha(c); });
  const std::vector<graph::Word> words = {{named ? "1" + unit : unit, false}};
  try {
    if (const double found = std::get<double>(graph::read_value(length, words)); found > 0.0) return found;
  } catch (const GraphError&) {
  }
  throw GraphError("import: -unit expects mm, cm, m, km, in, ft or a number of metres, not " +
                   graph::shown(unit));
}

CommandResult import_chan(Session& session, const Arguments& arguments) {
  const std::string order = arguments.text("rotateOrder", "zxy");
  const auto orders = rotate_order_names();
  if (std::ranges::find(orders, order) == orders.end())
    throw GraphError("import: -rotateOrder " + graph::shown(order) + " is none of " + join(orders));
  const double unit = metres(arguments.text("unit", "m"));
  const std::vector<ChanLine> lines = read_chan(arguments.text("file"));
  const std::string camera = create_camera(session, arguments);
  session.execute("setAttr " + camera + ".rotate_order " + order);
  session.execute("setAttr " + camera + ".film_fit vertical");
  const char* const attributes[] = {"translate.x", "translate.y", "translate.z",
                                    "rotate.x",    "rotate.y",    "rotate.z"};
  const auto key = [&](const std::string& attribute, double frame, double value) {
    session.execute("setKeyframe " + camera + "." + attribute + " -time " + write_number(frame) + " -value " +
                    write_number(value) + " -interpolation linear");
  };
  constexpr double film_height = 24.0;  // [mm] of a new camera
  for (const ChanLine& line : lines) {
    for (int i = 0; i < 6; ++i) {
      const double value = line.values[i] * (i < 3 ? unit : 1.0);
      if (lines.size() > 1)
        key(attributes[i], line.frame, value);
      else
        session.execute("setAttr " + camera + "." + attributes[i] + " " + write_number(value));
    }
    if (line.fov == 0.0) continue;
    const double length = 0.5 * film_height / std::tan(glm::radians(line.fov) / 2.0);
    if (lines.size() > 1)
      key("focal_length", line.frame, length);
    else
      session.execute("setAttr " + camera + ".focal_length " + write_number(length));
  }
  return {camera};
}

float fact(const Image& image, const char* name, float otherwise) {
  const auto found = image.metadata.find(name);
  const auto* value = found == image.metadata.end() ? nullptr : std::get_if<float>(&found->second);
  return value ? *value : otherwise;
}

CommandResult import_exr(Session& session, const Arguments& arguments) {
  const std::string path = arguments.text("file");
  const Image image = read_image(path);
  const auto found = image.metadata.find(attribute::world_to_camera);
  const auto* stored = found == image.metadata.end() ? nullptr : std::get_if<mat4>(&found->second);
  if (!stored) throw GraphError(path + ": its header has no camera (worldToCamera)");
  dmat4 world_from_camera = glm::inverse(dmat4(*stored));
  for (int i = 0; i < 3; ++i) {
    const double length = glm::length(dvec3(world_from_camera[i]));
    if (!std::isfinite(length) || length == 0.0) throw GraphError(path + ": its worldToCamera is no camera");
    world_from_camera[i] /= length;
  }
  const std::string camera = create_camera(session, arguments);
  const auto set = [&](const std::string& name, const std::string& words) {
    session.execute("setAttr " + camera + "." + name + " " + words);
  };
  const auto three = [](const dvec3& v) {
    return write_number(v.x) + " " + write_number(v.y) + " " + write_number(v.z);
  };
  set("translate", three(dvec3(world_from_camera[3])));
  set("rotate", three(angles_of(world_from_camera)));
  set("focal_length", write_number(fact(image, "plinian:focal_length_mm", 35.0f)));
  set("film_back", write_number(fact(image, "plinian:film_back_width_mm", 36.0f)) + " " +
                       write_number(fact(image, "plinian:film_back_height_mm", 24.0f)));
  return {camera};
}

}  // namespace

void add_camera_importers(Session& session) {
  session.commands().add_flags(
      "import",
      {{"rotateOrder", "of a .chan: which axes it turns about first to last (zxy)", ArgumentKind::text},
       {"unit", "of a .chan: mm, cm, m, in, ft, or a number of metres (m)", ArgumentKind::text}});
  session.file_types().add({.name = "chan",
                            .help = "A camera's movement, as Nuke writes it: frames, places, angles.",
                            .plugin = "",
                            .extensions = {"chan"},
                            .flags = {"rotateOrder", "unit"},
                            .import_file = import_chan,
                            .export_file = {}});
  session.file_types().add({.name = "camera of a picture",
                            .help = "The camera that the header of an EXR tells of.",
                            .plugin = "",
                            .extensions = {"exr"},
                            .import_file = import_exr,
                            .export_file = {}});
}

}  // namespace plinian::scene
