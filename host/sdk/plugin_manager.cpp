// Plug-ins: dlopen, and everything that must hold before and after.
#include "host/sdk/plugin_manager.h"

#include <dlfcn.h>

#include <algorithm>

#include "core/scene/nearest_word.h"
#include "host/graph/edits/sleep.h"
#include "host/graph/files/scene_writer.h"
#include "host/graph/files/unknown_nodes.h"
#include "host/graph/graph_error.h"
#include "host/sdk/inside_plugin.h"
#include "host/sdk/load_marker.h"
#include "host/sdk/plugin_commands.h"

namespace plinian::sdk {

namespace fs = std::filesystem;
using graph::GraphError;

namespace {

std::string skipped_text(const std::string& path) {
  return path + ": did not come back when it was loaded last, and is skipped; 'loadPlugin " + path +
         "' tries it again";
}

}  // namespace

struct PluginManager::Library {
  explicit Library(EventHub& events) : registrar(&events) {}

  PluginDescription description;
  std::string path;
  void* handle = nullptr;  // null: linked in
  PluginRegistrar registrar;
  void (*uninitialise)(const PlinianHost*) = nullptr;
  std::vector<graph::NodeTypePtr> types;
  std::vector<std::string> commands, data_types, file_types;
};

PluginManager::PluginManager(graph::Session& session, std::vector<fs::path> folders)
    : session_(session), search_(std::move(folders)) {
  add_plugin_commands(session_.commands(), *this);
  const auto elsewhere = [this](const std::string& kind) {
    const auto is_loaded = [this](const std::string& plugin) { return libraries_.contains(plugin); };
    return graph::NamesElsewhere{
        [=, this](const std::string& name) { return search_.hint_at(kind + name, is_loaded); },
        [=, this] { return search_.names_of(kind, is_loaded); }};
  };
  session_.types().elsewhere = elsewhere("node:");
  session_.commands().elsewhere = elsewhere("command:");
  session_.file_types().elsewhere = [this](const std::string& extension) {
    const auto is_loaded = [this](const std::string& plugin) { return libraries_.contains(plugin); };
    // A description names file types, which are mostly called as their files end.
    if (const std::string hint = search_.hint_at("file:" + extension, is_loaded); !hint.empty()) return hint;
    std::string others;
    for (const std::string& type : search_.names_of("file:", is_loaded))
      others += (others.empty() ? "; plug-ins that are not loaded read others: the file type '"
                                : ", the file type '") +
                type + "'" + search_.hint_at("file:" + type, is_loaded);
    return others;
  };
  session_.on_requires = [this](const std::string& name) {
    try {
      if (const auto loaded = libraries_.find(name); loaded != libraries_.end())
        return loaded->second->description.version;
      // A scene is data: it names plug-ins that are installed, and cannot point at a file.
      if (name.find('/') != name.npos) throw GraphError("the scene needs a plug-in " + graph::shown(name));
      return libraries_.at(load(name))->description.version;
    } catch (const GraphError& error) {
      session_.warn(error.what());  // the scene opens all the same
      return std::string();
    }
  };
}

PluginManager::~PluginManager() {
  session_.on_requires = nullptr;
  session_.types().elsewhere = session_.commands().elsewhere = {};
  session_.file_types().elsewhere = nullptr;
  graph::drop_unwritable_data(session_.editor());
  session_.history().forget_steps();
  while (!libraries_.empty()) remove(*libraries_.begin()->second);
  remove_plugin_commands(session_.commands());
}

std::string PluginManager::load(const std::string& name_or_path, bool* already) {
  auto library = std::make_unique<Library>(events_);
  library->path = search_.find(name_or_path);
  const auto refuse = [&](const std::string& why) -> GraphError {
    return GraphError(library->path + ": " + why);
  };
  library->description = read_description(library->path);
  if (name_or_path.find('/') == name_or_path.npos && LoadMarker::is_left(library->path))
    throw GraphError(skipped_text(library->path));
  const PluginDescription& description = library->description;
  library->registrar.set_name("the plug-in '" + description.name + "'");
  if (const std::string problem = abi_problem(description); !problem.empty()) throw refuse(problem);
  if (const auto loaded = libraries_.find(description.name); loaded != libraries_.end()) {
    if (revive(*loaded->second)) return description.name;
    // A script that asks for it also works on a scene that brought it.
    std::error_code ignored;
    if (fs::equivalent(loaded->second->path, library->path, ignored)) {
      if (already) *already = true;
      return description.name;
    }
    throw refuse("the plug-in '" + description.name + "' is loaded already, from " + loaded->second->path);
  }

  // Whoever loads a library that is still in memory gets that one, whatever its file holds by now.
  std::error_code no_time;
  const auto written = fs::last_write_time(library->path, no_time);
  if (void* mapped = ::dlopen(fs::absolute(library->path).c_str(), RTLD_NOW | RTLD_NOLOAD)) {
    ::dlclose(mapped);
    const auto before = written_.find(library->path);
    if (before != written_.end() && before->second != written)
      session_.warn(library->path +
                    ": has changed, but something still holds data of what was loaded before, which is used "
                    "again: start anew to use what is in the file");
  } else {
    written_[library->path] = written;
  }
  const LoadMarker marker(library->path);
  {
    const InsidePlugin inside(library->registrar.name(), "being loaded");
    library->handle = ::dlopen(fs::absolute(library->path).c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  if (!library->handle) {
    const char* why = ::dlerror();
    throw refuse(std::string("cannot be loaded: ") + (why ? why : "no reason is given"));
  }
  // Whatever fails from here on, the library goes as it came.
  struct Closer {
    Library* library;
    ~Closer() {
      if (!library) return;
      library->registrar.clear();
      ::dlclose(library->handle);
    }
  } closer{library.get()};
  const auto symbol = [&](const char* name) {
    void* found = ::dlsym(library->handle, name);
    if (!found) throw refuse(std::string("lacks the function ") + name);
    return found;
  };
  const auto initialise = reinterpret_cast<int (*)(const PlinianHost*)>(symbol("plinian_initialise"));
  library->uninitialise = reinterpret_cast<void (*)(const PlinianHost*)>(symbol("plinian_uninitialise"));
  start(*library, initialise);
  closer.library = nullptr;
  return adopt(std::move(library));
}

std::string PluginManager::add_linked(const PlinianLinkedPlugin& plugin) {
  auto library = std::make_unique<Library>(events_);
  library->description = parse_description(plugin.description, "a plug-in of the program");
  library->path = "part of the program";
  if (libraries_.contains(library->description.name))
    throw GraphError("the plug-in '" + library->description.name + "' is loaded already");
  library->registrar.set_name("the plug-in '" + library->description.name + "'");
  library->uninitialise = plugin.uninitialise;
  start(*library, plugin.initialise);
  return adopt(std::move(library));
}

// Runs a plug-in's initialisation and registers what it brings: all of it, or, where it throws, nothing.
void PluginManager::start(Library& library, int (*initialise)(const PlinianHost*)) {
  const auto refuse = [&](const std::string& why) -> GraphError {
    return GraphError(library.path + ": " + why);
  };
  bool success = false;
  try {
    const InsidePlugin inside(library.registrar.name(), "being initialised");
    success = initialise(&library.registrar.host()) != 0;
  } catch (...) {
    throw refuse("failed to initialise: it threw an exception");  // one that does not use plugin.h
  }
  const auto back_out = [&](const std::string& why) {
    withdraw(library);
    library.types.clear();
    library.registrar.subscriptions.clear();
    uninitialise(library);
    throw refuse(why);
  };
  if (!success || !library.registrar.error.empty())
    back_out("failed to initialise: " +
             (library.registrar.error.empty() ? std::string("no reason is given") : library.registrar.error));
  if (const std::string problem = registers_problem(library.description, library.registrar); !problem.empty())
    back_out(problem);
  try {
    enter(library);
  } catch (const GraphError& error) {
    back_out(error.what());
  }
  library.registrar.clear();
}

void PluginManager::uninitialise(Library& library) {
  const InsidePlugin inside(library.registrar.name(), "being uninitialised");
  library.uninitialise(&library.registrar.host());
}

// Puts what a plug-in registers where it belongs. Throws GraphError halfway.
void PluginManager::enter(Library& library) {
  PluginRegistrar& registrar = library.registrar;
  // A scene need not name what is a part of the program.
  const std::string plugin = library.handle ? library.description.name : "";
  for (graph::DataType& type : registrar.data_types) {
    const std::string name = type.name;
    type.plugin = plugin;
    session_.types().add_data_type(std::move(type));
    library.data_types.push_back(name);
  }
  for (graph::NodeTypeSpec& spec : registrar.node_types) {
    spec.plugin = plugin;
    if (library.handle) spec.plugin_version = library.description.version;
    library.types.push_back(session_.types().add(std::move(spec)));
  }
  for (graph::CommandSpec& spec : registrar.commands) {
    const std::string name = spec.name;
    session_.commands().add(std::move(spec));
    library.commands.push_back(name);
  }
  for (graph::FileType& type : registrar.file_types) {
    const std::string name = type.name;
    type.plugin = plugin;
    session_.file_types().add(std::move(type));
    library.file_types.push_back(name);
  }
  for (const DrawOverride& override : registrar.draw_overrides)
    draw_overrides_[override.node_type] = std::make_shared<const DrawOverride>(override);
  for (auto& [type, handles] : registrar.handles) handles_[type] = std::move(handles);
  for (MenuItem& entry : registrar.menu) {
    for (const MenuItem& other : menu_)
      if (other.path == entry.path)
        throw GraphError("the menu entry '" + entry.path + "' is already registered");
    entry.plugin = library.description.name;
    menu_.push_back(std::move(entry));
  }
}

// Nobody finds what the plug-in registered any more.
void PluginManager::withdraw(const Library& library) {
  for (const graph::NodeTypePtr& type : library.types) {
    session_.types().remove(type->name());
    draw_overrides_.erase(type->name());
    handles_.erase(type->name());
  }
  for (const std::string& command : library.commands) session_.commands().remove(command);
  for (const std::string& type : library.data_types) session_.types().remove_data_type(type);
  for (const std::string& type : library.file_types) session_.file_types().remove(type);
  std::erase_if(menu_, [&](const MenuItem& entry) { return entry.plugin == library.description.name; });
}

std::string PluginManager::adopt(std::unique_ptr<Library> library) {
  const std::string name = library->description.name;
  const Library& kept = *libraries_.emplace(name, std::move(library)).first->second;
  graph::History& history = session_.history();
  std::size_t forgotten = 0;
  for (const graph::NodeTypePtr& type : kept.types) forgotten += graph::wake(history, type);
  for (const std::string& type : kept.data_types)
    forgotten += graph::wake(history, *session_.types().find_data_type(type));
  warn_of_forgotten(forgotten, "the plug-in '" + name + "' does not declare what it did when they were made");
  // Where nothing happened since it went it is as if it had stayed. Nodes may have been waiting even then.
  history.take_back_form("unload " + name);
  revive(kept);
  return name;
}

// Nodes and data that were waiting for the plug-in come alive. Returns whether there were any.
bool PluginManager::revive(const Library& library) {
  const std::string& name = library.description.name;
  const std::uint64_t before = session_.history().steps_made();
  {
    const graph::History::Scope scope(session_.history(), "loadPlugin " + name,
                                      graph::History::Scope::Form{"load " + name});
    for (const graph::NodeTypePtr& type : library.types)
      for (const std::string& warning : graph::revive_nodes(session_.editor(), type)) session_.warn(warning);
    for (const std::string& type : library.data_types)
      for (const std::string& warning : graph::revive_data(session_.editor(), type)) session_.warn(warning);
  }
  return session_.history().steps_made() != before;
}

void PluginManager::warn_of_forgotten(std::size_t steps, const std::string& why) {
  if (steps > 0)
    session_.warn(std::to_string(steps) + (steps == 1 ? " step" : " steps") +
                  " of undo cannot be had any more: " + why);
}

void PluginManager::unload(const std::string& name, bool force) {
  const auto found = libraries_.find(name);
  if (found == libraries_.end()) {
    std::vector<std::string> known;
    for (const auto& [loaded, library] : libraries_) known.push_back(loaded);
    throw GraphError("the plug-in " + graph::shown(name) + " is not loaded" + did_you_mean(name, known));
  }
  Library& library = *found->second;
  if (events_.is_delivering())
    throw GraphError("the plug-in '" + name + "' cannot be unloaded by an event callback");
  if (!library.handle) throw GraphError("the plug-in '" + name + "' is a part of the program and stays");
  std::vector<std::string> users;
  for (const graph::Node* node : session_.graph().nodes())
    if (node->type->spec().plugin == name && !node->type->is_unknown()) users.push_back(node->name);
  if (!users.empty() && !force) {
    const std::size_t count = users.size();
    if (count > 5) users.resize(5);
    throw GraphError("the plug-in '" + name + "' is in use by " + join(users) +
                     (count > 5 ? " and " + std::to_string(count - 5) + " more" : "") +
                     ": delete them, or give -force to keep them as unknown nodes");
  }
  try {
    // All that nodes hold will be lines: what cannot be written would be lost halfway.
    for (const graph::Node* node : session_.graph().nodes()) graph::node_lines(session_.graph(), *node);
  } catch (const GraphError& error) {
    throw GraphError("the plug-in '" + name + "' cannot be unloaded: " + error.what());
  }
  remove(library);
}

void PluginManager::remove(Library& library) {
  for (const graph::NodeTypePtr& type : library.types)
    if (draw_overrides_.contains(type->name()))
      for (DrawOverrideListener* listener : listeners_) listener->goes(type->name());
  graph::History& history = session_.history();
  const std::string name = library.description.name;
  {
    const graph::History::Scope scope(history, "unloadPlugin " + name,
                                      graph::History::Scope::Form{"unload " + name});
    for (const graph::NodeTypePtr& type : library.types) graph::forget_type(session_.editor(), type);
    for (const std::string& type : library.data_types) graph::forget_data(session_.editor(), type);
  }
  // Steps of undo hold nodes and data whose code goes.
  for (const graph::NodeTypePtr& type : library.types) graph::put_to_sleep(history, type);
  std::size_t forgotten = 0;
  for (const std::string& type : library.data_types)
    forgotten += graph::put_to_sleep(history, *session_.types().find_data_type(type));
  warn_of_forgotten(forgotten, "they hold data of the plug-in '" + name + "' that cannot be written");
  withdraw(library);
  library.registrar.subscriptions.clear();
  // Nothing of it may run any more, nor be held, before it goes.
  session_.evaluator().cancel_all();
  session_.evaluator().finish();
  session_.evaluator().forget();
  session_.graph().snapshot();  // in the place of the last one, which holds nodes as they were
  library.types.clear();
  uninitialise(library);
  // Somebody, a picture on the screen for instance, may still hold data that the library must release: then
  // it stays.
  if (library.handle && library.registrar.data->objects == 0) ::dlclose(library.handle);
  libraries_.erase(name);
}

const std::vector<HandleSpec>& PluginManager::handles(const std::string& node_type) const {
  static const std::vector<HandleSpec> none;
  const auto found = handles_.find(node_type);
  return found == handles_.end() ? none : found->second;
}

DrawOverridePtr PluginManager::draw_override(const std::string& node_type) const {
  const auto found = draw_overrides_.find(node_type);
  return found == draw_overrides_.end() ? nullptr : found->second;
}

std::vector<std::string> PluginManager::skipped() {
  std::vector<std::string> lines;
  for (const std::string& library : LoadMarker::left()) lines.push_back(skipped_text(library));
  return lines;
}

std::vector<PluginManager::Loaded> PluginManager::plugins() const {
  std::vector<Loaded> result;
  for (const auto& [name, library] : libraries_) result.push_back({library->description, library->path});
  return result;
}

}  // namespace plinian::sdk
