// Sessions, and the scripts that run in them.
#include "host/graph/commands/session.h"

#include <algorithm>
#include <chrono>
#include <future>

#include "core/files/atomic_file.h"
#include "core/scene/nearest_word.h"
#include "host/graph/edits/clear.h"
#include "host/graph/files/scene_reader.h"
#include "host/graph/files/scene_writer.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

Session::Session() : Session(Evaluator::Options()) {}

Session::Session(const Evaluator::Options& options) : evaluator_(graph_, options) {
  add_node_commands(commands_);
  add_attribute_commands(commands_);
  add_connection_commands(commands_);
  add_selection_commands(commands_);
  add_time_commands(commands_);
  add_file_commands(commands_);
  add_session_commands(commands_);
  graph_.is_registered = [this](const std::string& type) { return types_.find(type) != nullptr; };
  evaluator_.on_warning = [this](const std::string& line) { warn(line); };
  new_scene();
}

void Session::tell(SceneMoment moment, const std::string& path) {
  for (SessionListener* listener : std::vector<SessionListener*>(listeners_)) listener->passed(moment, path);
}

void Session::note(const std::string& line) const {
  if (on_note) on_note(line);
}

void Session::warn(const std::string& line) const {
  if (on_warning) on_warning(line);
}

void Session::echo_as(std::string line) {
  if (running_.size() == 1) echo_ = std::move(line);
}

// Listeners hear of the outermost of what is done.
class Session::Doing {
 public:
  Doing(Session& session, const std::string& what) : session_(session) {
    if (session.running_.empty())
      for (SessionListener* listener : std::vector<SessionListener*>(session.listeners_)) listener->begun();
    session.running_.push_back(what);
  }
  Doing(const Doing&) = delete;
  Doing& operator=(const Doing&) = delete;
  ~Doing() {
    session_.running_.pop_back();
    if (!session_.running_.empty()) return;
    for (SessionListener* listener : std::vector<SessionListener*>(session_.listeners_))
      listener->ended(failed_);
  }
  void succeeded() { failed_ = false; }

 private:
  Session& session_;
  bool failed_ = true;
};

CommandResult Session::execute(std::string_view line, const std::string& merge_key) {
  std::vector<Word> words = split_words(line);
  if (words.empty()) return {};
  const CommandSpec& spec = commands_.get(words.front().text);
  words.erase(words.begin());
  return execute(spec, parse_arguments(spec, words), merge_key);
}

// Before the stack ends. Whoever runs itself is told by which way.
static void check_depth(const std::vector<std::string>& running, const std::string& next) {
  constexpr std::size_t deepest = 64;
  if (running.size() < deepest) return;
  const auto before = std::find(running.rbegin(), running.rend(), next);
  const auto first = before == running.rend() ? running.begin() : std::prev(before.base());
  throw GraphError("commands run one another without an end: " +
                   join(std::vector<std::string>(first, running.end()), " > ") + " > " + next);
}

CommandResult Session::execute(const CommandSpec& spec, const Arguments& arguments,
                               const std::string& merge_key) {
  check_depth(running_, spec.name);
  Doing doing(*this, spec.name);
  if (spec.handles_history && running_.size() > 1)
    throw GraphError(spec.name + ": cannot be run by another command");
  const std::string call = write_call(spec, arguments);
  if (running_.size() == 1) echo_.clear();
  CommandResult result;
  if (spec.handles_history) {
    result = spec.run(*this, arguments);
  } else {
    const History::Scope scope(history_, call, merge_key);
    result = spec.run(*this, arguments);
  }
  if (running_.size() == 1 && on_echo) on_echo(echo_.empty() ? call : echo_);
  doing.succeeded();
  return result;
}

void Session::new_scene() {
  tell(SceneMoment::before_new);
  {
    const History::Scope scope(history_, "newScene");
    clear_graph(editor_);
    // A program without node types has an empty scene.
    if (const NodeTypePtr time = types_.find("time")) editor_.create_node(time);
  }
  make_untitled();
  evaluator_.set_time(1.0);
  tell(SceneMoment::after_new);
}

bool Session::replace_scene(const std::string& name, const std::function<bool()>& make) {
  Doing doing(*this, name);
  tell(SceneMoment::before_new);
  {
    History::Scope scope(history_, name);
    clear_graph(editor_);
    time_node();
    if (!make()) {
      scope.roll_back();
      return false;
    }
  }
  tell(SceneMoment::after_new);
  doing.succeeded();
  return true;
}

void Session::make_untitled() {
  history_.clear();
  history_.mark_saved();
  scene_path_.clear();
  read_only_ = false;
  evaluator_.set_folder(scene_folder().string());
}

void Session::open_scene(const std::string& path) {
  take_scene(path, std::filesystem::absolute(path).lexically_normal().string(), true);
}

void Session::recover_scene(const std::string& file, const std::string& scene_path) {
  take_scene(file, scene_path, false);
}

// Reads a file in place of the scene.
void Session::take_scene(const std::string& file, const std::string& scene_path, bool saved) {
  tell(SceneMoment::before_open, file);
  SceneReport report, versions;
  const std::string text = read_text_file(file);
  for (const RequiredPlugin& plugin : required_plugins(text, file))
    if (const std::string version = on_requires ? on_requires(plugin.name) : ""; !version.empty())
      compare_version(plugin, version, file, versions);
  {
    const History::Scope scope(history_, "open");
    clear_graph(editor_);
    report = read_scene(text, file, types_, editor_);
  }
  report.read_only = report.read_only || versions.read_only;
  report.warnings.insert(report.warnings.begin(), versions.warnings.begin(), versions.warnings.end());
  history_.clear();
  saved ? history_.mark_saved() : history_.mark_modified();
  scene_path_ = scene_path;
  read_only_ = report.read_only;
  evaluator_.set_folder(scene_folder().string());
  for (const Node* node : graph_.nodes())
    if (const AttributeIndex start = node->schema->find("start");
        node->type->spec().time_source && start >= 0) {
      evaluator_.set_time(std::get<double>(node->value(start)));
      break;
    }
  for (const std::string& warning : report.warnings) warn(warning);
  tell(SceneMoment::after_open, scene_path_);
}

std::vector<NodeId> Session::import_scene(const std::string& path, const std::string& name_space) {
  const SceneReport report = read_scene(read_text_file(path), path, types_, editor_, name_space);
  for (const std::string& warning : report.warnings) warn(warning);
  for (const std::string& own : names_of(graph_, report.shared))
    note(path + ": " + own + " stays as it is here");
  return report.nodes;
}

// A disk may take seconds to confirm: where somebody looks on, what is looked at goes on being drawn. What
// has begun is not cancelled.
static void wait_beside(const std::function<bool(double)>& on_progress, const std::function<void()>& work) {
  if (!on_progress) return work();
  std::future<void> done = std::async(std::launch::async, work);
  while (done.wait_for(std::chrono::milliseconds(10)) != std::future_status::ready) on_progress(0.0);
  done.get();
}

void Session::save_scene(const std::string& path) {
  const std::string target =
      path.empty() ? scene_path_ : std::filesystem::absolute(path).lexically_normal().string();
  if (target.empty()) throw GraphError("save: the scene has no file yet: save FILE");
  if (read_only_ && target == scene_path_)
    throw GraphError("save: " + target +
                     " was made by a newer version and is read-only here: save it under another name");
  tell(SceneMoment::before_save, target);
  try {
    const std::string text = write_scene(graph_, std::filesystem::path(target).parent_path());
    wait_beside(on_progress, [&] { graph::save_scene(target, text); });
  } catch (const FileError& error) {
    throw GraphError(std::string("save: ") + error.what());
  }
  scene_path_ = target;
  evaluator_.set_folder(scene_folder().string());
  read_only_ = false;
  history_.mark_saved();
  tell(SceneMoment::after_save, target);
}

std::filesystem::path Session::scene_folder() const {
  return scene_path_.empty() ? std::filesystem::current_path()
                             : std::filesystem::path(scene_path_).parent_path();
}

NodeId Session::time_node() {
  for (const Node* node : graph_.nodes())
    if (node->type->spec().time_source) return node->id;
  return editor_.create_node(types_.get("time"));
}

void run_script(Session& session, const std::function<std::optional<std::string>()>& next,
                const std::string& name, const std::function<void(const std::string&)>& answer,
                const std::function<void(const std::string&)>& on_error) {
  std::string& where = session.script_place;
  struct Leave {
    std::string& place;
    ~Leave() { place.clear(); }
  } leave{where};
  int number = 0;
  const auto check_interrupted = [&] {
    if (session.evaluator().is_interrupted())
      throw ScriptInterrupted(where + "cancelled here; what the lines before it did is done");
  };
  while (std::optional<std::string> line = next()) {
    if (number == 0 && line->starts_with("\xef\xbb\xbf")) line->erase(0, 3);  // editors put it there
    where = name + ":" + std::to_string(++number) + ": ";
    check_interrupted();
    if (line->size() > longest_script_line)
      throw GraphError(where + "the line is longer than " + std::to_string(longest_script_line >> 20) +
                       " MiB: this is no script");
    try {
      for (const std::string& reply : session.execute(*line))
        if (answer) answer(reply);
    } catch (const EvaluationCancelled&) {
      check_interrupted();
      throw;
    } catch (const std::exception& error) {
      check_interrupted();  // also ends helpers of ours, whose end is then an error
      if (!on_error) throw GraphError(where + error.what());
      on_error(where + error.what());
    }
  }
  where = name + ":" + std::to_string(number + 1) + ": ";
  check_interrupted();
}

void run_script(Session& session, std::string_view text, const std::string& name,
                const std::function<void(const std::string&)>& answer) {
  const auto next = [&]() -> std::optional<std::string> {
    if (text.empty()) return std::nullopt;
    const std::size_t length = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
    return line;
  };
  run_script(session, next, name, answer);
}

}  // namespace plinian::graph
