// What a plug-in says of itself, read without loading it: loading would run its static initialisers.
#pragma once

#include <string>
#include <vector>

namespace plinian::sdk {

struct PluginDescription {
  std::string name, version, vendor;
  int abi_major = 0, abi_minor = 0;
  std::vector<std::string> registers;  // "node:TYPE", "command:NAME", "data:TYPE", "file:NAME"
};

/// The description in the library's ELF note (section .note.plinian) or, where it has none, in the file of
/// the same name with ".plinian" behind it. Throws GraphError, naming the file, where the library is none or
/// describes nothing.
PluginDescription read_description(const std::string& path);

/// Reads the lines "name NAME", "version VERSION", "vendor VENDOR", "abi MAJOR.MINOR", "registers ...".
PluginDescription parse_description(const std::string& text, const std::string& path);

/// Why a program of our ABI cannot load it, or empty: another major version, or a newer minor one.
std::string abi_problem(const PluginDescription& description);

}  // namespace plinian::sdk
