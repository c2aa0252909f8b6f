// See integrator.h: radii of the iteration, the light pass, the photon index, and the eye passes of all sensors.
#include "transport/integrator.h"

#include "transport/eye_pass.h"
#include "transport/light_pass.h"
#include "transport/radii.h"

namespace ups {

Integrator::Integrator(std::shared_ptr<const Snapshot> scene, const TransportSettings& settings, ThreadPool& pool,
                       const std::atomic<bool>& stop)
    : scene_(std::move(scene)), settings_(settings), pool_(pool), plan_(make_plan(*scene_, settings)) {
  choose_radii(*scene_, settings_, pool_, stop, plan_);
}

float Integrator::largest_radius(const std::vector<std::vector<float>>& radii, double factor) const {
  double largest = 0;
  for (const auto& set : radii)
    for (float r : set) largest = std::max(largest, double(r));
  return float(std::sqrt(plan_.radius2(largest, factor)));
}

bool Integrator::run(uint32_t iteration, const std::atomic<bool>& stop, IterationTally& tally) const {
  std::vector<TechniqueTally> techniques = std::move(tally.techniques);  // large: kept from one iteration to the next
  tally = {};
  if (settings_.technique_edges) {
    techniques.resize(scene_->cameras.size());
    for (size_t c = 0; c < techniques.size(); ++c)
      techniques[c].reset(settings_.technique_edges, uint32_t(scene_->cameras[c].pixel_count()));
    tally.techniques = std::move(techniques);
  }
  for (const Camera& c : scene_->cameras) {
    tally.pixels.emplace_back(c.pixel_count());
    tally.illuminance.emplace_back(c.illuminance() ? c.pixel_count() : 0);
    tally.splats.emplace_back(settings_.has(UPS_TECHNIQUE_SENSOR_CONNECT) ? c.pixel_count() : 0);
  }
  for (const MeterSet& s : scene_->meter_sets) {
    tally.meters.emplace_back(s.meters.size());
    tally.separated.emplace_back(s.meters.size() * plan_.separation.columns.size());
  }

  for (const Goniometer& g : scene_->goniometers) tally.goniometers.push_back(g.empty_tally());

  const uint32_t pass = plan_.pass(iteration);
  const double camera_factor = Plan::radius2_factor(pass, settings_.radius_alpha),
               meter_factor = Plan::radius2_factor(iteration, settings_.radius_alpha);
  LightPaths light;
  PhotonIndex pixel_photons, walk_photons;
  const double walk_radius2 = plan_.radius2(plan_.walk_radius, meter_factor);
  if (settings_.traces_light()) {
    const SensorIndex sensors(*scene_, plan_, settings_, iteration, pool_);
    const bool merges = settings_.has(UPS_TECHNIQUE_MERGE);
    const bool connects = settings_.has(UPS_TECHNIQUE_CONNECT) || settings_.light_tracing;
    light = trace_light_paths({*scene_, plan_, settings_, iteration, iteration % batch_count, iteration / batch_count,
                               camera_factor, walk_radius2, merges || connects, stop},
                              sensors, pool_, tally);
    const float pixel_radius = largest_radius(plan_.pixel_radius, camera_factor);
    pool_.for_blocks(merges ? 2 : 0, 1, [&](size_t, size_t which, size_t) {
      const float radius = which == 0 ? pixel_radius : float(std::sqrt(walk_radius2));
      if (radius > 0) (which == 0 ? pixel_photons : walk_photons) = PhotonIndex(light.vertices, radius);
    });
  }

  const EyePassInput eye{*scene_, plan_, settings_, light, pixel_photons, walk_photons, iteration,
                         pass % batch_count, pass / batch_count, iteration % batch_count, iteration / batch_count,
                         camera_factor, meter_factor, walk_radius2, stop};
  uint32_t path = 0;
  for (uint32_t c = 0; c < scene_->cameras.size(); ++c) path = trace_camera_paths(eye, c, path, pool_, tally);
  for (uint32_t s = 0; s < scene_->meter_sets.size(); ++s) path = trace_meter_paths(eye, s, path, pool_, tally);
  return !stop.load();
}

}  // namespace ups
