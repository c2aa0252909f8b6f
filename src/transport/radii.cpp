#include "transport/radii.h"

#include <limits>

#include "transport/light_pass.h"
#include "transport/walk.h"

namespace ups {

namespace {

constexpr uint32_t pilot_iteration = 0xffffffffu;  // its random numbers are nobody else's
constexpr size_t pilot_photons = 32;

// r_1 = 1.5 sqrt(A / pi), A the pixel's footprint at the first diffuse point.
std::vector<float> pixel_radii(const Snapshot& scene, const Camera& camera, ThreadPool& pool) {
  std::vector<float> radii(camera.pixel_count());
  pool.for_blocks(radii.size(), 1024, [&](size_t, size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) {
      const Vec3 d = camera.ray(uint32_t(p) % camera.width(), uint32_t(p) / camera.width(), {0.5f, 0.5f});
      SurfacePoint s;
      Vec3 direction = d;
      const float distance = first_diffuse(scene, camera.position(), d, s, direction);
      const float area = distance * distance / (camera.pdf_w(d) * std::max(std::abs(dot(direction, s.ng)), 0.1f));
      radii[p] = 1.5f * std::sqrt(area * inv_pi);
    }
  });
  // Pixels that see nothing to merge at get the median of the others; far outliers are drawn to it, so that one grid serves.
  std::vector<float> seen;
  for (float r : radii)
    if (r > 0) seen.push_back(r);
  if (seen.empty()) return radii;
  std::nth_element(seen.begin(), seen.begin() + seen.size() / 2, seen.end());
  const float median = seen[seen.size() / 2];
  for (float& r : radii) r = r > 0 ? std::clamp(r, median / 4, median * 4) : median;
  return radii;
}

// Half the typical distance to the next meter of the set; without neighbours a tenth of the scene.
float half_spacing(const MeterSet& set, float scene_radius) {
  std::vector<float> nearest;
  const size_t n = set.meters.size(), step = std::max<size_t>(1, n / 256);
  for (size_t i = 0; i < n; i += step) {
    float best = std::numeric_limits<float>::infinity();
    for (size_t j = 0; j < n; ++j)
      if (j != i) best = std::min(best, length2(set.meters[j].p - set.meters[i].p));
    if (std::isfinite(best) && best > 0) nearest.push_back(std::sqrt(best));
  }
  const float cap = 0.1f * scene_radius;
  if (nearest.empty()) return cap;
  std::nth_element(nearest.begin(), nearest.begin() + nearest.size() / 2, nearest.end());
  return std::min(cap, 0.5f * nearest[nearest.size() / 2]);
}

// A disc must not reach through a wall: photons behind it would leak in, and its edge would darken.
float distance_in_plane(const Snapshot& scene, const Meter& meter, float radius) {
  const Vec3 o = lifted(meter.p, meter.frame.n, meter.error);
  float free = radius;
  for (int i = 0; i < 32; ++i) {
    const float phi = (float(i) + 0.5f) * (2 * pi / 32);
    Hit hit;
    if (scene.raytracer->intersect(o, meter.frame.s * std::cos(phi) + meter.frame.t * std::sin(phi), free, hit)) free = hit.t;
  }
  return std::max(0.99f * free, radius / 16);
}

}  // namespace

void choose_radii(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool, Plan& plan) {
  if (!settings.has(UPS_TECHNIQUE_MERGE)) return;
  for (const Camera& camera : scene.cameras) plan.pixel_radius.push_back(pixel_radii(scene, camera, pool));
  for (const MeterSet& set : scene.meter_sets) {
    const float r = set.is_cell() ? 0.5f * std::min(set.cell_width, set.cell_height) : half_spacing(set, scene.radius);
    std::vector<float> radii(set.meters.size(), r);
    if (!set.is_cell())
      pool.for_blocks(radii.size(), 64, [&](size_t, size_t begin, size_t end) {
        for (size_t m = begin; m < end; ++m) radii[m] = distance_in_plane(scene, set.meters[m], radii[m]);
      });
    plan.meter_radius.push_back(std::move(radii));
  }
  if (settings.merge_radius > 0) {
    for (auto& radii : plan.pixel_radius) std::fill(radii.begin(), radii.end(), settings.merge_radius);
    for (auto& radii : plan.meter_radius) std::fill(radii.begin(), radii.end(), settings.merge_radius);
    return;
  }
  // Where light is dense, a disc that catches 32 pilot photons is large enough. The pilot is thrown away.
  static const std::atomic<bool> never{false};
  const SensorIndex sensors(scene, plan, settings, 0, pool.thread_count());
  if (sensors.empty()) return;
  TransportSettings pilot = settings;
  pilot.photon_mapping = true;  // no weights are needed
  const LightPassInput in{scene, plan, pilot, pilot_iteration, pilot_iteration, 0, 1.0, false, never};
  std::vector<std::vector<float>> distances = pilot_crossings(in, sensors, pool);
  for (uint32_t disc = 0; disc < distances.size(); ++disc) {
    const SensorIndex::Entry& e = sensors.entry(disc);
    std::vector<float>& d2 = distances[disc];
    if (e.radius2 <= 0 || d2.size() < pilot_photons) continue;
    std::nth_element(d2.begin(), d2.begin() + (pilot_photons - 1), d2.end());
    float& r = plan.meter_radius[e.set][e.meter];
    r = std::min(r, std::sqrt(d2[pilot_photons - 1]));
  }
}

}  // namespace ups
