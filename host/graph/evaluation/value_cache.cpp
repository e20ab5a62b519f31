// Least recently used values leave first.
#include "host/graph/evaluation/value_cache.h"

namespace plinian::graph {

namespace {

// Numbers and what is left of larger values are kept up to this many.
constexpr std::size_t max_light_entries = 1'000'000;

}  // namespace

std::optional<ValueCache::Entry> ValueCache::find(Hash key) {
  const std::lock_guard lock(mutex_);
  const Stored* stored = entries_.find(key);
  if (!stored) return std::nullopt;
  if (!stored->extra) return Entry{stored->result};
  if (stored->bytes() > 0) recent_.splice(recent_.begin(), recent_, stored->extra->recent);
  return Entry{stored->result, stored->extra->reads, stored->extra->warning};
}

void ValueCache::insert(Hash key, Entry entry) {
  const std::lock_guard lock(mutex_);
  const auto [stored, fresh] = entries_.emplace(key);
  const bool was_light = !fresh && stored->bytes() == 0;
  if (stored->bytes() > 0) recent_.erase(stored->extra->recent);
  bytes_ -= stored->bytes();
  stored->result = std::move(entry.result);
  const std::size_t bytes = bytes_held(stored->result->value);
  stored->extra.reset();
  if (bytes > 0 || !entry.reads.empty() || !entry.warning.empty())
    stored->extra =
        std::make_unique<Extra>(Extra{std::move(entry.reads), bytes, {}, std::move(entry.warning)});
  bytes_ += bytes;
  if (bytes > 0)
    stored->extra->recent = recent_.insert(recent_.begin(), key);
  else if (!was_light)
    light_.push_back(key);
  shrink();
}

void ValueCache::shrink() {
  while (bytes_ > budget_ && !recent_.empty()) {
    Stored& oldest = *entries_.find(recent_.back());
    Result husk = *oldest.result;
    husk.value = {};
    husk.has_value = false;
    oldest.result = std::make_shared<const Result>(std::move(husk));
    bytes_ -= oldest.bytes();
    oldest.extra->bytes = 0;
    light_.push_back(recent_.back());
    recent_.pop_back();
  }
  while (light_.size() > max_light_entries) {
    // It may have got a larger value since.
    const Stored* oldest = entries_.find(light_.front());
    if (oldest && oldest->bytes() == 0) entries_.erase(light_.front());
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

std::size_t ValueCache::budget() const {
  const std::lock_guard lock(mutex_);
  return budget_;
}

}  // namespace plinian::graph
