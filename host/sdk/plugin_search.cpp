// Looks through folders, and reads what plug-ins say of themselves without loading them.
#include "host/sdk/plugin_search.h"

#include <algorithm>
#include <cstdlib>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"
#include "host/graph/values/words.h"
#include "host/sdk/plugin_description.h"

namespace plinian::sdk {

namespace fs = std::filesystem;
using graph::GraphError;

PluginSearch::PluginSearch(const std::vector<fs::path>& folders) {
  if (const char* variable = std::getenv("PLINIAN_PLUGIN_PATH")) {
    const std::string list = variable;
    for (std::size_t begin = 0; begin <= list.size();) {
      const std::size_t end = std::min(list.find(':', begin), list.size());
      // An empty or relative entry would mean the current folder, whatever that is.
      if (const fs::path folder = list.substr(begin, end - begin); folder.is_absolute())
        folders_.push_back(folder);
      begin = end + 1;
    }
  }
  folders_.insert(folders_.end(), folders.begin(), folders.end());
}

void PluginSearch::search(const std::function<bool(const std::string&)>& is_loaded,
                          const std::function<bool(const PluginDescription&, const fs::path&)>& look) const {
  for (const fs::path& folder : folders_) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      if (entry.path().extension() != ".so") continue;
      try {
        const PluginDescription found = read_description(entry.path().string());
        if (!is_loaded(found.name) && abi_problem(found).empty() && look(found, entry.path())) return;
      } catch (const GraphError&) {
        // No plug-in.
      }
    }
  }
}

std::optional<PluginSearch::Bringer> PluginSearch::find_bringer(
    const std::string& what, const std::function<bool(const std::string&)>& is_loaded) const {
  std::optional<Bringer> bringer;
  search(is_loaded, [&](const PluginDescription& found, const fs::path& path) {
    if (std::ranges::find(found.registers, what) == found.registers.end()) return false;
    std::string name = path.stem().string();
    std::error_code error;
    if (!fs::exists(path.parent_path() / (name + ".so"), error) || find(name) != path.string())
      name = path.string();
    bringer = Bringer{found.name, name};
    return true;
  });
  return bringer;
}

std::vector<std::string> PluginSearch::names_of(
    const std::string& kind, const std::function<bool(const std::string&)>& is_loaded) const {
  std::vector<std::string> names;
  search(is_loaded, [&](const PluginDescription& found, const fs::path&) {
    for (const std::string& what : found.registers)
      if (what.starts_with(kind)) names.push_back(what.substr(kind.size()));
    return false;
  });
  return names;
}

std::string PluginSearch::hint_at(const std::string& what,
                                  const std::function<bool(const std::string&)>& is_loaded) const {
  const auto found = find_bringer(what, is_loaded);
  return found ? ": the plug-in '" + found->plugin + "' brings it: loadPlugin " +
                     graph::quote_if_needed(found->load)
               : "";
}

std::string PluginSearch::find(const std::string& name) const {
  if (name.find('/') != name.npos) {
    std::error_code error;
    if (!fs::exists(name, error)) throw GraphError(name + ": there is no such file");
    return name;
  }
  for (const fs::path& folder : folders_)
    for (const std::string& file : {name + ".so", "lib" + name + ".so"}) {
      std::error_code error;
      if (fs::is_regular_file(folder / file, error)) return (folder / file).string();
    }
  std::vector<std::string> looked, known;
  for (const fs::path& folder : folders_) {
    looked.push_back(folder.string());
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
      if (entry.path().extension() == ".so") {
        const std::string stem = entry.path().stem().string();
        known.push_back(stem.starts_with("lib") ? stem.substr(3) : stem);
      }
  }
  if (const auto meant = did_you_mean(name, known); !meant.empty())
    throw GraphError("there is no plug-in " + graph::shown(name) + meant);
  throw GraphError("there is no plug-in " + graph::shown(name) + " in " +
                   (looked.empty() ? "any folder: set PLINIAN_PLUGIN_PATH, or give a path" : join(looked)));
}

}  // namespace plinian::sdk
