// One open scene and all that acts on it: what a window, a script and a batch job have in common.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "host/graph/commands/command.h"
#include "host/graph/commands/file_types.h"
#include "host/graph/edits/editor.h"
#include "host/graph/evaluation/evaluator.h"
#include "host/graph/types/type_registry.h"

namespace plinian::graph {

enum class SceneMoment { before_new, after_new, before_open, after_open, before_save, after_save };

/// Is told what a session goes through. Must not throw.
class SessionListener {
 public:
  virtual ~SessionListener() = default;
  /// path: of the file that is opened or saved.
  virtual void passed(SceneMoment moment, const std::string& path) = 0;
  /// A command that no other one runs begins, and is over; failed: what it did was taken back.
  virtual void begun() = 0;
  virtual void ended(bool failed) = 0;
};

class Session {
 public:
  /// A new scene, with the graph's own commands registered; node types come from plug-ins.
  Session();
  explicit Session(const Evaluator::Options& options);

  TypeRegistry& types() { return types_; }
  CommandRegistry& commands() { return commands_; }
  FileTypeRegistry& file_types() { return file_types_; }
  const Graph& graph() const { return graph_; }
  History& history() { return history_; }
  Editor& editor() { return editor_; }
  Evaluator& evaluator() { return evaluator_; }
  const Evaluator& evaluator() const { return evaluator_; }

  /// Runs a line of a script: one command, or nothing but a comment. All its edits are one step of undo,
  /// called by the line; where it throws, what it did is taken back. merge_key: as in History::Scope.
  CommandResult execute(std::string_view line, const std::string& merge_key = "");
  CommandResult execute(const CommandSpec& spec, const Arguments& arguments,
                        const std::string& merge_key = "");

  /// The commands that are being run now, each by the one before it.
  const std::vector<std::string>& running() const { return running_; }

  /// Hears of every command that ran, as the line that would run it again, of warnings, and of what was
  /// assumed.
  std::function<void(const std::string&line)> on_echo, on_warning, on_note;
  /// The line that the command which runs is echoed by, where that is another than it was called by: with the
  /// value that holds. Nothing to a command that another one runs.
  void echo_as(std::string line);
  /// Hears how far a command has come that takes its time [0, 1]; returning false cancels it.
  std::function<bool(double share)> on_progress;
  void warn(const std::string& line) const;
  void note(const std::string& line) const;
  /// Which line of a script is being run, "FILE:3: "; empty: none.
  std::string script_place;
  void add_listener(SessionListener* listener) { listeners_.push_back(listener); }
  void remove_listener(SessionListener* listener) { std::erase(listeners_, listener); }
  /// Is told of each plug-in that a scene needs before the scene is opened, and may load it. Returns the
  /// version that is loaded; empty for none.
  std::function<std::string(const std::string& plugin)> on_requires;

  /// An empty scene but for a time node; the old one cannot be had back.
  void new_scene();
  /// What `make` makes in place of the scene, as one step of undo called `name`; listeners are told of a new
  /// scene once it is there. Where it returns false or throws, everything is as it was. Returns what it did.
  bool replace_scene(const std::string& name, const std::function<bool()>& make);
  /// What is there is a new scene from now on: of no file, with nothing to undo and nothing unsaved.
  void make_untitled();
  /// Throws GraphError and leaves the scene as it is where the file cannot be read.
  void open_scene(const std::string& path);
  /// Opens what was kept of a scene that was not saved: as the scene of `scene_path`, which may be empty,
  /// with unsaved changes. Throws as open_scene().
  void recover_scene(const std::string& file, const std::string& scene_path);
  /// Adds a scene's nodes to this one.
  std::vector<NodeId> import_scene(const std::string& path, const std::string& name_space);
  /// path: empty for the scene's own. Throws where there is none, or where a newer format would be lost.
  void save_scene(const std::string& path);

  /// Of the file of the scene; empty before it was saved.
  const std::string& scene_path() const { return scene_path_; }
  /// What relative paths in the scene are relative to.
  std::filesystem::path scene_folder() const;
  bool is_read_only() const { return read_only_; }

  /// The node that tells the time; made where there is none.
  NodeId time_node();

 private:
  class Doing;
  void tell(SceneMoment moment, const std::string& path = "");
  void take_scene(const std::string& file, const std::string& scene_path, bool saved);

  TypeRegistry types_;
  CommandRegistry commands_;
  FileTypeRegistry file_types_;
  std::vector<SessionListener*> listeners_;
  Graph graph_;
  History history_{graph_};
  Editor editor_{graph_, history_};
  Evaluator evaluator_;
  std::string scene_path_;
  bool read_only_ = false;
  std::vector<std::string> running_;  // commands, each run by the one before it
  std::string echo_;                  // of the first of them; empty: as it was called
};

/// A script that an interrupt (Evaluator::set_interrupt) has ended; names file and line.
struct ScriptInterrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A line of a script holds no more. [bytes]
inline constexpr std::size_t longest_script_line = std::size_t(16) << 20;

/// Runs the lines of a script, each as it comes. next: empty at the end. name: of the file, for errors.
/// Throws GraphError that names file and line, and ScriptInterrupted. answer: is given the lines that
/// commands answer with. on_error: where there is one, it is told of a line that fails, and the script goes
/// on.
void run_script(Session& session, const std::function<std::optional<std::string>()>& next,
                const std::string& name, const std::function<void(const std::string&)>& answer,
                const std::function<void(const std::string&)>& on_error = {});
/// ... of a text.
void run_script(Session& session, std::string_view text, const std::string& name,
                const std::function<void(const std::string&)>& answer);

/// The commands of the graph, by theme; each file registers its own.
void add_node_commands(CommandRegistry& commands);
void add_attribute_commands(CommandRegistry& commands);
void add_connection_commands(CommandRegistry& commands);
void add_selection_commands(CommandRegistry& commands);
void add_time_commands(CommandRegistry& commands);
void add_file_commands(CommandRegistry& commands);
void add_session_commands(CommandRegistry& commands);

/// Why nothing will come of an attribute that is keyed or driven: another one of the node, which it is shown
/// for, reads otherwise. One line with what to do; empty where nothing is against it.
std::string without_effect(const Graph& graph, const Plug& plug);

/// Nodes by names and patterns with * and ?, each once. Throws GraphError for a name that is none and a
/// pattern that matches nothing.
std::vector<NodeId> matching_nodes(const Graph& graph, const std::vector<std::string>& patterns);

/// Plugs by names, NODE.ATTRIBUTE, each once. Both parts may be patterns with * and ?: then whatever matches
/// both is meant that `takes` takes, of what holds others and of arrays what they hold. Throws GraphError for
/// a name that is none and a pattern that matches nothing.
std::vector<Plug> matching_plugs(const Graph& graph, const std::vector<std::string>& patterns,
                                 const std::function<bool(const Plug& plug)>& takes);

/// Nodes as above or, where none are named, the selection. Throws GraphError where nothing is selected
/// either.
std::vector<NodeId> nodes_or_selection(Session& session, const std::vector<std::string>& patterns);

std::vector<std::string> names_of(const Graph& graph, const std::vector<NodeId>& nodes);

}  // namespace plinian::graph
