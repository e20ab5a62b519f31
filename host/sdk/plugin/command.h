// Commands in C++.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/sdk/abi.h"
#include "host/sdk/plugin/support.h"

namespace plinian {
namespace PLINIAN_HIDDEN sdk {

/// A running command. Throws Error where another command that it runs fails.
class Call {
 public:
  Call(const PlinianCommandContext& table, PlinianCall* call) : table_(table), call_(call) {}
  bool given(const std::string& argument) const { return table_.given(call_, argument.c_str()) != 0; }
  std::vector<std::string> words(const std::string& argument) const {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < table_.word_count(call_, argument.c_str()); ++i)
      result.push_back(table_.word(call_, argument.c_str(), i));
    return result;
  }
  /// Runs another command as a part of this one; returns what it answers.
  std::string execute(const std::string& line) {
    const char* answers = "";
    if (!table_.execute(call_, line.c_str(), &answers)) throw Error(table_.error(call_));
    return answers;
  }
  void answer(const std::string& line) { table_.answer(call_, line.c_str()); }

 private:
  const PlinianCommandContext& table_;
  PlinianCall* call_;
};

struct Argument {
  std::string name{}, kind = "text", help{};
  bool optional = false;
  bool many = false;  // several words; of a flag: it may be given several times, with a word each
};

struct Command {
  std::string name{}, help{};
  std::vector<Argument> parameters{}, flags{};  // a flag of kind "" takes no word
  std::function<void(Call&)> run{};
};

/// Files that the commands import and export take, by extension. An importer runs commands that make what the
/// file holds and answers with the names of the nodes; the namespace that was asked for they get by
/// themselves. An exporter finds in call.words("nodes") the names of all that is to be written, each once,
/// those that were named or are selected first; it writes to `path`, a temporary file that takes the real
/// one's place when it returns.
struct FileType {
  std::string name{}, help{};
  std::string extensions{};  // "chan" or "obj ply", in lower case
  std::function<void(Call&, const std::string&path)> import_file{}, export_file{};
};

/// An entry of a menu, which runs a command line.
struct MenuEntry {
  std::string path{};  // "Create/Clouds/Ash Column"
  std::string command{}, help{};
};

namespace detail {

inline std::vector<PlinianArgument> plain(const std::vector<Argument>& arguments) {
  std::vector<PlinianArgument> result;
  for (const Argument& a : arguments)
    result.push_back(
        {sizeof(PlinianArgument), a.name.c_str(), a.kind.c_str(), a.help.c_str(), a.optional, a.many});
  return result;
}

// command: stays where it is until the plug-in is uninitialised.
inline int register_command(const PlinianHost& host, Command& command) {
  const auto parameters = plain(command.parameters), flags = plain(command.flags);
  PlinianCommand plain{};
  plain.size = sizeof(PlinianCommand);
  plain.name = command.name.c_str();
  plain.help = command.help.c_str();
  plain.parameters = parameters.data();
  plain.parameter_count = parameters.size();
  plain.flags = flags.data();
  plain.flag_count = flags.size();
  plain.user = &command;
  if (command.run)
    plain.run = [](void* user, const PlinianCommandContext* table, PlinianCall* call) {
      guarded(
          [&] {
            Call wrapped(*table, call);
            static_cast<Command*>(user)->run(wrapped);
          },
          [&](const char* message) { table->fail(call, message); });
    };
  return host.register_command(host.self, &plain);
}

inline int register_file_type(const PlinianHost& host, FileType& type) {
  PlinianFileType plain{};
  plain.size = sizeof(plain);
  plain.name = type.name.c_str();
  plain.help = type.help.c_str();
  plain.extensions = type.extensions.c_str();
  plain.user = &type;
  if (type.import_file)
    plain.import_file = [](void* user, const PlinianCommandContext* table, PlinianCall* call,
                           const char* path) {
      guarded(
          [&] {
            Call wrapped(*table, call);
            static_cast<FileType*>(user)->import_file(wrapped, path);
          },
          [&](const char* message) { table->fail(call, message); });
    };
  if (type.export_file)
    plain.export_file = [](void* user, const PlinianCommandContext* table, PlinianCall* call,
                           const char* path) {
      guarded(
          [&] {
            Call wrapped(*table, call);
            static_cast<FileType*>(user)->export_file(wrapped, path);
          },
          [&](const char* message) { table->fail(call, message); });
    };
  return host.register_file_type(host.self, &plain);
}

inline int register_menu_entry(const PlinianHost& host, const MenuEntry& entry) {
  PlinianMenuEntry plain{};
  plain.size = sizeof(plain);
  plain.path = entry.path.c_str();
  plain.command = entry.command.c_str();
  plain.help = entry.help.c_str();
  return host.register_menu_entry(host.self, &plain);
}

}  // namespace detail

}  // namespace sdk
}  // namespace plinian
