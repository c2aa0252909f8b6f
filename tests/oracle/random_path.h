// A path with random local quantities: what the oracle (slow_weights.h) and the engine's recurrences (fast_weights.h)
// are both computed from. No geometry and no scene: any positive numbers are a valid case for the weights.
#pragma once
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "transport/weights.h"

namespace ups::test {

enum class EmitterType { area, point, directional };
enum class SensorType { camera, point_meter, cell };

// x_0 on the emitter ... x_k on the sensor; edge i joins x_i and x_{i+1}.
struct Path {
  int k = 0;
  EmitterType emitter = EmitterType::area;
  SensorType sensor = SensorType::camera;
  std::vector<double> distance, cos_near, cos_far;  // by edge: length, cosine at x_i, cosine at x_{i+1}
  std::vector<bool> delta;                          // by vertex: scatters by a delta lobe
  std::vector<bool> merges;                         // by vertex: the material's own merge gate
  std::vector<bool> caster;                         // by vertex: a delta or a glossy lobe
  std::vector<double> pass;                         // by edge: probability to go on through its panes
  // By vertex, of scattering towards x_{i+1} and towards x_{i-1}: per solid angle, or discrete where delta.
  std::vector<double> pdf_to_sensor, pdf_to_emitter;
  std::vector<double> jacobian;  // delta: (n_i^2 cos_i) / (n_o^2 cos_o) of the light walk
  double emission_a = 1;         // pf_0; points and directional emitters: the probability of the choice
  double nee_a = 1;              // pn_0, likewise
  double disc_area = 1;          // directional: where its light starts
  double cell_area = 1;
  double sensor_merge_share = 1;  // eta at a point meter's own point over eta at the vertices of its eye paths

  bool hittable() const { return emitter == EmitterType::area; }
  bool camera() const { return sensor == SensorType::camera; }
};

class Random {
 public:
  explicit Random(uint64_t seed) : engine_(seed) {}
  double uniform(double a, double b) { return a + (b - a) * std::generate_canonical<double, 53>(engine_); }
  double log_uniform(double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); }
  int integer(int first, int last) { return std::min(last, int(std::floor(uniform(first, last + 1)))); }
  bool chance(double p) { return uniform(0, 1) < p; }

 private:
  std::mt19937_64 engine_;
};

struct PathRanges {
  int k_min = 1, k_max = 8;
  double distance_min = 0.05, distance_max = 20;
  double cos_min = 1e-3;
  double pdf_min = 2.5e-3, pdf_max = 400;
  double position_min = 0.05, position_max = 20;  // pf_0, pn_0, 1 / areas
};

inline Path random_path(Random& random, const PathRanges& range) {
  Path path;
  path.k = random.integer(range.k_min, range.k_max);
  path.emitter = EmitterType(random.integer(0, 2));
  path.sensor = SensorType(random.integer(0, 2));
  for (int i = 0; i < path.k; ++i) {
    path.distance.push_back(random.log_uniform(range.distance_min, range.distance_max));
    path.cos_near.push_back(random.log_uniform(range.cos_min, 1));
    path.cos_far.push_back(random.log_uniform(range.cos_min, 1));
    path.pass.push_back(random.chance(0.5) ? 1 : random.log_uniform(1e-3, 1));
  }
  for (int i = 0; i <= path.k; ++i) {
    path.delta.push_back(i > 0 && i < path.k && random.chance(0.25));
    path.merges.push_back(random.chance(0.6));
    path.caster.push_back(path.delta.back() || random.chance(0.3));
    path.pdf_to_sensor.push_back(random.log_uniform(range.pdf_min, range.pdf_max));
    path.pdf_to_emitter.push_back(random.log_uniform(range.pdf_min, range.pdf_max));
    path.jacobian.push_back(random.log_uniform(0.3, 3));
  }
  path.emission_a = random.log_uniform(range.position_min, range.position_max);
  path.nee_a = random.log_uniform(range.position_min, range.position_max);
  path.disc_area = 1 / random.log_uniform(range.position_min, range.position_max);
  path.cell_area = 1 / random.log_uniform(range.position_min, range.position_max);
  path.sensor_merge_share = random.log_uniform(1e-3, 30);
  return path;
}

// Technique subsets by bit, as every restriction of the engine switches them.
enum Subset {
  use_hit = 1,
  use_light_sample = 2,
  use_connect = 4,
  use_sensor_connect = 8,
  use_merge = 16,
  use_land = 32
};
inline constexpr int subset_count = 64;

inline mis::Counts random_counts(Random& random, const Path& path, int subset, double length_scale = 1) {
  const double light_paths = random.log_uniform(1e2, 1e7), eye_paths = std::pow(4.0, random.integer(0, 2));
  const double radius = random.log_uniform(1e-5, 3) * length_scale, connections = random.log_uniform(0.1, 10);
  mis::Counts n;
  if (subset & use_hit) n.hit = 1;
  if (subset & use_light_sample) n.light_sample = 1;
  if (subset & use_connect) n.connect = connections;
  if ((subset & use_sensor_connect) && path.camera()) n.sensor_connect = light_paths / eye_paths;
  if ((subset & use_land) && path.sensor == SensorType::cell) n.land = light_paths / eye_paths;
  if (subset & use_merge) {
    n.eta = light_paths * 3.14159265358979323846 * radius * radius;
    if (path.camera()) n.eta_first = n.eta * random.log_uniform(1e-3, 30);
    n.merge_all = random.chance(0.5);
  }
  return n;
}

// The same path with all lengths times `scale`. Choice probabilities of sources without extent have no unit.
inline Path scaled(Path path, double scale) {
  for (double& d : path.distance) d *= scale;
  if (path.emitter == EmitterType::area) {
    path.emission_a /= scale * scale;
    path.nee_a /= scale * scale;
  }
  path.disc_area *= scale * scale;
  path.cell_area *= scale * scale;
  return path;
}
inline mis::Counts scaled(mis::Counts n, double scale) {
  n.eta *= scale * scale;
  n.eta_first *= scale * scale;
  return n;
}

}  // namespace ups::test
