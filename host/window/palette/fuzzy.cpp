// The best of all ways to find the letters, letter by letter.
#include "host/window/palette/fuzzy.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <vector>

namespace plinian::window {

namespace {

char lower(char c) {
  return char(std::tolower((unsigned char)c));
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = lower(c);
  return result;
}

bool begins_word(std::string_view text, std::size_t at) {
  if (at == 0) return true;
  const auto before = (unsigned char)text[at - 1], here = (unsigned char)text[at];
  return (!std::isalnum(before) && std::isalnum(here)) || (std::islower(before) && std::isupper(here));
}

std::optional<int> score_of_word(const std::string& word, std::string_view text) {
  // Most texts lack a letter, which is soon seen.
  std::size_t found = 0;
  for (std::size_t at = 0; at < text.size() && found < word.size(); ++at)
    found += lower(text[at]) == word[found];
  if (found < word.size()) return std::nullopt;
  constexpr int none = -1000000, letter = 1, in_a_row = 7, beginning = 6, very_first = 4;
  // Of the letters so far, the last one at that place of the text.
  std::vector<int> ending(text.size(), none), next(text.size());
  for (std::size_t i = 0; i < word.size(); ++i) {
    int best_before = none;  // ending two places back or earlier
    for (std::size_t at = 0; at < text.size(); ++at) {
      next[at] = none;
      if (at >= 2) best_before = std::max(best_before, ending[at - 2]);
      if (lower(text[at]) != word[i]) continue;
      const int here =
          letter + (begins_word(text, at) ? beginning : 0) + (at == 0 && i == 0 ? very_first : 0);
      if (i == 0) {
        next[at] = here;
      } else {
        const int row = at >= 1 && ending[at - 1] > none ? ending[at - 1] + in_a_row : none;
        const int before = std::max(best_before, row);
        if (before > none) next[at] = before + here;
      }
    }
    std::swap(ending, next);
  }
  const int best = ending.empty() ? none : *std::max_element(ending.begin(), ending.end());
  return best > none ? std::optional(best) : std::nullopt;
}

}  // namespace

std::vector<std::string> words_of(std::string_view query) {
  std::istringstream stream{lower(query)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::optional<int> fuzzy_score(const std::vector<std::string>& words, std::string_view text) {
  constexpr int finer = 8;  // of which the length of the text takes a part
  if (words.empty()) return 0;
  int sum = 0;
  for (const std::string& word : words) {
    const auto score = score_of_word(word, text);
    if (!score) return std::nullopt;
    sum += *score;
  }
  return finer * sum - int(text.size());
}

bool holds_words(const std::vector<std::string>& words, std::string_view text) {
  const std::string all = lower(text);
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return all.find(word) != all.npos; });
}

std::optional<int> fuzzy_score(std::string_view query, std::string_view text) {
  return fuzzy_score(words_of(query), text);
}

bool holds_words(std::string_view query, std::string_view text) {
  return holds_words(words_of(query), text);
}

}  // namespace plinian::window
