// A description made into nodes. What it leaves open is filled in by core's own functions (scene_loader.h),
// so that a scene is the same whichever way it comes.
#include "host/scene/import_description.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <future>

#include "core/media/frame_sequence.h"
#include "core/scene/framing.h"
#include "core/scene/medium_loader.h"
#include "core/scene/placement_angles.h"
#include "core/scene/scene_loader.h"
#include "core/scene/scene_parameters.h"
#include "host/graph/graph_error.h"
#include "host/nodes/read_facts.h"
#include "host/scene/medium_names.h"
#include "host/scene/sequence_setup.h"
#include "host/scene/snapshot.h"
#include "host/sdk/volume_table.h"

namespace plinian::scene {

namespace fs = std::filesystem;
using graph::quote;
using graph::write_number;

namespace {

std::string words_of(float value) {
  return write_number(value);
}
std::string words_of(double value) {
  return write_number(value);
}
std::string words_of(const vec2& v) {
  return write_number(v.x) + " " + write_number(v.y);
}
std::string words_of(const vec3& v) {
  return write_number(v.x) + " " + write_number(v.y) + " " + write_number(v.z);
}
std::string words_of(const dvec3& v) {
  return write_number(v.x) + " " + write_number(v.y) + " " + write_number(v.z);
}
std::string words_of(const std::string& text) {
  return quote(text);
}

// The word of an enumeration that a table of parameters declares.
template <class T, class Enum>
std::string word_of(const std::vector<Parameter<T>>& table, const char* parameter, Enum value) {
  return find_parameter(table, parameter)->spec.choices.at(std::size_t(value));
}

// Of the work on a medium; the rest is measuring it.
constexpr double reading_share = 0.9;

class Importer {
 public:
  Importer(graph::Session& session, const SceneDescription& description, const ImportOptions& options)
      : session_(session), description_(description), options_(options) {}

  ImportReport run() {
    for (const MediumDescription& medium : description_.media) check_medium(medium);
    need_shape_type();
    make_nodes();
    if (options_.nodes_made) options_.nodes_made();
    fill_media();
    if (options_.media_only) {
      ImportReport media = report();
      if (is_anything_dense()) media.extent = extent_text(scene_bounds(media_));
      return media;
    }
    to_show_.insert(to_show_.begin(), media_.begin(), media_.end());
    const SceneBounds bounds = scene_bounds(to_show_);
    const ivec2 size = description_.size.value_or(ivec2(512));
    const Camera camera = make_camera(description_, bounds, size, told_);
    fill_camera(camera);
    for (std::size_t i = 0; i < description_.lights.size(); ++i)
      fill_light(light_nodes_[i], description_.lights[i],
                 make_light(description_, description_.lights[i], camera, bounds, told_));
    return report();
  }

 private:
  struct MediumNodes {
    std::string medium, place, shape, source;  // source: empty for an analytic one
    std::vector<int> frames;                   // of a sequence
  };

  ImportReport report() {
    command("select -clear");
    return {std::move(told_.notes), std::move(told_.warnings), told_.seed, std::move(made_), ""};
  }
  bool is_anything_dense() const {
    return std::any_of(media_.begin(), media_.end(), [](const Medium& medium) {
      return medium.shape != MediumShape::voxels || (medium.volume && !medium.volume->empty());
    });
  }
  std::string command(const std::string& line) {
    const graph::CommandResult answers = session_.execute(line);
    return answers.empty() ? "" : answers.front();
  }
  std::string create(const std::string& type, const std::string& name, const std::string& parent = "") {
    const bool alone = session_.types().get(type)->spec().unique;
    const std::string wanted =
        (options_.name_space.empty() || alone ? "" : options_.name_space + ":") + node_name_of(name);
    made_.push_back(command("createNode " + type + " -name " + quote(wanted) +
                            (parent.empty() ? "" : " -parent " + parent)));
    return made_.back();
  }
  template <class T>
  void set(const std::string& plug, const T& value) {
    command("setAttr " + plug + " " + words_of(value));
  }
  void set_word(const std::string& plug, const std::string& word) { command("setAttr " + plug + " " + word); }

  void need_shape_type() {
    if (!session_.types().find("atfmVolume")) command("loadPlugin atfm");
  }

  void make_nodes() {
    make_settings();
    for (const MediumDescription& medium : description_.media) medium_nodes_.push_back(make_medium(medium));
    if (!options_.media_only) make_camera_and_lights();
  }

  // There is one of it in a scene; a volume that comes alone finds one or brings it, for there to be
  // something to set the size of a picture by.
  void make_settings() {
    const graph::Node* there = first_of_type(session_.graph(), "renderSettings");
    if (options_.media_only) {
      if (!there) command("createNode renderSettings -name settings");
      return;
    }
    const std::string settings = there ? there->name : create("renderSettings", "settings");
    if (description_.size) {
      set_word(settings + ".width", std::to_string(description_.size->x));
      set_word(settings + ".height", std::to_string(description_.size->y));
    }
    set(settings + ".background", background_of(description_));
    set_word(settings + ".default_lights", "false");  // a description says all that shines
  }

  void make_camera_and_lights() {
    camera_node_ = create("camera", "camera");
    for (const LightDescription& light : description_.lights)
      light_nodes_.push_back(create(light.type == LightType::spot    ? "spotLight"
                                    : light.type == LightType::point ? "pointLight"
                                                                     : "directionalLight",
                                    light.name));
    if (const vec3 ambient = ambient_of(description_); ambient != vec3(0.0f))
      set(create("ambientLight", "sky") + ".colour", ambient);
  }

  MediumNodes make_medium(const MediumDescription& d) {
    const std::string name = d.name.empty() ? "medium" : d.name;
    const MediumSource source = medium_source(d);
    MediumNodes nodes;
    nodes.place = create("transform", name + "_place");
    nodes.medium = create("medium", name);
    if (source == MediumSource::file) nodes.source = make_reader(d, name, nodes.frames);
    if (source == MediumSource::procedural) nodes.source = make_noise(d, name);
    nodes.shape = create("atfmVolume", name + "_shape", nodes.place);
    if (source == MediumSource::analytic) set_word(nodes.shape + ".draw", d.volume);
    if (!nodes.source.empty()) command("connectAttr " + nodes.source + ".volume " + nodes.shape + ".volume");
    if (source == MediumSource::file)
      command("connectAttr " + nodes.source + ".space " + nodes.shape + ".space");
    command("connectAttr " + nodes.medium + ".out " + nodes.shape + ".medium");
    const Placement placement = medium_placement(d);
    set(nodes.place + ".translate", placement.translate);
    set(nodes.place + ".rotate", placement.rotate);
    set(nodes.place + ".scale", placement.scale);
    return nodes;
  }

  std::string make_reader(const MediumDescription& d, const std::string& name, std::vector<int>& frames) {
    const std::string node = create("volumeRead", name + "_file");
    const std::string path = medium_path(d);
    set(node + ".file", fs::absolute(path).lexically_normal().string());
    const VdbOptions vdb = medium_vdb_options(d);
    set(node + ".grid", vdb.grid);
    set(node + ".temperature_grid", vdb.temperature_grid);
    set_word(node + ".level_set", word_of(medium_parameters(), "level_set", vdb.level_set));
    set_word(node + ".frustum", word_of(medium_parameters(), "frustum", vdb.frustum));
    set(node + ".time_limit", options_.vdb_time_limit_s);
    set(node + ".memory_limit", double(options_.vdb_memory_limit_bytes));
    const auto pattern = FramePattern::parse(path);
    if (!pattern || fs::exists(path)) return node;
    frames = pattern->frames_on_disk();
    const std::string time = session_.graph().find(session_.time_node())->name;
    command("connectAttr " + time + ".out " + node + ".time");
    command("connectAttr " + time + ".rate " + node + ".scene_rate");
    set(time + ".start", double(frames.front()));
    set(time + ".end", double(frames.back()));
    return node;
  }

  std::string make_noise(const MediumDescription& d, const std::string& name) {
    const std::string node = create("volumeNoise", name + "_noise");
    const ProceduralSettings settings = medium_procedural(d);
    set_word(node + ".kind", settings.kind);
    set_word(node + ".resolution", std::to_string(settings.resolution));
    set_word(node + ".seed", std::to_string(settings.seed));
    const auto known = procedural_parameters(settings.kind);
    for (const auto& [parameter, value] : settings.shape) {
      std::vector<std::string> names;
      for (const ProceduralParameter& p : known) {
        names.push_back(p.name);
        if (p.name == parameter && !(value >= p.low && value <= p.high))
          throw std::runtime_error(
              fmt::format("{}: {} {} is not in [{}, {}]", settings.kind, parameter, value, p.low, p.high));
      }
      if (std::find(names.begin(), names.end(), parameter) == names.end())
        throw std::runtime_error(fmt::format("{}: no parameter '{}'; there are: {}", settings.kind, parameter,
                                             fmt::join(names, ", ")));
      set(node + "." + settings.kind + "." + parameter, value);
    }
    return node;
  }

  bool tell(double part) const {
    return !options_.progress || options_.progress(share_ + part / double(medium_nodes_.size()));
  }

  // Does what takes its time on a thread of its own, while progress is told on this one.
  template <class Work>
  auto beside(const Work& work) {
    std::future<decltype(work())> result = std::async(std::launch::async, work);
    bool wanted = true;
    while (result.wait_for(std::chrono::milliseconds(2)) != std::future_status::ready)
      wanted = tell(reading_share) && wanted;
    auto done = result.get();
    if (!tell(1.0) || !wanted) throw SceneLoadCancelled();
    return done;
  }

  void fill_media() {
    for (std::size_t i = 0; i < medium_nodes_.size(); ++i) {
      const MediumNodes& nodes = medium_nodes_[i];
      const MediumDescription& d = description_.media[i];
      share_ = double(i) / double(medium_nodes_.size());
      SequenceSetup setup;
      if (!nodes.frames.empty())
        setup = read_sequence(nodes);
      else if (!nodes.source.empty())
        setup.volume = sdk::volume_in(evaluate(nodes.source + ".volume"));
      if (medium_source(d) == MediumSource::file) {
        if (nodes.frames.empty()) setup.facts = read_facts(nodes);
        const VdbOrientation space = medium_orientation(d, setup.facts);
        set_word(nodes.source + ".up_axis", std::string(1, space.up_axis));
        set(nodes.source + ".file_unit", space.file_unit);
      }
      // Measuring how dense a volume is looks at all of it.
      media_.push_back(beside([&] { return finish_medium(d, setup.volume, &setup.facts, told_); }));
      for (const auto& volume : setup.others) {
        to_show_.push_back(media_.back());
        to_show_.back().volume = volume;
      }
      fill_medium(nodes.medium, d, media_.back());
    }
  }

  VdbFacts read_facts(const MediumNodes& nodes) {
    const auto data = std::get<graph::DataPtr>(evaluate(nodes.source + ".facts"));
    return *static_cast<const VdbFacts*>(data->object.get());
  }

  // Where a camera has to be placed it has to show more of a sequence than one frame.
  bool places_camera() const {
    const CameraDescription& camera = description_.camera;
    return !options_.media_only && !camera.eye && !camera.translate && !camera.rotate;
  }

  SequenceSetup read_sequence(const MediumNodes& nodes) {
    SequenceSetup setup = set_up_sequence(nodes.frames, places_camera(), [&](int frame) -> SequenceFrame {
      command("currentTime " + std::to_string(frame));
      SequenceFrame found{sdk::volume_in(evaluate(nodes.source + ".volume")), read_facts(nodes)};
      found.readable = std::get<std::string>(evaluate(nodes.source + ".badge")).empty();
      return found;
    });
    if (!setup.note.empty()) told_.notes.push_back(setup.note);
    if (!setup.warning.empty()) told_.warnings.push_back(setup.warning);
    return setup;
  }

  graph::Value evaluate(const std::string& name) {
    const graph::Plug plug = session_.graph().plug(name);
    const bool finished =
        compute_plugs(session_, {plug}, [&](double part) { return tell(part * reading_share); });
    if (!finished) throw SceneLoadCancelled();
    const graph::ResultPtr result = session_.evaluator().evaluate(plug);
    session_.evaluator().take_reports();
    if (result->error) throw std::runtime_error(nodes::advice_for_command_line(result->error->message));
    return result->value;
  }

  void fill_medium(const std::string& node, const MediumDescription& d, const Medium& medium) {
    set(node + ".density_scale", medium.density_scale);
    set_coefficients(node, d, medium);
    set_word(node + ".phase", word_of(medium_parameters(), "phase", medium.phase.kind));
    set(node + ".g", medium.phase.g);
    set(node + ".g_back", medium.phase.g_back);
    set(node + ".blend", medium.phase.blend);
    set(node + ".emission_scale", medium.emission.scale);
    set(node + ".emission_exposure", medium.emission.exposure);
    set(node + ".temperature_scale", medium.emission.temperature_scale);
    set(node + ".temperature_offset", medium.emission.temperature_offset);
  }

  // Albedo and extinction where they scatter and weaken light the same to the bit, else the coefficients
  // themselves.
  void set_coefficients(const std::string& node, const MediumDescription& d, const Medium& medium) {
    const vec3 sum = medium.sigma_s + medium.sigma_a;
    vec3 share(0.0f);
    for (int i = 0; i < 3; ++i)
      if (sum[i] > 0.0f) share[i] = medium.sigma_s[i] / sum[i];
    for (const auto& [albedo, extinction] : {std::pair(d.albedo.value_or(share), d.extinction.value_or(sum)),
                                             std::pair(medium.sigma_s, vec3(1.0f))}) {
      const vec3 scattered = extinction * albedo, absorbed = extinction * (vec3(1.0f) - albedo);
      if (d.sigma_s || d.sigma_a || scattered != medium.sigma_s || scattered + absorbed != sum) continue;
      set(node + ".albedo", albedo);
      set(node + ".extinction", extinction);
      return;
    }
    set_word(node + ".coefficients", "sigma");
    set(node + ".sigma_s", medium.sigma_s);
    set(node + ".sigma_a", medium.sigma_a);
  }

  void fill_camera(const Camera& camera) {
    const std::string& node = camera_node_;
    set(node + ".translate", dvec3(camera.world_from_camera[3]));
    set(node + ".rotate", tidied(angles_of(camera.world_from_camera)));
    set(node + ".focal_length", camera.focal_length);
    set(node + ".film_back", camera.film_back);
    set_word(node + ".film_fit", word_of(camera_parameters(), "film_fit", camera.fit));
    set(node + ".film_offset", camera.film_offset);
    set(node + ".pixel_aspect", camera.pixel_aspect);
    set(node + ".near_clip", double(camera.near_clip));
  }

  void fill_light(const std::string& node, const LightDescription& d, const Light& light) {
    if (light.type != LightType::directional) set(node + ".translate", dvec3(light.position));
    if (light.type != LightType::point) set(node + ".rotate", short_angles_toward(light.toward));
    if (d.kelvin && !d.irradiance) {
      set_word(node + ".use_kelvin", "true");
      set(node + ".kelvin", *d.kelvin);
    } else {
      set(node + ".colour", light.colour);
    }
    set(node + ".intensity", light.intensity);
    set(node + ".exposure", light.exposure);
    if (light.type != LightType::directional) {
      set_word(node + ".falloff", word_of(light_parameters(), "falloff", light.falloff));
      set(node + ".radius", double(light.radius));
    }
    if (light.type == LightType::spot) {
      set(node + ".cone_angle", double(light.cone_angle));
      set(node + ".penumbra", double(light.penumbra));
    }
  }

  graph::Session& session_;
  const SceneDescription& description_;
  const ImportOptions& options_;
  std::vector<MediumNodes> medium_nodes_;
  std::string camera_node_;
  std::vector<std::string> made_;
  std::vector<std::string> light_nodes_;
  std::vector<Medium> media_;
  std::vector<Medium> to_show_;  // in the picture, by a camera that is placed: media_, and at other frames
  LoadedScene told_;
  double share_ = 0.0;  // of the media that have been read
};

}  // namespace

ImportReport import_description(graph::Session& session, const SceneDescription& description,
                                const ImportOptions& options) {
  return Importer(session, description, options).run();
}

}  // namespace plinian::scene
