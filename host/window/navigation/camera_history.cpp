// Two stacks.
#include "host/window/navigation/camera_history.h"

namespace plinian::window {

namespace {

std::optional<Look> step(std::vector<Look>& from, std::vector<Look>& to, const Look& now) {
  if (from.empty()) return std::nullopt;
  to.push_back(now);
  const Look look = from.back();
  from.pop_back();
  return look;
}

}  // namespace

void CameraHistory::note(const Look& before) {
  constexpr std::size_t most = 200;
  back_.push_back(before);
  if (back_.size() > most) back_.erase(back_.begin());
  forth_.clear();
}

std::optional<Look> CameraHistory::back(const Look& now) {
  return step(back_, forth_, now);
}

std::optional<Look> CameraHistory::forth(const Look& now) {
  return step(forth_, back_, now);
}

void CameraHistory::clear() {
  back_.clear();
  forth_.clear();
}

}  // namespace plinian::window
