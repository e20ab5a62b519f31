#include "core/integrate/ray_integral.h"

#include <cmath>
#include <limits>

#include "core/media/blackbody.h"
#include "core/shared/light_falloff.h"
#include "core/shared/phase.h"

namespace plinian {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double channel_is_dead = 40.0;  // [-] optical depth past which a channel asks for no more care

// Three-point Gauss-Legendre rule on [0, 1], exact to degree five.
constexpr double gauss_node[3] = {0.1127016653792583, 0.5, 0.8872983346207417};
constexpr double gauss_weight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

double mean(const dvec3& v) {
  return (v.x + v.y + v.z) / 3.0;
}
double least(const dvec3& v) {
  return glm::min(v.x, glm::min(v.y, v.z));
}

/// Adds the real roots of a t^2 + 2 b t + c to `out`.
void add_roots(double a, double b, double c, std::vector<double>& out) {
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0.0)) return;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (a != 0.0) out.push_back(q / a);
  if (q != 0.0) out.push_back(c / q);
}

/// Adds the distances where a ray crosses a light's cones and radius: its light has kinks there.
void add_light_kinks(const ReferenceScene::LightOptics& light, const Ray& ray, std::vector<double>& out) {
  if (light.type == LightType::directional) return;
  const dvec3 v = ray.origin - light.position;
  const double vv = glm::dot(v, v), vd = glm::dot(v, ray.direction);
  if (light.radius > 0.0f) add_roots(1.0, vd, vv - double(light.radius) * double(light.radius), out);
  if (light.type != LightType::spot) return;
  const double va = glm::dot(v, light.toward), da = glm::dot(ray.direction, light.toward);
  for (const double cosine : {light.cos_inner, light.cos_outer}) {
    const double c2 = cosine * cosine;
    add_roots(da * da - c2, va * da - c2 * vd, va * va - c2 * vv, out);
  }
}

}  // namespace

RayIntegral::RayIntegral(const ReferenceScene& scene) : scene_(scene), cursors_(scene.media.size()) {
  result_.lights.resize(scene.lights.size());
}

// Finds the pieces of every medium, and the sorted distances at which anything changes.
void RayIntegral::cut(const Ray& ray, double near) {
  cuts_.clear();
  for (std::size_t m = 0; m < cursors_.size(); ++m) {
    const ReferenceScene::MediumOptics& medium = scene_.media[m];
    Cursor& cursor = cursors_[m];
    cursor.pieces.clear();
    cursor.next = 0;
    cursor.active = nullptr;
    if (medium.extinction == dvec3(0.0) && medium.emission == 0.0) continue;
    // Transmittance is reported down to 1e-26, far below the view cut-off.
    medium.walk.pieces(ray, near, infinity, 60.0 / medium.weakest_extinction, cursor.pieces);
    for (const DensityPiece& piece : cursor.pieces) {
      if (cuts_.empty() || cuts_.back() != piece.begin) cuts_.push_back(piece.begin);
      cuts_.push_back(piece.end);
    }
  }
  if (cuts_.empty()) return;
  const auto [first, last] = std::minmax_element(cuts_.begin(), cuts_.end());
  const double begin = *first, end = *last;
  for (const ReferenceScene::LightOptics& light : scene_.lights)
    if (!light.dark) add_light_kinks(light, ray, cuts_);
  std::erase_if(cuts_, [&](double t) { return !(t >= begin && t <= end); });
  if (!std::is_sorted(cuts_.begin(), cuts_.end())) std::sort(cuts_.begin(), cuts_.end());
}

// Moves the cursors to the interval that begins here. False where no medium covers it.
bool RayIntegral::enter(double begin) {
  bool any = false;
  for (std::size_t m = 0; m < cursors_.size(); ++m) {
    Cursor& cursor = cursors_[m];
    for (; cursor.next < cursor.pieces.size() && cursor.pieces[cursor.next].end <= begin; ++cursor.next) {
      const DensityPiece& piece = cursor.pieces[cursor.next];
      tau_passed_ += scene_.media[m].extinction * piece.integral(piece.end);
    }
    const bool covered = cursor.next < cursor.pieces.size() && cursor.pieces[cursor.next].begin <= begin;
    cursor.active = covered ? &cursor.pieces[cursor.next] : nullptr;
    any |= covered;
  }
  return any;
}

// Optical depth of the view ray up to a distance in the current interval.
dvec3 RayIntegral::optical_depth(double t) const {
  dvec3 tau = tau_passed_;
  for (std::size_t m = 0; m < cursors_.size(); ++m)
    if (const DensityPiece* piece = cursors_[m].active)
      tau += scene_.media[m].extinction * piece->integral(t);
  return tau;
}

bool RayIntegral::fits(double begin, const dvec3& tau_begin, double end, const Limits& limits) const {
  if (end - begin > limits.length) return false;
  const dvec3 tau_end = optical_depth(end);
  for (int c = 0; c < 3; ++c)
    if (tau_begin[c] < channel_is_dead && tau_end[c] - tau_begin[c] > limits.optical_depth) return false;
  for (const ReferenceScene::LightOptics& light : scene_.lights) {
    if (light.type == LightType::directional || light.dark) continue;
    const double closest = glm::dot(light.position - ray_.origin, ray_.direction);
    const dvec3 point = ray_.origin + ray_.direction * glm::clamp(closest, begin, end);
    const double distance = glm::max(glm::distance(point, light.position),
                                     double(glm::max(light.radius, shared::smallest_light_distance)));
    if (end - begin > limits.light_share * distance) return false;
  }
  return true;
}

// Adds an interval's quadrature nodes to the step, and what needs no light ray to the result.
void RayIntegral::add(double begin, double end) {
  for (int k = 0; k < 3; ++k) {
    const double t = begin + (end - begin) * gauss_node[k];
    const dvec3 transmitted = glm::exp(-optical_depth(t)) * ((end - begin) * gauss_weight[k]);
    node_t_.push_back(t);
    for (std::size_t m = 0; m < cursors_.size(); ++m) {
      const DensityPiece* piece = cursors_[m].active;
      if (!piece) {
        node_weights_.push_back(dvec3(0.0));
        continue;
      }
      const ReferenceScene::MediumOptics& medium = scene_.media[m];
      const dvec3 seen = transmitted * piece->density(t);
      node_weights_.push_back(seen * medium.scattering);
      result_.ambient += seen * medium.scattering * scene_.ambient;
      if (medium.emission > 0.0) {
        const float kelvin =
            medium.temperature_offset +
            medium.temperature_scale * medium.walk.stored_temperature(ray_.origin + ray_.direction * t);
        result_.emission += seen * (medium.emission * double(shared::blackbody_gain(kelvin))) *
                            dvec3(blackbody_colour(kelvin));
      }
    }
  }
}

// Ends a step: traces light at the nodes of the Gauss rule that belongs to the weight sigma_s T of the step.
void RayIntegral::shade() {
  const std::size_t count = node_t_.size(), media = cursors_.size();
  if (count == 0) return;
  const double origin = node_t_.front();
  const auto weight = [&](std::size_t i) {
    double sum = 0.0;
    for (std::size_t m = 0; m < media; ++m) sum += mean(node_weights_[i * media + m]);
    return sum;
  };
  double total = 0.0, first = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    total += weight(i);
    first += weight(i) * (node_t_[i] - origin);
  }
  if (total > 0.0) {
    const double centre = first / total;
    double second = 0.0, third = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = node_t_[i] - origin - centre;
      second += weight(i) * x * x;
      third += weight(i) * x * x * x;
    }
    second /= total;
    third /= total;
    // Roots of x^2 - (third/second) x - second, the quadratic that is orthogonal to 1 and x under the weight.
    const double half = second > 0.0 ? 0.5 * third / second : 0.0;
    const double root = std::sqrt(half * half + second);
    const double x[2] = {centre + half - root, centre + half + root};
    const double width = x[1] - x[0];

    // Each medium and channel has a weight of its own: it shares itself out so that a linear J stays exact,
    // but never beyond the nodes, which keeps every share positive.
    for (std::size_t l = 0; l < scene_.lights.size(); ++l) {
      const ReferenceScene::LightOptics& light = scene_.lights[l];
      if (light.dark) continue;
      ReferenceScene::Arrival arrivals[2];
      for (int k = 0; k < 2; ++k)
        arrivals[k] = scene_.arrival(light, ray_.origin + ray_.direction * (origin + x[k]));
      for (std::size_t m = 0; m < media; ++m) {
        dvec3 whole(0.0), moment(0.0);
        for (std::size_t i = 0; i < count; ++i) {
          whole += node_weights_[i * media + m];
          moment += node_weights_[i * media + m] * (node_t_[i] - origin - x[0]);
        }
        const dvec3 far = width > 0.0 ? glm::clamp(moment / width, dvec3(0.0), whole) : 0.5 * whole;
        const Phase& phase = scene_.media[m].phase;
        for (int k = 0; k < 2; ++k) {
          // Light travels along -toward and leaves along -direction.
          const double cos_theta = glm::clamp(glm::dot(arrivals[k].toward, ray_.direction), -1.0, 1.0);
          const double p = shared::phase_function(static_cast<int>(phase.kind), static_cast<float>(cos_theta),
                                                  phase.g, phase.g_back, phase.blend);
          result_.lights[l] += (k == 0 ? whole - far : far) * arrivals[k].irradiance * p;
        }
      }
    }
  }
  node_t_.clear();
  node_weights_.clear();
}

// Distance in an interval where the mean transmittance falls under one half.
double RayIntegral::half_way(double begin, double end) const {
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (begin + end);
    (mean(glm::exp(-optical_depth(middle))) > 0.5 ? begin : end) = middle;
  }
  return end;
}

const RayRadiance& RayIntegral::integrate(const Ray& ray, double near, int level) {
  ray_ = ray;
  result_.ambient = result_.emission = dvec3(0.0);
  result_.transmittance = dvec3(1.0);
  result_.depth = infinity;
  result_.empty = true;
  std::fill(result_.lights.begin(), result_.lights.end(), dvec3(0.0));
  node_t_.clear();
  node_weights_.clear();
  tau_passed_ = dvec3(0.0);
  cut(ray, near);
  if (cuts_.empty()) return result_;
  result_.empty = false;

  dvec3 tau_whole(0.0);
  double voxel = infinity;
  bool hot = false;  // temperature varies from voxel to voxel
  for (std::size_t m = 0; m < cursors_.size(); ++m) {
    const ReferenceScene::MediumOptics& medium = scene_.media[m];
    for (const DensityPiece& piece : cursors_[m].pieces)
      tau_whole += medium.extinction * piece.integral(piece.end);
    // A medium beside the ray counts too: its shadow may fall on this one.
    voxel = glm::min(voxel, medium.walk.voxel_length(ray.direction));
    hot |= medium.emission > 0.0 && medium.walk.has_temperature();
  }
  result_.transmittance = glm::exp(-tau_whole);

  // A haze of a kilometre around smoke of a metre would take forever in steps of the smoke's voxels.
  voxel = glm::max(voxel, (cuts_.back() - cuts_.front()) / 4096.0);
  const double halvings = std::exp2(-level);
  const Limits step{scene_.steps.length * voxel * halvings, scene_.steps.optical_depth * halvings,
                    scene_.steps.light_distance * halvings};
  // Inside a step the weights are integrated more finely: transmittance, and the temperature of hot voxels.
  const Limits part{hot ? voxel * halvings : step.length, glm::min(step.optical_depth, 0.5),
                    step.light_share};

  const double view_cutoff = -std::log(scene_.steps.view_cutoff);
  double step_begin = 0.0;
  dvec3 step_tau(0.0);
  for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) {
    if (!(cuts_[i + 1] > cuts_[i]) || !enter(cuts_[i])) continue;
    const double length = cuts_[i + 1] - cuts_[i];
    const int equal_parts = glm::max(1, static_cast<int>(std::ceil(length / part.length)));
    for (int k = 0; k < equal_parts; ++k) {
      double begin = cuts_[i] + length * k / equal_parts;
      const double part_end = k + 1 == equal_parts ? cuts_[i + 1] : cuts_[i] + length * (k + 1) / equal_parts;
      while (begin < part_end) {
        const dvec3 tau = optical_depth(begin);
        if (least(tau) > view_cutoff) {
          shade();
          return result_;
        }
        double end = part_end;
        const Limits bound{infinity, part.optical_depth, part.light_share};
        while (!fits(begin, tau, end, bound)) {
          const double middle = 0.5 * (begin + end);
          if (!(middle > begin && middle < end)) break;  // at the end of double precision
          end = middle;
        }
        // What little light comes from the depth needs less care.
        const double deep = std::exp(scene_.steps.growth * least(step_tau));
        const Limits bound_here{step.length * deep, step.optical_depth * deep, step.light_share};
        if (!node_t_.empty() && !fits(step_begin, step_tau, end, bound_here)) shade();
        if (node_t_.empty()) step_begin = begin, step_tau = tau;
        if (result_.depth == infinity && mean(glm::exp(-optical_depth(end))) <= 0.5)
          result_.depth = half_way(begin, end);
        add(begin, end);
        begin = end;
      }
    }
  }
  shade();
  return result_;
}

}  // namespace plinian
