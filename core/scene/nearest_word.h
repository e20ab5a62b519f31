// The known word that a mistyped one most likely meant, for "did you mean".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plinian {

/// Edits (insert, delete, replace, swap of neighbours; Damerau-Levenshtein, optimal string alignment) that
/// turn `a` into `b`.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, letter case aside, if it is near enough to be what was meant: at most a
/// third of its letters wrong, or `word` is its beginning.
std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// " (did you mean 'x'?)", or nothing.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// "a, b, c".
std::string join(const std::vector<std::string>& words, std::string_view separator = ", ");

}  // namespace plinian
