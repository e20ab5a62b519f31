// Loads and unloads plug-ins.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/graph/commands/session.h"
#include "host/sdk/plugin_description.h"
#include "host/sdk/plugin_registrar.h"
#include "host/sdk/plugin_search.h"

namespace plinian::sdk {

/// Is told before the draw override of a node type goes with its plug-in: the last moment to release what it
/// made.
class DrawOverrideListener {
 public:
  virtual ~DrawOverrideListener() = default;
  virtual void goes(const std::string& node_type) = 0;
};

class PluginManager {
 public:
  /// Adds the commands loadPlugin, unloadPlugin and pluginInfo to the session, and loads by itself what a
  /// scene needs when it is opened. folders: to look for plug-ins in, after those of $PLINIAN_PLUGIN_PATH;
  /// never the current folder.
  PluginManager(graph::Session& session, std::vector<std::filesystem::path> folders);
  ~PluginManager();
  PluginManager(const PluginManager&) = delete;
  PluginManager& operator=(const PluginManager&) = delete;

  /// Loads a plug-in by the path of its library (anything with a '/') or by name, as NAME.so or libNAME.so in
  /// one of the folders. Nodes that were waiting for its types come alive. Returns its name. Throws
  /// GraphError, with file and reason, and leaves everything as it was: no such plug-in, no shared library,
  /// no description, another ABI, a missing symbol, a failure to initialise, a type or command or anything
  /// else that exists already. Loading the same library once more does nothing; then `already` is set.
  std::string load(const std::string& name_or_path, bool* already = nullptr);

  /// Registers a plug-in that is compiled into the program (PLINIAN_LINKED_PLUGIN): it cannot be unloaded,
  /// and scenes that use it do not ask for it. Returns its name. Throws as load() does.
  std::string add_linked(const PlinianLinkedPlugin& plugin);

  /// Unloads a plug-in once running evaluations have ended. Throws GraphError where it is a part of the
  /// program, and, naming nodes of its types, where there are any; with `force` they become unknown ones that
  /// keep everything. Forgets results. Steps of undo stay; those that hold what is of the plug-in wait until
  /// it is loaded again.
  void unload(const std::string& name, bool force);

  struct Loaded {
    PluginDescription description;
    std::string path;  // or "part of the program"
  };
  std::vector<Loaded> plugins() const;
  /// A line for each library that took a program with it when it was loaded last: by its name it is not
  /// loaded any more, by its path it is tried again.
  static std::vector<std::string> skipped();
  /// Entries of menus that plug-ins bring, in the order of registration.
  const std::vector<MenuItem>& menu() const { return menu_; }
  /// The draw override of a node type, or null.
  DrawOverridePtr draw_override(const std::string& node_type) const;
  /// The handles of a node type; none where it has none.
  const std::vector<HandleSpec>& handles(const std::string& node_type) const;
  void add_listener(DrawOverrideListener* listener) { listeners_.push_back(listener); }
  void remove_listener(DrawOverrideListener* listener) { std::erase(listeners_, listener); }
  /// What plug-ins hear; whoever else wants to may listen too.
  EventHub& events() { return events_; }
  const PluginSearch& search() const { return search_; }

 private:
  struct Library;
  void start(Library& library, int (*initialise)(const PlinianHost*));
  std::string adopt(std::unique_ptr<Library> library);
  void enter(Library& library);
  void withdraw(const Library& library);
  void uninitialise(Library& library);
  void remove(Library& library);
  bool revive(const Library& library);
  void warn_of_forgotten(std::size_t steps, const std::string& why);

  graph::Session& session_;
  PluginSearch search_;
  EventHub events_{session_};
  std::vector<MenuItem> menu_;
  std::map<std::string, DrawOverridePtr> draw_overrides_;   // by node type
  std::map<std::string, std::vector<HandleSpec>> handles_;  // by node type
  std::vector<DrawOverrideListener*> listeners_;
  std::map<std::string, std::unique_ptr<Library>> libraries_;
  std::map<std::string, std::filesystem::file_time_type> written_;  // libraries that are in memory, by path
};

}  // namespace plinian::sdk
