#include "host/cli/drags.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "core/image/image_io.h"
#include "core/image/metrics.h"
#include "core/scene/framing.h"
#include "core/scene/placement.h"
#include "host/cli/hand.h"
#include "host/cli/renderers.h"
#include "host/cli/swim.h"

namespace plinian::cli {

using nlohmann::ordered_json;

namespace {

constexpr double promised_ms = 150.0, promised_ssim = 0.9;
constexpr double orbit_degrees = 45.0, key_degrees = 60.0;
constexpr int holds = 6;  // how often a picture that is refined is taken hold of

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const std::size_t at =
      std::min(values.size() - 1, std::size_t(std::max(0.0, std::ceil(share * double(values.size())) - 1.0)));
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(at), values.end());
  return values[at];
}

double share_of(const std::vector<double>& values, const std::function<bool(double)>& good) {
  return values.empty() ? 0.0
                        : double(std::count_if(values.begin(), values.end(), good)) / double(values.size());
}

// There and back: 0, 1, 0.
double there_and_back(double u) {
  return 1.0 - std::abs(2.0 * u - 1.0);
}

using Drag = std::function<SceneSnapshot(const SceneSnapshot&, double u)>;

const std::vector<std::pair<std::string, Drag>>& drags() {
  static const std::vector<std::pair<std::string, Drag>> all = {
      {"density",
       [](SceneSnapshot scene, double u) {
         for (Medium& medium : scene.media) medium.density_scale *= float(std::exp2(there_and_back(u)));
         return scene;
       }},
      {"key",
       [](SceneSnapshot scene, double u) {
         if (scene.lights.empty()) return scene;
         const dmat4 turned = turn(key_degrees * there_and_back(u), scene_bounds(scene.media).centre());
         Light& key = scene.lights.front();
         key.toward = normalize(vec3(dmat3(turned) * dvec3(key.toward)));
         key.position = vec3(dvec3(turned * dvec4(dvec3(key.position), 1.0)));
         return scene;
       }},
      {"camera", [](SceneSnapshot scene, double u) {
         const dmat4 turned = turn(orbit_degrees * there_and_back(u), scene_bounds(scene.media).centre());
         scene.camera.world_from_camera = turned * scene.camera.world_from_camera;
         return scene;
       }}};
  return all;
}

// As large as the window shows it: between the four pixels around each place. The window does so with what a
// display shows of them.
Image as_shown(const Frame& frame, int width, int height) {
  Image image = make_image(width, height);
  const auto place = [](int at, int of, int from) {
    return std::clamp((float(at) + 0.5f) * float(from) / float(of) - 0.5f, 0.0f, float(from - 1));
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float s = place(x, width, frame.width), t = place(y, height, frame.height);
      const int x0 = int(s), y0 = int(t), x1 = std::min(x0 + 1, frame.width - 1),
                y1 = std::min(y0 + 1, frame.height - 1);
      const auto at = [&](int i, int j) {
        return frame.beauty[std::size_t(j) * frame.width + std::size_t(i)];
      };
      const vec3 value = glm::mix(glm::mix(at(x0, y0), at(x1, y0), s - float(x0)),
                                  glm::mix(at(x0, y1), at(x1, y1), s - float(x0)), t - float(y0));
      for (int c = 0; c < 3; ++c)
        image.channels[std::size_t(c)].values[std::size_t(y) * width + x] = value[c];
    }
  return image;
}

struct Likeness {
  double ssim, psnr;
};
Likeness likeness(const Image& picture, const Image& truth) {
  const PicturePair pair = pair_pictures(picture, truth);
  const PixelMetrics metrics = pixel_metrics(pair);
  return {ssim(pair, metrics.peak), metrics.psnr};
}

ordered_json decibels(double psnr) {
  return std::isfinite(psnr) ? ordered_json(psnr) : ordered_json(nullptr);
}

// What most have.
template <class Value>
Value most_common(const std::vector<Value>& values) {
  std::map<Value, int> counts;
  for (const Value& value : values) ++counts[value];
  const auto most = std::max_element(counts.begin(), counts.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? Value() : most->first;
}

class Measurement {
 public:
  Measurement(const SceneSnapshot& scene, const DragOptions& options,
              const std::function<bool(double)>& progress)
      : scene_(scene), options_(options), progress_(progress) {
    // Roughly what each part takes [s].
    drag_s_ = options.seconds + 2.0;
    judge_s_ = 1.5 * options.samples;
    all_s_ = 3.0 * (drag_s_ + judge_s_) + 2.0 * options.rest_seconds + 40.0;
  }

  ordered_json run() {
    ordered_json report;
    std::vector<Hand::Movement> movements;
    std::vector<Hand::Arrival> before, after;
    {
      Hand hand([&] { return make_renderer(options_.renderer); });
      hand.rest(scene_, 60.0, part(1.0));
      for (const auto& [name, drag] : drags()) {
        movements.push_back(hand.move(
            options_.seconds, [&](double u) { return drag(scene_, u); }, keeper(), part(options_.seconds)));
        hand.rest(60.0, part(2.0));
      }
      report["rest"] = options_.rest_seconds > 0.0 ? rest(hand) : ordered_json(nullptr);
      report["take_hold_ms"] = take_hold(hand);
    }
    std::size_t i = 0;
    for (const auto& [name, drag] : drags()) report["drags"][name] = judge(name, movements[i++]);
    return {{"drags", report["drags"]}, {"rest", report["rest"]}, {"take_hold_ms", report["take_hold_ms"]}};
  }

 private:
  // The progress of a part that takes so long of the whole.
  Hand::Progress part(double seconds) {
    const double begin = done_s_;
    done_s_ += seconds;
    return [=, this](double share) { return progress_(std::min(1.0, (begin + share * seconds) / all_s_)); };
  }

  // The first picture in each of so many equal stretches of a drag.
  std::function<bool(double)> keeper() const {
    return [samples = options_.samples, last = -1](double u) mutable {
      const int stretch = std::min(samples - 1, int(u * samples));
      const bool keeps = stretch != last;
      last = stretch;
      return keeps;
    };
  }

  ordered_json judge(const std::string& name, const Hand::Movement& movement) {
    std::vector<double> latencies, renders, maps, views, likenesses;
    std::vector<std::pair<int, int>> sizes;
    std::vector<int> resolutions;
    int changes = 0;
    std::int64_t builds = 0;
    const auto renderer = make_renderer(options_.renderer);
    std::vector<const Hand::Arrival*> kept;
    for (const Hand::Arrival& arrival : movement.arrivals) {
      const window::ViewPicture& picture = *arrival.picture;
      latencies.push_back(arrival.latency_ms);
      maps.push_back(picture.stats.map_ms);
      views.push_back(picture.stats.view_ms);
      const std::pair size(picture.frame.width, picture.frame.height);
      changes += !sizes.empty() && (sizes.back() != size || resolutions.back() != picture.map_resolution);
      sizes.push_back(size);
      resolutions.push_back(picture.map_resolution);
      builds += picture.map_builds;
      if (!picture.frame.beauty.empty()) kept.push_back(&arrival);
    }
    for (const Hand::Arrival* arrival : kept) {
      const SceneSnapshot& scene = arrival->picture->scene;
      const ViewQuality& view = scene.quality.view;
      const auto step = part(judge_s_ / double(kept.size()));
      const Frame truth = renderer->render(scene, Passes(view.passes, view.rest_change), step);
      const Image shown = as_shown(arrival->picture->frame, scene.width, scene.height),
                  at_rest = as_shown(truth, scene.width, scene.height);
      likenesses.push_back(likeness(shown, at_rest).ssim);
      keep(fmt::format("{}_{:02}_quick", name, likenesses.size()), shown);
      keep(fmt::format("{}_{:02}_rest", name, likenesses.size()), at_rest);
    }
    const double in_time = share_of(latencies, [](double ms) { return ms <= promised_ms; });
    const double alike = share_of(likenesses, [](double s) { return s >= promised_ssim; });
    const auto size = most_common(sizes);
    return {{"asked", movement.asked},
            {"dropped", movement.dropped},
            {"pictures", movement.arrivals.size()},
            {"per_second", double(movement.arrivals.size()) / movement.seconds},
            {"latency_ms",
             {{"median", percentile(latencies, 0.5)},
              {"p95", percentile(latencies, 0.95)},
              {"worst", percentile(latencies, 1.0)}}},
            {"within_150_ms", in_time},
            {"ssim",
             {{"median", percentile(likenesses, 0.5)},
              {"p5", percentile(likenesses, 0.05)},
              {"worst", percentile(likenesses, 0.0)},
              {"samples", likenesses.size()}}},
            {"ssim_over_0.9", alike},
            {"size", {size.first, size.second}},
            {"map_resolution", most_common(resolutions)},
            {"changes", changes},
            {"map_ms", percentile(maps, 0.5)},
            {"view_ms", percentile(views, 0.5)},
            {"map_builds", builds}};
  }

  // A short drag of the camera, then nothing.
  ordered_json rest(Hand& hand) {
    SceneSnapshot scene = scene_;
    scene.quality = options_.rest;
    const Drag& camera = drags().back().second;
    const Hand::Movement movement = hand.move(
        std::min(1.0, options_.seconds), [&](double u) { return camera(scene, 0.2 * (1.0 - u)); },
        [](double) { return true; }, part(1.0));
    const std::vector<Hand::Arrival> arrivals = hand.rest(options_.rest_seconds, part(options_.rest_seconds));

    const Frame truth = make_renderer("reference")->render(scene, 1, [&, step = part(40.0)](double share) {
      return step(share);
    });
    const Image reference = as_shown(truth, scene.width, scene.height);
    ordered_json pictures = ordered_json::array(), after = ordered_json::object();
    for (const double seconds : {1.0, 2.0, 5.0, 10.0}) after[fmt::format("{}", seconds)] = nullptr;
    ordered_json at_rest_s = nullptr, passes = nullptr;
    for (const Hand::Arrival& arrival : arrivals) {
      const Image shown = as_shown(arrival.picture->frame, scene.width, scene.height);
      const ordered_json psnr = decibels(likeness(shown, reference).psnr);
      pictures.push_back({{"seconds", arrival.at_s}, {"passes", arrival.picture->passes}, {"psnr", psnr}});
      for (const double seconds : {1.0, 2.0, 5.0, 10.0})
        if (arrival.at_s <= seconds) after[fmt::format("{}", seconds)] = psnr;
      if (arrival.picture->at_rest) at_rest_s = arrival.at_s;
      passes = arrival.picture->passes;
      keep(fmt::format("rest_{:02}", pictures.size()), shown);
    }
    keep("rest_reference", reference);
    ordered_json pop = nullptr;
    if (!movement.arrivals.empty() && !arrivals.empty()) {
      const Image last = as_shown(movement.arrivals.back().picture->frame, scene.width, scene.height),
                  first = as_shown(arrivals.front().picture->frame, scene.width, scene.height);
      const Likeness like = likeness(last, first);
      pop = {{"ssim", like.ssim}, {"psnr", decibels(like.psnr)}};
      keep("rest_00", last);
    }
    return {{"preset", options_.rest.name}, {"psnr_after_s", after},
            {"at_rest_s", at_rest_s},       {"passes", passes},
            {"pictures", pictures},         {"pop", pop}};
  }

  ordered_json take_hold(Hand& hand) {
    const Drag& camera = drags().back().second;
    std::vector<double> times;
    for (int i = 0; i < holds; ++i) {
      SceneSnapshot scene = scene_;
      scene.quality = options_.rest;
      // Every time at another place of what is under way.
      times.push_back(
          hand.interrupt(camera(scene, 0.1 * (i % 2)), camera(scene, 0.05), 0.3 + 0.17 * i, part(1.0)));
    }
    return {{"median", percentile(times, 0.5)}, {"worst", percentile(times, 1.0)}};
  }

  void keep(const std::string& name, const Image& image) const {
    if (options_.folder.empty()) return;
    std::filesystem::create_directories(options_.folder);
    write_image((std::filesystem::path(options_.folder) / (name + ".png")).string(), image);
  }

  const SceneSnapshot& scene_;
  const DragOptions& options_;
  const std::function<bool(double)>& progress_;
  double drag_s_ = 0.0, judge_s_ = 0.0, all_s_ = 1.0, done_s_ = 0.0;
};

}  // namespace

ordered_json measure_drags(const SceneSnapshot& scene, const DragOptions& options,
                           const std::function<bool(double)>& progress) {
  return Measurement(scene, options, progress).run();
}

}  // namespace plinian::cli
