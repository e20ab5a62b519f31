// Keeps and restores.
#include "host/window/compare/snapshots.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/scene/nearest_word.h"
#include "host/graph/edits/clear.h"
#include "host/graph/files/scene_reader.h"
#include "host/graph/files/scene_writer.h"
#include "host/graph/graph_error.h"

namespace plinian::window {

namespace {

constexpr int thumbnail_height = 72;  // [pixels]

// What is open gives way to the scene of a snapshot; that is one edit, and undone as one.
void restore(graph::Session& session, const Snapshot& snapshot) {
  graph::clear_graph(session.editor());
  for (const std::string& warning :
       graph::read_scene(snapshot.scene, snapshot.name, session.types(), session.editor()).warnings)
    session.warn(warning);
}

}  // namespace

Snapshots::Snapshots(scene::Workspace& workspace, std::size_t budget_bytes)
    : workspace_(workspace), budget_(budget_bytes) {
  workspace_.session().commands().add(
      {.name = "restoreSnapshot",
       .help = "Puts the scene of a snapshot in place of the one that is open; one step of undo.",
       .parameters = {{"name", graph::ArgumentKind::text, "of the snapshot, such as \"snapshot 1\""}},
       .flags = {},
       .run = [this](graph::Session& session, const graph::Arguments& words) -> graph::CommandResult {
         restore(session, get("restoreSnapshot", words.text("name")));
         return {};
       }});
  workspace_.session().commands().add(
      {.name = "deleteSnapshot",
       .help = "Lets go of a snapshot's picture and scene, for good.",
       .parameters = {{"name", graph::ArgumentKind::text, "of the snapshot; without it: of all", true}},
       .flags = {},
       .run = [this](graph::Session&, const graph::Arguments& words) -> graph::CommandResult {
         if (words.has("name"))
           forget(get("deleteSnapshot", words.text("name")).name);
         else
           all_.clear();
         return {};
       }});
}

Snapshots::~Snapshots() {
  workspace_.session().commands().remove("restoreSnapshot");
  workspace_.session().commands().remove("deleteSnapshot");
}

const Snapshot& Snapshots::get(const std::string& command, const std::string& name) const {
  if (const Snapshot* snapshot = find(name)) return *snapshot;
  std::vector<std::string> names;
  for (const Snapshot& one : all_) names.push_back(one.name);
  throw graph::GraphError(command + ": no snapshot is called '" + name + "'" +
                          (names.empty() ? "; there is none" : "; there are: " + join(names)));
}

std::vector<std::string> Snapshots::keep(const ViewPicturePtr& picture, const DevelopedPtr& shown,
                                         const std::string& name) {
  ++made_;
  Snapshot snapshot;
  snapshot.name = name.empty() ? fmt::format("snapshot {}", made_) : name;
  for (int i = 2; find(snapshot.name); ++i)
    snapshot.name = fmt::format("{} ({})", name.empty() ? "snapshot" : name, i);
  snapshot.picture = picture;
  snapshot.scene = graph::write_scene(workspace_.session().graph());
  if (shown) snapshot.thumbnail = thumbnail_of(*shown, thumbnail_height);
  snapshot.figures =
      fmt::format("{}, {}x{}, {} passes in {:.2f} s", picture->scene.quality.name, picture->frame.width,
                  picture->frame.height, picture->passes, picture->render_ms / 1000.0);
  all_.push_back(std::move(snapshot));
  std::vector<std::string> gone;
  while (bytes() > budget_ && all_.size() > 1) {
    gone.push_back(all_.front().name);
    all_.pop_front();
  }
  return gone;
}

void Snapshots::make_thumbnail(const Development& how, std::function<void()> wake) {
  const ViewPicturePtr picture = all_.back().picture;
  const auto make = [picture, how, wake = std::move(wake)]() -> DevelopedPtr {
    const DevelopedPtr developed = develop(picture, how);
    const DevelopedPtr small = developed ? thumbnail_of(*developed, thumbnail_height) : nullptr;
    wake();
    return small;
  };
  making_.push_back({picture, std::async(std::launch::async, make)});
}

void Snapshots::update() {
  std::erase_if(making_, [this](Making& making) {
    if (making.thumbnail.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    const DevelopedPtr thumbnail = making.thumbnail.get();
    for (Snapshot& snapshot : all_)
      if (snapshot.picture == making.picture && !snapshot.thumbnail) snapshot.thumbnail = thumbnail;
    return true;
  });
}

const Snapshot* Snapshots::find(const std::string& name) const {
  const auto found =
      std::find_if(all_.begin(), all_.end(), [&](const Snapshot& s) { return s.name == name; });
  return found == all_.end() ? nullptr : &*found;
}

void Snapshots::forget(const std::string& name) {
  const std::string given = name;  // it may be that of what goes
  std::erase_if(all_, [&](const Snapshot& s) { return s.name == given; });
}

std::size_t Snapshots::bytes() const {
  std::size_t sum = 0;
  for (const Snapshot& snapshot : all_) sum += bytes_of(snapshot.picture->frame) + snapshot.scene.size();
  return sum;
}

DevelopedPtr thumbnail_of(const Developed& shown, int height) {
  auto small = std::make_shared<Developed>();
  small->height = std::max(1, std::min(height, shown.height));
  small->width = std::max(1, shown.width * small->height / std::max(1, shown.height));
  small->bytes.resize(std::size_t(small->width) * std::size_t(small->height) * 3);
  for (int y = 0; y < small->height; ++y)
    for (int x = 0; x < small->width; ++x) {
      const int x0 = x * shown.width / small->width, y0 = y * shown.height / small->height;
      const int x1 = std::max(x0 + 1, (x + 1) * shown.width / small->width),
                y1 = std::max(y0 + 1, (y + 1) * shown.height / small->height);
      for (int c = 0; c < 3; ++c) {
        unsigned sum = 0;
        for (int v = y0; v < y1; ++v)
          for (int u = x0; u < x1; ++u) sum += shown.bytes[3 * (std::size_t(v) * shown.width + u) + c];
        small->bytes[3 * (std::size_t(y) * small->width + x) + c] =
            std::uint8_t(sum / unsigned((x1 - x0) * (y1 - y0)));
      }
    }
  return small;
}

std::size_t bytes_of(const Frame& frame) {
  std::size_t values = 0;
  for (const auto* plane :
       {&frame.beauty, &frame.transmittance, &frame.ambient, &frame.emission, &frame.background})
    values += plane->size();
  for (const LightLayer& light : frame.lights) values += light.radiance.size();
  return values * sizeof(vec3) + frame.depth.size() * sizeof(float);
}

}  // namespace plinian::window
