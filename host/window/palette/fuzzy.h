// How well a few letters name something.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plinian::window {

/// Each word of the query must have its letters in the text in their order, case aside; higher is better:
/// letters in a row and at the beginnings of words (also of "words_likeThis") count most, then short texts.
/// None where a word is not there; 0 for an empty query.
std::optional<int> fuzzy_score(std::string_view query, std::string_view text);

/// The words of a query, in lower case. For many texts they are made once.
std::vector<std::string> words_of(std::string_view query);
std::optional<int> fuzzy_score(const std::vector<std::string>& words, std::string_view text);
bool holds_words(const std::vector<std::string>& words, std::string_view text);

/// Whether a text holds every word of the query as it is written, case aside.
bool holds_words(std::string_view query, std::string_view text);

}  // namespace plinian::window
