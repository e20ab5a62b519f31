// Least recently used values leave first.
#include "host/graph/evaluation/value_cache.h"

namespace plinian::graph {

namespace {

// What an entry costs besides the value itself [bytes].
constexpr std::size_t overhead = 200;
// Entries whose value has gone are kept up to this number.
constexpr std::size_t max_entries = 1'000'000;

}  // namespace

std::optional<ValueCache::Entry> ValueCache::find(Hash key) {
  const std::lock_guard lock(mutex_);
  const auto found = by_key_.find(key);
  if (found == by_key_.end()) return std::nullopt;
  if (found->second->entry.result->has_value) entries_.splice(entries_.begin(), entries_, found->second);
  return found->second->entry;
}

void ValueCache::insert(Hash key, Entry entry) {
  const std::lock_guard lock(mutex_);
  const std::size_t bytes = overhead + bytes_held(entry.result->value);
  if (const auto found = by_key_.find(key); found != by_key_.end()) {
    if (found->second == first_empty_) ++first_empty_;
    bytes_ -= found->second->bytes;
    entries_.erase(found->second);
    by_key_.erase(found);
  }
  entries_.push_front({key, std::move(entry), bytes});
  by_key_.emplace(key, entries_.begin());
  bytes_ += bytes;
  shrink();
}

void ValueCache::shrink() {
  while (bytes_ > budget_ && first_empty_ != entries_.begin()) {
    const auto oldest = std::prev(first_empty_);
    Result husk = *oldest->entry.result;
    husk.value = {};
    husk.has_value = false;
    oldest->entry.result = std::make_shared<const Result>(std::move(husk));
    bytes_ -= oldest->bytes;
    oldest->bytes = 0;
    first_empty_ = oldest;
  }
  while (entries_.size() > max_entries && first_empty_ != entries_.end()) {
    const auto last = std::prev(entries_.end());
    if (last == first_empty_) first_empty_ = entries_.end();
    by_key_.erase(last->key);
    entries_.erase(last);
  }
}

void ValueCache::clear() {
  const std::lock_guard lock(mutex_);
  entries_.clear();
  by_key_.clear();
  first_empty_ = entries_.end();
  bytes_ = 0;
}

void ValueCache::set_budget(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  budget_ = bytes;
  shrink();
}

std::size_t ValueCache::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

}  // namespace plinian::graph
