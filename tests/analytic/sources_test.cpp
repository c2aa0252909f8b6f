// Direct light of every kind of source against its closed form, by every method that computes it: without noise where
// the source has no extent, else as expect_lx.h says, with its false alarms and what it finds, at every single meter:
// 130 comparisons, of which noise decides few.
#include <vector>

#include "../support/expect_lx.h"
#include "ies_text.h"

namespace ups::test {
namespace {

struct Case {
  P3 position, normal;
  double expected;
};

// Renders the scene, to which the cases' meters are added, by each method.
void expect_cases(Scene& scene, const std::vector<Case>& cases, uint32_t iterations) {
  std::vector<P3> positions, normals;
  for (const Case& c : cases) {
    positions.push_back(c.position);
    normals.push_back(c.normal);
  }
  const Sensor meters = scene.add_meters(positions, normals);
  for (ups_method method : eye_methods) {
    const auto readings = scene.render({.method = method, .iterations = iterations}).readings(meters);
    for (size_t i = 0; i < cases.size(); ++i) {
      const std::string what = std::string(method_name(method)) + ", meter " + std::to_string(i);
      if (cases[i].expected == 0)
        EXPECT_EQ(readings[i].illuminance_lx, 0) << what;
      else
        expect_lx(readings[i], cases[i].expected, quiet, what);
      EXPECT_NEAR(readings[i].direct_lx, readings[i].illuminance_lx, 1e-4 * cases[i].expected) << what;
      EXPECT_NEAR(readings[i].indirect_lx, 0, 1e-4 * cases[i].expected) << what;
    }
  }
}

// Sources without extent have no noise at all, so that rounding alone is allowed. The false-alarm rate is 0.
void expect_exact(Scene& scene, const std::vector<Case>& cases, double relative) {
  std::vector<P3> positions, normals;
  for (const Case& c : cases) {
    positions.push_back(c.position);
    normals.push_back(c.normal);
  }
  const Sensor meters = scene.add_meters(positions, normals);
  for (ups_method method : eye_methods) {
    const auto readings = scene.render({.method = method, .iterations = 32}).readings(meters);
    for (size_t i = 0; i < cases.size(); ++i)
      EXPECT_NEAR(readings[i].illuminance_lx, cases[i].expected, relative * std::max(cases[i].expected, 1e-3))
          << method_name(method) << ", meter " << i;
  }
}

TEST(Sources, PointLightFollowsInverseSquareAndCosine) {
  Scene scene;
  scene.add_point_light({1, 2, 3}, 200);
  std::vector<Case> cases;
  for (const P3& p : {P3{1, 2, 0}, P3{3, 2, 0}, P3{-4, 7, 1}}) {
    const P3 d = P3{1, 2, 3} - p;
    cases.push_back({p, {0, 0, 1}, 200 * d.z / std::pow(length(d), 3)});
    cases.push_back({p, {0, 0, -1}, 0});
  }
  expect_exact(scene, cases, 1e-5);
}

// A meter stands off by the rounding error of its position, a millionth of the scene's size: 2e-4 of 10 cm at the most.
TEST(Sources, PointLightNearby) {
  Scene scene;
  scene.add_point_light({1, 2, 3}, 200);
  const P3 p{1.03, 2, 2.9}, d = P3{1, 2, 3} - p;
  expect_exact(scene, {{p, {0, 0, 1}, 200 * d.z / std::pow(length(d), 3)}, {{-4, 7, 1}, {0, 0, -1}, 0}}, 4e-4);
}

// CIE 171:2006 case 5.2: Lambertian point, 1000 cd, 3 m above a plane: E = I h^2 / d^4. The table has a value a degree;
// interpolation is at most (1 deg)^2 / 8 = 4e-5 low.
TEST(Sources, LambertianPointOfCie171) {
  Scene scene;
  const Profile profile = parse(scene.context(), ies_text([](double gamma) { return 1000 * std::cos(gamma); }, 90, 0));
  scene.add_luminaire(profile.get(), {0, 0, 3}, {0, 0, -1}, false);
  std::vector<Case> cases;
  for (const P3& p : {P3{0, 0}, P3{.5, 0}, P3{1, 0}, P3{1.5, 0}, P3{.5, .5}, P3{1, .5}, P3{1.5, .5}, P3{1, 1},
                      P3{1.5, 1}, P3{1.5, 1.5}})
    cases.push_back({p, {0, 0, 1}, 1000 * 9 / std::pow(9 + dot(p, p), 2)});
  EXPECT_NEAR(cases[9].expected, 49.383, 0.001);  // as the published calculation
  expect_exact(scene, cases, 1e-4);
}

// A hall of 10 x 10 luminaires, I = I0 cos gamma, and a point light beside each, half of them below the meters: enough
// that next-event estimation chooses among groups of them. An error of 1 % would be found.
TEST(Sources, AHundredLuminairesAddUp) {
  Scene scene;
  const Profile profile = parse(scene.context(), ies_text([](double gamma) { return 1000 * std::cos(gamma); }, 90, 0));
  std::vector<Case> cases;
  for (const P3& p : {P3{0, 0, 0}, P3{10, 10, 0}, P3{3, 19, 1}, P3{7.1, 12, 2.9}}) {
    cases.push_back({p, {0, 0, 1}, 0});
    cases.push_back({p, {1, 0, 0}, 0});
  }
  const auto add = [&](const P3& source, const auto& intensity) {  // of the cosine to the nadir
    for (Case& c : cases) {
      const P3 d = source - c.position;
      c.expected += intensity(d.z / length(d)) * std::max(0.0, dot(d, c.normal)) / std::pow(length(d), 3);
    }
  };
  for (int i = 0; i < 100; ++i) {
    const P3 p{1.0 + 2 * (i % 10), 1.0 + 2 * (i / 10), 4};
    scene.add_luminaire(profile.get(), p, {0, 0, -1}, false);
    add(p, [](double cosine) { return 1000 * std::max(0.0, cosine); });
    const P3 q{p.x - 0.7, p.y + 0.3, i % 2 ? 3.5 : -0.5};
    scene.add_point_light(q, 10 + i);
    add(q, [&](double) { return 10 + i; });
  }
  expect_cases(scene, cases, 32);
}

TEST(Sources, IsotropicIesProfileIsAPoint) {
  Scene scene;
  const Profile profile = parse(scene.context(), ies_text([](double) { return 150; }, 180, 0));
  scene.add_luminaire(profile.get(), {0, 0, 2}, {0.3, -0.2, -1}, false);  // its aim does not matter
  expect_exact(
      scene,
      {{{0, 0, 0}, {0, 0, 1}, 150 / 4.0}, {{1.5, 0, 2}, {-1, 0, 0}, 150 / 2.25}, {{0, 0, 5}, {0, 0, -1}, 150 / 9.0}},
      1e-5);
}

// glTF's cone falloff: ((cos a - cos outer) / (cos inner - cos outer))^2 between the cones.
TEST(Sources, SpotHasFullIntensityInsideAndFallsOffToItsOuterCone) {
  const double inner = 0.2, outer = 0.5, between = 0.35;
  const double falloff = std::pow((std::cos(between) - std::cos(outer)) / (std::cos(inner) - std::cos(outer)), 2);
  Scene scene;
  scene.add_spot({0, 0, 2}, {0, 0, -1}, 500, inner, outer);
  const auto at = [](double angle) { return P3{2 * std::tan(angle), 0, 0}; };
  const auto lx = [](double angle) { return 500 * std::pow(std::cos(angle), 3) / 4; };
  expect_exact(scene,
               {{at(0), {0, 0, 1}, lx(0)},
                {at(0.19), {0, 0, 1}, lx(0.19)},
                {at(between), {0, 0, 1}, lx(between) * falloff},
                {at(0.51), {0, 0, 1}, 0}},
               2e-5);
}

TEST(Sources, DirectionalLightFollowsTheCosineAndIsBlocked) {
  Scene scene;
  scene.add_directional({1, 0, -1}, 1000);
  scene.add(quad({-1, -1, 2}, {2, 0, 0}, {0, 2, 0}), matte(0));
  const double cos_45 = std::sqrt(0.5);
  expect_exact(scene,
               {{{0, 0, 0}, {0, 0, 1}, 1000 * cos_45},
                {{0, 0, 0}, {-1, 0, 1}, 1000},
                {{0, 0, 0}, {-1, 0, 0}, 1000 * cos_45},
                {{2, 0, 0}, {0, 0, 1}, 0},
                {{0, 0, 0}, {1, 0, 0}, 0}},
               1e-5);
}

// CIE 171:2006 case 5.3: a square metre of 1000 cd/m^2 in the ceiling of a black room, meters on the surfaces.
TEST(Sources, AreaSourceOfCie171) {
  Scene scene;
  const Shape source = quad({1.5, 1.5, 3}, {0, 1, 0}, {1, 0, 0});
  scene.add(source, emitter(1000));
  Shape room = quad({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  room.append(quad({0, 0, 0}, {0, 0, 3}, {4, 0, 0}));
  scene.add(room, matte(0));
  std::vector<Case> cases;
  const auto add = [&](const P3& p, const P3& n) {
    cases.push_back({p, n, 1000 * polygon_irradiance_factor(source.vertices, p, n)});
  };
  for (int i = 0; i < 6; ++i) add({2, 0, 2.75 - 0.5 * i}, {0, 1, 0});
  for (int i = 0; i < 8; ++i) add({2, 0.25 + 0.5 * i, 0}, {0, 0, 1});
  expect_cases(scene, cases, 64);
}

TEST(Sources, DiscEmitterNearAndFar) {
  Scene scene;
  const Shape source = disc({0, 0, 0}, {0, 0, 1}, 0.5, 64);
  scene.add(source, emitter(2000));
  std::vector<Case> cases;
  for (double d : {0.05, 0.25, 0.5, 1.0, 5.0})
    cases.push_back({{0, 0, d}, {0, 0, -1}, 2000 * convex_irradiance_factor(source, {0, 0, d}, {0, 0, -1})});
  cases.push_back({{0, 0, -1}, {0, 0, 1}, 0});  // its back is dark
  expect_cases(scene, cases, 64);
}

// The point-source formula pi L R^2 / d^2 holds for a sphere at every distance; the mesh has its own closed form.
TEST(Sources, SphereEmitterNearAndFar) {
  Scene scene;
  const double radius = 0.4;
  const Shape source = icosphere({1, -1, 2}, radius, 3);
  scene.add(source, emitter(5000));
  std::vector<Case> cases;
  for (double d : {0.44, 0.6, 1.2, 4.0}) {
    const P3 p = P3{1, -1, 2} + normalize({2, 1, -3}) * d, n = P3{1, -1, 2} - p;
    cases.push_back({p, n, 5000 * convex_irradiance_factor(source, p, n)});
    EXPECT_NEAR(cases.back().expected / (5000 * pi_d * radius * radius / (d * d)), 1, 0.02);
  }
  expect_cases(scene, cases, 128);
}

// A disc opening with a Lambertian table is a uniform disc: L = I / A. Off axis: Foote 1915, the element parallel to
// it.
TEST(Sources, LambertianOpeningIsAUniformDiscNearAndFar) {
  const double diameter = 0.5, radius = 0.25, intensity = 300, luminance = intensity / (pi_d * radius * radius);
  Scene scene;
  const Profile profile =
      parse(scene.context(), ies_text([=](double gamma) { return intensity * std::cos(gamma); }, 90, diameter));
  scene.add_luminaire(profile.get(), {0, 0, 3}, {0, 0, -1}, true);
  const auto lx = [=](double h, double a) {
    const double s = a * a + h * h;
    const double root = std::sqrt(std::pow(s + radius * radius, 2) - 4 * a * a * radius * radius);
    return pi_d * luminance / 2 * (1 - (s - radius * radius) / root);
  };
  std::vector<Case> cases;
  for (double h : {0.05, radius, diameter, 5 * diameter})
    for (double a : {0.0, 0.4}) cases.push_back({{a, 0, 3 - h}, {0, 0, 1}, lx(h, a)});
  EXPECT_NEAR(lx(5 * diameter, 0) / (intensity / (6.25)), 0.99, 1e-3);  // the five-times rule: 1 %
  expect_cases(scene, cases, 128);
}

}  // namespace
}  // namespace ups::test
