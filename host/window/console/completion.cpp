// Candidates by where the word stands.
#include "host/window/console/completion.h"

#include <algorithm>
#include <set>

#include "host/graph/graph_error.h"

namespace plinian::window {

namespace {

using graph::ArgumentKind;

void add_attributes(graph::Session& session, const std::string& node_name, std::set<std::string>& words) {
  const graph::Node* node = session.graph().find(node_name);
  if (!node) return;
  for (graph::AttributeIndex i = 0; i < node->schema->size(); ++i)
    if (!(*node->schema)[i].spec.hidden) words.insert(node_name + "." + (*node->schema)[i].path);
}

std::set<std::string> candidates(graph::Session& session, const std::string& line, const std::string& word,
                                 std::size_t begin) {
  std::set<std::string> words;
  const std::size_t first = line.find_first_not_of(' ');
  if (first == line.npos || first >= begin) {
    for (const std::string& name : session.commands().names()) words.insert(name);
    return words;
  }
  const std::string name = line.substr(first, line.find(' ', first) - first);
  const auto names = session.commands().names();
  if (std::find(names.begin(), names.end(), name) == names.end()) return words;
  const graph::CommandSpec& spec = session.commands().get(name);
  if (word.starts_with("-")) {
    for (const graph::CommandFlag& flag : spec.flags) words.insert("-" + flag.name);
    return words;
  }
  bool nodes = false, plugs = false, types = false, commands = false;
  const auto want = [&](ArgumentKind kind) {
    nodes |= kind == ArgumentKind::node || kind == ArgumentKind::value;
    plugs |= kind == ArgumentKind::plug;
    types |= kind == ArgumentKind::type;
    commands |= kind == ArgumentKind::command;
  };
  for (const graph::CommandParameter& parameter : spec.parameters) want(parameter.kind);
  for (const graph::CommandFlag& flag : spec.flags)
    if (flag.takes) want(*flag.takes);
  if (plugs && word.find('.') != word.npos) add_attributes(session, word.substr(0, word.find('.')), words);
  if ((nodes || plugs) && word.find('.') == word.npos)
    for (const graph::Node* node : session.graph().nodes())
      words.insert(plugs ? node->name + "." : node->name);
  if (types)
    for (const std::string& type : session.types().names()) words.insert(type);
  if (commands) words.insert(names.begin(), names.end());
  return words;
}

}  // namespace

Completion complete(graph::Session& session, const std::string& line) {
  Completion completion;
  const std::size_t space = line.rfind(' ');
  completion.begin = space == line.npos ? 0 : space + 1;
  const std::string word = line.substr(completion.begin);
  for (const std::string& candidate : candidates(session, line, word, completion.begin))
    if (candidate.starts_with(word)) completion.words.push_back(candidate);
  completion.common = completion.words.empty() ? word : completion.words.front();
  for (const std::string& other : completion.words) {
    const auto [end, ignored] =
        std::mismatch(completion.common.begin(), completion.common.end(), other.begin(), other.end());
    completion.common.erase(end, completion.common.end());
  }
  return completion;
}

}  // namespace plinian::window
