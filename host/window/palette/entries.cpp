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
                                   const std::vector<std::string>& recent,
                                   const std::vector<PaletteEntry>& more, std::size_t most) {
  using Rank = std::tuple<bool, int, std::size_t, std::size_t>;  // by help alone, -score, last use, place
  const std::vector<std::string> words = words_of(query);
  std::vector<std::pair<Rank, const PaletteEntry*>> found;
  const auto look_at = [&](const PaletteEntry& entry, std::size_t place) {
    const auto score = entry.score ? entry.score : fuzzy_score(words, entry.title);
    if (!score && !holds_words(words, entry.kind + " " + entry.title + " " + entry.detail)) return;
    const auto used = std::find(recent.begin(), recent.end(), entry.id());
    found.push_back({{!score, -score.value_or(0), std::size_t(used - recent.begin()), place}, &entry});
  };
  for (std::size_t i = 0; i < entries.size(); ++i) look_at(entries[i], i);
  for (std::size_t i = 0; i < more.size(); ++i) look_at(more[i], entries.size() + i);
  most = std::min(most, found.size());
  std::partial_sort(found.begin(), found.begin() + std::ptrdiff_t(most), found.end());
  std::vector<PaletteEntry> result;
  for (std::size_t i = 0; i < most; ++i) result.push_back(*found[i].second);
  return result;
}

}  // namespace plinian::window
