// A session with the test's node types, and what it said.
#pragma once

#include "host/graph/commands/session.h"
#include "host/graph/evaluation/compute_context.h"
#include "host/graph/files/scene_writer.h"
#include "host/nodes/built_in.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/graph/test_scene.h"

namespace plinian::graph {

struct TestSession : Session {
  std::vector<std::string> echoes, warnings;
  sdk::PluginManager plugins{*this, {}};

  TestSession() : Session({.cache_bytes = 1 << 20, .workers = 1}) {
    nodes::add_built_in(*this, plugins);
    add_test_types(types());
    on_echo = [this](const std::string& line) { echoes.push_back(line); };
    on_warning = [this](const std::string& line) { warnings.push_back(line); };
  }
  /// Runs lines; answers joined by "\n".
  std::string run(std::string_view lines) {
    std::string answer;
    run_script(*this, lines, "script.pln",
               [&](const std::string& line) { answer += (answer.empty() ? "" : "\n") + line; });
    return answer;
  }
  std::string refusal(const std::string& line) {
    const std::string before = write_scene(graph());
    const std::size_t steps = history().undo_names().size();
    const std::string message = message_of([&] { execute(line); });
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_EQ(write_scene(graph()), before);
    EXPECT_EQ(history().undo_names().size(), steps);
    return message;
  }
};

}  // namespace plinian::graph
