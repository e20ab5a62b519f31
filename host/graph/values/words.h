// Lines cut into words: what commands, scripts and scene files are written in.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plinian::graph {

struct Word {
  std::string text;     // without quotes and escapes
  bool quoted = false;  // then it is a value, whatever it looks like
};

/// Cuts a line at spaces and tabs. A word in double quotes may hold anything: \" \\ \n \r \t and \xNN stand
/// for what they stand for in C. '#' at the beginning of a word starts a comment. Throws GraphError for a
/// quote without its end and for an unknown escape.
std::vector<Word> split_words(std::string_view line);

/// The text in double quotes, as split_words reads it. Bytes that are not UTF-8, and control characters, are
/// written as escapes, so that a scene stays a text file.
std::string quote(std::string_view text);

/// The text as it is where it reads back as one plain word, quoted otherwise.
std::string quote_if_needed(std::string_view text);

/// A text of unknown origin as an error line may show it: in one line, shortened, without control characters.
std::string shown(std::string_view text);

}  // namespace plinian::graph
