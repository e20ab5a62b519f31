// The offline reference against closed forms and independent quadrature, relative error under 1e-4.
#include "core/integrate/dual_march.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "core/media/blackbody.h"
#include "tests/core/integrate/closed_forms.h"
#include "tests/core/integrate/one_pixel.h"

namespace plinian {
namespace {

constexpr double tolerance = 1e-4;

// A view ray ends at a transmittance of 1e-6 and a light ray at 2e-9: what would shine from behind, by a
// light of irradiance 1 on an isotropic medium, is less than this. It matters to truths that are themselves
// that dark alone.
constexpr double cut_off = 1e-6 * truth::isotropic;

Frame render(const SceneSnapshot& scene) {
  return DualMarch().render(scene);
}

double henyey_greenstein(double cosine, double g) {
  return truth::isotropic * (1 - g * g) / std::pow(1 + g * g - 2 * g * cosine, 1.5);
}

// Box
// ---------------------------------------------------------------------------------------------------------------

TEST(DualMarch, BoxLitFromTheCameraIsHalfOfOneMinusTheSquaredTransmittance) {
  // In and out along the same line: integral of sigma_s e^(-2 sigma_t x) dx, per channel.
  SceneSnapshot scene = one_pixel({0, 0, 6}, {0, 0, 0});
  scene.media = {analytic_medium(MediumShape::box, {0.6f, 1.5f, 4.0f}, {0.2f, 0.0f, 2.0f})};
  scene.lights = {sun({0, 0, 1}, {3.0f, 2.0f, 5.0f})};
  const Frame frame = render(scene);
  const double sigma_s[3] = {0.6, 1.5, 4.0}, sigma_t[3] = {0.8, 1.5, 6.0}, irradiance[3] = {3, 2, 5};
  for (int c = 0; c < 3; ++c) {
    const double truth =
        sigma_s[c] * truth::isotropic * irradiance[c] * -std::expm1(-4 * sigma_t[c]) / (2 * sigma_t[c]);
    EXPECT_RELATIVE(frame.beauty[0][c], truth, tolerance);
    EXPECT_RELATIVE(frame.transmittance[0][c], std::exp(-2 * sigma_t[c]), tolerance);
  }
}

TEST(DualMarch, BoxLitFromAnyDirectionMatchesItsClosedForm) {
  const dvec3 eye(3, 2.5, 6);
  const dvec3 towards[] = {{0.8, 0.45, 0.25}, {-1, 0, 0},       {0, 1, 0},
                           {-0.3, -0.2, -1},  {0.1, 0.9, -0.4}, {0.5, 0.4, 1}};
  for (const dvec3& target : {dvec3(0, 0, 0), dvec3(0.6, -0.4, 0.3), dvec3(-0.85, 0.9, 0.7)})
    for (const dvec3& toward : towards)
      for (const double density : {0.05, 1.0, 30.0}) {
        SceneSnapshot scene = one_pixel(eye, target);
        Medium box = analytic_medium(MediumShape::box, vec3(0.7f), vec3(0.3f));
        box.density_scale = static_cast<float>(density);
        scene.media = {box};
        scene.lights = {sun(toward)};
        const double truth =
            truth::box_directional(eye, glm::normalize(target - eye), dvec3(1.0), glm::normalize(toward),
                                   density, 0.7 * density, 1.0, truth::isotropic);
        EXPECT_NEAR(render(scene).beauty[0].y, truth, tolerance * truth + cut_off)
            << "toward " << toward.x << ' ' << toward.y << ' ' << toward.z << ", density " << density;
      }
}

TEST(DualMarch, BoxSeenFromInsideStartsAtTheCamera) {
  const dvec3 eye(0.25, -0.5, 0.5), target(0.5, 0.75, -2), toward(0.3, 0.6, 0.5);
  SceneSnapshot scene = one_pixel(eye, target);
  scene.media = {analytic_medium(MediumShape::box, vec3(1.2f), vec3(0.3f))};
  scene.lights = {sun(toward)};
  const dvec3 d = glm::normalize(target - eye);
  EXPECT_RELATIVE(
      render(scene).beauty[0].x,
      truth::box_directional(eye, d, dvec3(1.0), glm::normalize(toward), 1.5, 1.2, 1.0, truth::isotropic),
      tolerance);
  // Nothing is seen in front of the near plane.
  scene.camera.near_clip = 0.5f;
  EXPECT_RELATIVE(render(scene).beauty[0].x,
                  truth::box_directional(eye, d, dvec3(1.0), glm::normalize(toward), 1.5, 1.2, 1.0,
                                         truth::isotropic, 0.5),
                  tolerance);
}

TEST(DualMarch, PhaseFunctionsWeighTheAngleBetweenTheWaysOfTheLight) {
  const dvec3 eye(1, 2, 6), d = glm::normalize(dvec3(0) - eye);
  for (const dvec3& toward : {dvec3(0.8, 0.45, 0.25), -eye, eye}) {
    SceneSnapshot scene = one_pixel(eye, dvec3(0));
    Medium box = analytic_medium(MediumShape::box, vec3(1.0f), vec3(0.5f));
    box.phase = {.kind = PhaseKind::henyey_greenstein, .g = 0.6f};
    scene.media = {box};
    scene.lights = {sun(toward)};
    // A light behind the medium shines straight on into the camera: toward . d = 1 is forward scattering.
    const double phase = henyey_greenstein(glm::dot(glm::normalize(toward), d), 0.6);
    const double forward =
        truth::box_directional(eye, d, dvec3(1.0), glm::normalize(toward), 1.5, 1.0, 1.0, phase);
    EXPECT_RELATIVE(render(scene).beauty[0].y, forward, tolerance);

    scene.media[0].phase = {.kind = PhaseKind::two_lobe, .g = 0.6f, .g_back = -0.3f, .blend = 0.25f};
    const double lobes = 0.75 * phase + 0.25 * henyey_greenstein(glm::dot(glm::normalize(toward), d), -0.3);
    EXPECT_RELATIVE(render(scene).beauty[0].y, forward / phase * lobes, tolerance);
  }
}

// Sphere
// ------------------------------------------------------------------------------------------------------------

TEST(DualMarch, SphereMatchesTheIntegralOverItsChord) {
  const dvec3 eye(0.5, 1, 5);
  for (const dvec3& target : {dvec3(0, 0, 0), dvec3(0.5, 0.25, 0), dvec3(-0.7, 0.5, 0.2)})
    for (const dvec3& toward : {dvec3(0.8, 0.45, 0.25), dvec3(0, 1, 0), dvec3(-1, 0.2, -0.8)})
      for (const double sigma_t : {0.1, 2.0, 40.0}) {
        SceneSnapshot scene = one_pixel(eye, target);
        scene.media = {
            analytic_medium(MediumShape::sphere, vec3(float(0.75 * sigma_t)), vec3(float(0.25 * sigma_t)))};
        scene.lights = {sun(toward)};
        const dvec3 d = glm::normalize(target - eye), w = glm::normalize(toward);
        const double b = glm::dot(eye, d), root = std::sqrt(b * b - glm::dot(eye, eye) + 1.0);
        const auto integrand = [&](double t) {
          const dvec3 p = eye + t * d;
          const double pw = glm::dot(p, w);
          const double out = -pw + std::sqrt(std::max(0.0, pw * pw - glm::dot(p, p) + 1.0));
          return 0.75 * sigma_t * truth::isotropic * std::exp(-sigma_t * (t + b + root + out));
        };
        const double truth = truth::integrate(integrand, -b - root, -b + root);
        const Frame frame = render(scene);
        EXPECT_NEAR(frame.beauty[0].z, truth, tolerance * truth + cut_off) << "sigma_t " << sigma_t;
        EXPECT_RELATIVE(frame.transmittance[0].z, std::exp(-2 * sigma_t * root), tolerance)
            << "sigma_t " << sigma_t;
      }
}

// What needs no light
// -----------------------------------------------------------------------------------------------

TEST(DualMarch, AmbientIsAlbedoTimesOpacity) {
  SceneSnapshot scene = one_pixel({0, 0, 6}, {0, 0, 0});
  scene.media = {analytic_medium(MediumShape::box, {0.2f, 0.5f, 9.0f}, {0.1f, 0.5f, 1.0f})};
  scene.ambient = {2.0f, 1.0f, 0.5f};
  const Frame frame = render(scene);
  const double albedo[3] = {2.0 / 3.0, 0.5, 0.9}, sigma_t[3] = {0.3, 1.0, 10.0};
  for (int c = 0; c < 3; ++c) {
    const double truth = scene.ambient[c] * albedo[c] * -std::expm1(-2 * sigma_t[c]);
    EXPECT_RELATIVE(frame.ambient[0][c], truth, tolerance);
    EXPECT_EQ(frame.beauty[0][c], frame.ambient[0][c]);
  }
}

TEST(DualMarch, EmissionIsItsColourTimesTheMeanFreePathsSeen) {
  SceneSnapshot scene = one_pixel({0, 0, 6}, {0, 0, 0});
  Medium box = analytic_medium(MediumShape::box, vec3(0.0f), {0.5f, 0.0f, 3.0f});
  box.density_scale = 2.0f;
  box.emission = {.scale = 0.25f, .exposure = 1.0f, .temperature_offset = 2700.0f};
  scene.media = {box};
  const Frame frame = render(scene);
  const vec3 colour = blackbody_colour(2700.0f);
  // density_scale * scale * 2^exposure * (2700/1800)^4 over a depth of 2; a channel without extinction sees
  // it all.
  const double strength = 2.0 * 0.25 * 2.0 * 5.0625, sigma_t[3] = {1.0, 0.0, 6.0};
  for (int c = 0; c < 3; ++c) {
    const double seen = sigma_t[c] > 0 ? -std::expm1(-2 * sigma_t[c]) / sigma_t[c] : 2.0;
    EXPECT_RELATIVE(frame.emission[0][c], strength * colour[c] * seen, tolerance);
    EXPECT_EQ(frame.beauty[0][c], frame.emission[0][c]);
  }
}

TEST(DualMarch, BackgroundIsSeenThroughTheMediumAndAroundIt) {
  SceneSnapshot scene = one_pixel({0, 0, 6}, {0, 0, 0});
  scene.media = {analytic_medium(MediumShape::box, {0.1f, 0.0f, 2.0f}, {0.1f, 0.3f, 0.5f})};
  scene.background = {1.0f, 2.0f, 3.0f};
  const Frame frame = render(scene);
  EXPECT_RELATIVE(frame.background[0].x, std::exp(-0.4), tolerance);
  EXPECT_RELATIVE(frame.background[0].y, 2 * std::exp(-0.6), tolerance);
  EXPECT_RELATIVE(frame.background[0].z, 3 * std::exp(-5.0), tolerance);

  SceneSnapshot beside = one_pixel({0, 0, 6}, {3, 0, 0});
  beside.media = scene.media;
  beside.background = scene.background;
  EXPECT_EQ(render(beside).beauty[0], scene.background);
  EXPECT_EQ(render(beside).transmittance[0], vec3(1.0f));
}

TEST(DualMarch, DepthIsWhereAlphaPassesOneHalf) {
  SceneSnapshot scene = one_pixel({0, 0, 6}, {0, 0, 0});
  scene.media = {analytic_medium(MediumShape::box, vec3(0.5f), vec3(1.5f))};
  EXPECT_RELATIVE(render(scene).depth[0], 5.0 + std::log(2.0) / 2.0, 1e-6);
  scene.media[0].density_scale = 0.1f;  // 1 - e^-0.4 stays under one half
  EXPECT_TRUE(std::isinf(render(scene).depth[0]));
}

// Point and spot lights
// ---------------------------------------------------------------------------------------------

/// Radiance along eye + t d in the unit box from a light at `lamp`: E(p) is its irradiance before shadowing.
double box_near_light(dvec3 eye, dvec3 d, dvec3 lamp, double sigma_t, double sigma_s,
                      const std::function<double(dvec3)>& irradiance, std::vector<double> cuts = {}) {
  double in, out;
  truth::box_chord(eye, d, dvec3(1.0), in, out);
  in = std::max(in, 0.0);
  const auto integrand = [&](double t) {
    const dvec3 p = eye + t * d;
    const dvec3 w = glm::normalize(lamp - p);
    const double shadow = std::min(truth::box_way_out(p, w, dvec3(1.0)), glm::distance(p, lamp));
    return sigma_s * truth::isotropic * irradiance(p) * std::exp(-sigma_t * (t - in + shadow));
  };
  cuts.push_back(glm::dot(lamp - eye, d));  // closest to the light: the integrand's peak
  cuts.push_back(in);
  cuts.push_back(out);
  std::sort(cuts.begin(), cuts.end());
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    if (cuts[i] >= in && cuts[i + 1] <= out && cuts[i + 1] > cuts[i])
      sum += truth::integrate(integrand, cuts[i], cuts[i + 1], 1e-9);
  return sum;
}

TEST(DualMarch, PointLightInsideAndOutsideABoxMatchesQuadrature) {
  const dvec3 eye(1, 2, 6), target(0.125, 0.25, 0), d = glm::normalize(target - eye);
  for (const dvec3& lamp :
       {dvec3(0.25, 0.5, 0.25), dvec3(0.0, -0.75, 0.5), dvec3(2, 3, 1), dvec3(0.126, 0.25, 0)})
    for (const Falloff falloff : {Falloff::inverse_square, Falloff::linear, Falloff::none}) {
      SceneSnapshot scene = one_pixel(eye, target);
      scene.media = {analytic_medium(MediumShape::box, vec3(1.2f), vec3(0.3f))};
      Light light;
      light.type = LightType::point;
      light.position = vec3(lamp);
      light.falloff = falloff;
      light.intensity = 3.0f;
      light.exposure = 1.0f;
      scene.lights = {light};
      const double power = falloff == Falloff::inverse_square ? 2.0 : falloff == Falloff::linear ? 1.0 : 0.0;
      const dvec3 at(light.position);
      const double truth = box_near_light(
          eye, d, at, 1.5, 1.2, [&](dvec3 p) { return 6.0 / std::pow(glm::distance(p, at), power); });
      EXPECT_RELATIVE(render(scene).beauty[0].y, truth, tolerance)
          << "lamp at " << lamp.x << ' ' << lamp.y << ' ' << lamp.z << ", falloff " << int(falloff);
    }
}

TEST(DualMarch, RadiusHoldsTheFalloffInsideALamp) {
  const dvec3 eye(0, 0, 6), lamp(0.125, 0, 0);
  const double radius = 0.5;
  SceneSnapshot scene = one_pixel(eye, dvec3(0));
  scene.media = {analytic_medium(MediumShape::box, vec3(0.5f), vec3(0.5f))};
  Light light;
  light.type = LightType::point;
  light.position = vec3(lamp);
  light.radius = static_cast<float>(radius);
  scene.lights = {light};
  const double reach = std::sqrt(radius * radius - 0.125 * 0.125);
  const double truth =
      box_near_light(eye, {0, 0, -1}, lamp, 1.0, 0.5,
                     [&](dvec3 p) { return 1.0 / std::pow(std::max(glm::distance(p, lamp), radius), 2.0); },
                     {6 - reach, 6 + reach});
  EXPECT_RELATIVE(render(scene).beauty[0].y, truth, tolerance);
}

TEST(DualMarch, SpotConesHaveASoftEdgeAndNothingOutside) {
  // The lamp above the box shines down; the ray crosses its cone from side to side.
  const dvec3 lamp(0, 3, 0), eye(-6, 0.25, 0), d(1, 0, 0);
  for (const double penumbra : {0.0, 4.0}) {
    SceneSnapshot scene = one_pixel(eye, eye + d);
    scene.media = {analytic_medium(MediumShape::box, vec3(1.2f), vec3(0.3f))};
    Light light;
    light.type = LightType::spot;
    light.position = vec3(lamp);
    light.toward = {0, 1, 0};
    light.cone_angle = 30.0f;
    light.penumbra = static_cast<float>(penumbra);
    scene.lights = {light};
    constexpr double degree = std::numbers::pi / 180.0;
    const double inner = std::cos((15 - penumbra) * degree), outer = std::cos(15 * degree);
    const auto irradiance = [&](dvec3 p) {
      const double r = glm::distance(p, lamp), cosine = (lamp - p).y / r;
      const double x =
          penumbra > 0 ? std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0) : cosine > outer;
      return x * x * (3 - 2 * x) / (r * r);
    };
    std::vector<double> cuts;
    for (const double angle : {15.0, 15.0 - penumbra})
      for (const double side : {-1.0, 1.0}) cuts.push_back(6 + side * 2.75 * std::tan(angle * degree));
    EXPECT_RELATIVE(render(scene).beauty[0].x, box_near_light(eye, d, lamp, 1.5, 1.2, irradiance, cuts),
                    tolerance);

    SceneSnapshot beside = one_pixel({-6, 0.25, 0.75}, {0, 0.25, 0.75});  // 15.3 degrees off the axis
    beside.media = scene.media;
    beside.lights = scene.lights;
    EXPECT_EQ(render(beside).beauty[0], vec3(0.0f));
  }
}

// Several media
// -----------------------------------------------------------------------------------------------------

TEST(DualMarch, CoincidingMediaAddTheirCoefficients) {
  const dvec3 eye(3, 2.5, 6), toward(0.8, 0.45, 0.25);
  SceneSnapshot two = one_pixel(eye, {0.25, 0, 0});
  two.media = {analytic_medium(MediumShape::box, {0.5f, 0.1f, 2.0f}, {0.1f, 0.2f, 0.3f}),
               analytic_medium(MediumShape::box, {0.2f, 0.9f, 0.0f}, {0.4f, 0.0f, 1.0f})};
  two.media[1].phase = {.kind = PhaseKind::henyey_greenstein, .g = -0.4f};
  two.lights = {sun(toward)};
  const Frame frame = render(two);
  const dvec3 d = glm::normalize(dvec3(0.25, 0, 0) - eye), w = glm::normalize(toward);
  const double phase = henyey_greenstein(glm::dot(d, w), -0.4);
  const double first[3] = {0.5, 0.1, 2.0}, second[3] = {0.2, 0.9, 0.0}, sigma_t[3] = {1.2, 1.2, 3.3};
  for (int c = 0; c < 3; ++c)
    EXPECT_RELATIVE(frame.beauty[0][c],
                    truth::box_directional(eye, d, dvec3(1.0), w, sigma_t[c],
                                           first[c] * truth::isotropic + second[c] * phase, 1.0, 1.0),
                    tolerance);
}

TEST(DualMarch, PartlyOverlappingMediaShadowEachOther) {
  // Boxes over z in [-1, 1] and [-2, 0], seen and lit along z: three slabs of constant coefficients.
  SceneSnapshot scene = one_pixel({0.125, 0.25, 9}, {0.125, 0.25, 0});
  scene.media = {
      analytic_medium(MediumShape::box, vec3(0.3f), vec3(0.1f)),
      analytic_medium(MediumShape::box, vec3(0.2f), vec3(0.7f), glm::translate(dmat4(1), dvec3(0, 0, -1)))};
  scene.lights = {sun({0, 0, 1})};
  const double sigma_s[3] = {0.3, 0.5, 0.2}, sigma_t[3] = {0.4, 1.3, 0.9};  // each one long, from the front
  double truth = 0, tau = 0;
  for (int i = 0; i < 3; ++i) {
    truth +=
        sigma_s[i] * truth::isotropic * std::exp(-2 * tau) * -std::expm1(-2 * sigma_t[i]) / (2 * sigma_t[i]);
    tau += sigma_t[i];
  }
  const Frame frame = render(scene);
  EXPECT_RELATIVE(frame.beauty[0].x, truth, tolerance);
  EXPECT_RELATIVE(frame.transmittance[0].x, std::exp(-tau), tolerance);
}

TEST(DualMarch, AMediumBesideTheRayCastsItsShadow) {
  // The lit box is at the origin; the other one stands between it and the light, off the view ray.
  const dvec3 eye(0, 0, 6);
  SceneSnapshot scene = one_pixel(eye, {0, 0, 0});
  scene.media = {
      analytic_medium(MediumShape::box, vec3(0.5f), vec3(0.5f)),
      analytic_medium(MediumShape::box, vec3(0.1f), vec3(0.3f),
                      glm::translate(dmat4(1), dvec3(0, 5, 0)) * glm::scale(dmat4(1), dvec3(4, 0.5, 4)))};
  scene.lights = {sun({0, 1, 0})};
  const double truth = std::exp(-0.4) * truth::box_directional(eye, {0, 0, -1}, dvec3(1.0), {0, 1, 0}, 1.0,
                                                               0.5, 1.0, truth::isotropic);
  EXPECT_RELATIVE(render(scene).beauty[0].y, truth, tolerance);
}

// Voxels
// ------------------------------------------------------------------------------------------------------------

/// A rough, reproducible field in [0, 1] with holes in it.
float rough(ivec3 v) {
  const std::uint32_t h =
      (std::uint32_t(v.x) * 73856093u) ^ (std::uint32_t(v.y) * 19349663u) ^ (std::uint32_t(v.z) * 83492791u);
  const float value = float((h * 2654435761u) >> 8) / float(1 << 24);
  return value < 0.25f ? 0.0f : value;
}

/// Optical depth of `rough` along the x axis at whole y and z, where trilinear is linear between voxels and
/// fades to zero in one voxel at both ends: the trapezoid's sum of the voxels.
double rough_sum(int low, int high, int y, int z) {
  double sum = 0.0;
  for (int x = low; x <= high; ++x) sum += rough({x, y, z});
  return sum;
}

TEST(DualMarch, RoughVoxelsLitFromTheCameraMatchTheirClosedForm) {
  // Whatever the density, in and out along one line gives albedo / 2 (1 - T^2): a voxel grid at ten thousand
  // times the density as well, where each cell is opaque.
  for (const double density : {0.01, 1.0, 10.0, 1e4}) {
    SceneSnapshot scene = one_pixel({40, 3, -2}, {0, 3, -2});
    Medium medium;
    medium.volume = voxels({-11, -6, -6}, {13, 9, 9}, rough);
    medium.density_scale = static_cast<float>(density);
    medium.sigma_s = vec3(0.75f);
    medium.sigma_a = vec3(0.25f);
    scene.media = {medium};
    scene.lights = {sun({1, 0, 0})};
    const double tau = density * rough_sum(-11, 13, 3, -2);
    const Frame frame = render(scene);
    EXPECT_RELATIVE(frame.beauty[0].x, 0.75 * truth::isotropic * -std::expm1(-2 * tau) / 2, tolerance)
        << density;
    EXPECT_NEAR(frame.transmittance[0].x, std::exp(-tau), tolerance * std::exp(-tau) + 1e-26) << density;
  }
}

TEST(DualMarch, RoughVoxelsLitFromBehindShineWithTauTimesTransmittance) {
  for (const double density : {0.01, 0.3, 0.6}) {
    SceneSnapshot scene = one_pixel({40, 3, -2}, {0, 3, -2});
    Medium medium;
    medium.volume = voxels({-11, -6, -6}, {13, 9, 9}, rough);
    medium.density_scale = static_cast<float>(density);
    medium.sigma_s = vec3(0.75f);
    medium.sigma_a = vec3(0.25f);
    scene.media = {medium};
    scene.lights = {sun({-1, 0, 0})};
    const double tau = density * rough_sum(-11, 13, 3, -2);
    EXPECT_RELATIVE(render(scene).beauty[0].x, 0.75 * truth::isotropic * tau * std::exp(-tau), tolerance)
        << density;
  }
}

TEST(DualMarch, ALinearRampOfVoxelsMatchesQuadrature) {
  // density = 1 + x/16 over x in [-16, 15], constant in y and z far around the ray; seen along -z, lit along
  // x.
  const auto volume = voxels({-16, -16, -16}, {15, 15, 15}, [](ivec3 v) { return 1.0f + v.x / 16.0f; });
  SceneSnapshot scene = one_pixel({0.5, 0, 60}, {0.5, 0, 0});
  Medium medium;
  medium.volume = volume;
  medium.density_scale = 0.05f;
  medium.sigma_s = vec3(0.8f);
  medium.sigma_a = vec3(0.2f);
  scene.media = {medium};
  scene.lights = {sun({1, 0, 0})};
  // At x = 0.5: density 1.03125; towards +x the density grows to 1.9375 at x = 15 and fades to zero at 16.
  // All of it is scaled by the same fade at both ends of z.
  const double here = 1.03125, beside = (1.03125 + 1.9375) / 2 * 14.5 + 1.9375 / 2;
  const auto profile = [](double z) { return std::clamp(std::min(16 - z, z + 17), 0.0, 1.0); };
  const auto depth = [&](double z) {  // integral of the profile from 16 down to z
    if (z > 15) return (16 - z) * (16 - z) / 2;
    if (z > -16) return 0.5 + 15 - z;
    return 0.5 + 31 + 0.5 - (z + 17) * (z + 17) / 2;
  };
  const auto integrand = [&](double z) {
    return 0.8 * 0.05 * here * profile(z) * truth::isotropic *
           std::exp(-0.05 * (here * depth(z) + beside * profile(z)));
  };
  const double truth = truth::integrate(integrand, -17, -16) + truth::integrate(integrand, -16, 15) +
                       truth::integrate(integrand, 15, 16);
  const Frame frame = render(scene);
  EXPECT_RELATIVE(frame.beauty[0].x, truth, tolerance);
  EXPECT_RELATIVE(frame.transmittance[0].x, std::exp(-0.05 * here * 32), tolerance);
}

TEST(DualMarch, EmissionOfVoxelsFollowsTheirTemperature) {
  // Density 1, temperature 1000 K + 50 K per voxel along the ray.
  BrickVolumeBuilder builder;
  for (int x = -2; x < 2; ++x)
    for (int y = -1; y < 1; ++y)
      for (int z = -1; z < 1; ++z) {
        float density[512], temperature[512];
        for (int i = 0; i < 512; ++i) {
          density[i] = 1.0f;
          temperature[i] = 2000.0f + 50.0f * static_cast<float>(x * 8 + (i & 7));
        }
        builder.add({x, y, z}, density, temperature);
      }
  Medium medium;
  medium.volume = std::make_shared<const BrickVolume>(builder.build(dmat4(1.0)));
  medium.density_scale = 0.1f;
  medium.sigma_s = vec3(0.0f);
  medium.sigma_a = vec3(1.0f);
  medium.emission = {.scale = 0.5f, .temperature_scale = 0.5f, .temperature_offset = 300.0f};
  SceneSnapshot scene = one_pixel({60, 0, 0}, {0, 0, 0});
  scene.media = {medium};
  const Frame frame = render(scene);
  for (int c = 0; c < 3; ++c) {
    const auto emitted = [&](double x) {
      const double density = std::clamp(std::min(16 - x, x + 17), 0.0, 1.0);
      const double kelvin = 300 + 0.5 * (x > 15 ? 2750 * density : x < -16 ? 1200 * density : 2000 + 50 * x);
      const double tau = x > 15 ? (16 - x) * (16 - x) / 2 : x > -16 ? 15.5 - x : 32 - (x + 17) * (x + 17) / 2;
      return 0.1 * 0.5 * density * std::pow(kelvin / 1800, 4) * double(blackbody_colour(float(kelvin))[c]) *
             std::exp(-0.1 * tau);
    };
    double truth = 0.0;
    for (int x = -17; x < 16; ++x) truth += truth::integrate(emitted, x, x + 1, 1e-6, 12);
    EXPECT_RELATIVE(frame.emission[0][c], truth, tolerance) << "channel " << c;
  }
}

}  // namespace
}  // namespace plinian
