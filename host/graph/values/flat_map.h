// A hash table whose entries lie one after the other in the order in which they came: filling it costs no
// allocation for each, and going through it follows memory.
//
// Addresses of values hold until something is added or erased.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace plinian::graph {

template <class Key, class Value>
class FlatMap {
 public:
  using Entry = std::pair<Key, Value>;

  std::size_t size() const { return entries_.size(); }
  /// All entries: in the order in which they came, but that one which was erased has the last in its place.
  auto begin() const { return entries_.begin(); }
  auto end() const { return entries_.end(); }

  /// The value of a key, or null. Of keys that are strings any text can be looked for.
  template <class Wanted = Key>
  const Value* find(const Wanted& key) const {
    if (entries_.empty()) return nullptr;
    const std::uint32_t number = places_[place_of(key, hash_of(key))];
    return number == 0 ? nullptr : &entries_[number_of(number)].second;
  }
  template <class Wanted = Key>
  Value* find(const Wanted& key) {
    return const_cast<Value*>(std::as_const(*this).find(key));
  }
  /// Of a key that is there.
  const Value& at(const Key& key) const { return *find(key); }
  template <class Wanted = Key>
  bool contains(const Wanted& key) const {
    return find(key) != nullptr;
  }

  /// The value of a key, an empty one where there was none; whether there was none. Throws std::length_error
  /// for the 2^25th.
  std::pair<Value*, bool> emplace(const Key& key) {
    if ((entries_.size() + 1) * 3 > places_.size() * 2) grow();
    const std::uint64_t hash = hash_of(key);
    const std::size_t place = place_of(key, hash);
    if (places_[place] != 0) return {&entries_[number_of(places_[place])].second, false};
    if (entries_.size() == number_mask) throw std::length_error("FlatMap: too many entries");
    places_[place] = tagged(entries_.size(), hash);
    entries_.emplace_back(key, Value());
    return {&entries_.back().second, true};
  }
  Value& operator[](const Key& key) { return *emplace(key).first; }

  void erase(const Key& key) {
    if (entries_.empty()) return;
    std::size_t hole = place_of(key, hash_of(key));
    if (places_[hole] == 0) return;
    const std::size_t number = number_of(places_[hole]);
    // What was pushed past the hole moves up, so that no search ends early.
    for (std::size_t at = (hole + 1) & mask_; places_[at] != 0; at = (at + 1) & mask_) {
      const std::size_t home = hash_of(entries_[number_of(places_[at])].first) & mask_;
      if (((at - home) & mask_) < ((at - hole) & mask_)) continue;
      places_[hole] = places_[at];
      hole = at;
    }
    places_[hole] = 0;
    if (number + 1 < entries_.size()) {
      const Key& last = entries_.back().first;
      const std::uint64_t hash = hash_of(last);
      places_[place_of(last, hash)] = tagged(number, hash);
      entries_[number] = std::move(entries_.back());
    }
    entries_.pop_back();
  }
  void clear() {
    places_.clear();
    entries_.clear();
    mask_ = 0;
  }

 private:
  // A place holds the number of its entry + 1, and above it a part of the hash that tells most other keys
  // apart without looking at them; 0 is an empty place.
  static constexpr int number_bits = 25;
  static constexpr std::uint32_t number_mask = (1u << number_bits) - 1;
  static std::size_t number_of(std::uint32_t place) { return (place & number_mask) - 1; }
  static std::uint32_t tag_of(std::uint64_t hash) { return std::uint32_t(hash >> 57) << number_bits; }
  static std::uint32_t tagged(std::size_t number, std::uint64_t hash) {
    return std::uint32_t(number + 1) | tag_of(hash);
  }
  // What keys are hashed and looked for as.
  using Look = std::conditional_t<std::is_same_v<Key, std::string>, std::string_view, const Key&>;
  static std::uint64_t hash_of(Look key) {
    // Fibonacci hashing: the low bits of a poor hash depend on all of it.
    const std::uint64_t hash =
        std::uint64_t(std::hash<std::remove_cvref_t<Look>>()(key)) * 0x9e3779b97f4a7c15ull;
    return hash ^ (hash >> 32);
  }
  // Where the key is, or the empty place where it would go.
  std::size_t place_of(Look key, std::uint64_t hash) const {
    for (std::size_t at = hash & mask_;; at = (at + 1) & mask_) {
      const std::uint32_t place = places_[at];
      if (place == 0 || ((place & ~number_mask) == tag_of(hash) && entries_[number_of(place)].first == key))
        return at;
    }
  }
  void grow() {
    places_.assign(places_.empty() ? 16 : places_.size() * 2, 0);
    mask_ = places_.size() - 1;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const std::uint64_t hash = hash_of(entries_[i].first);
      std::size_t at = hash & mask_;
      while (places_[at] != 0) at = (at + 1) & mask_;
      places_[at] = tagged(i, hash);
    }
  }

  std::vector<std::uint32_t> places_;  // their number is a power of two
  std::vector<Entry> entries_;         // at most 2^25 - 1
  std::size_t mask_ = 0;
};

}  // namespace plinian::graph
