// Where plug-ins are found.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/sdk/plugin_description.h"

namespace plinian::sdk {

class PluginSearch {
 public:
  /// folders: to look in, after those of $PLINIAN_PLUGIN_PATH; never the current folder.
  explicit PluginSearch(const std::vector<std::filesystem::path>& folders);

  const std::vector<std::filesystem::path>& folders() const { return folders_; }
  /// The library of a name, as NAME.so or libNAME.so in one of the folders; anything with a '/' is a path.
  /// Throws GraphError where there is none.
  std::string find(const std::string& name) const;
  /// Who brings something ("node:puff", "command:mark") and is not loaded, or none.
  struct Bringer {
    std::string plugin, load;  // its name, and what loadPlugin takes
  };
  std::optional<Bringer> find_bringer(const std::string& what,
                                      const std::function<bool(const std::string& plugin)>& is_loaded) const;
  /// What to say of something that is unknown likewise: which plug-in brings it and how to load it; empty
  /// where none does.
  std::string hint_at(const std::string& what,
                      const std::function<bool(const std::string& plugin)>& is_loaded) const;
  /// Names of a kind ("node:") that plug-ins bring that can be loaded and are not.
  std::vector<std::string> names_of(const std::string& kind,
                                    const std::function<bool(const std::string& plugin)>& is_loaded) const;

 private:
  /// Calls with each plug-in that can be loaded and is not, until `look` returns true.
  void search(const std::function<bool(const std::string& plugin)>& is_loaded,
              const std::function<bool(const PluginDescription&, const std::filesystem::path&)>& look) const;

  std::vector<std::filesystem::path> folders_;
};

}  // namespace plinian::sdk
