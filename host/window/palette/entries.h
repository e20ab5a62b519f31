// What the command palette offers, and in which order.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/graph/commands/session.h"
#include "host/sdk/command_table.h"
#include "host/window/hotkeys/hotkeys.h"

namespace plinian::window {

class Studio;

struct PaletteEntry {
  std::string title;   // "frame all", "setAttr", "key"
  std::string kind;    // "action", "menu", "command", "node", "attribute", "look", "create"
  std::string detail;  // help, the type of a node, or the value of an attribute
  std::string keys;    // of an action; else empty
  // What choosing it does: one of these.
  std::optional<Action> action;
  std::string line;      // a command to be run
  bool is_open = false;  // ... or rather to be completed in the command line
  std::function<void(Studio&)> act = {};
  std::string field = {};  // an attribute, whose field takes the keys once its node is selected by the line
  std::optional<int> score = {};  // how well the query names it, where that is known; see fuzzy_score

  /// By which it is remembered.
  std::string id() const { return kind + " " + title; }
};

/// Actions with their keys, entries of menus that plug-ins bring, commands with their help, nodes, looks for
/// the medium that is selected or the first, and node types to be created.
std::vector<PaletteEntry> palette_entries(graph::Session& session, const Hotkeys& hotkeys,
                                          const std::vector<sdk::MenuItem>& of_plugins);

/// Those that the query names, best first, at most so many: by their title, then by words of their help.
/// Equally good ones and, for an empty query, all stand as they were used lately, then as they were, `more`
/// behind the others.
std::vector<PaletteEntry> matching(const std::vector<PaletteEntry>& entries, const std::string& query,
                                   const std::vector<std::string>& recent,
                                   const std::vector<PaletteEntry>& more = {},
                                   std::size_t most = std::size_t(-1));

}  // namespace plinian::window
