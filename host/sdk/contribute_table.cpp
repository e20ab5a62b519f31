// Checks and takes over what a shape adds. No exception leaves a function that a plug-in calls.
#include "host/sdk/contribute_table.h"

#include <algorithm>
#include <cmath>

#include "host/graph/graph_error.h"
#include "host/graph/values/value_text.h"
#include "host/sdk/contribution.h"
#include "host/sdk/plain_text.h"
#include "host/sdk/volume_table.h"

namespace plinian::sdk {

using graph::GraphError;

namespace {

struct ContributionState {
  ComputeState& compute;
  ShapeContribution result;
  graph::Hasher content;
  bool content_known = true;
};

ContributionState& state_of(PlinianContribution* contribution) {
  return *reinterpret_cast<ContributionState*>(contribution);
}

template <class Action>
int taken(PlinianContribution* contribution, const Action& action) {
  ContributionState& state = state_of(contribution);
  return guarded(state.compute.plain(), [&](ComputeState&) { action(state); });
}

// Checks numbers of one thing, named in errors, and takes them into the content.
class Reader {
 public:
  Reader(const char* what, const char* name, graph::Hasher& content)
      : what_(std::string("a ") + what + (name && *name ? " '" + std::string(name) + "'" : "")),
        content_(content) {
    content_.add(std::string_view(what_));
  }
  /// Throws GraphError unless lowest <= value <= highest.
  float number(const char* field, float value, float lowest = -1e30f, float highest = 1e30f) const {
    if (!(value >= lowest && value <= highest))
      throw GraphError(what_ + ": its " + field + " cannot be " + graph::write_number(value));
    content_.add(double(value));
    return value;
  }
  /// Throws likewise unless it lies between the ends, which it cannot be; so near to one that pictures of it
  /// could not be computed, it becomes what is nearest.
  float between(const char* field, float value, float low, float high, float nearest_low,
                float nearest_high) const {
    number(field, value, std::nextafter(low, high), std::nextafter(high, low));
    return std::clamp(value, nearest_low, nearest_high);
  }
  float positive(const char* field, float value) const { return number(field, value, 1e-30f); }
  float not_negative(const char* field, float value) const { return number(field, value, 0.0f); }
  vec3 colour(const char* field, const float (&value)[3]) const {
    return {not_negative(field, value[0]), not_negative(field, value[1]), not_negative(field, value[2])};
  }
  vec3 vector(const char* field, const float (&value)[3]) const {
    return {number(field, value[0]), number(field, value[1]), number(field, value[2])};
  }
  template <class Enum>
  Enum choice(const char* field, std::uint32_t value, Enum last) const {
    if (value > std::uint32_t(last))
      throw GraphError(what_ + ": there is no " + field + " " + std::to_string(value));
    content_.add(std::uint64_t(value));
    return Enum(value);
  }
  dmat4 matrix(const char* field, const double (&value)[16]) const {
    dmat4 matrix;
    for (int i = 0; i < 16; ++i) {
      matrix[i / 4][i % 4] = value[i];
      content_.add(value[i]);
    }
    const double size = determinant(dmat3(matrix));
    if (!std::isfinite(size) || size == 0.0 || row(matrix, 3) != dvec4(0.0, 0.0, 0.0, 1.0) ||
        !std::isfinite(dot(matrix[3], matrix[3])))
      throw GraphError(what_ + ": its " + field + " is no transform that could be taken back");
    return matrix;
  }
  const std::string& what() const { return what_; }

 private:
  static dvec4 row(const dmat4& m, int i) { return {m[0][i], m[1][i], m[2][i], m[3][i]}; }
  std::string what_;
  graph::Hasher& content_;
};

int add_medium(PlinianContribution* c, const PlinianMedium* plain) {
  return taken(c, [&](ContributionState& s) {
    const PlinianMedium from = whole(plain);
    const Reader read("medium", from.name, s.content);
    Medium medium;
    medium.name = text_of(from.name);
    medium.shape = read.choice("shape", from.shape, MediumShape::sphere);
    if (medium.shape == MediumShape::voxels) {
      if (!from.volume) throw GraphError(read.what() + " of voxels needs a volume");
      const graph::DataPtr volume = volume_data(s.compute, from.volume);
      medium.volume = std::static_pointer_cast<const BrickVolume>(volume->object);
      s.content.add(volume->content);
      s.content_known = s.content_known && volume->content != 0;
    }
    medium.world_from_medium = read.matrix("object_from_medium", from.object_from_medium);
    medium.density_scale = read.not_negative("density_scale", from.density_scale);
    medium.sigma_s = read.colour("sigma_s", from.sigma_s);
    medium.sigma_a = read.colour("sigma_a", from.sigma_a);
    medium.phase.kind = read.choice("phase", from.phase, PhaseKind::two_lobe);
    medium.phase.g = read.between("g", from.g, -1.0f, 1.0f, -0.99999f, 0.99999f);
    medium.phase.g_back = read.between("g_back", from.g_back, -1.0f, 1.0f, -0.99999f, 0.99999f);
    medium.phase.blend = read.number("blend", from.blend, 0.0f, 1.0f);
    medium.emission.scale = read.not_negative("emission_scale", from.emission_scale);
    medium.emission.exposure = read.number("emission_exposure", from.emission_exposure, -100.0f, 100.0f);
    medium.emission.temperature_scale = read.number("temperature_scale", from.temperature_scale);
    medium.emission.temperature_offset = read.number("temperature_offset", from.temperature_offset);
    s.result.media.push_back(std::move(medium));
  });
}

int add_light(PlinianContribution* c, const PlinianLight* plain) {
  return taken(c, [&](ContributionState& s) {
    const PlinianLight from = whole(plain);
    constexpr std::uint32_t ambient = 3;
    const Reader read("light", from.name, s.content);
    Light light;
    light.name = text_of(from.name);
    light.colour = read.colour("colour", from.colour);
    light.intensity = read.not_negative("intensity", from.intensity);
    light.exposure = read.number("exposure", from.exposure, -100.0f, 100.0f);
    if (from.type == ambient) {
      s.content.add(std::uint64_t(ambient));
      s.result.ambient += light.power();
      return;
    }
    light.type = read.choice("type", from.type, LightType::point);
    light.toward = read.vector("toward", from.toward);
    if (light.type != LightType::point) {
      if (!(dot(light.toward, light.toward) > 0.0f))
        throw GraphError(read.what() + ": its toward has no length");
      light.toward = normalize(light.toward);
    }
    light.position = read.vector("position", from.position);
    light.falloff = read.choice("falloff", from.falloff, Falloff::none);
    light.radius = read.not_negative("radius", from.radius);
    if (light.type == LightType::spot) {
      light.cone_angle = read.between("cone_angle", from.cone_angle, 0.0f, 180.0f, 0.001f, 179.0f);
      light.penumbra = read.not_negative("penumbra", from.penumbra);
    }
    s.result.lights.push_back(std::move(light));
  });
}

// A camera neither scales nor shears nor mirrors what it sees.
dmat4 rigid(const ContributionState& s, const Reader& read, const dmat4& matrix) {
  if (determinant(dmat3(matrix)) < 0.0)
    throw GraphError(read.what() + ": its object_from_camera mirrors: give it a rotation and a translation");
  const dmat4 result = rigid_part(matrix);
  double off = 0.0;
  for (int i = 0; i < 3; ++i) off = std::max(off, length(dvec3(matrix[i] - result[i])));
  // Floats that were turned into doubles are off by as much as floats are.
  constexpr double tolerance = 1e-5;
  if (off <= tolerance) return off > 1e-12 ? result : matrix;
  s.compute.context.warn(read.what() +
                         ": its object_from_camera scales or shears, which is left out: give it a rotation "
                         "and a translation");
  return result;
}

int add_camera(PlinianContribution* c, const PlinianCamera* plain) {
  return taken(c, [&](ContributionState& s) {
    const PlinianCamera from = whole(plain);
    const Reader read("camera", from.name, s.content);
    Camera camera;
    camera.world_from_camera = rigid(s, read, read.matrix("object_from_camera", from.object_from_camera));
    camera.focal_length = read.positive("focal_length", from.focal_length);
    for (int i = 0; i < 2; ++i) {
      camera.film_back[i] = read.positive("film_back", from.film_back[i]);
      camera.film_offset[i] = read.number("film_offset", from.film_offset[i]);
    }
    camera.fit = read.choice("fit", from.fit, FilmFit::overscan);
    camera.pixel_aspect = read.positive("pixel_aspect", from.pixel_aspect);
    camera.near_clip = read.not_negative("near_clip", from.near_clip);
    s.result.cameras.push_back({text_of(from.name), camera});
  });
}

int add_bounds(PlinianContribution* c, const double* minimum, const double* maximum) {
  return taken(c, [&](ContributionState& s) {
    ContributedBounds box;
    for (int i = 0; i < 3; ++i) {
      if (!std::isfinite(minimum[i]) || !std::isfinite(maximum[i]) || minimum[i] > maximum[i])
        throw GraphError("bounds must be finite, the minimum below the maximum");
      box.minimum[i] = minimum[i];
      box.maximum[i] = maximum[i];
      s.content.add(minimum[i]);
      s.content.add(maximum[i]);
    }
    if (auto& all = s.result.bounds)
      all = {min(all->minimum, box.minimum), max(all->maximum, box.maximum)};
    else
      all = box;
  });
}

const PlinianContribute contribute_table = {sizeof(PlinianContribute), add_medium, add_light, add_camera,
                                            add_bounds};

}  // namespace

graph::Value contribution_by(ContributeFunction contribute, void* user, ComputeState& compute) {
  ContributionState state{compute, {}, {}};
  contribute(user, &compute_table, compute.plain(), &contribute_table,
             reinterpret_cast<PlinianContribution*>(&state));
  if (!compute.failure.empty()) throw GraphError(compute.failure);
  const std::size_t bytes = sizeof(ShapeContribution) + state.result.media.size() * sizeof(Medium) +
                            state.result.lights.size() * sizeof(Light) +
                            state.result.cameras.size() * sizeof(ContributedCamera);
  const graph::Hash hash = state.content.result();
  const std::uint64_t content = state.content_known ? hash.low | 1u : 0u;  // 0 would mean unknown
  return std::make_shared<const graph::Data>(graph::Data{
      contribution_type, std::make_shared<const ShapeContribution>(std::move(state.result)), bytes, content});
}

}  // namespace plinian::sdk
