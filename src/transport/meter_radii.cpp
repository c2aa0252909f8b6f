// See radii.h: the radius at which a meter's disc starts to catch photons, so that noise and bias together are least.
#include <algorithm>
#include <cmath>
#include <limits>

#include "transport/radii.h"
#include "transport/walk.h"

namespace ups {

namespace {

// A disc must not reach through a wall: photons behind it would leak in, and its edge would darken.
float distance_in_plane(const Snapshot& scene, const Meter& meter, float radius) {
  const Vec3 o = lifted(meter.p, meter.frame.n, meter.error);
  float free = radius;
  for (int i = 0; i < 32; ++i) {
    const float phi = (float(i) + 0.5f) * (2 * pi / 32);
    Hit hit;
    if (scene.raytracer->intersect(o, meter.frame.s * std::cos(phi) + meter.frame.t * std::sin(phi), free, hit))
      free = hit.t;
  }
  return std::max(0.99f * free, radius / 16);
}

// What the pilot says of one disc, free of its radius: the variance of one iteration is
// noise / r^2, its bias curvature * r^2.
struct DiscMoments {
  double noise = 0, curvature = 0;
};

DiscMoments moments(const std::vector<PilotPaths::Crossing>& crossings, double radius2, uint32_t passes) {
  double squares = 0, difference = 0;
  for (const PilotPaths::Crossing& c : crossings) {
    squares += c.value * c.value;
    difference += 2.0 * c.value * (2.0 * c.distance2 < radius2 ? -1 : 1);  // 2 (M_r - M_{r / sqrt 2})
  }
  return {squares / passes * radius2, difference / passes / radius2};
}

// Means over each meter's neighbourhood: one meter's photons are too few to tell bias from noise. Of the meters that
// the iteration visits, by their running number.
std::vector<DiscMoments> pooled(const MeterSet& set, const Plan& plan, uint32_t iteration,
                                const std::vector<DiscMoments>& own, float reach) {
  constexpr size_t enough = 32;
  std::vector<uint32_t> order(own.size());
  for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto meter_of = [&](uint32_t i) -> const Meter& { return set.meters[plan.visited_meter(iteration, i)]; };
  const auto x = [&](uint32_t i) { return meter_of(i).p.x; };
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return x(a) != x(b) ? x(a) < x(b) : a < b; });
  std::vector<DiscMoments> out(own.size());
  for (size_t at = 0; at < order.size(); ++at) {
    const Meter& meter = meter_of(order[at]);
    size_t count = 0;
    DiscMoments sum;
    const auto take = [&](uint32_t j) {
      const Meter& other = meter_of(j);
      if (length2(other.p - meter.p) > reach * reach || dot(other.frame.n, meter.frame.n) < 0.9f) return;
      sum.noise += own[j].noise;
      sum.curvature += own[j].curvature;
      ++count;
    };
    take(order[at]);
    for (size_t k = at; k-- > 0 && count < enough && meter.p.x - x(order[k]) <= reach;) take(order[k]);
    for (size_t k = at + 1; k < order.size() && count < 2 * enough && x(order[k]) - meter.p.x <= reach; ++k)
      take(order[k]);
    out[order[at]] = {sum.noise / double(count), sum.curvature / double(count)};
  }
  return out;
}

// Least mean square error at alpha = 2/3, which others take over. After n iterations of Plan::radius2_factor the
// variance is Gamma(5/3) / (4/3) noise / r_1^2 n^(-2/3) and the bias 1.5 * 1.108 curvature r_1^2 n^(-1/3), so that n
// drops out of r_1^6 = 0.1226 noise / curvature^2.
double best_radius2(const DiscMoments& m, double largest2) {
  if (!(m.noise > 0)) return largest2;
  const double best = std::cbrt(0.1226 * m.noise / (m.curvature * m.curvature));
  return std::clamp(best, largest2 / 64, largest2);
}

}  // namespace

float meter_spacing(const MeterSet& set) {
  if (set.is_cell()) return 0;
  std::vector<float> nearest;
  const size_t n = set.meters.size(), probes = std::clamp<size_t>((size_t(1) << 24) / n, 16, 256),
               step = std::max<size_t>(1, n / probes);
  for (size_t i = 0; i < n; i += step) {
    float best = std::numeric_limits<float>::infinity();
    for (size_t j = 0; j < n; ++j)
      if (j != i) best = std::min(best, length2(set.meters[j].p - set.meters[i].p));
    if (std::isfinite(best) && best > 0) nearest.push_back(std::sqrt(best));
  }
  if (nearest.empty()) return std::numeric_limits<float>::infinity();
  return median(nearest);
}

void set_largest_disc_radii(const Snapshot& scene, ThreadPool& pool, const StopSignal& stop, uint32_t iteration,
                            Plan& plan) {
  for (size_t s = 0; s < scene.meter_sets.size(); ++s) {
    const MeterSet& set = scene.meter_sets[s];
    if (set.is_cell()) continue;
    // Half the spacing would keep discs apart; 8 times its area is as far as noise may widen them.
    const float largest = std::min(largest_meter_disc * scene.radius, std::sqrt(2.0f) * plan.meter_spacing[s]);
    pool.for_blocks(plan.visited_meters(iteration, set.meters.size()), 64, [&](size_t, size_t begin, size_t end) {
      if (stop.is_set()) return;
      for (size_t i = begin; i < end; ++i) {
        const uint32_t m = plan.visited_meter(iteration, i);
        plan.meter_radius[s][m] = distance_in_plane(scene, set.meters[m], largest);
      }
    });
  }
}

void fit_disc_radii(const Snapshot& scene, const SensorIndex& sensors,
                    const std::vector<std::vector<PilotPaths::Crossing>>& crossings, uint32_t passes,
                    double share, uint32_t iteration, Plan& plan) {
  std::vector<std::vector<DiscMoments>> own;
  for (const MeterSet& set : scene.meter_sets) own.emplace_back(plan.visited_meters(iteration, set.meters.size()));
  for (uint32_t disc = 0; disc < crossings.size(); ++disc) {
    const SensorIndex::Entry& e = sensors.entry(disc);
    if (e.radius2 > 0) own[e.set][e.visited] = moments(crossings[disc], e.radius2, passes);
  }
  const float sparser = std::sqrt(float(plan.meter_subsets));  // than the set are those that one iteration visits
  for (size_t s = 0; s < scene.meter_sets.size(); ++s) {
    const MeterSet& set = scene.meter_sets[s];
    if (set.is_cell()) continue;
    std::vector<DiscMoments> m = pooled(set, plan, iteration, own[s], 1.5f * sparser * plan.meter_spacing[s]);
    for (size_t i = 0; i < m.size(); ++i) {
      m[i].noise *= share;
      float& radius = plan.meter_radius[s][plan.visited_meter(iteration, i)];
      radius = float(std::sqrt(best_radius2(m[i], double(radius) * radius)));
    }
  }
}

}  // namespace ups
