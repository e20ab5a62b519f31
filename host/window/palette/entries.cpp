// Collects, scores, sorts.
#include "host/window/palette/entries.h"

#include <algorithm>
#include <cctype>
#include <tuple>

#include "host/scene/looks.h"
#include "host/scene/workspace.h"
#include "host/window/palette/fuzzy.h"

namespace plinian::window {

namespace {

// "frameAll": "frame all".
std::string spaced(const std::string& name) {
  std::string words;
  for (const char c : name) {
    if (std::isupper((unsigned char)c)) words += ' ';
    words += char(std::tolower((unsigned char)c));
  }
  return words;
}

bool needs_words(const graph::CommandSpec& spec) {
  return std::any_of(spec.parameters.begin(), spec.parameters.end(),
                     [](const graph::CommandParameter& parameter) { return !parameter.optional; });
}

}  // namespace

std::vector<PaletteEntry> palette_entries(graph::Session& session, const Hotkeys& hotkeys,
                                          const std::vector<sdk::MenuItem>& of_plugins) {
  std::vector<PaletteEntry> entries;
  for (const Hotkey& hotkey : hotkeys.all()) {
    if (hotkey.is_held) continue;
    const std::string keys = text_of(hotkey.chord);
    entries.push_back({.title = spaced(hotkey.name),
                       .kind = "action",
                       .detail = hotkey.help,
                       .keys = keys == "none" ? "" : keys,
                       .action = hotkey.action,
                       .line = ""});
  }
  for (const sdk::MenuItem& item : of_plugins)
    entries.push_back({.title = item.path,
                       .kind = "menu",
                       .detail = item.help.empty() ? item.command : item.help,
                       .keys = "",
                       .action = {},
                       .line = item.command});
  const graph::Graph& graph = session.graph();
  for (const graph::Node* node : graph.nodes())
    entries.push_back({.title = node->name,
                       .kind = "node",
                       .detail = node->type->name(),
                       .keys = "",
                       .action = {},
                       .line = "select " + node->name});
  if (const graph::Node* medium = scene::medium_for_looks(graph))
    for (const std::string& look : scene::look_names())
      entries.push_back({.title = look,
                         .kind = "look",
                         .detail = "put on " + medium->name,
                         .keys = "",
                         .action = {},
                         .line = "preset apply " + graph::quote(look) + " " + medium->name});
  for (const std::string& type : session.types().names())
    entries.push_back({.title = type,
                       .kind = "create",
                       .detail = session.types().get(type)->spec().help,
                       .keys = "",
                       .action = {},
                       .line = "createNode " + type});
  for (const std::string& name : session.commands().names()) {
    const graph::CommandSpec& spec = session.commands().get(name);
    entries.push_back({.title = name,
                       .kind = "command",
                       .detail = spec.help,
                       .keys = "",
                       .action = {},
                       .line = name,
                       .is_open = needs_words(spec)});
  }
  return entries;
}

std::vector<PaletteEntry> matching(const std::vector<PaletteEntry>& entries, const std::string& query,
                                   const std::vector<std::string>& recent) {
  using Rank = std::tuple<bool, int, std::size_t, std::size_t>;  // by help alone, -score, last use, place
  std::vector<std::pair<Rank, const PaletteEntry*>> found;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto score = fuzzy_score(query, entries[i].title);
    if (!score && !holds_words(query, entries[i].kind + " " + entries[i].title + " " + entries[i].detail))
      continue;
    const auto used = std::find(recent.begin(), recent.end(), entries[i].id());
    found.push_back({{!score, -score.value_or(0), std::size_t(used - recent.begin()), i}, &entries[i]});
  }
  std::sort(found.begin(), found.end());
  std::vector<PaletteEntry> result;
  for (const auto& [rank, entry] : found) result.push_back(*entry);
  return result;
}

}  // namespace plinian::window
