#include "host/graph/commands/file_types.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"
#include "host/graph/values/words.h"

namespace plinian::graph {

void FileTypeRegistry::add(FileType type) {
  const std::string what = "the file type " + shown(type.name);
  if (types_.contains(type.name)) throw GraphError(what + " is already registered");
  if (type.extensions.empty() && type.words.empty()) throw GraphError(what + " has no extension");
  for (const std::string& extension : type.extensions) {
    if (extension == "plinian") throw GraphError(what + " cannot take .plinian, which is for scenes");
    if (const FileType* other = find("file." + extension))
      throw GraphError(what + " cannot take ." + extension + ", which '" + other->name + "' has");
  }
  const std::string name = type.name;
  types_.emplace(name, std::move(type));
}

void FileTypeRegistry::remove(const std::string& name) {
  types_.erase(name);
}

const FileType* FileTypeRegistry::find(const std::string& path) const {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  for (const auto& [name, type] : types_)
    if (std::ranges::count(type.extensions, extension) || std::ranges::count(type.words, path)) return &type;
  return nullptr;
}

std::string FileTypeRegistry::nearest_word(const std::string& word) const {
  std::vector<std::string> words;
  for (const auto& [name, type] : types_) words.insert(words.end(), type.words.begin(), type.words.end());
  return did_you_mean(word, words);
}

std::vector<const FileType*> FileTypeRegistry::all() const {
  std::vector<const FileType*> result;
  for (const auto& [name, type] : types_) result.push_back(&type);
  return result;
}

}  // namespace plinian::graph
