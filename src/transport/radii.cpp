// See radii.h: a pixel's radius from its footprint, that of the walks from the spacing of pilot photons. Those of
// meters are fitted in meter_radii.cpp.
#include "transport/radii.h"

#include <limits>

#include "transport/light_pass.h"
#include "transport/photon_index.h"
#include "transport/walk.h"

namespace ups {

namespace {

constexpr uint32_t meter_pilot_passes = 4;
constexpr size_t walk_photons = 1;

// r_1 = 1.5 sqrt(A / pi), A the pixel's footprint at the first diffuse point.
std::vector<float> pixel_radii(const Snapshot& scene, size_t c, ThreadPool& pool) {
  const Camera& camera = scene.cameras[c];
  const MediaStack& media = scene.media_stacks[scene.media_of_camera[c]];
  std::vector<float> radii(camera.pixel_count());
  pool.for_blocks(radii.size(), 1024, [&](size_t, size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) {
      const Vec3 d = camera.ray(uint32_t(p) % camera.width(), uint32_t(p) / camera.width(), {0.5f, 0.5f});
      Encounter seen;
      Vec3 direction = d;
      const float distance = first_diffuse(scene, camera.position(), d, media, seen, direction);
      const float cosine = std::abs(dot(direction, seen.surface.ng));
      const float area = distance * distance / (camera.pdf_w(d) * std::max(cosine, 0.1f));
      radii[p] = 1.5f * std::sqrt(area * inv_pi);
    }
  });
  // Pixels that see nothing to merge at get the median of the others;
  // far outliers are drawn to it, so that one grid serves.
  std::vector<float> seen;
  for (float r : radii)
    if (r > 0) seen.push_back(r);
  if (seen.empty()) return radii;
  const float typical = median(seen);
  for (float& r : radii) r = r > 0 ? std::clamp(r, typical / 4, typical * 4) : typical;
  return radii;
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
  return median(spacings);
}

void fix_radii(float radius, Plan& plan) {
  for (auto& radii : plan.pixel_radius) std::fill(radii.begin(), radii.end(), radius);
  for (auto& radii : plan.meter_radius)
    for (float& r : radii)
      if (r > 0) r = radius;
  plan.walk_radius = radius;
}

// The pilot's light paths say how dense light is, and are thrown away. Fits the meters' discs; returns the vertices of
// its first pass.
std::vector<LightVertex> run_pilot(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool,
                                   const std::vector<float>& spacings, const std::atomic<bool>& stop, Plan& plan) {
  const SensorIndex sensors(scene, plan, settings, 0, pool);
  TransportSettings pilot = settings;
  pilot.photon_mapping = true;  // no weights are needed
  pilot.techniques &= ~uint32_t(UPS_TECHNIQUE_SENSOR_CONNECT);
  std::vector<LightVertex> vertices;
  std::vector<std::vector<PilotPaths::Crossing>> crossings;
  const uint32_t passes = sensors.empty() ? 1 : meter_pilot_passes;
  for (uint32_t k = 0; k < passes; ++k) {
    const LightPassInput in{scene, plan, pilot, k, 0, k, 1.0, 0.0, k == 0, stop, Stream::pilot};
    PilotPaths paths = trace_pilot_paths(in, sensors, pool);
    if (k == 0) vertices = std::move(paths.vertices);
    if (crossings.size() < paths.crossings.size()) crossings.resize(paths.crossings.size());
    for (size_t d = 0; d < paths.crossings.size(); ++d)
      crossings[d].insert(crossings[d].end(), paths.crossings[d].begin(), paths.crossings[d].end());
  }
  fit_disc_radii(scene, sensors, crossings, passes, spacings, plan.meter_radius);
  return vertices;
}

}  // namespace

void choose_radii(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool,
                  const std::atomic<bool>& stop, Plan& plan) {
  if (!settings.has(UPS_TECHNIQUE_MERGE) && !settings.actual_perturbation) return;
  for (size_t c = 0; c < scene.cameras.size(); ++c) plan.pixel_radius.push_back(pixel_radii(scene, c, pool));
  std::vector<float> spacings;
  for (const MeterSet& set : scene.meter_sets) {
    spacings.push_back(meter_spacing(set));
    plan.meter_radius.push_back(largest_disc_radii(scene, set, spacings.back(), pool));
  }
  if (settings.merge_radius > 0) return fix_radii(settings.merge_radius, plan);
  std::vector<LightVertex> vertices = run_pilot(scene, settings, pool, spacings, stop, plan);
  plan.walk_radius = typical_spacing(vertices, 0.05f * scene.radius);
  // A coarse image's pixels are wider than the light's detail that photons can show.
  for (auto& radii : plan.pixel_radius)
    for (float& r : radii) r = std::min(r, 4 * plan.walk_radius);
}

}  // namespace ups
