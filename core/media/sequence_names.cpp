// Splits names at their numbers.
#include "core/media/sequence_names.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

namespace plinian {

namespace {

// "smoke.0007.vdb": "smoke." and ".vdb" around "0007".
struct Numbered {
  std::size_t begin = 0, digits = 0;  // of the number in the name
  int number = 0;
};

bool is_digit(char c) {
  return std::isdigit((unsigned char)c) != 0;
}

// "_v" or "V" alone before the number.
bool is_version(const std::string& name, std::size_t begin) {
  if (begin == 0 || (name[begin - 1] != 'v' && name[begin - 1] != 'V')) return false;
  return begin == 1 || !std::isalpha((unsigned char)name[begin - 2]);
}

bool split(const std::string& name, Numbered& found) {
  const std::size_t dot = name.rfind('.');
  if (dot == name.npos || dot == 0) return false;
  std::size_t begin = dot;
  while (begin > 0 && is_digit(name[begin - 1])) --begin;
  found.begin = begin;
  found.digits = dot - begin;
  if (found.digits == 0 || found.digits > 9 || is_version(name, begin)) return false;
  found.number = std::stoi(name.substr(begin, found.digits));
  return true;
}

// How many digits the pattern shows that writes this number: of the widths that are padded somewhere the
// largest that it fills; without any, its own where all have the same, else 1.
std::size_t width_of(std::size_t digits, bool padded, const std::set<std::size_t>& padded_widths,
                     std::size_t common) {
  if (padded) return digits;
  auto wider = padded_widths.upper_bound(digits);
  if (wider != padded_widths.begin()) return *std::prev(wider);
  return padded_widths.empty() ? common : 1;
}

}  // namespace

std::vector<NameGroup> group_names(const std::vector<std::string>& names) {
  using Member = std::pair<Numbered, std::size_t>;
  std::map<std::pair<std::string, std::string>, std::vector<Member>> alike;
  std::vector<NameGroup> groups;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Numbered numbered;
    if (split(names[i], numbered))
      alike[{names[i].substr(0, numbered.begin), names[i].substr(numbered.begin + numbered.digits)}]
          .emplace_back(numbered, i);
    else
      groups.push_back({names[i], {i}});
  }
  for (auto& [around, members] : alike) {
    const auto is_padded = [&](const Member& member) {
      return member.first.digits > 1 && names[member.second][member.first.begin] == '0';
    };
    std::set<std::size_t> padded_widths;
    std::size_t common = members.front().first.digits;
    for (const Member& member : members) {
      if (is_padded(member)) padded_widths.insert(member.first.digits);
      if (member.first.digits != common) common = 1;
    }
    std::map<std::size_t, std::vector<std::pair<int, std::size_t>>> by_width;
    for (const Member& member : members)
      by_width[width_of(member.first.digits, is_padded(member), padded_widths, common)].emplace_back(
          member.first.number, member.second);
    for (auto& [width, frames] : by_width) {
      if (frames.size() == 1) {
        groups.push_back({names[frames[0].second], {frames[0].second}});
        continue;
      }
      std::sort(frames.begin(), frames.end());
      NameGroup group{around.first + std::string(width, '#') + around.second, {}};
      for (const auto& [number, place] : frames) group.members.push_back(place);
      group.first = frames.front().first;
      group.last = frames.back().first;
      groups.push_back(std::move(group));
    }
  }
  return groups;
}

}  // namespace plinian
