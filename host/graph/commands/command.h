// A command is declared once; parsing, help, echo and whatever calls it from outside derive from the
// declaration.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/graph/types/names_elsewhere.h"
#include "host/graph/values/words.h"

namespace plinian::graph {

class Session;

/// What an argument must be, and what an interface may offer for it.
enum class ArgumentKind { text, number, integer, node, plug, type, path, value, command };

struct CommandParameter {
  std::string name;
  ArgumentKind kind = ArgumentKind::text;
  std::string help;
  bool optional = false;
  bool many = false;  // takes all words that are left (but one for each parameter after it)
};

struct CommandFlag {
  std::string name;  // without the hyphen
  std::string help;
  std::optional<ArgumentKind> takes;  // a word, or none: then it is on where it is given
  bool many = false;                  // may be given several times; its words are those of all of them
  bool vector = false;                // takes the numbers too that follow its word
};

/// Words of a call, by the name of the parameter or flag that they were given for.
class Arguments {
 public:
  bool has(const std::string& name) const { return words_.contains(name); }
  /// All words given for it; none where it was left out.
  const std::vector<Word>& words(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;
  /// The first word, or `otherwise`.
  std::string text(const std::string& name, const std::string& otherwise = "") const;
  std::optional<double> number(const std::string& name) const;
  void set(const std::string& name, std::vector<Word> words) { words_[name] = std::move(words); }

 private:
  std::map<std::string, std::vector<Word>> words_;
};

/// Lines that a command answers with.
using CommandResult = std::vector<std::string>;

struct CommandSpec {
  std::string name;
  std::string help;  // one sentence
  std::vector<CommandParameter> parameters;
  std::vector<CommandFlag> flags;
  std::function<CommandResult(Session&, const Arguments&)> run;
  bool handles_history = false;  // moves between steps of undo, or forgets them, instead of being one
};

/// The arguments in the words of a call (without the command itself). Throws GraphError, naming the command,
/// for an unknown flag (with the nearest one), a missing or superfluous word and a word that is no number.
Arguments parse_arguments(const CommandSpec& spec, const std::vector<Word>& words);

/// The call as a line that parses to the same arguments.
std::string write_call(const CommandSpec& spec, const Arguments& arguments);

/// "setAttr PLUG VALUE..." and, in `lines`, what each of it means.
std::string usage(const CommandSpec& spec);
std::vector<std::string> help_lines(const CommandSpec& spec);

class CommandRegistry {
 public:
  /// Throws GraphError where the name is taken.
  void add(CommandSpec spec);
  void remove(const std::string& name) { commands_.erase(name); }
  /// Gives a command more flags; those that it has stay as they are.
  void add_flags(const std::string& name, const std::vector<CommandFlag>& flags);
  /// The command of that name. Throws GraphError with the nearest name.
  const CommandSpec& get(const std::string& name) const;
  std::vector<std::string> names() const;
  /// Commands that are not there and could be.
  NamesElsewhere elsewhere;

 private:
  std::map<std::string, CommandSpec> commands_;
};

}  // namespace plinian::graph
