#include "host/cli/hand.h"

#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

namespace plinian::cli {

namespace {

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

Hand::Hand(window::ViewRenderer::Maker make) : renderer_(std::move(make), [this] { arrived(); }) {}

void Hand::begin() {
  const std::lock_guard lock(mutex_);
  asked_at_.clear();
  place_of_.clear();
  arrivals_.clear();
  keeps_ = nullptr;
  begin_ = Clock::now();
}

void Hand::ask(const SceneSnapshot& scene, bool new_picture, bool hand_on) {
  if (new_picture) ++number_;
  scene_ = scene;
  {
    const std::lock_guard lock(mutex_);
    asked_at_.emplace(number_, Clock::now());
  }
  renderer_.ask({.scene = scene, .number = number_, .hand_on = hand_on});
}

// On the renderer's thread.
void Hand::arrived() {
  const Clock::time_point now = Clock::now();
  window::ViewPicturePtr picture = renderer_.picture();
  {
    const std::lock_guard lock(mutex_);
    if (picture && picture != last_) {
      last_ = picture;
      if (const auto asked = asked_at_.find(picture->number); asked != asked_at_.end()) {
        if (const auto place = place_of_.find(picture->number);
            keeps_ && place != place_of_.end() && !keeps_(place->second)) {
          auto figures = std::make_shared<window::ViewPicture>(*picture);
          figures->frame = {.width = picture->frame.width, .height = picture->frame.height};
          picture = std::move(figures);
        }
        arrivals_.push_back(
            {1e3 * seconds_between(asked->second, now), seconds_between(begin_, now), std::move(picture)});
      }
    }
  }
  news_.notify_all();
}

void Hand::check(const Progress& progress, double share) {
  if (const std::string error = renderer_.status().error; !error.empty()) throw std::runtime_error(error);
  if (!progress(share)) throw RenderCancelled();
}

void Hand::wait(double most_seconds, const std::function<bool()>& ready, const Progress& progress) {
  for (;;) {
    const double passed = seconds_between(begin_, Clock::now());
    check(progress, std::min(1.0, passed / most_seconds));
    std::unique_lock lock(mutex_);
    if (ready() || passed >= most_seconds) return;
    news_.wait_for(lock, std::chrono::milliseconds(50));
  }
}

Hand::Movement Hand::move(double seconds, const std::function<SceneSnapshot(double u)>& scene_at,
                          const std::function<bool(double u)>& keeps, const Progress& progress) {
  begin();
  keeps_ = keeps;
  Movement movement;
  const std::uint64_t dropped = renderer_.status().dropped;
  const int turns = std::max(1, int(std::lround(60.0 * seconds)));
  for (int i = 0; i <= turns; ++i) {
    const double u = double(i) / turns;
    std::this_thread::sleep_until(
        begin_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(u * seconds)));
    {
      const std::lock_guard lock(mutex_);
      place_of_.emplace(number_ + 1, u);
    }
    ask(scene_at(u), true, true);
    ++movement.asked;
    check(progress, u);
  }
  // The last one that was asked for counts, too.
  const auto is_here = [&] { return !arrivals_.empty() && arrivals_.back().picture->number == number_; };
  wait(seconds + 10.0, is_here, progress);
  const std::lock_guard lock(mutex_);
  movement.seconds = arrivals_.empty() ? seconds : arrivals_.back().at_s;
  movement.arrivals = std::move(arrivals_);
  movement.dropped = renderer_.status().dropped - dropped;
  return movement;
}

std::vector<Hand::Arrival> Hand::rest(double most_seconds, const Progress& progress) {
  return let_go(scene_, false, most_seconds, progress);
}

std::vector<Hand::Arrival> Hand::rest(const SceneSnapshot& scene, double most_seconds,
                                      const Progress& progress) {
  return let_go(scene, true, most_seconds, progress);
}

std::vector<Hand::Arrival> Hand::let_go(const SceneSnapshot& scene, bool new_picture, double most_seconds,
                                        const Progress& progress) {
  begin();
  ask(scene, new_picture, false);
  const auto is_at_rest = [&] { return !arrivals_.empty() && arrivals_.back().picture->at_rest; };
  wait(most_seconds, is_at_rest, progress);
  const std::lock_guard lock(mutex_);
  return std::move(arrivals_);
}

double Hand::interrupt(const SceneSnapshot& scene, const SceneSnapshot& next, double after_seconds,
                       const Progress& progress) {
  begin();
  ask(scene, true, false);
  wait(
      after_seconds, [] { return false; }, progress);
  begin();
  ask(next, true, true);
  wait(
      60.0, [&] { return !arrivals_.empty() && arrivals_.back().picture->number == number_; }, progress);
  const std::lock_guard lock(mutex_);
  if (arrivals_.empty()) throw std::runtime_error("no picture came within a minute");
  return arrivals_.back().latency_ms;
}

}  // namespace plinian::cli
