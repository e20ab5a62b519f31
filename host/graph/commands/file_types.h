// Files beside scenes that import and export take, by extension.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/graph/commands/command.h"

namespace plinian::graph {

struct FileType {
  std::string name, help;
  std::string plugin;                   // who registers it; empty: the program itself
  std::vector<std::string> extensions;  // in lower case, without the dot
  std::vector<std::string> words;       // what can be named that is no file, as "ash"
  std::vector<std::string> flags{};     // of import that mean something here, beside those for every file
  /// Run as a part of the command, with its arguments; either may be empty. The importer answers with names
  /// of nodes; what it makes outside of the flag's namespace is put there. The exporter finds as "nodes" the
  /// names of all that is to be written, and as "file" a temporary one, which takes its place once it is
  /// written.
  std::function<CommandResult(Session&, const Arguments&)> import_file, export_file;
};

class FileTypeRegistry {
 public:
  /// Throws GraphError where an extension is taken, or is the scenes' own.
  void add(FileType type);
  void remove(const std::string& name);
  /// The type of a file by its name, or of a word, or null.
  const FileType* find(const std::string& path) const;
  std::vector<const FileType*> all() const;
  /// " (did you mean 'ash'?)" behind a word that is nearly one of theirs; else empty.
  std::string nearest_word(const std::string& word) const;
  /// Which plug-in that is not loaded may read a file of an extension, as ": the plug-in 'places' brings
  /// it: loadPlugin places"; empty where none does.
  std::function<std::string(const std::string& extension)> elsewhere;

 private:
  std::map<std::string, FileType> types_;  // by name
};

}  // namespace plinian::graph
