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
constexpr double max_radius_rays = 1u << 18;

// r_1 = 1.5 sqrt(A / pi), A the pixel's footprint at the first diffuse point; of a square of pixels that of its middle,
// so that the rays of a large image take no longer than an iteration.
std::vector<float> pixel_radii(const Snapshot& scene, size_t c, ThreadPool& pool, const StopSignal& stop) {
  const Camera& camera = scene.cameras[c];
  const MediaStack& media = scene.media_stacks[scene.media_of_camera[c]];
  const uint32_t side = uint32_t(std::ceil(std::sqrt(double(camera.pixel_count()) / max_radius_rays))),
                 columns = (camera.width() + side - 1) / side, rows = (camera.height() + side - 1) / side;
  std::vector<float> radii(size_t(columns) * rows);
  pool.for_blocks(radii.size(), 1024, [&](size_t, size_t begin, size_t end) {
    if (stop.is_set()) return;
    for (size_t p = begin; p < end; ++p) {
      const uint32_t x = std::min(uint32_t(p % columns) * side + side / 2, camera.width() - 1),
                     y = std::min(uint32_t(p / columns) * side + side / 2, camera.height() - 1);
      const Vec3 d = camera.ray(x, y, {0.5f, 0.5f});
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
  std::vector<float> of_pixels(camera.pixel_count());
  if (seen.empty()) return of_pixels;
  const float typical = median(seen);
  for (float& r : radii) r = r > 0 ? std::clamp(r, typical / 4, typical * 4) : typical;
  for (uint32_t y = 0, p = 0; y < camera.height(); ++y)
    for (uint32_t x = 0; x < camera.width(); ++x) of_pixels[p++] = radii[size_t(y / side) * columns + x / side];
  return of_pixels;
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

void fix_radii(const Snapshot& scene, float radius, Plan& plan) {
  for (const Camera& camera : scene.cameras) plan.pixel_radius.emplace_back(camera.pixel_count(), radius);
  for (const MeterSet& set : scene.meter_sets)
    plan.meter_radius.emplace_back(set.meters.size(), set.is_cell() ? 0 : radius);
  plan.walk_radius = radius;
}

// The pilot's light paths say how dense light is, and are thrown away. Fits the discs of the meters that the iteration
// visits; returns the vertices of its first pass.
std::vector<LightVertex> run_pilot(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool,
                                   const StopSignal& stop, double share, uint32_t iteration, Plan& plan) {
  set_largest_disc_radii(scene, pool, stop, iteration, plan);
  TransportSettings pilot = settings;
  pilot.method.weighted = false;
  pilot.techniques &= ~uint32_t(UPS_TECHNIQUE_SENSOR_CONNECT);
  const SensorIndex sensors(Iteration(scene, plan, pilot, iteration, stop), pool);
  std::vector<LightVertex> vertices;
  std::vector<std::vector<PilotPaths::Crossing>> crossings;
  const uint32_t passes = sensors.empty() ? 1 : meter_pilot_passes;
  for (uint32_t k = 0; k < passes; ++k) {
    const uint32_t number = iteration * meter_pilot_passes + k;
    Iteration in = Iteration::of_pilot(scene, plan, pilot, number, stop, Stream::pilot);
    in.stores_vertices = k == 0;
    PilotPaths paths = trace_pilot_paths(in, sensors, pool);
    if (k == 0) vertices = std::move(paths.vertices);
    if (crossings.size() < paths.crossings.size()) crossings.resize(paths.crossings.size());
    for (size_t d = 0; d < paths.crossings.size(); ++d)
      crossings[d].insert(crossings[d].end(), paths.crossings[d].begin(), paths.crossings[d].end());
  }
  if (!stop.is_set()) fit_disc_radii(scene, sensors, crossings, passes, share, iteration, plan);
  return vertices;
}

}  // namespace

void choose_radii(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool, const StopSignal& stop,
                  double share, Plan& plan) {
  if (!settings.has(UPS_TECHNIQUE_MERGE) && !settings.actual_perturbation) return;
  if (settings.merge_radius > 0) return fix_radii(scene, settings.merge_radius, plan);
  for (size_t c = 0; c < scene.cameras.size(); ++c)
    plan.pixel_radius.push_back(pixel_radii(scene, c, pool, stop));
  for (const MeterSet& set : scene.meter_sets) {
    plan.meter_spacing.push_back(meter_spacing(set));
    plan.meter_radius.emplace_back(set.meters.size());
  }
  std::vector<LightVertex> vertices = run_pilot(scene, settings, pool, stop, share, 0, plan);
  plan.walk_radius = typical_spacing(vertices, 0.05f * scene.radius) * float(std::sqrt(share));
  // A coarse image's pixels are wider than the light's detail that photons can show.
  for (auto& radii : plan.pixel_radius)
    for (float& r : radii) r = std::min(r, 4 * plan.walk_radius);
}

void choose_meter_radii(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool,
                        const StopSignal& stop, uint32_t iteration, Plan& plan) {
  if (!plan.meter_spacing.empty()) run_pilot(scene, settings, pool, stop, 1, iteration, plan);
}

}  // namespace ups
