// See integrator.h: radii of the iteration, the light pass, the photon index, and the eye passes of all sensors.
#include "transport/integrator.h"

#include "transport/eye_pass.h"
#include "transport/light_pass.h"
#include "transport/radii.h"

namespace ups {

Integrator::Integrator(std::shared_ptr<const Snapshot> scene, const TransportSettings& settings, ThreadPool& pool,
                       const StopSignal& stop)
    : scene_(std::move(scene)), settings_(settings), pool_(pool), plan_(make_plan(*scene_, settings)),
      direct_(*scene_, plan_, settings_) {
  choose_radii(*scene_, settings_, pool_, stop, plan_);
  for (const auto& radii : plan_.pixel_radius)
    for (const float r : radii) largest_pixel_radius_ = std::max(largest_pixel_radius_, r);
}

void Integrator::reset(uint32_t iteration, IterationTally& tally) const {
  std::vector<TechniqueTally> techniques = std::move(tally.techniques);  // large: kept from one iteration to the next
  tally = {};
  if (settings_.technique_edges) {
    techniques.resize(scene_->cameras.size());
    for (size_t c = 0; c < techniques.size(); ++c)
      techniques[c].reset(settings_.technique_edges, scene_->cameras[c].pixel_count());
    tally.techniques = std::move(techniques);
  }
  tally.pixels.resize(scene_->cameras.size());
  tally.illuminance.resize(scene_->cameras.size());
  tally.splats.resize(scene_->cameras.size());
  for (const MeterSet& s : scene_->meter_sets) {
    const size_t visited = plan_.visited_meters(iteration, s.meters.size());
    tally.meters.emplace_back(visited);
    tally.separated.emplace_back(visited * plan_.separation.columns.size());
  }
  for (const Goniometer& g : scene_->goniometers) tally.goniometers.push_back(g.empty_tally());
}

bool Integrator::run(uint32_t iteration, const StopSignal& stop, IterationTally& tally) {
  reset(iteration, tally);
  if (iteration > 0 && plan_.meter_pass(iteration) == 0)
    choose_meter_radii(*scene_, settings_, pool_, stop, iteration, plan_);
  const Iteration in(*scene_, plan_, settings_, iteration, stop);
  direct_.find(in, pool_, tally.work);
  Photons photons;
  if (settings_.traces_light()) {
    const SensorIndex sensors(in, pool_);
    photons.paths = trace_light_paths(in, sensors, pool_, tally);
    if (stop.is_set()) return false;
    const double pixel_radius2 = plan_.radius2(largest_pixel_radius_, in.camera_shrinkage);
    pool_.for_blocks(in.has(UPS_TECHNIQUE_MERGE) ? 2 : 0, 1, [&](size_t, size_t which, size_t) {
      const float radius = float(std::sqrt(which == 0 ? pixel_radius2 : in.walk_radius2));
      if (radius > 0)
        (which == 0 ? photons.of_pixels : photons.of_walks) = PhotonIndex(photons.paths.vertices, radius);
    });
  }
  uint32_t path = 0;
  for (uint32_t c = 0; c < scene_->cameras.size(); ++c) path = trace_camera_paths(in, photons, c, path, pool_, tally);
  for (uint32_t s = 0; s < scene_->meter_sets.size(); ++s)
    path = trace_meter_paths(in, photons, direct_, s, path, pool_, tally);
  direct_.add(in, tally);
  return !stop.is_set();
}

}  // namespace ups
