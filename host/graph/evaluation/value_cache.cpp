// Least recently used values leave first.
#include "host/graph/evaluation/value_cache.h"

namespace plinian::graph {

namespace {

// Numbers and what is left of larger values are kept up to this many.
constexpr std::size_t max_light_entries = 1'000'000;

}  // namespace

std::optional<ValueCache::Entry> ValueCache::find(Hash key) {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(key);
  if (found == entries_.end()) return std::nullopt;
  Stored& stored = found->second;
  if (stored.bytes > 0) recent_.splice(recent_.begin(), recent_, stored.recent);
  return stored.entry;
}

void ValueCache::insert(Hash key, Entry entry) {
  const std::lock_guard lock(mutex_);
  Stored& stored = entries_[key];
  const bool was_light = stored.entry.result && stored.bytes == 0;
  if (stored.bytes > 0) recent_.erase(stored.recent);
  bytes_ -= stored.bytes;
  stored.entry = std::move(entry);
  stored.bytes = bytes_held(stored.entry.result->value);
  bytes_ += stored.bytes;
  if (stored.bytes > 0)
    stored.recent = recent_.insert(recent_.begin(), key);
  else if (!was_light)
    light_.push_back(key);
  shrink();
}

void ValueCache::shrink() {
  while (bytes_ > budget_ && !recent_.empty()) {
    Stored& oldest = entries_.at(recent_.back());
    Result husk = *oldest.entry.result;
    husk.value = {};
    husk.has_value = false;
    oldest.entry.result = std::make_shared<const Result>(std::move(husk));
    bytes_ -= oldest.bytes;
    oldest.bytes = 0;
    light_.push_back(recent_.back());
    recent_.pop_back();
  }
  while (light_.size() > max_light_entries) {
    // It may have got a larger value since.
    const auto oldest = entries_.find(light_.front());
    if (oldest != entries_.end() && oldest->second.bytes == 0) entries_.erase(oldest);
    light_.pop_front();
  }
}

void ValueCache::clear() {
  const std::lock_guard lock(mutex_);
  entries_.clear();
  recent_.clear();
  light_.clear();
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
