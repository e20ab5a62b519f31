// Finds and reads descriptions. The ELF file is taken for hostile: every offset is checked before it is used.
#include "host/sdk/plugin_description.h"

#include <elf.h>

#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "host/graph/graph_error.h"
#include "host/graph/values/words.h"
#include "host/sdk/abi.h"

namespace plinian::sdk {

namespace {

using graph::GraphError;

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw GraphError(path + ": cannot be read");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// A structure at an offset of the file; false where it does not fit.
template <class T>
bool read_at(const std::string& file, std::uint64_t offset, T& result) {
  if (offset > file.size() || file.size() - offset < sizeof(T)) return false;
  std::memcpy(&result, file.data() + offset, sizeof(T));
  return true;
}

bool is_library(const std::string& file) {
  Elf64_Ehdr header;
  return read_at(file, 0, header) && std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 &&
         header.e_ident[EI_CLASS] == ELFCLASS64 && header.e_type == ET_DYN;
}

// The text of the note in section .note.plinian, or empty.
std::string find_note(const std::string& file) {
  Elf64_Ehdr header;
  Elf64_Shdr names, section;
  if (!read_at(file, 0, header) || header.e_shentsize != sizeof(Elf64_Shdr)) return "";
  const auto section_at = [&](std::uint64_t index, Elf64_Shdr& result) {
    return header.e_shoff < file.size() && read_at(file, header.e_shoff + index * sizeof(Elf64_Shdr), result);
  };
  if (!section_at(header.e_shstrndx, names)) return "";
  for (std::uint64_t i = 0; i < header.e_shnum; ++i) {
    constexpr char wanted[] = ".note.plinian";
    char name[sizeof(wanted)];
    if (!section_at(i, section)) return "";
    if (names.sh_offset > file.size() || !read_at(file, names.sh_offset + section.sh_name, name)) continue;
    if (std::memcmp(name, wanted, sizeof(wanted)) != 0) continue;
    Elf64_Nhdr note;
    char owner[8];
    if (section.sh_offset > file.size() || !read_at(file, section.sh_offset, note) || note.n_namesz != 8 ||
        !read_at(file, section.sh_offset + sizeof(note), owner) || std::memcmp(owner, "Plinian", 8) != 0)
      return "";
    const std::uint64_t begin = section.sh_offset + sizeof(note) + sizeof(owner);
    if (begin > file.size() || file.size() - begin < note.n_descsz) return "";
    return std::string(file.data() + begin, strnlen(file.data() + begin, note.n_descsz));
  }
  return "";
}

}  // namespace

PluginDescription read_description(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw GraphError(path + ": is a folder, not a plug-in");
  const std::string file = read_file(path);
  if (!is_library(file)) throw GraphError(path + ": is not a shared library");
  std::string text = find_note(file);
  if (text.empty() && std::filesystem::exists(path + ".plinian", error)) text = read_file(path + ".plinian");
  if (text.empty())
    throw GraphError(path + ": is no plug-in: it has neither a description within nor a file " + path +
                     ".plinian");
  return parse_description(text, path);
}

PluginDescription parse_description(const std::string& text, const std::string& path) {
  PluginDescription description;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t space = line.find(' ');
    const std::string key = line.substr(0, space), value = space == line.npos ? "" : line.substr(space + 1);
    if (key == "name") description.name = value;
    if (key == "version") description.version = value;
    if (key == "vendor") description.vendor = value;
    if (key == "abi") {
      const std::size_t dot = value.find('.');
      const auto number = [&](std::size_t begin, std::size_t end, int& result) {
        const auto [rest, failed] = std::from_chars(value.data() + begin, value.data() + end, result);
        return failed == std::errc() && rest == value.data() + end;
      };
      if (dot == value.npos || !number(0, dot, description.abi_major) ||
          !number(dot + 1, value.size(), description.abi_minor))
        throw GraphError(path + ": its description has no ABI version: " + graph::shown(value));
    }
    if (key == "registers") {
      std::istringstream words(value);
      for (std::string word; words >> word;) description.registers.push_back(word);
    }
  }
  if (description.name.empty() || description.name.find_first_of(" \t") != std::string::npos)
    throw GraphError(path + ": its description has no name");
  if (description.version.empty() || description.version.find_first_of(" \t") != std::string::npos)
    throw GraphError(path + ": its description has no version");
  return description;
}

std::string abi_problem(const PluginDescription& description) {
  const std::string its = std::to_string(description.abi_major) + "." + std::to_string(description.abi_minor);
  const std::string ours = std::to_string(PLINIAN_ABI_MAJOR) + "." + std::to_string(PLINIAN_ABI_MINOR);
  if (description.abi_major == PLINIAN_ABI_MAJOR && description.abi_minor <= PLINIAN_ABI_MINOR) return "";
  return "was built for version " + its + " of the plug-in interface, this program has " + ours +
         (description.abi_major < PLINIAN_ABI_MAJOR ? ": build it again" : ": it needs a newer Plinian");
}

}  // namespace plinian::sdk
