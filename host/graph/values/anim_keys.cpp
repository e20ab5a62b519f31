#include "host/graph/values/anim_keys.h"

#include <algorithm>

namespace plinian::graph {

double evaluate_keys(std::vector<AnimKey> keys, double time) {
  if (keys.empty()) return 0.0;
  std::stable_sort(keys.begin(), keys.end(),
                   [](const AnimKey& a, const AnimKey& b) { return a.time < b.time; });
  // Of keys at the same time the last one holds.
  std::vector<AnimKey> distinct;
  for (const AnimKey& key : keys)
    if (!distinct.empty() && distinct.back().time == key.time)
      distinct.back() = key;
    else
      distinct.push_back(key);
  const auto next = std::upper_bound(distinct.begin(), distinct.end(), time,
                                     [](double t, const AnimKey& key) { return t < key.time; });
  if (next == distinct.begin()) return distinct.front().value;
  if (next == distinct.end()) return distinct.back().value;
  const AnimKey &from = *std::prev(next), &to = *next;
  if (from.interpolation == Interpolation::stepped) return from.value;
  if (from.interpolation == Interpolation::linear)
    return from.value + (to.value - from.value) * (time - from.time) / (to.time - from.time);
  // A slope depends on a key's neighbours alone.
  const std::size_t i = std::size_t(std::prev(next) - distinct.begin());
  const std::size_t first = i > 0 ? i - 1 : i, last = std::min(i + 2, distinct.size() - 1);
  std::vector<double> x, y;
  for (std::size_t k = first; k <= last; ++k) {
    x.push_back(distinct[k].time);
    y.push_back(distinct[k].value);
  }
  const std::vector<double> slopes = monotone_slopes(x, y);
  const std::size_t at = i - first;
  return hermite(x[at], y[at], slopes[at], x[at + 1], y[at + 1], slopes[at + 1], time);
}

}  // namespace plinian::graph
