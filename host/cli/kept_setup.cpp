// Settings in pictures.
#include "host/cli/kept_setup.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/image/image_io.h"
#include "core/scene/nearest_word.h"
#include "host/graph/files/scene_reader.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/hierarchy.h"
#include "host/graph/values/hash.h"

namespace plinian::cli {

namespace {

// What an import fills in where a description leaves it open, by node type.
std::vector<const char*> settled_attributes(const std::string& type) {
  if (type == "camera") return {"translate", "rotate"};
  if (type == "medium") return {"density_scale"};
  if (type == "volumeRead") return {"up_axis", "file_unit"};
  if (type.ends_with("Light") && type != "ambientLight") return {"rotate", "intensity", "exposure"};
  return {};
}

// Those that the setup depends on beside the files.
std::string key_of(const SceneArguments& arguments) {
  graph::Hasher hash;
  hash.add(std::string_view(arguments.input));
  hash.add(std::string_view(arguments.size));
  // What it says itself is no matter of which frames there are.
  if (arguments.input.ends_with(".json")) hash.add(std::string_view(graph::read_text_file(arguments.input)));
  for (const SceneEdit& edit : edits_of(arguments)) {
    if (is_quality_key(edit.key)) continue;
    hash.add(std::string_view(edit.key));
    hash.add(std::string_view(edit.value));
  }
  const graph::Hash result = hash.result();
  return fmt::format("{:016x}{:016x}", result.high, result.low);
}

constexpr std::string_view separator = "; ";

// What is settled and how, as "camera.translate.x 3".
std::vector<std::string> settled_values(graph::Session& session) {
  const graph::Graph& graph = session.graph();
  std::vector<std::string> values;
  for (const graph::Node* node : graph.nodes())
    for (const char* attribute : settled_attributes(node->type->name()))
      if (node->schema->find(attribute) != graph::no_attribute)
        for (const graph::Plug& leaf : leaf_plugs(graph, graph.plug(node->name + "." + attribute)))
          if (node->inputs_of(leaf.attribute).empty())
            values.push_back(graph.name_of(leaf) + " " +
                             session.execute("getAttr " + graph.name_of(leaf)).front());
  return values;
}

}  // namespace

std::string setup_text(graph::Session& session, const SceneArguments& arguments) {
  return key_of(arguments) + std::string(separator) + join(settled_values(session), separator);
}

std::optional<KeptSetup> find_setup(const std::vector<FramePattern>& pictures,
                                    const SceneArguments& arguments) {
  const std::string key = key_of(arguments);
  constexpr std::size_t enough = 8;  // others that were made otherwise; each is read whole
  for (const FramePattern& pattern : pictures) {
    std::vector<int> frames = pattern.frames_on_disk();
    frames.resize(std::min(frames.size(), enough));
    for (const int frame : frames) try {
        const std::string path = pattern.path(frame);
        const Image image = read_image(path);
        const auto found = image.metadata.find(setup_attribute);
        const auto* text = found == image.metadata.end() ? nullptr : std::get_if<std::string>(&found->second);
        if (!text || !text->starts_with(key + std::string(separator))) continue;
        KeptSetup setup{path, {}};
        for (std::size_t begin = key.size() + separator.size(); begin < text->size();) {
          const std::size_t end = std::min(text->find(separator, begin), text->size());
          setup.values.push_back(text->substr(begin, end - begin));
          begin = end + separator.size();
        }
        return setup;
      } catch (const ImageError&) {
        // Half written, or something else.
      }
  }
  return std::nullopt;
}

bool restore_setup(graph::Session& session, const KeptSetup& setup) {
  const std::vector<std::string> now = settled_values(session);
  // A picture is data: it settles what is settled here, and nothing else.
  const auto name_of = [](const std::string& value) { return value.substr(0, value.find(' ')); };
  if (!std::ranges::equal(now, setup.values, {}, name_of, name_of) || now == setup.values) return false;
  graph::History::Scope scope(session.history(), "setup");
  try {
    for (const std::string& value : setup.values) session.execute("setAttr " + value);
  } catch (const graph::GraphError&) {
    scope.roll_back();
    return false;
  }
  return true;
}

}  // namespace plinian::cli
