// The oracle: the balance heuristic as it is defined. The density of every technique is multiplied out over the whole
// path, in the log domain, from the path's local quantities; nothing is carried from vertex to vertex. O(k^2), obvious.
// Densities: Hachisuka, Pantaleoni, Jensen 2012, Eq. 7 to 15, the common kernel 1 / (pi r^2) divided out.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "random_path.h"

namespace ups::test {

enum class Technique { hit, light_sample, connect, sensor_connect, land, merge };

struct Term {
  Technique technique;
  int at = 0;              // connect: light vertices s; merge: the vertex m
  double log_density = 0;  // times its count
  double weight = 0;       // the balance heuristic
};

// Area densities of every vertex by the walk from the emitter.
inline std::vector<double> light_densities(const Path& p) {
  std::vector<double> pf(p.k + 1);
  pf[0] = p.emission_a;
  for (int i = 1; i <= p.k; ++i) {
    const double g = p.cos_far[i - 1] / (p.distance[i - 1] * p.distance[i - 1]);
    pf[i] = p.pdf_to_sensor[i - 1] * p.pass[i - 1] * g;
  }
  if (p.emitter == EmitterType::directional) pf[1] = p.cos_far[0] / p.disc_area * p.pass[0];  // parallel light from a disc
  return pf;
}

// ... and from the sensor. A delta lobe's discrete probability times the Jacobian of its map, so that both walks'
// densities have the same Dirac factor, which is left out.
inline std::vector<double> eye_densities(const Path& p) {
  std::vector<double> pb(p.k + 1);
  pb[p.k] = p.sensor == SensorType::cell ? 1 / p.cell_area : 1;
  for (int i = p.k - 1; i >= 0; --i) {
    const double g = p.cos_near[i] / (p.distance[i] * p.distance[i]);
    pb[i] = p.pdf_to_emitter[i + 1] * (p.delta[i + 1] ? p.jacobian[i + 1] : 1) * p.pass[i] * g;
  }
  return pb;
}

// Every technique that can make this path, with its weight. Empty: none can.
inline std::vector<Term> slow_weights(const Path& p, const mis::Counts& n, const mis::Gates& gates) {
  const int k = p.k;
  const bool meter = !p.camera();
  const std::vector<double> pf = light_densities(p), pb = eye_densities(p);
  // The first `light` vertices by the light walk, those from `eye` on by the eye walk; a merge has one vertex by both.
  const auto density = [&](double count, double first, int light, int eye) {
    double sum = std::log(count);
    for (int i = 0; i < light; ++i) sum += std::log(i == 0 ? first : pf[i]);
    for (int i = eye; i <= k; ++i) sum += std::log(pb[i]);
    return sum;
  };
  std::vector<Term> terms;
  const auto add = [&](Technique technique, int at, double count, double first, int light, int eye) {
    if (count > 0) terms.push_back({technique, at, density(count, first, light, eye), 0});
  };

  if (p.hittable()) add(Technique::hit, 0, n.hit, pf[0], 0, 0);
  // x_1 needs a continuous lobe, or is a meter's own point. A camera's own point sees emitters by hits alone.
  if (k > 1 ? !p.delta[1] : meter) add(Technique::light_sample, 1, n.light_sample, p.nee_a, 1, 1);
  for (int s = 2; s < k; ++s)
    if (!p.delta[s - 1] && !p.delta[s]) add(Technique::connect, s, n.connect, pf[0], s, s);
  if (k >= 2 && !p.delta[k - 1]) {
    const double count = meter ? n.connect : k == 2 && !gates.sensor_connect_at_first ? 0 : n.sensor_connect;
    add(Technique::sensor_connect, k, count, pf[0], k, k);
  }
  if (p.sensor == SensorType::cell) add(Technique::land, k + 1, n.land, pf[0], k + 1, k + 1);
  // Of a camera's vertices the one nearest to it that scatters by a continuous lobe has a radius of its own.
  int first = k - 1;
  while (first > 0 && p.delta[first]) --first;
  for (int m = 1; m <= k; ++m) {
    const bool own = m == k ? p.sensor == SensorType::point_meter : p.merges[m] && !p.delta[m];
    const bool by_casters = std::all_of(p.caster.begin() + 1, p.caster.begin() + m, [](bool c) { return c; });
    if (own && (m > 1 || gates.merge_at_first) && (by_casters || n.merge_all > 0))
      add(Technique::merge, m, m == k ? n.eta * p.sensor_merge_share : p.camera() && m == first ? n.eta_first : n.eta,
          pf[0], m + 1, m);
  }

  double largest = -INFINITY, sum = 0;
  for (const Term& t : terms) largest = std::max(largest, t.log_density);
  for (const Term& t : terms) sum += std::exp(t.log_density - largest);
  for (Term& t : terms) t.weight = std::exp(t.log_density - largest) / sum;
  return terms;
}

}  // namespace ups::test
