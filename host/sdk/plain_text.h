// Plain C read on the host's side.
#pragma once

#include <algorithm>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace plinian::sdk {

// A structure of a plug-in that may have been built with an older, shorter one: what it lacks is zero.
template <class T>
T whole(const T* from) {
  T result{};
  if (from) std::memcpy(&result, from, std::min(sizeof(T), from->size));
  return result;
}

inline std::string text_of(const char* text) {
  return text ? text : "";
}

inline std::vector<std::string> words_of(const char* text, char separator = ' ') {
  std::istringstream words(text_of(text));
  std::vector<std::string> result;
  for (std::string word; std::getline(words, word, separator);)
    if (!word.empty()) result.push_back(word);
  return result;
}

/// The structures of an array whose elements may be shorter or longer than ours, each as whole() gives it.
template <class T>
std::vector<T> all_of(const T* first, std::size_t count) {
  std::vector<T> result;
  const auto* next = reinterpret_cast<const char*>(first);
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(whole(reinterpret_cast<const T*>(next)));
    next += result.back().size;
  }
  return result;
}

}  // namespace plinian::sdk
