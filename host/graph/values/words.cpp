// Words and quotes.
#include "host/graph/values/words.h"

#include <array>

#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// Reads a quoted word whose opening quote has been passed.
std::string read_quoted(std::string_view line, std::size_t& at) {
  std::string text;
  while (true) {
    if (at >= line.size()) throw GraphError("a quote is not closed");
    const char c = line[at++];
    if (c == '"') return text;
    if (c != '\\') {
      text += c;
      continue;
    }
    const char escape = at < line.size() ? line[at++] : '\0';
    if (escape == '"' || escape == '\\')
      text += escape;
    else if (escape == 'n')
      text += '\n';
    else if (escape == 'r')
      text += '\r';
    else if (escape == 't')
      text += '\t';
    else if (escape == 'x' && at + 1 < line.size() && hex_digit(line[at]) >= 0 &&
             hex_digit(line[at + 1]) >= 0) {
      text += char(hex_digit(line[at]) * 16 + hex_digit(line[at + 1]));
      at += 2;
    } else
      throw GraphError("unknown escape in a quoted text (\\\" \\\\ \\n \\r \\t \\xNN are known)");
  }
}

// Bytes of the UTF-8 character at the beginning of a text; 0 where there is none (RFC 3629).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? (unsigned char)text[i] : 0u; };
  const auto tail = [&](std::size_t i) { return (byte(i) & 0xc0u) == 0x80u; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead <= 0xdf) return tail(1) ? 2 : 0;
  if (lead >= 0xe0 && lead <= 0xef) {
    const bool overlong = lead == 0xe0 && byte(1) < 0xa0, surrogate = lead == 0xed && byte(1) > 0x9f;
    return tail(1) && tail(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xf0 && lead <= 0xf4) {
    const bool outside = (lead == 0xf0 && byte(1) < 0x90) || (lead == 0xf4 && byte(1) > 0x8f);
    return tail(1) && tail(2) && tail(3) && !outside ? 4 : 0;
  }
  return 0;
}

}  // namespace

std::vector<Word> split_words(std::string_view line) {
  std::vector<Word> words;
  std::size_t at = 0;
  while (true) {
    while (at < line.size() && is_space(line[at])) ++at;
    if (at >= line.size() || line[at] == '#') return words;
    Word word;
    if (line[at] == '"') {
      word.quoted = true;
      word.text = read_quoted(line, ++at);
      if (at < line.size() && !is_space(line[at]))
        throw GraphError("a space is missing after a closing quote");
    } else {
      const std::size_t begin = at;
      while (at < line.size() && !is_space(line[at])) ++at;
      word.text = line.substr(begin, at - begin);
    }
    words.push_back(std::move(word));
  }
}

std::string quote(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    const std::size_t length = utf8_length(text.substr(at));
    if (c == '"' || c == '\\')
      (result += '\\') += c;
    else if (c == '\n')
      result += "\\n";
    else if (c == '\r')
      result += "\\r";
    else if (c == '\t')
      result += "\\t";
    else if (length == 0 || (unsigned char)c < 0x20 || c == 0x7f) {
      result += "\\x";
      result += digits[(unsigned char)c >> 4];
      result += digits[(unsigned char)c & 15];
    } else
      result += text.substr(at, length);
    at += std::max<std::size_t>(length, 1);
  }
  return result + '"';
}

std::string quote_if_needed(std::string_view text) {
  bool plain = !text.empty() && text.front() != '"' && text.front() != '#' && text.front() != '-';
  for (const char c : text) plain = plain && (unsigned char)c > 0x20 && (unsigned char)c < 0x7f && c != '\\';
  return plain ? std::string(text) : quote(text);
}

std::string shown(std::string_view text) {
  const bool cut = text.size() > 60;
  std::string result = quote(cut ? text.substr(0, 57) : text);
  result.front() = result.back() = '\'';
  if (cut) result.insert(result.size() - 1, "...");
  return result;
}

}  // namespace plinian::graph
