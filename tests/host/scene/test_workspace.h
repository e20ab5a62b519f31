// A workspace with what it said, for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/scene/scene_file.h"
#include "host/scene/import_description.h"
#include "host/scene/workspace.h"
#include "tests/core/scene/temporary_folder.h"

namespace plinian::scene {

struct TestWorkspace : Workspace {
  std::vector<std::string> warnings;

  TestWorkspace() {
    session().on_warning = [this](const std::string& line) { warnings.push_back(line); };
  }
  explicit TestWorkspace(const SceneDescription& description) : TestWorkspace() {
    import_description(session(), description);
  }
  /// Runs lines; answers joined by "\n".
  std::string run(std::string_view lines) {
    std::string answer;
    graph::run_script(session(), lines, "script.pln",
                      [&](const std::string& line) { answer += (answer.empty() ? "" : "\n") + line; });
    return answer;
  }
  std::string refusal(const std::string& line) {
    return error_of([&] { session().execute(line); });
  }
  BuiltSnapshot build() { return build_snapshot(session(), view()); }
  SceneSnapshot snapshot() {
    const BuiltSnapshot built = build();
    for (const std::string& problem : built.problems) ADD_FAILURE() << problem;
    return built.snapshot;
  }
  std::uint64_t computes() { return session().evaluator().counters().computes; }
  std::uint64_t computes(const std::string& type) {
    const auto& counters = session().evaluator().counters().computes_of_type;
    const auto found = counters.find(type);
    return found == counters.end() ? 0 : found->second;
  }
};

/// The default scene around a small procedural medium, or a scene of a file's text.
inline SceneDescription small_scene(const std::string& kind = "ash") {
  SceneDescription description = describe_input(kind);
  if (kind != "box" && kind != "sphere") set_scene_value(description, "medium.resolution", "16");
  return description;
}

}  // namespace plinian::scene
