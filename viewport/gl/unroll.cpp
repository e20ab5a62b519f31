#include "viewport/gl/unroll.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace plinian::gl {
namespace {

constexpr std::string_view directive = "#unroll ";
constexpr int most_copies = 64;

struct Loop {
  std::string word;
  std::string index;
  int count = 0;
};

bool is_part_of_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

Loop read_directive(const std::string& line, const Defines& defines) {
  std::istringstream words(line.substr(directive.size()));
  Loop loop;
  std::string count;
  words >> loop.word >> loop.index >> count;
  for (const auto& [name, value] : defines)
    if (name == count) {
      count = value;
      break;
    }
  const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), loop.count);
  if (error != std::errc() || end != count.data() + count.size() || loop.count < 0 ||
      loop.count > most_copies)
    throw std::runtime_error("'" + line + "': '" + count + "' is no number of copies");
  return loop;
}

/// Where the statement that begins at `begin` ends; npos if it does not.
std::size_t statement_end(std::string_view text, std::size_t begin) {
  int depth = 0;
  for (std::size_t at = begin; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '{' || c == '(') ++depth;
    if (c == '}' || c == ')') --depth;
    if (depth == 0 && (c == ';' || c == '}')) return at + 1;
  }
  return text.npos;
}

std::string copies(const Loop& loop, const std::string& statement) {
  std::string all = "{";
  for (int i = 0; i < loop.count; ++i)
    all += " { const int " + loop.index + " = " + std::to_string(i) + "; " + statement + " }";
  return all + " }";
}

/// Writes out `loop` wherever it stands behind `begin`, the last first: what a statement holds comes before
/// it.
void write_out(const Loop& loop, std::size_t begin, std::string& text) {
  std::size_t at = text.size();
  while (at > begin && (at = text.rfind(loop.word, at - 1)) != text.npos && at >= begin) {
    const std::size_t after = at + loop.word.size();
    const std::size_t line = at == 0 ? 0 : text.rfind('\n', at) + 1;
    if (text[line] == '#' || (at > 0 && is_part_of_name(text[at - 1])) || is_part_of_name(text[after]))
      continue;
    const std::size_t end = statement_end(text, after);
    if (end == text.npos) throw std::runtime_error("a statement behind " + loop.word + " does not end");
    text.replace(at, end - at, copies(loop, text.substr(after, end - after)));
  }
}

}  // namespace

std::string unroll(std::string text, const Defines& defines) {
  std::size_t at = 0;
  while ((at = text.find(directive, at)) != text.npos) {
    if (at > 0 && text[at - 1] != '\n') {
      ++at;
      continue;
    }
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const Loop loop = read_directive(text.substr(at, end - at), defines);
    text.erase(at, end - at);
    write_out(loop, at, text);
  }
  return text;
}

}  // namespace plinian::gl
