// Solids of glass in, on and through one another, against closed forms: stacks of flat layers, paraxial lenses, light
// through indices, and scenes that a medium around everything must not change. Seeds are fixed (expect_lx.h).
#include <gtest/gtest.h>

#include <numeric>

#include "../support/expect_lx.h"

namespace ups::test {
namespace {

ups_material_desc absorbing(double ior, double per_m, int priority = 0, double roughness = 0) {
  ups_material_desc m = glass(ior, roughness);
  for (float& a : m.absorption_per_m_rgb) a = float(per_m);
  m.priority = priority;
  return m;
}

std::string warnings_of(const Scene& scene) {
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  char text[4096];
  check(ups_scene_get_text(scene.get(), UPS_SCENE_TEXT_WARNINGS, text, sizeof text, nullptr), "ups_scene_get_text");
  return text;
}

double fresnel(double cos_1, double n_1, double n_2) {  // unpolarised
  const double sine = n_1 / n_2 * std::sqrt(1 - cos_1 * cos_1);
  if (sine >= 1) return 1;
  const double cos_2 = std::sqrt(1 - sine * sine);
  const double s = (n_1 * cos_1 - n_2 * cos_2) / (n_1 * cos_1 + n_2 * cos_2);
  const double p = (n_2 * cos_1 - n_1 * cos_2) / (n_2 * cos_1 + n_1 * cos_2);
  return 0.5 * (s * s + p * p);
}

// ---- flat layers ----------------------------------------------------------------------------------------------------

struct Layer {
  double ior, absorption_per_m, thickness_m;
};

// Of a stack in air, with all reflections in it: layer by layer, its reflectance seen from the newest layer kept.
double stack_transmittance(const std::vector<Layer>& layers, double cos_outside) {
  const auto cosine = [&](double n) { return std::sqrt(1 - (1 - cos_outside * cos_outside) / (n * n)); };
  double n = 1, t = 1, behind = 0, inner = 1;  // inner: transmittance of one passage through the newest layer
  for (size_t k = 0; k <= layers.size(); ++k) {
    const double next = k < layers.size() ? layers[k].ior : 1, r = fresnel(cosine(n), n, next);
    const double echo = behind * inner * inner;
    t *= inner * (1 - r) / (1 - r * echo);
    behind = r + (1 - r) * (1 - r) * echo / (1 - r * echo);
    n = next;
    if (k < layers.size()) inner = std::exp(-layers[k].absorption_per_m * layers[k].thickness_m / cosine(n));
  }
  return t;
}

struct Block {
  double low, high, half_width;
  ups_material_desc material;
  double lift = 0;  // by the instance's transform
};

// Parallel light through blocks with horizontal faces, on a large cell below. What enters by a side does not leave by
// the bottom, but is reflected totally: cos(angle) / n < sqrt(1 - 1 / n^2), or the angle is 0.
void expect_layers(const std::vector<Block>& blocks, const std::vector<Layer>& layers, double angle_rad,
                   const std::string& what) {
  Scene scene;
  for (const Block& b : blocks)
    scene.add(box({-b.half_width, -b.half_width, b.low}, {b.half_width, b.half_width, b.high}), b.material,
              {0, 0, b.lift});
  scene.add_directional({std::sin(angle_rad), 0, -std::cos(angle_rad)}, 1000);
  const Sensor cells = scene.add_cells({{0, 0, 0}}, {{0, 0, 1}}, {{1, 0, 0}}, 3, 3);
  const Result result = scene.render({.iterations = 16, .light_paths = 8192});
  const double expected = 1000 * std::cos(angle_rad) * stack_transmittance(layers, std::cos(angle_rad));
  expect_lx(result.readings(cells)[0], expected, 0.005, what);
}

TEST(Taught, NestedMediaBlocksThatTouchHaveOneBoundary) {
  const double angle = 0.5;
  const std::vector<Layer> layers = {{1.5, 0.3, 0.2}, {1.8, 0.6, 0.3}};
  expect_layers({{0.7, 1.0, 3, absorbing(1.8, 0.6)}, {1.0, 1.2, 2.5, absorbing(1.5, 0.3)}}, layers, angle,
                "faces of different size");
  expect_layers({{0.7, 1.0, 3, absorbing(1.8, 0.6)}, {0.0, 0.2, 2.5, absorbing(1.5, 0.3), 1.0}}, layers, angle,
                "one of them moved there");
  expect_layers({{0.4, 0.7, 3, absorbing(1.8, 0.6), 0.3}, {0.9, 1.1, 3, absorbing(1.5, 0.3), 0.1}}, layers, angle,
                "both moved");
}

TEST(Taught, NestedMediaPriorityDecidesWhereBlocksOverlap) {  // such as water that reaches into the wall of its glass
  const auto water = [](int priority) { return Block{0.7, 1.1, 2.5, absorbing(1.33, 0.5, priority)}; };
  const auto wall = [](int priority) { return Block{1.0, 1.3, 3, absorbing(1.52, 0.1, priority)}; };
  for (const double angle : {0.0, 0.6}) {
    expect_layers({water(0), wall(1)}, {{1.52, 0.1, 0.3}, {1.33, 0.5, 0.3}}, angle, "glass counts");
    expect_layers({water(-2), wall(-3)}, {{1.52, 0.1, 0.2}, {1.33, 0.5, 0.4}}, angle, "water counts");
  }
}

TEST(Taught, NestedMediaTheSmallerSolidCountsInTheLarger) {  // ice in water
  const Block water{0.5, 1.3, 3, absorbing(1.33, 0.5)}, ice{0.8, 1.0, 2.5, absorbing(1.31, 0.1)};
  const std::vector<Layer> layers = {{1.33, 0.5, 0.3}, {1.31, 0.1, 0.2}, {1.33, 0.5, 0.3}};
  expect_layers({water, ice}, layers, 0.6, "inner last");
  expect_layers({ice, water}, layers, 0.6, "inner first");
}

TEST(Taught, NestedMediaAStrongerMediumHidesWhatIsInIt) {
  const Block strong{0.5, 1.3, 3, absorbing(1.5, 0.5, 1)};
  expect_layers({strong, {0.8, 1.0, 2.5, absorbing(1.9, 3)}, {0.9, 1.1, 2.4, absorbing(1.2, 3)}}, {{1.5, 0.5, 0.8}},
                0.4, "solids of lower priority");
}

TEST(Taught, NestedMediaABlockWithinTheSameGlassChangesNothing) {
  const auto read = [](const std::vector<double>& inner_roughness, ups_method method) {
    Scene scene;
    scene.add(box({-3, -3, 0}, {3, 3, 1}), glass(1.5));
    for (const double roughness : inner_roughness) scene.add(box({-2, -2, 0.4}, {2, 2, 0.6}), glass(1.5, roughness));
    scene.add_spot({0, 0, 2}, {0, 0, -1}, 1000, 0.3, 0.35);
    const Sensor meters = scene.add_meters({{0, 0, -0.5}}, {0, 0, 1});
    return scene.render({.method = method, .iterations = 16, .merge_radius_m = 0.05, .light_paths = 8192})
        .readings(meters)[0];
  };
  for (const ups_method method : {UPS_METHOD_UPS, UPS_METHOD_SPPM}) {
    const ups_meter_reading alone = read({}, method);
    // The same random numbers: what is left are photons that rounding moves across the rim of the meter's disc.
    EXPECT_NEAR(read({0.0}, method).illuminance_lx / alone.illuminance_lx, 1, 2e-4) << method_name(method);
    EXPECT_NEAR(read({0.6}, method).illuminance_lx / alone.illuminance_lx, 1, 2e-4) << "rough, " << method_name(method);
  }
}

void mirror_x(const Scene& scene, ups_instance_id id) {
  auto d = make_desc<ups_instance_desc>(ups_instance_desc_init);
  check(ups_scene_get_instance(scene.get(), id, &d), "ups_scene_get_instance");
  d.to_world[0] = -1;
  check(ups_scene_set_instance(scene.get(), id, &d), "ups_scene_set_instance");
}

// Glass that was wound inwards is what it would be turned, bit for bit: alone, in other glass and around it, mirrored.
TEST(Taught, NestedMediaASolidInsideOutIsThatSolid) {
  struct Turned {
    bool outer, inner;
  };
  const auto read = [](Turned turned, bool nested, bool mirrored) {
    Scene scene;
    const Shape outer = box({-3, -3, 0.2}, {3, 3, 1}), inner = box({-2, -2, 0.4}, {2, 2, 0.6});
    const ups_instance_id id = scene.add(turned.outer ? outer.flipped() : outer, absorbing(1.5, 0.2));
    if (mirrored) mirror_x(scene, id);
    if (nested) scene.add(turned.inner ? inner.flipped() : inner, absorbing(1.8, 0.5));
    scene.add_spot({0, 0, 2}, {0, 0, -1}, 1000, 0.3, 0.35);
    const Sensor meters = scene.add_meters({{0.1, 0, 0}, {0.1, 0, 0.5}}, {0, 0, 1});
    const Result result = scene.render({.iterations = 4, .merge_radius_m = 0.05, .light_paths = 4096});
    const auto readings = result.readings(meters);
    return std::make_pair(readings[0].illuminance_lx, readings[1].illuminance_lx);
  };
  const auto alone = read({false, false}, false, false), both = read({false, false}, true, false);
  EXPECT_GT(alone.second, alone.first);
  EXPECT_NE(alone, both);
  EXPECT_EQ(read({true, false}, false, false), alone);
  EXPECT_EQ(read({true, false}, true, false), both);
  EXPECT_EQ(read({false, true}, true, false), both);
  EXPECT_EQ(read({true, true}, true, false), both);
  EXPECT_EQ(read({true, false}, false, true), read({false, false}, false, true)) << "mirrored";
}

// ---- shadow rays ----------------------------------------------------------------------------------------------------

// Light, meter and a block between them, all in one block of the same index: the block between them is seen in its
// absorption alone.
TEST(Taught, NestedMediaLightPassesBoundariesBetweenEqualIndices) {
  const double intensity = 500, around = 0.3, between = 1.1;
  for (const ups_method method : {UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING}) {
    Scene scene;
    scene.add(box({-3, -3, -1}, {3, 3, 3}), absorbing(1.6, around));
    scene.add(box({-2, -2, 0.5}, {2, 2, 1}), absorbing(1.6, between));
    scene.add(box({-1.5, -1.5, 1.2}, {1.5, 1.5, 1.4}), absorbing(1.9, 7, -1));  // weaker: not there
    scene.add(box({-3.1, -3.1, -1.1}, {3.1, 3.1, 3.1}).flipped(), matte(0));
    scene.add(box({-2.9, -2.9, -0.9}, {2.9, 2.9, 2.9}).flipped(), matte(0));  // so that nothing comes back
    scene.add_point_light({0, 0, 2}, intensity);
    const Sensor meters = scene.add_meters({{0, 0, 0}, {1, 0, 0.7}}, {0, 0, 1});
    const auto readings = scene.render({.method = method, .iterations = 32, .light_paths = 4096}).readings(meters);
    // One exact shadow ray each: there is no noise, and nothing else to be found.
    const double beside = intensity / 4 * std::exp(-1.5 * around - 0.5 * between);
    EXPECT_NEAR(readings[0].illuminance_lx, beside, 1e-4 * beside) << method_name(method);
    const double d2 = 1 + 1.3 * 1.3, d = std::sqrt(d2), inside = 0.3 / 1.3 * d;
    const double through = intensity * 1.3 / (d2 * d) * std::exp(-(d - inside) * around - inside * between);
    EXPECT_NEAR(readings[1].illuminance_lx, through, 1e-4 * through) << "inside, " << method_name(method);
  }
}

// ---- lenses and domes -----------------------------------------------------------------------------------------------

// The height of a lens surface at a distance from the axis.
using Profile = std::vector<double>;
constexpr int rings = 12, segments = 64;
constexpr double lens_radius = 0.3;

Profile sphere_cap(double vertex_z, double curvature) {  // > 0: its centre lies below
  Profile z;
  for (int i = 0; i <= rings; ++i) {
    const double r = lens_radius * i / rings;
    z.push_back(vertex_z - curvature * r * r / (1 + std::sqrt(1 - curvature * curvature * r * r)));
  }
  return z;
}

Shape cap(double vertex_z, double curvature) {
  const Profile profile = sphere_cap(vertex_z, curvature);
  Shape s{{{0, 0, profile[0]}}, {}, {{0, 0, 1}}};
  for (int i = 1; i <= rings; ++i)
    for (int k = 0; k < segments; ++k) {
      const double r = lens_radius * i / rings, a = 2 * pi_d * k / segments;
      s.vertices.push_back({r * std::cos(a), r * std::sin(a), profile[size_t(i)]});
      s.normals.push_back(normalize({r * curvature * std::cos(a), r * curvature * std::sin(a),
                                     std::sqrt(1 - curvature * curvature * r * r)}));
    }
  const auto at = [](int i, int k) { return i == 0 ? 0u : uint32_t(1 + (i - 1) * segments + k % segments); };
  for (int k = 0; k < segments; ++k) {
    s.triangles.push_back({0u, at(1, k), at(1, k + 1)});
    for (int i = 1; i < rings; ++i) {
      s.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      s.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return s;
}

Shape lens(double top_z, double top_curvature, double bottom_z, double bottom_curvature) {
  Shape s = cap(top_z, top_curvature), bottom = cap(bottom_z, bottom_curvature).flipped();
  for (P3& n : bottom.normals) n = n * -1;
  const P3 *upper = &s.vertices[s.vertices.size() - segments], *lower = &bottom.vertices[s.vertices.size() - segments];
  Shape side;
  for (int k = 0; k < segments; ++k) {
    side.vertices.insert(side.vertices.end(), {upper[k], lower[k]});
    side.normals.insert(side.normals.end(), 2, normalize({upper[k].x, upper[k].y, 0}));
    const uint32_t a = uint32_t(2 * k), b = uint32_t(2 * ((k + 1) % segments));
    side.triangles.insert(side.triangles.end(), {{a, a + 1, b + 1}, {a, b + 1, b}});
  }
  for (const Shape* part : {&bottom, &side})
    s.normals.insert(s.normals.end(), part->normals.begin(), part->normals.end());
  s.append(bottom);
  s.append(side);
  return s;
}

struct Part {
  Shape shape;
  ups_material_desc material;
};

// A crown and a flint cemented together, under a spot: what arrives on the axis, by the heights and angles of a
// paraxial ray through the three faces.
void expect_doublet(const std::vector<Part>& parts, const std::string& what) {
  const double crown = 1.5, flint = 1.75, c_1 = 1, c_2 = -1.6, c_3 = -0.2, t_1 = 0.2, t_2 = 0.1, from = 3, to = 1;
  Scene scene;
  for (const Part& p : parts) scene.add(p.shape, p.material);
  scene.add_spot({0, 0, from}, {0, 0, -1}, 1000, 0.03, 0.035);
  const Sensor cells = scene.add_cells({{0, 0, -t_1 - t_2 - to}}, {{0, 0, 1}}, {{1, 0, 0}}, 0.03, 0.03);
  double h = from, u = 1;  // per radian at the spot; falling rays that leave the axis have u > 0
  const auto refract = [&](double n_1, double n_2, double c) { u = (n_1 * u - (n_2 - n_1) * c * h) / n_2; };
  refract(1, crown, c_1);
  h += t_1 * u;
  refract(crown, flint, c_2);
  h += t_2 * u;
  refract(flint, 1, c_3);
  h += to * u;
  double passed = 1;
  for (const auto& [a, b] : {std::pair(1.0, crown), {crown, flint}, {flint, 1.0}}) passed *= 1 - fresnel(1, a, b);
  const Result result = scene.render({.iterations = 32, .light_paths = 16384});
  expect_lx(result.readings(cells)[0], 1000 * passed / (h * h), 0.005, what);
}

TEST(Taught, NestedMediaACementedDoubletIsItsThreeFaces) {
  const double c_1 = 1, c_2 = -1.6, c_3 = -0.2;
  const ups_material_desc crown = absorbing(1.5, 0), flint = absorbing(1.75, 0);
  const Shape upper = lens(0, c_1, -0.2, c_2), lower = lens(-0.2, c_2, -0.3, c_3);
  expect_doublet({{upper, crown}, {lower, flint}}, "faces that coincide");
  expect_doublet({{lower, flint}, {upper, crown}}, "faces that coincide, the other way round");
  expect_doublet({{upper, absorbing(1.5, 0, 1)}, {lens(-0.1, 0, -0.3, c_3), flint}}, "the crown cuts into the flint");
  expect_doublet({{lens(0, c_1, -0.25, 0), crown}, {lower, absorbing(1.75, 0, 1)}}, "the flint cuts into the crown");
}

// A source of unit intensity on the axis below flat layers, and how far from the axis its rays reach.
struct Axial {
  std::vector<Layer> layers;  // from the source up, then air
  double air_m;
  bool lambertian;

  double reach(double angle) const {
    double r = 0;
    const double sine = layers[0].ior * std::sin(angle);
    for (const Layer& l : layers) r += l.thickness_m * sine / std::sqrt(l.ior * l.ior - sine * sine);
    return r + air_m * sine / std::sqrt(1 - sine * sine);
  }
  double passed(double angle) const {  // without what is reflected twice
    double t = 1;
    for (size_t k = 0; k < layers.size(); ++k) {
      const double n = layers[k].ior, sine = layers[0].ior * std::sin(angle) / n;
      t *= 1 - fresnel(std::sqrt(1 - sine * sine), n, k + 1 < layers.size() ? layers[k + 1].ior : 1);
    }
    return t;
  }
  double illuminance(double distance) const {
    double low = 0, high = 0.6;
    for (int i = 0; i < 60; ++i) (reach((low + high) / 2) < distance ? low : high) = (low + high) / 2;
    const double step = 1e-4, annulus = (std::pow(reach(low + step), 2) - std::pow(reach(low), 2)) / 2;
    const double middle = low + step / 2, intensity = lambertian ? std::cos(middle) : 1;
    return intensity * passed(middle) * (std::cos(low) - std::cos(low + step)) / annulus;
  }
  double mean_over_square(double side) const {
    double sum = 0;
    for (int i = 0; i < 16; ++i)
      for (int k = 0; k < 16; ++k) sum += illuminance(side / 32 * std::hypot(i + 0.5, k + 0.5));
    return sum / 256;
  }
};

// Light in a body of silicone within a dome of glass, both flat: each face spreads it by the indices on its two sides.
TEST(Taught, NestedMediaAnEmitterInItsDomeShinesByTheSquareOfTheIndex) {
  const double silicone = 1.41, dome = 1.6, square = 0.8, emitting = 0.02, luminance = 1e6;
  for (const bool surface : {false, true}) {
    const Axial exact{{{silicone, 0, 0.2}, {dome, 0, 0.3}}, 1, surface};
    Scene scene;
    scene.add(box({-2, -2, -0.2}, {2, 2, 0.5}), glass(dome));
    scene.add(box({-1.5, -1.5, -0.1}, {1.5, 1.5, 0.2}), glass(silicone));
    scene.add(quad({-1.4, -1.4, -0.05}, {2.8, 0, 0}, {0, 2.8, 0}), matte(0));  // nothing comes back from below
    const P3 x{emitting, 0, 0}, y{0, emitting, 0};
    if (surface)
      scene.add(quad(x * -0.5 + y * -0.5, x, y), emitter(luminance));
    else
      scene.add_spot({0, 0, 0}, {0, 0, 1}, luminance * emitting * emitting, 0.5, 0.55);
    const Sensor cells = scene.add_cells({{0, 0, 1.5}}, {{0, 0, -1}}, {{1, 0, 0}}, square, square);
    const auto readings = scene.render({.iterations = 32, .light_paths = 8192}).readings(cells);
    expect_lx(readings[0], luminance * emitting * emitting * exact.mean_over_square(square), 0.007,
              surface ? "an emitting surface" : "a spot");
  }
}

// ---- rough glass, all methods ---------------------------------------------------------------------------------------

// Everything in one medium: only ratios of indices count, so it reads as in air with the ratio for an index.
TEST(Taught, NestedMediaRoughGlassCountsItsIndexAgainstWhatIsAroundIt) {
  const auto read = [](bool immersed, ups_method method) {
    const double around = 1.3, relative = 1.5;
    Scene scene;
    if (immersed) scene.add(box({-4, -4, -1}, {4, 4, 4}), glass(around));
    scene.add(box({-2, -2, 0}, {2, 2, 2}).flipped(), matte(0.5));
    scene.add(box({-1, -1, 0.6}, {1, 1, 0.8}), glass(immersed ? around * relative : relative, 0.5));
    scene.add(quad({-0.5, -0.5, 1.9}, {0, 1, 0}, {1, 0, 0}), emitter(1000));
    const Sensor meters = scene.add_meters({{0, 0, 0.3}, {1.3, 0, 0.3}}, {0, 0, 1});
    return scene.render({.method = method, .iterations = 16, .merge_radius_m = 0.1, .light_paths = 2048})
        .readings(meters);
  };
  for (const ups_method method :
       {UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING, UPS_METHOD_SPPM}) {
    const auto in_air = read(false, method), immersed = read(true, method);
    for (size_t i = 0; i < in_air.size(); ++i)  // from the same random numbers
      EXPECT_NEAR(immersed[i].illuminance_lx / in_air[i].illuminance_lx, 1, 1e-3) << method_name(method) << " " << i;
  }
}

// In an enclosure of constant luminance L, filled with a medium of index n, a bubble of air has the luminance L / n^2.
TEST(Taught, NestedMediaABubbleInAFurnaceHasTheRadianceOfItsIndex) {
  const double n = 1.5, luminance = 100;
  for (const double roughness : {0.0, 0.4})
    for (const ups_method method : eye_methods) {
      Scene scene;
      scene.add(box({-2, -2, -2}, {2, 2, 2}), glass(n));
      scene.add(box({-1, -1, -1}, {1, 1, 1}).flipped(), emitter(luminance));
      scene.add(icosphere({0, 0, 0}, 0.5, 2), glass(1, roughness));
      const Sensor meters = scene.add_meters({{0.1, 0, 0.1}, {0.8, 0, 0}}, {0, 0, 1});
      const Sensor camera = scene.add_camera({0, 0.1, 0}, {1, 0.2, 0.3}, 8, 8, 0.8);
      const Result result = scene.render({.method = method, .iterations = 64, .light_paths = 1024});
      const auto readings = result.readings(meters);
      const std::string what = std::string(method_name(method)) + ", roughness " + std::to_string(roughness);
      // Rough glass closes its balance within 1.3 % (bsdf/albedo.h).
      const double tolerance = roughness > 0 ? 0.013 : 0;
      for (size_t i = 0; i < 2; ++i) {
        const double expected = pi_d * luminance / (i == 0 ? n * n : 1);
        EXPECT_LE(readings[i].standard_error_lx, 0.006 * expected) << what;
        const double noise = std::max(relative_tolerance * expected, sigmas * readings[i].standard_error_lx);
        EXPECT_LE(std::abs(readings[i].illuminance_lx - expected), tolerance * expected + noise)
            << what << ", meter " << i << ": " << readings[i].illuminance_lx << ", expected " << expected;
      }
      const std::vector<float> pixels = result.image(camera).luminance;
      const double seen = std::accumulate(pixels.begin(), pixels.end(), 0.0) / double(pixels.size());
      EXPECT_NEAR(seen * n * n / luminance, 1, 0.005 + tolerance) << what << ", camera";
    }
}

// ---- warnings -------------------------------------------------------------------------------------------------------

std::string warnings(const std::vector<Part>& parts) {
  Scene scene;
  scene.add_point_light({0, 0, 9}, 1);
  scene.add_meters({{0, 0, 8}}, {0, 0, 1});
  for (const Part& p : parts) scene.add(p.shape, p.material);
  return warnings_of(scene);
}

TEST(Taught, NestedMediaSolidsInsideOutAreWarnedOf) {
  const Shape block = box({0, 0, 0}, {1, 1, 1}), other = box({2, 0, 0}, {3, 1, 1});
  const Shape sheet = quad({5, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto told = warnings({{block.flipped(), glass(1.5)}, {other, glass(1.5)}, {sheet.flipped(), glass(1.33)},
                              {box({7, 0, 0}, {8, 1, 1}).flipped(), matte(0.5)},
                              {box({9, 0, 0}, {10, 1, 1}).flipped(), glass(1.4)}});
  EXPECT_NE(told.find("instances 1 and 5: a closed mesh of glass whose front is inwards"), std::string::npos) << told;
  Shape hollow = block;
  hollow.append(box({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}).flipped());
  EXPECT_EQ(warnings({{hollow, glass(1.5)}}), "");
}

TEST(Taught, NestedMediaOverlapsInPartAreWarnedOf) {
  const Shape block = box({0, 0, 0}, {1, 1, 1}), shifted = box({0.7, 0.1, 0}, {1.7, 0.9, 1});
  EXPECT_NE(warnings({{block, glass(1.5)}, {box({5, 5, 5}, {6, 6, 6}), glass(1.5)}, {shifted, glass(1.6)}})
                .find("instances 1 and 3 are glass of different index and overlap in part"),
            std::string::npos);
  EXPECT_NE(warnings({{block, glass(1.5)}, {box({0.4, 0.4, -1}, {0.6, 0.6, 2}), glass(1.6)}}).find("instances 1 and 2"),
            std::string::npos)
      << "a rod through a block";
  EXPECT_EQ(warnings({{block, glass(1.5)}, {shifted, glass(1.5)}}), "") << "the same index";
  EXPECT_EQ(warnings({{block, absorbing(1.5, 0, 1)}, {shifted, glass(1.6)}}), "") << "a priority";
  EXPECT_EQ(warnings({{block, glass(1.5)}, {box({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}), glass(1.6)}}), "") << "within";
  EXPECT_EQ(warnings({{block, glass(1.5)}, {box({0.2, 0.2, 0}, {0.8, 0.8, 0.8}), glass(1.6)}}), "")
      << "within, on the same floor";
  EXPECT_EQ(warnings({{block, glass(1.5)}, {box({1, 0, 0}, {2, 1, 1}), glass(1.6)}}), "") << "side by side";
  EXPECT_EQ(warnings({{icosphere({0, 0, 0}, 1, 3), glass(1.5)}, {icosphere({1.2, 1.2, 1.2}, 1, 3), glass(1.6)}}), "")
      << "boxes that overlap, spheres that do not";
  EXPECT_EQ(warnings({{lens(0, 1, -0.2, -1.6), glass(1.5)}, {lens(-0.2, -1.6, -0.3, -0.2), glass(1.75)}}), "")
      << "a cemented doublet";
}

}  // namespace
}  // namespace ups::test
