#include "transport/radii.h"

#include <limits>

#include "transport/light_pass.h"
#include "transport/photon_index.h"
#include "transport/walk.h"

namespace ups {

namespace {

constexpr uint32_t pilot_iteration = 0xffffffffu;  // its random numbers are nobody else's
constexpr size_t disc_photons = 32, walk_photons = 1;

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

// A disc that catches 32 pilot photons is large enough where light is dense.
void shrink_to_pilot(const SensorIndex& sensors, std::vector<std::vector<float>> distances, Plan& plan) {
  for (uint32_t disc = 0; disc < distances.size(); ++disc) {
    const SensorIndex::Entry& e = sensors.entry(disc);
    std::vector<float>& d2 = distances[disc];
    if (e.radius2 <= 0 || d2.size() < disc_photons) continue;
    std::nth_element(d2.begin(), d2.begin() + (disc_photons - 1), d2.end());
    float& r = plan.meter_radius[e.set][e.meter];
    r = std::min(r, std::sqrt(d2[disc_photons - 1]));
  }
}

// Median distance of a photon to the next one: a query finds about one. Wider discs hardly lessen the noise, but they
// reach past more edges and so lose more light.
float typical_spacing(const std::vector<LightVertex>& photons, float largest) {
  const PhotonIndex index(photons, largest);
  std::vector<float> spacings, d2;
  const size_t step = std::max<size_t>(1, photons.size() / 256);
  for (size_t i = 0; i < photons.size(); i += step) {
    d2.clear();
    index.query(photons[i].p, largest, [&](uint32_t, float distance2) { d2.push_back(distance2); });
    std::sort(d2.begin(), d2.end());
    spacings.push_back(d2.size() > walk_photons ? std::sqrt(d2[walk_photons]) : largest);
  }
  if (spacings.empty()) return largest;
  std::nth_element(spacings.begin(), spacings.begin() + ptrdiff_t(spacings.size() / 2), spacings.end());
  return spacings[spacings.size() / 2];
}

std::vector<float> disc_radii(const Snapshot& scene, const MeterSet& set, ThreadPool& pool) {
  if (set.is_cell()) return std::vector<float>(set.meters.size());  // photons are counted there, not merged
  std::vector<float> radii(set.meters.size(), half_spacing(set, scene.radius));
  pool.for_blocks(radii.size(), 64, [&](size_t, size_t begin, size_t end) {
    for (size_t m = begin; m < end; ++m) radii[m] = distance_in_plane(scene, set.meters[m], radii[m]);
  });
  return radii;
}

void fix_radii(float radius, Plan& plan) {
  for (auto& radii : plan.pixel_radius) std::fill(radii.begin(), radii.end(), radius);
  for (auto& radii : plan.meter_radius)
    for (float& r : radii)
      if (r > 0) r = radius;
  plan.walk_radius = radius;
}

}  // namespace

void choose_radii(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool, Plan& plan) {
  if (!settings.has(UPS_TECHNIQUE_MERGE)) return;
  for (const Camera& camera : scene.cameras) plan.pixel_radius.push_back(pixel_radii(scene, camera, pool));
  for (const MeterSet& set : scene.meter_sets) plan.meter_radius.push_back(disc_radii(scene, set, pool));
  if (settings.merge_radius > 0) return fix_radii(settings.merge_radius, plan);
  // The pilot's light paths say how dense light is, and are thrown away.
  static const std::atomic<bool> never{false};
  const SensorIndex sensors(scene, plan, settings, 0, pool.thread_count());
  TransportSettings pilot = settings;
  pilot.photon_mapping = true;  // no weights are needed
  const LightPassInput in{scene, plan, pilot, pilot_iteration, pilot_iteration, 0, 1.0, 0.0, true, never};
  PilotPaths paths = trace_pilot_paths(in, sensors, pool);
  shrink_to_pilot(sensors, std::move(paths.crossings), plan);
  plan.walk_radius = typical_spacing(paths.vertices, 0.05f * scene.radius);
  // A coarse image's pixels are wider than the light's detail that photons can show.
  for (auto& radii : plan.pixel_radius)
    for (float& r : radii) r = std::min(r, 4 * plan.walk_radius);
}

}  // namespace ups
