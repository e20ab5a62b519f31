// The renderer's thread.
#include "host/window/view/view_renderer.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "host/window/view/interactive_cost.h"
#include "host/window/view/quick_maps.h"
#include "host/window/view/relight.h"

namespace plinian::window {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Where the processor is the graphics card too, whoever draws the interface goes first. What the thread
// starts takes after it.
void step_back() {
  errno = 0;
  const id_t thread = id_t(gettid());
  setpriority(PRIO_PROCESS, thread, getpriority(PRIO_PROCESS, thread) + 5);
}

}  // namespace

ViewRenderer::ViewRenderer(Maker make, std::function<void()> wake)
    : make_(std::move(make)), wake_(std::move(wake)), thread_([this] { run(); }) {}

ViewRenderer::~ViewRenderer() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  news_.notify_all();
  thread_.join();
}

void ViewRenderer::ask(ViewRequest request) {
  {
    const std::lock_guard lock(mutex_);
    const ivec2 size(request.scene.width, request.scene.height);
    if (request.number == asked_number_ && size == asked_size_ && request.hand_on == asked_hand_on_ &&
        request.light_maps == asked_light_maps_)
      return;
    if (waiting_) ++status_.dropped;
    asked_number_ = request.number;
    asked_size_ = size;
    asked_hand_on_ = request.hand_on;
    asked_light_maps_ = request.light_maps;
    waiting_ = std::move(request);
  }
  news_.notify_all();
}

ViewPicturePtr ViewRenderer::picture() const {
  const std::lock_guard lock(mutex_);
  return picture_;
}

ViewRenderer::Status ViewRenderer::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

/// What the thread keeps from one request to the next.
class ViewRenderer::Thread {
 public:
  explicit Thread(ViewRenderer& owner) : owner_(owner) {}

  void serve(const ViewRequest& request) {
    if (!renderer_) renderer_ = owner_.make_();
    start_ = Clock::now();
    builds_ = renderer_->stats().map_builds;
    if (refines(request))
      add_light_maps(request);
    else if (!relight(request))
      render_quick(request);
    if (!request.hand_on && !is_overtaken(request) && !at_rest_) render_to_rest(request);
  }

 private:
  // Whether the picture that is up shows the same, only less refined.
  bool refines(const ViewRequest& request) const {
    return shown_number_ == request.number && shown_size_ == ivec2(request.scene.width, request.scene.height);
  }
  bool is_overtaken(const ViewRequest& request) const {
    const std::lock_guard lock(owner_.mutex_);
    return owner_.stopping_ || (owner_.waiting_ && (owner_.waiting_->number != request.number ||
                                                    owner_.waiting_->scene.width != request.scene.width ||
                                                    owner_.waiting_->scene.height != request.scene.height));
  }
  // Whether other media are to be seen than those of the request: its picture is of no use any more.
  bool is_of_another_scene(const ViewRequest& request) const {
    const std::lock_guard lock(owner_.mutex_);
    if (owner_.stopping_) return true;
    return owner_.waiting_ && !std::ranges::equal(owner_.waiting_->scene.media, request.scene.media, {},
                                                  &Medium::name, &Medium::name);
  }
  void tell_share(double share) const {
    const std::lock_guard lock(owner_.mutex_);
    owner_.status_.share = share;
  }

  // To a picture that is up already.
  void add_light_maps(const ViewRequest& request) {
    if (!request.light_maps || !shown_ || shown_->light_maps) return;
    copied_ = copy_light_maps(*renderer_, copied_);
    if (!copied_) return;
    auto picture = std::make_shared<ViewPicture>(*shown_);
    picture->light_maps = copied_;
    const bool is_base = rendered_ == shown_;
    show(std::move(picture));
    if (is_base) rendered_ = shown_;
  }

  // From the layers of what was rendered last, where only the power of lights is another one.
  bool relight(const ViewRequest& request) {
    if (!rendered_) return false;
    std::optional<Frame> frame = relit(rendered_->frame, rendered_->scene, request.scene);
    if (!frame) return false;
    const ViewPicturePtr base = rendered_;
    // The power of a light is in no map.
    publish(request, std::move(*frame), base->quick, base->at_rest, base->passes, base->light_maps);
    rendered_ = base;  // the next one is made of it, too: nothing is lost by many
    return true;
  }

  // A quick picture of a scene is finished whatever is tuned: else a hand that never rests would see none.
  void render_quick(const ViewRequest& request) {
    SceneSnapshot scene = request.scene;
    // Biased: see map_power(). What is shown at rest builds its own.
    scene.extinction_reuse = 2.0f;
    const ivec2 pane(scene.width, scene.height);
    const std::optional<int> serving = quick_maps_.serving(scene);
    const InteractiveCost::Choice choice =
        cost_.choose(pane, scene.quality.map.resolution, serving ? 0 : quick_maps_.builds(scene));
    scene.quality.map.resolution = serving.value_or(choice.resolution);
    const ivec2 size = InteractiveCost::size(pane, choice.scale);
    scene.width = size.x;
    scene.height = size.y;
    const std::int64_t builds = renderer_->stats().map_builds;
    const Clock::time_point begin = Clock::now();
    Frame frame = render(scene, Passes(1), [&](double share) {
      tell_share(share);
      return !is_of_another_scene(request);
    });
    const RenderStats& stats = renderer_->stats();
    cost_.took_view(size, milliseconds_since(begin) - stats.map_ms - stats.upload_ms);
    cost_.took_maps(scene.quality.map.resolution, int(stats.map_builds - builds), stats.map_ms);
    publish(request, std::move(frame), true, false, 1);
  }

  void render_to_rest(const ViewRequest& request) {
    const ViewQuality& view = request.scene.quality.view;
    Passes passes(view.passes, view.rest_change);
    Clock::time_point shown = Clock::now();
    passes.on_mean = [&](int done, const std::function<Frame()>& mean) {
      // Early passes change the picture most.
      constexpr double pause_ms = 200.0;
      if (done > 2 && milliseconds_since(shown) < pause_ms) return;
      publish(request, mean(), false, false, done);
      shown = Clock::now();
    };
    passes.after_pass = [&](int, std::optional<float>) { return !is_overtaken(request); };
    Frame frame = render(request.scene, passes, [&](double share) {
      tell_share(share);
      return !is_overtaken(request);
    });
    if (is_overtaken(request)) return;
    publish(request, std::move(frame), false, true, renderer_->stats().passes);
  }

  Frame render(const SceneSnapshot& scene, const Passes& passes, const Progress& progress) {
    // After a first pass the maps are there, whatever ends the picture.
    bool maps_there = false;
    map_resolution_ = scene.quality.map.resolution;
    Passes told = passes;
    told.on_mean = [&](int done, const std::function<Frame()>& mean) {
      if (!maps_there) quick_maps_.rendered(scene);
      maps_there = true;
      if (passes.on_mean) passes.on_mean(done, mean);
    };
    try {
      Frame frame = renderer_->render(scene, told, progress);
      if (!maps_there) quick_maps_.forget();  // there is nothing in the scene
      return frame;
    } catch (...) {
      if (!maps_there) quick_maps_.forget();
      throw;
    }
  }

  void publish(const ViewRequest& request, Frame frame, bool quick, bool at_rest, int passes,
               const LightMapCopyPtr& light_maps = nullptr) {
    auto picture = std::make_shared<ViewPicture>();
    picture->frame = std::move(frame);
    picture->scene = request.scene;
    picture->extent = extent_ = MediaExtent::of(request.scene.media, extent_);
    picture->number = request.number;
    picture->time = request.time;
    picture->quick = quick;
    picture->at_rest = at_rest;
    picture->passes = passes;
    picture->map_resolution = map_resolution_;
    picture->stats = renderer_->stats();
    picture->map_builds = picture->stats.map_builds - std::exchange(builds_, picture->stats.map_builds);
    picture->render_ms = milliseconds_since(start_);
    if (request.light_maps)
      picture->light_maps = light_maps ? light_maps : copy_light_maps(*renderer_, copied_);
    copied_ = picture->light_maps;
    rendered_ = picture;
    at_rest_ = at_rest;
    shown_number_ = request.number;
    shown_size_ = {request.scene.width, request.scene.height};
    show(std::move(picture));
  }

  void show(ViewPicturePtr picture) {
    shown_ = picture;
    {
      const std::lock_guard lock(owner_.mutex_);
      owner_.picture_ = std::move(picture);
      owner_.status_.error.clear();
    }
    owner_.wake_();
  }

  ViewRenderer& owner_;
  std::unique_ptr<Renderer> renderer_;
  InteractiveCost cost_;
  QuickMaps quick_maps_;
  Clock::time_point start_;
  int map_resolution_ = 0;   // [texels] of what is rendered
  std::int64_t builds_ = 0;  // of maps, up to the last picture
  ViewPicturePtr rendered_, shown_;
  MediaExtent::Ptr extent_;
  LightMapCopyPtr copied_;  // of the last picture that wanted light maps
  bool at_rest_ = false;
  std::uint64_t shown_number_ = 0;
  ivec2 shown_size_{0};
};

void ViewRenderer::run() {
  step_back();
  Thread thread(*this);
  for (;;) {
    ViewRequest request;
    {
      std::unique_lock lock(mutex_);
      status_.is_busy = false;
      lock.unlock();
      wake_();
      lock.lock();
      news_.wait(lock, [&] { return stopping_ || waiting_; });
      if (stopping_) return;
      request = std::move(*waiting_);
      waiting_.reset();
      status_.is_busy = true;
      status_.share = 0.0;
      ++status_.begun;
    }
    try {
      thread.serve(request);
    } catch (const RenderCancelled&) {
      // A newer request waits.
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex_);
      status_.error = error.what();
    }
  }
}

}  // namespace plinian::window
