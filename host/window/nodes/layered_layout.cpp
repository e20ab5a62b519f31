// Layers by the longest way, order by the middle of the neighbours, then places.
#include "host/window/nodes/layered_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace plinian::window {

namespace {

constexpr float column_gap = 56.0f, row_gap = 18.0f, group_gap = 34.0f;  // [points]

using Lists = std::vector<std::vector<std::size_t>>;

struct Neighbours {
  Lists before, after;  // in the order of the edges
  Neighbours(std::size_t count, const LayoutEdges& edges) : before(count), after(count) {
    for (const auto& [from, to] : edges) {
      if (from == to || std::find(after[from].begin(), after[from].end(), to) != after[from].end()) continue;
      after[from].push_back(to);
      before[to].push_back(from);
    }
  }
};

// Every box behind all that it depends on; what goes round in a circle last, as it comes.
std::vector<std::size_t> in_order_of_dependence(const Neighbours& near) {
  std::vector<std::size_t> waits(near.before.size()), order;
  for (std::size_t i = 0; i < waits.size(); ++i)
    if ((waits[i] = near.before[i].size()) == 0) order.push_back(i);
  for (std::size_t next = 0; next < order.size(); ++next)
    for (const std::size_t to : near.after[order[next]])
      if (--waits[to] == 0) order.push_back(to);
  for (std::size_t i = 0; i < waits.size(); ++i)
    if (waits[i] > 0) order.push_back(i);
  return order;
}

// The longest way to it; what nothing is before moves up to what it drives.
std::vector<int> layers_of(const Neighbours& near, const std::vector<std::size_t>& order) {
  std::vector<int> layer(near.before.size(), 0);
  for (const std::size_t i : order)
    for (const std::size_t to : near.after[i]) layer[to] = std::max(layer[to], layer[i] + 1);
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    if (near.after[*i].empty()) continue;
    int first = layer[near.after[*i].front()];
    for (const std::size_t to : near.after[*i]) first = std::min(first, layer[to]);
    layer[*i] = first - 1;
  }
  return layer;
}

std::vector<std::vector<std::size_t>> groups_of(const Neighbours& near) {
  std::vector<std::vector<std::size_t>> groups;
  std::vector<bool> seen(near.before.size(), false);
  for (std::size_t first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    std::vector<std::size_t> group = {first};
    seen[first] = true;
    for (std::size_t next = 0; next < group.size(); ++next)
      for (const auto* sides : {&near.before, &near.after})
        for (const std::size_t other : (*sides)[group[next]])
          if (!seen[other]) {
            seen[other] = true;
            group.push_back(other);
          }
    std::sort(group.begin(), group.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

// Boxes of one group, and how large it is.
class Group {
 public:
  Group(std::vector<LaidOut>& boxes, const Neighbours& near, const std::vector<int>& layer,
        const std::vector<std::size_t>& members)
      : boxes_(boxes), near_(near) {
    int first = layer[members.front()], last = first;
    for (const std::size_t i : members) {
      first = std::min(first, layer[i]);
      last = std::max(last, layer[i]);
    }
    columns_.resize(std::size_t(last - first) + 1);
    for (const std::size_t i : members) columns_[std::size_t(layer[i] - first)].push_back(i);
  }

  /// Puts its upper left corner into the origin. Returns its size.
  vec2 put() {
    sort();
    float x = 0.0f, height = 0.0f;
    std::vector<float> heights;
    for (const auto& column : columns_) {
      float sum = -row_gap;
      for (const std::size_t i : column) sum += boxes_[i].size.y + row_gap;
      heights.push_back(sum);
      height = std::max(height, sum);
    }
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      float y = std::round((height - heights[c]) / 2), width = 0.0f;
      for (const std::size_t i : columns_[c]) {
        boxes_[i].place = vec2(x, y);
        y += boxes_[i].size.y + row_gap;
        width = std::max(width, boxes_[i].size.x);
      }
      x += width + column_gap;
    }
    return {x - column_gap, height};
  }

 private:
  void sort() {
    std::vector<float> rank(boxes_.size(), 0.0f);
    const auto number = [&](const std::vector<std::size_t>& column) {
      for (std::size_t k = 0; k < column.size(); ++k)
        rank[column[k]] = (float(k) + 0.5f) / float(column.size());
    };
    for (const auto& column : columns_) number(column);
    // Of wires into one box that of the upper plug comes first.
    constexpr float plug_step = 1e-3f;
    const auto settle = [&](std::vector<std::size_t>& column, const Lists& sides, const Lists& back) {
      std::vector<std::pair<float, std::size_t>> keys;
      for (const std::size_t i : column) {
        float sum = 0.0f;
        for (const std::size_t other : sides[i]) {
          const auto plug = std::find(back[other].begin(), back[other].end(), i) - back[other].begin();
          sum += rank[other] + plug_step * float(plug);
        }
        keys.emplace_back(sides[i].empty() ? rank[i] : sum / float(sides[i].size()), i);
      }
      std::stable_sort(keys.begin(), keys.end(),
                       [](const auto& x, const auto& y) { return x.first < y.first; });
      for (std::size_t k = 0; k < keys.size(); ++k) column[k] = keys[k].second;
      number(column);
    };
    constexpr int sweeps = 4;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (std::size_t c = 1; c < columns_.size(); ++c) settle(columns_[c], near_.before, near_.after);
      for (std::size_t c = columns_.size() - 1; c-- > 0;) settle(columns_[c], near_.after, near_.before);
    }
  }

  std::vector<LaidOut>& boxes_;
  const Neighbours& near_;
  std::vector<std::vector<std::size_t>> columns_;
};

// Panes beneath a picture are wide and low.
constexpr float shape = 4.0f;  // [-] of the whole, width over height

// What is connected, group beside group. Returns how far they reach.
vec2 put_in_rows(const Lists& groups, std::vector<LaidOut>& boxes, const Neighbours& near,
                 const std::vector<int>& layer) {
  std::vector<vec2> sizes;
  float area = 0.0f, widest = 0.0f;
  for (const auto& group : groups) {
    const vec2 size = Group(boxes, near, layer, group).put();
    sizes.push_back(size);
    area += (size.x + column_gap) * (size.y + group_gap);
    widest = std::max(widest, size.x);
  }
  const float width = std::max(widest, std::sqrt(area * shape));
  vec2 corner(0.0f), reach(0.0f);
  float row = 0.0f;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (corner.x > 0.0f && corner.x + sizes[g].x > width) {
      corner = {0.0f, corner.y + row + group_gap};
      row = 0.0f;
    }
    for (const std::size_t i : groups[g]) *boxes[i].place += corner;
    reach = glm::max(reach, corner + sizes[g]);
    corner.x += sizes[g].x + column_gap;
    row = std::max(row, sizes[g].y);
  }
  return reach;
}

// What stands alone: right of the rest, in columns as high as that or as their number asks for.
void put_in_columns(const std::vector<std::size_t>& alone, std::vector<LaidOut>& boxes, vec2 rest) {
  float area = rest.x * rest.y;
  for (const std::size_t i : alone) area += (boxes[i].size.x + row_gap) * (boxes[i].size.y + row_gap);
  const float height = std::max(rest.y, std::sqrt(area / shape));
  float x = rest.x > 0.0f ? rest.x + column_gap : 0.0f, y = 0.0f, width = 0.0f;
  for (const std::size_t i : alone) {
    if (y > 0.0f && y + boxes[i].size.y > height) {
      x += width + row_gap;
      y = width = 0.0f;
    }
    boxes[i].place = vec2(x, y);
    y += boxes[i].size.y + row_gap;
    width = std::max(width, boxes[i].size.x);
  }
}

void lay_out_all(std::vector<LaidOut>& boxes, const Neighbours& near) {
  const std::vector<int> layer = layers_of(near, in_order_of_dependence(near));
  std::vector<std::vector<std::size_t>> groups = groups_of(near);
  std::stable_sort(groups.begin(), groups.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  const auto lone = std::find_if(groups.begin(), groups.end(), [](const auto& g) { return g.size() == 1; });
  const vec2 together = put_in_rows({groups.begin(), lone}, boxes, near, layer);
  std::vector<std::size_t> alone;
  for (auto group = lone; group != groups.end(); ++group) alone.push_back(group->front());
  put_in_columns(alone, boxes, together);
}

// Down to where there is room.
vec2 moved_down(const std::vector<LaidOut>& boxes, std::size_t self, vec2 place) {
  for (bool moved = true; moved;) {
    moved = false;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (i == self || !boxes[i].place) continue;
      const vec2 begin = *boxes[i].place - row_gap, end = *boxes[i].place + boxes[i].size + row_gap;
      if (place.x + boxes[self].size.x <= begin.x || place.x >= end.x ||
          place.y + boxes[self].size.y <= begin.y || place.y >= end.y)
        continue;
      place.y = end.y;
      moved = true;
    }
  }
  return place;
}

// What nothing connects: beneath everything while that is wide, else in the last column or a new one, so that
// many of them can still be read in a low pane.
vec2 place_alone(const std::vector<LaidOut>& boxes, std::size_t self) {
  vec2 begin(std::numeric_limits<float>::max()), end(std::numeric_limits<float>::lowest());
  float last_column = end.x;
  for (const LaidOut& other : boxes)
    if (other.place) {
      begin = glm::min(begin, *other.place);
      end = glm::max(end, *other.place + other.size);
      last_column = std::max(last_column, other.place->x);
    }
  if (end.x - begin.x > shape * (end.y - begin.y)) return {begin.x, end.y + group_gap};
  const vec2 place = moved_down(boxes, self, {last_column, begin.y});
  return place.y + boxes[self].size.y <= end.y ? place : vec2(end.x + column_gap, begin.y);
}

// Beside its neighbours that have a place, at the height of their middle.
vec2 place_beside(const std::vector<LaidOut>& boxes, const Neighbours& near, std::size_t self) {
  float y = 0.0f, count = 0.0f;
  std::optional<float> left, right;
  for (const std::size_t i : near.before[self])
    if (const auto& place = boxes[i].place) {
      left = std::max(left.value_or(place->x), place->x + boxes[i].size.x + column_gap);
      y += place->y;
      count += 1.0f;
    }
  for (const std::size_t i : near.after[self])
    if (const auto& place = boxes[i].place) {
      const float x = place->x - column_gap - boxes[self].size.x;
      right = std::min(right.value_or(x), x);
      y += place->y;
      count += 1.0f;
    }
  vec2 place(left ? *left : right.value_or(0.0f), count > 0.0f ? std::round(y / count) : 0.0f);
  return count > 0.0f ? moved_down(boxes, self, place) : place_alone(boxes, self);
}

}  // namespace

void lay_out(std::vector<LaidOut>& boxes, const LayoutEdges& edges) {
  const Neighbours near(boxes.size(), edges);
  if (std::none_of(boxes.begin(), boxes.end(), [](const LaidOut& box) { return box.place.has_value(); }))
    return lay_out_all(boxes, near);
  for (const std::size_t i : in_order_of_dependence(near))
    if (!boxes[i].place) boxes[i].place = place_beside(boxes, near, i);
}

}  // namespace plinian::window
