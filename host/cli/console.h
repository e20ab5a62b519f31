// What the program says to people, on standard error: notes, warnings, errors, one line each. Results that a
// script would read go to standard output.
#pragma once

#include <string>

namespace plinian::cli {

/// Silences notes and progress, not warnings and errors.
void set_quiet(bool quiet);
bool is_quiet();

void note(const std::string& line);
void warn(const std::string& line);
/// "plinian: error: ...", control characters and line ends made visible so that it is one line.
void error(const std::string& line);

/// Prints to standard output.
void print(const std::string& text);

/// A file name, or a hint at its length: "1.5 MiB".
std::string bytes_text(double bytes);

}  // namespace plinian::cli
