// Files that belong to the library but are no part of it: programs and modules in libexec/plinian.
#pragma once

#include <string>

namespace plinian {

struct Companion {
  const char* file;      // its name in libexec/plinian
  const char* variable;  // an environment variable that names another one in its place
  const char* purpose;   // what it is to a person: "the .vdb reader"
};

/// Its path: what the variable says; else libexec/plinian/<file> in a folder above this library or above the
/// running program (so a build tree, an installed tree or a moved one); else where it was to be installed.
/// Throws std::runtime_error where there is none.
std::string companion_path(const Companion& companion);

}  // namespace plinian
