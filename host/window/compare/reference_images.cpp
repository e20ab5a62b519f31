// Looks at the nodes, and reads.
#include "host/window/compare/reference_images.h"

#include <sys/stat.h>

#include <filesystem>

#include "core/image/image_io.h"
#include "core/media/frame_sequence.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"
#include "host/graph/values/file_path.h"
#include "host/scene/placed.h"

namespace plinian::window {

namespace {

constexpr const char* colour_spaces[] = {"auto", "linear", "srgb"};

}  // namespace

void ReferenceImage::forget() {
  picture_.reset();
  problem_.clear();
  node_.clear();
  read_ = {};
}

bool ReferenceImage::update(const std::string& node, const Wanted& wanted,
                            const std::function<void()>& wake) {
  bool news = false;
  node_ = node;
  if (reading_.valid() && reading_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    Outcome outcome = reading_.get();
    // A file that is being written anew is no reason to lose the picture.
    if (outcome.picture) picture_ = outcome.picture;
    problem_ = outcome.problem;
    news = true;
  }
  if (reading_.valid() || wanted == read_) return news;
  read_ = wanted;
  reading_ = std::async(std::launch::async, [wanted, wake] {
    Outcome outcome;
    try {
      const Image image = read_image(wanted.path);
      auto picture = std::make_shared<FilePicture>();
      picture->picture = read_picture(image, wanted.layer, wanted.colour_space, wanted.exposure);
      picture->name = std::filesystem::path(wanted.path).filename().string();
      picture->source = wanted.source;
      picture->layers = colour_layers(image);
      outcome.picture = std::move(picture);
    } catch (const std::exception& error) {
      outcome.problem = error.what();
    }
    wake();
    return outcome;
  });
  return news;
}

bool ReferenceImages::update() {
  const bool a = update(reference, false), b = update(plate, true);
  return a || b;
}

bool ReferenceImages::update(ReferenceImage& image, bool behind) {
  graph::Session& session = workspace_.session();
  const graph::Node* found = nullptr;
  for (const graph::Node* node : session.graph().nodes())
    if (node->type->name() == "referenceImage" &&
        (graph::number_of(node->value(node->schema->find("place"))) == 0.0) == behind)
      found = node;
  const bool was_there = image.picture_ != nullptr;
  if (!found) {
    image.forget();
    return was_there;
  }
  ReferenceImage::Wanted wanted;
  try {
    const scene::Placed placed(session.graph(), session.evaluator());
    const auto value = [&](const char* name) { return placed.value(placed.plug(*found, name)); };
    const std::string file = std::get<std::string>(value("file"));
    if (file.empty()) throw graph::GraphError(found->name + ": no file is set");
    wanted.path = graph::expand_path(file, session.scene_folder());
    if (const auto pattern = FramePattern::parse(wanted.path))
      wanted.path = pattern->path(int(graph::number_of(value("time"))));
    wanted.layer = std::get<std::string>(value("layer"));
    wanted.colour_space = colour_spaces[int(graph::number_of(value("colour_space")))];
    wanted.source = file + " " + wanted.colour_space;
    wanted.exposure = float(graph::number_of(value("exposure")));
  } catch (const std::runtime_error& error) {
    image.node_ = found->name;
    image.picture_.reset();
    image.problem_ = error.what();
    return was_there;
  }
  struct stat facts {};
  if (::stat(wanted.path.c_str(), &facts) == 0) {
    wanted.modified_ns = std::int64_t(facts.st_mtim.tv_sec) * 1'000'000'000 + facts.st_mtim.tv_nsec;
    wanted.bytes = facts.st_size;
  }
  return image.update(found->name, wanted, wake_);
}

}  // namespace plinian::window
