// One picture after the other, with maps as small as they are.
#include "host/window/looks/look_pictures.h"

#include <algorithm>
#include <exception>

#include "core/scene/medium_optics.h"
#include "host/window/view/same_picture.h"

namespace plinian::window {

namespace {

// What matters to pictures of all looks: the same whatever look the scene wears.
SceneSnapshot small(const SceneSnapshot& scene) {
  SceneSnapshot result = in_look(scene, {});
  result.width = std::max(1, scene.width * LookPictures::height / std::max(1, scene.height));
  result.height = LookPictures::height;
  result.quality = {};
  result.quality.map.resolution = 128;
  return result;
}

}  // namespace

SceneSnapshot in_look(SceneSnapshot scene, const MediumDescription& look) {
  for (Medium& medium : scene.media) {
    const Medium plain;
    medium.sigma_s = plain.sigma_s;
    medium.sigma_a = plain.sigma_a;
    medium.phase = plain.phase;
    medium.emission.scale = plain.emission.scale;
    medium.emission.exposure = plain.emission.exposure;
    set_optics(look, medium);
  }
  return scene;
}

LookPictures::LookPictures(std::function<std::unique_ptr<Renderer>()> make, std::function<void()> wake)
    : make_(std::move(make)),
      worker_([this](const Question& question) { return make_all(question); }, std::move(wake)) {}

LookPictures::~LookPictures() {
  stopping_ = true;
}

void LookPictures::update(const SceneSnapshot& scene, const ViewSettings& view) {
  if (scene.media.empty()) return forget();
  const std::vector<std::string> looks = scene::look_names();
  Development how;
  how.view = view;
  std::string words = words_of(how);
  for (const std::string& look : looks) words += "\n" + look;
  SceneSnapshot wanted = small(scene);
  if (asked_ && words == asked_words_ && same_picture(*asked_, wanted)) return;
  asked_words_ = std::move(words);
  asked_ = wanted;
  worker_.ask({std::move(wanted), view, looks});
}

std::vector<LookPicture> LookPictures::make_all(const Question& question) const {
  std::vector<LookPicture> all;
  std::unique_ptr<Renderer> renderer;
  for (const std::string& name : question.looks) {
    all.push_back({name, "", nullptr});
    try {
      if (!renderer) renderer = make_();
      const SceneSnapshot scene = in_look(question.scene, scene::load_look(name).medium);
      const Frame frame = renderer->render(scene, 1, [this](double) { return !stopping_; });
      auto picture = std::make_shared<Developed>();
      picture->width = frame.width;
      picture->height = frame.height;
      picture->bytes = to_display_bytes(visible_layers(frame, {}), ViewTransform(question.view));
      all.back().picture = std::move(picture);
    } catch (const RenderCancelled&) {
      break;
    } catch (const std::exception& error) {
      all.back().problem = error.what();
    }
  }
  return all;
}

}  // namespace plinian::window
