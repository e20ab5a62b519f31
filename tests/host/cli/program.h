// Runs the built program as a person would, and keeps what it says.
#pragma once

#include <csignal>
#include <string>
#include <vector>

namespace plinian {

struct Ended {
  int code = -1;         // exit code; 128 + signal where one ended it
  std::string out;       // standard output
  std::string err;       // standard error
  long peak_memory = 0;  // [KiB] resident, at least what the test itself holds when it starts the program

  /// Lines of standard error.
  int error_lines() const;
};

struct RunOptions {
  std::string folder = ".";                                           // to run in
  std::vector<std::pair<std::string, std::string>> environment = {};  // beside what there is
  unsigned user = 0;              // to run as, where the test runs as the superuser; 0: as the test does
  int signal = SIGINT;            // that is sent
  double signal_after_s = 0.0;    // so long after the start; 0: never
  std::string signal_after_text;  // ... or so long after this was said
};

/// Where the program is.
std::string program_path();

/// Runs `plinian` with the arguments. Its user presets are looked for in an empty place unless the
/// environment says otherwise, so that nobody's own presets change a test.
Ended plinian_program(const std::vector<std::string>& arguments, const RunOptions& options = {});

}  // namespace plinian
