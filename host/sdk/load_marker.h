// Remembers, while a library is being loaded, that it is: who finds such a mark of a program that has gone
// knows that the library did not come back.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plinian::sdk {

/// Leaves a file in the user's state folder for as long as it lives; a program that crashes leaves it behind.
/// Where there is no such folder, or it cannot be written, there is no mark.
class LoadMarker {
 public:
  explicit LoadMarker(const std::filesystem::path& library);
  LoadMarker(const LoadMarker&) = delete;
  LoadMarker& operator=(const LoadMarker&) = delete;
  /// Takes away all marks of the library but those of programs that are loading it now.
  ~LoadMarker();

  /// Whether a program that has gone left one, and the library is still the same file.
  static bool is_left(const std::filesystem::path& library);
  /// All libraries of which one is left.
  static std::vector<std::string> left();

 private:
  std::filesystem::path library_, file_;
};

}  // namespace plinian::sdk
