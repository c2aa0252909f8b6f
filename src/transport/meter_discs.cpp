// See meter_discs.h.
#include "transport/meter_discs.h"

#include <limits>

#include "transport/radii.h"
#include "transport/walk.h"

namespace ups {

MeterDiscs::MeterDiscs(size_t meters, uint32_t rings, float radius, uint32_t rays)
    : rings_(rings), sectors_(rays / 2), radius_(meters, radius),
      area_(meters, pi_d * radius * radius), limits_(meters * sectors_, uint8_t(rings)) {}

Rings MeterDiscs::rings(uint32_t m, float min_radius) const {
  Rings r;
  r.count = rings_;
  uint32_t ending[max_rings + 1] = {}, seen = sectors_;  // sectors before a ring; that reach it
  for (uint32_t i = 0; i < sectors_; ++i) ++ending[limits_[size_t(m) * sectors_ + i]];
  double inner = 0;
  const bool halved = !height_.empty() && std::isfinite(height_[m]);
  for (uint32_t k = 0; k < rings_; ++k) {
    seen -= ending[k];
    const double outer = std::ldexp(double(radius_[m]) * radius_[m], int(k + 1) - int(rings_));
    r.area[k] = pi_d * (outer - inner) * (sectors_ ? double(seen) / sectors_ : 1.0);
    r.radius2[k] = 0.5 * (outer + inner);
    r.bias_scale[k] = halved ? 2.0 / 3 * (std::pow(outer, 1.5) - std::pow(inner, 1.5)) / (outer - inner) : r.radius2[k];
    if (outer < double(min_radius) * min_radius && k + 1 < rings_) r.narrowest = k + 1;
    inner = outer;
  }
  return r;
}

void MeterDiscs::look_around(const Snapshot& scene, const Meter& meter, uint32_t m, float largest) {
  // Rays run between sectors, each of which ends with the shorter of its two: a flat wall is not crossed between them.
  const uint32_t half = sectors_, rays = 2 * half;
  const Vec3 o = lifted(meter.p, meter.frame.n, meter.error);
  std::vector<float> free(half, largest);
  for (uint32_t i = 0; i < rays; ++i) {
    const float phi = float(i) * (2 * pi / float(rays));
    float& both = free[i % half];
    Hit hit;
    if (scene.raytracer->intersect(o, meter.frame.s * std::cos(phi) + meter.frame.t * std::sin(phi), both, hit))
      both = std::min(both, 0.99f * hit.t);
  }
  std::vector<float> sectors(half);
  for (uint32_t i = 0; i < half; ++i) sectors[i] = std::min(free[i], free[(i + 1) % half]);
  const float radius = std::max(*std::max_element(sectors.begin(), sectors.end()), 0x1p-12f * largest);
  radius_[m] = radius;

  const auto limits = limits_.begin() + ptrdiff_t(size_t(m) * half);
  for (uint32_t i = 0; i < half; ++i) limits[ptrdiff_t(i)] = uint8_t(ring_of(sectors[i] * sectors[i], radius * radius));
  if (std::all_of(limits, limits + half, [](uint8_t limit) { return limit == 0; }))
    std::fill(limits, limits + half, uint8_t(1));  // without any area there is no light
  area_[m] = 0;
  for (const double area : rings(m, 0).area) area_[m] += area;
}

MeterDiscs MeterDiscs::across(size_t meters, uint32_t rings, float radius, uint32_t rays) {
  MeterDiscs discs(meters, rings, radius);
  discs.rays_ = rays;
  discs.height_.assign(meters, std::numeric_limits<float>::infinity());
  return discs;
}

void MeterDiscs::look_all_around(const Snapshot& scene, const Meter& meter, uint32_t m, float largest) {
  constexpr float beneath = 0.125f;  // of the largest radius: nearer surfaces would leave too small a ball
  constexpr float between_rays = 0.9f;
  Hit hit;
  const Vec3 n = meter.frame.n;
  const bool stands = scene.raytracer->intersect(meter.p, -n, beneath * largest, hit);
  height_[m] = stands ? hit.t : std::numeric_limits<float>::infinity();
  float free = largest;
  for (uint32_t i = 0; i < rays_; ++i) {  // a spiral from one pole to the other, by the golden section
    const float z = 1 - (2 * float(i) + 1) / float(rays_), r = std::sqrt(1 - z * z),
                turn = 2 * pi * std::fmod(0.618034f * float(i), 1.0f);
    if (stands && z <= 0) continue;
    const Vec3 d = meter.frame.to_world({r * std::cos(turn), r * std::sin(turn), z});
    if (scene.raytracer->intersect(meter.p, d, free / between_rays, hit)) free = std::min(free, between_rays * hit.t);
  }
  radius_[m] = std::max(free, 0x1p-12f * largest);
  area_[m] = pi_d * radius_[m] * radius_[m];
}

uint32_t MeterDiscs::most_that_meet(const std::vector<Meter>& meters, uint32_t sides) const {
  constexpr size_t all = 2048;  // of more some tell, spread by the golden section: grids have rows
  const size_t n = meters.size() / sides, probes = n <= all ? n : std::max<size_t>(16, all * all / n);
  std::vector<float> radius(radius_.begin(), radius_.begin() + ptrdiff_t(n));
  for (size_t i = n; i < meters.size(); ++i) radius[i % n] = std::max(radius[i % n], radius_[i]);
  uint32_t most = 1;
  for (size_t i = 0; i < probes; ++i) {
    const double turn = 0.6180339887498949 * double(i);
    const size_t m = n <= all ? i : size_t((turn - std::floor(turn)) * double(n));
    uint32_t meet = 0;
    for (size_t other = 0; other < n; ++other) {
      const float reach = radius[m] + radius[other];
      meet += length2(meters[other].p - meters[m].p) < reach * reach;
    }
    most = std::max(most, meet);
  }
  return most;
}

float meter_spacing(const MeterSet& set) {
  if (set.is_cell()) return 0;
  std::vector<float> nearest;
  const size_t n = set.count(), probes = std::clamp<size_t>((size_t(1) << 24) / n, 16, 256),
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

}  // namespace ups
