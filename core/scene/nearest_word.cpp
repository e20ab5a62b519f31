// Nearest known word.
#include "core/scene/nearest_word.h"

#include <algorithm>
#include <cctype>

namespace plinian {

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t columns = b.size() + 1;
  std::vector<int> before_last(columns), last(columns), row(columns);
  for (std::size_t j = 0; j < columns; ++j) last[j] = int(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = int(i);
    for (std::size_t j = 1; j < columns; ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  const auto lower = [](std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return result;
  };
  const std::string wanted = lower(word);
  if (wanted.empty()) return std::nullopt;
  std::optional<std::string> best;
  int best_distance = 0;
  for (const std::string& candidate : candidates) {
    const std::string known = lower(candidate);
    const bool begins = wanted.size() >= 3 && known.starts_with(wanted);
    const std::size_t longer = std::max(known.size(), wanted.size()),
                      shorter = std::min(known.size(), wanted.size());
    const std::size_t allowed = std::max<std::size_t>(1, longer / 3);
    // So many letters are too many or missing at least; of a word of megabytes nothing else is asked.
    if (!begins && longer - shorter > allowed) continue;
    const int distance = begins ? std::min(1, int(longer - shorter)) : edit_distance(wanted, known);
    if (std::size_t(distance) <= allowed && (!best || distance < best_distance)) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const auto near = nearest_word(word, candidates);
  return near ? " (did you mean '" + *near + "'?)" : "";
}

std::string join(const std::vector<std::string>& words, std::string_view separator) {
  std::string result;
  for (const std::string& word : words) {
    if (!result.empty()) result += separator;
    result += word;
  }
  return result;
}

}  // namespace plinian
