// Results by the hash of what they were computed from, so that coming back to a frame or undoing costs
// nothing.
#pragma once

#include <deque>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "host/graph/evaluation/result.h"
#include "host/graph/values/flat_map.h"

namespace plinian::graph {

/// An input that a computation read at another time: part of what its result depends on, but known only
/// afterwards.
struct OtherTimeRead {
  double time = 0.0;  // [frames]
  AttributeIndex attribute = no_attribute;
  std::int32_t element = -1;
  Hash identity;  // of what was read
};

/// Safe to use from several threads. The values used longest ago go first; who they were stays known, so that
/// what was computed from them can still be found.
class ValueCache {
 public:
  struct Entry {
    ResultPtr result;
    std::vector<OtherTimeRead> reads = {};
    std::string warning = {};  // what the computation had to say of it
  };

  /// budget: of values [bytes].
  explicit ValueCache(std::size_t budget) : budget_(budget) {}

  std::optional<Entry> find(Hash key);
  void insert(Hash key, Entry entry);
  void clear();

  void set_budget(std::size_t bytes);
  std::size_t bytes() const;  // held at the moment
  std::size_t budget() const;

 private:
  // What few entries have.
  struct Extra {
    std::vector<OtherTimeRead> reads;
    std::size_t bytes = 0;               // that the value holds
    std::list<Hash>::iterator recent{};  // where bytes > 0: its place in recent_
    std::string warning;
  };
  struct Stored {
    ResultPtr result;
    std::unique_ptr<Extra>
        extra;  // null: a number, made of nothing from another time and with nothing to say
    std::size_t bytes() const { return extra ? extra->bytes : 0; }
  };
  void shrink();

  mutable std::mutex mutex_;
  FlatMap<Hash, Stored> entries_;
  std::list<Hash> recent_;  // values that hold memory, the most recently used first
  std::deque<Hash> light_;  // numbers, and what is left of values that have gone, the oldest first
  std::size_t budget_, bytes_ = 0;
};

}  // namespace plinian::graph
