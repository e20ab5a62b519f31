// A session with the built-in node types and the test's plug-ins.
#pragma once

#include <string>

#include "host/nodes/built_in.h"
#include "tests/host/graph/message_of.h"

namespace plinian::sdk {

struct PluginSession {
  graph::Session session;
  PluginManager plugins{session, {PLINIAN_TEST_PLUGINS}};

  PluginSession() { nodes::add_built_in(session, plugins); }

  /// Runs lines; answers joined by "\n".
  std::string run(const std::string& lines) {
    std::string answer;
    run_script(session, lines, "script",
               [&](const std::string& line) { answer += (answer.empty() ? "" : "\n") + line; });
    return answer;
  }
  /// A refusal changes nothing: neither types nor commands nor what is loaded.
  std::string refusal(const std::string& line) {
    const auto types = session.types().names(), commands = session.commands().names();
    const std::size_t loaded = plugins.plugins().size();
    const std::string message = graph::message_of([&] { session.execute(line); });
    EXPECT_EQ(session.types().names(), types);
    EXPECT_EQ(session.commands().names(), commands);
    EXPECT_EQ(plugins.plugins().size(), loaded);
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message;
  }
};

}  // namespace plinian::sdk
