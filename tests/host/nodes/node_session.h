// A session with the built-in node types, and what it said.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/media/vdb_writer.h"
#include "host/graph/commands/session.h"
#include "host/nodes/built_in.h"
#include "host/sdk/volume_table.h"
#include "tests/core/scene/temporary_folder.h"

namespace plinian {

struct NodeSession : graph::Session {
  std::vector<std::string> warnings;
  sdk::PluginManager plugins;

  explicit NodeSession(std::vector<std::filesystem::path> folders = {})
      : Session({.cache_bytes = 1 << 28, .workers = 1}), plugins(*this, std::move(folders)) {
    nodes::add_built_in(*this, plugins);
    on_warning = [this](const std::string& line) { warnings.push_back(line); };
  }
  /// Runs lines; answers joined by "\n".
  std::string run(std::string_view lines) {
    std::string answer;
    graph::run_script(*this, lines, "script.pln",
                      [&](const std::string& line) { answer += (answer.empty() ? "" : "\n") + line; });
    return answer;
  }
  /// What a line is refused with.
  std::string refusal(const std::string& line) {
    return error_of([&] { execute(line); });
  }
  std::uint64_t computes(const std::string& type) {
    const auto& counters = evaluator().counters().computes_of_type;
    const auto found = counters.find(type);
    return found == counters.end() ? 0 : found->second;
  }
  /// The volume that an output hands on now; null where it failed.
  std::shared_ptr<const BrickVolume> volume(const std::string& plug) {
    const graph::ResultPtr result = evaluator().evaluate(graph().plug(plug));
    return result->error ? nullptr : sdk::volume_in(result->value);
  }
};

/// A block of even density as a .vdb file.
inline void write_block(const std::string& path, float density, const VdbWriteOptions& options = {}) {
  BrickVolumeBuilder builder;
  const std::vector<float> voxels(BrickVolumeBuilder::block_voxels, density);
  builder.add({0, 0, 0}, voxels.data());
  write_vdb(path, builder.build(dmat4(glm::dmat3(0.5))), options);
}

}  // namespace plinian
