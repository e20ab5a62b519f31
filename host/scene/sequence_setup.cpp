// Chooses frames and joins what they say.
#include "host/scene/sequence_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace plinian::scene {

SequenceSetup set_up_sequence(std::vector<int> frames, bool whole,
                              const std::function<SequenceFrame(int)>& read) {
  SequenceSetup setup;
  setup.frames = std::move(frames);
  VdbFacts spokesman;  // of the first file that says how it is oriented
  const auto says = [](const VdbFacts& facts) {
    return !facts.orientation.up_assumed || !facts.orientation.unit_assumed;
  };
  const auto visit = [&](int frame) {
    SequenceFrame found = read(frame);
    if (!says(spokesman)) spokesman = found.facts;
    return found;
  };

  const std::size_t count = setup.frames.size();
  std::size_t first = 0;
  SequenceFrame shown;
  for (; first < count; ++first)
    if (shown = visit(setup.frames[first]); shown.readable && !shown.volume->empty()) break;
  const bool any = first < count;
  if (!any) {
    setup.warning = "none of the sequence's frames shows anything";
    first = 0;
    shown = read(setup.frames.front());
  }
  setup.frame = setup.frames[first];

  std::string placed;
  if (any && whole) {
    std::vector<std::size_t> further = {first + (count - 1 - first) / 2, count - 1};
    further.erase(std::unique(further.begin(), further.end()), further.end());
    std::erase(further, first);
    std::vector<int> seen;
    for (std::size_t i : further)
      for (; i > first; --i) {
        if (std::ranges::count(seen, setup.frames[i])) break;
        SequenceFrame found = visit(setup.frames[i]);
        if (!found.readable) continue;
        setup.others.push_back(std::move(found.volume));
        seen.push_back(setup.frames[i]);
        placed += fmt::format("{}{}", placed.empty() ? "" : " and ", setup.frames[i]);
        break;
      }
    if (!placed.empty()) read(setup.frame);  // where time is to stand
  }

  setup.volume = std::move(shown.volume);
  setup.facts = std::move(shown.facts);
  if (says(spokesman) && !says(setup.facts)) {
    setup.facts.orientation = spokesman.orientation;
    setup.facts.orientation.reason +=
        fmt::format(", by what {} says", std::filesystem::path(spokesman.path).filename().string());
  }
  if (any)
    setup.note =
        fmt::format("{} frames, {} to {}; set up by frame {}{}{}", count, setup.frames.front(),
                    setup.frames.back(), setup.frame, first == 0 ? "" : ", the first that shows anything",
                    placed.empty() ? ""
                                   : fmt::format("; the camera shows {} {} as well",
                                                 setup.others.size() > 1 ? "frames" : "frame", placed));
  return setup;
}

}  // namespace plinian::scene
