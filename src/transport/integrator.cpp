// See integrator.h: radii of the iteration, the light pass, the photon index, and the eye passes of all sensors.
#include "transport/integrator.h"

#include "transport/eye_pass.h"
#include "transport/light_pass.h"
#include "transport/radii.h"

namespace ups {

namespace {

bool finds_all_emitters(const Snapshot& scene, const Plan& plan) {
  for (size_t i = 0; i < plan.exact.size(); ++i)
    if (!plan.exact[i] && max_component(scene.emitters[i].flux_rgb()) > 0) return false;
  return true;
}

bool scatters(const Snapshot& scene) {
  for (size_t i = 0; i < scene.materials.size(); ++i)
    if (const MaterialTraits t = traits_of(scene.materials[i]); scene.material_used[i] && (t.delta || t.continuous))
      return true;
  return false;
}

}  // namespace

Integrator::Integrator(std::shared_ptr<const Snapshot> scene, const TransportSettings& settings, ThreadPool& pool,
                       const StopSignal& stop)
    : scene_(std::move(scene)), settings_(settings), pool_(pool), plan_(make_plan(*scene_, settings)),
      direct_(*scene_, plan_, settings_) {
  plan_.exact_direct = direct_.finds_all() && finds_all_emitters(*scene_, plan_);
  plan_.exact_light = plan_.exact_direct && (settings_.max_path_length == 1 || !scatters(*scene_));
  choose_first_radii(stop);
  for (const auto& radii : plan_.pixel_radius)
    for (const float r : radii) largest_pixel_radius_ = std::max(largest_pixel_radius_, r);
  if (settings_.automatic && !stop.is_set()) select(stop);
  complete(*scene_, plan_, settings_, selection_.sensors);
}

// A choice of techniques may leave few light paths: it takes few to find a radius, whose noise is known for any number.
void Integrator::choose_first_radii(const StopSignal& stop) {
  const uint32_t all = plan_.light_paths, few = settings_.automatic ? std::min(all, 1u << 12) : all;
  plan_.light_paths = few;
  choose_radii(*scene_, settings_, pool_, stop, all > 0 ? double(few) / all : 1, plan_);
  plan_.light_paths = all;
}

void Integrator::select(const StopSignal& stop) {
  const EmissionGuide guide = settings_.has(UPS_TECHNIQUE_MERGE) ? train_guide(stop) : EmissionGuide();
  selection_ = select_techniques(*scene_, plan_, settings_, guide, stop,
                                 [this](const Iteration& in, IterationTally& tally) { return trace(in, tally); });
  if (selection_.shares.empty()) return;
  plan_.light_paths = selection_.light_paths;
  plan_.shares = selection_.shares;
  settings_.techniques = 0;
  for (const ups_sensor_choice& s : selection_.sensors) settings_.techniques |= s.techniques;
  if (plan_.traces_caustics_alone()) plan_.guide = guide;
  if (settings_.has(UPS_TECHNIQUE_MERGE)) return;
  plan_.pixel_radius.clear(), plan_.meter_discs.clear(), plan_.meter_reach.clear();
  plan_.walk_radius = 0;
}

namespace {

void reset(const Iteration& in, IterationTally& tally) {
  std::vector<TechniqueTally> techniques = std::move(tally.techniques);  // large: kept from one iteration to the next
  tally = {};
  const Snapshot& scene = in.scene;
  if (in.settings.technique_edges) {
    techniques.resize(scene.cameras.size());
    for (size_t c = 0; c < techniques.size(); ++c)
      techniques[c].reset(in.settings.technique_edges, scene.cameras[c].pixel_count());
    tally.techniques = std::move(techniques);
  }
  tally.pixels.resize(scene.cameras.size());
  if (in.has(UPS_TECHNIQUE_MERGE)) tally.pixel_bias.resize(scene.cameras.size());
  tally.illuminance.resize(scene.cameras.size());
  tally.splats.resize(scene.cameras.size());
  const size_t sets = in.moments ? in.moments->row() : 0;
  for (size_t c = 0; c < scene.cameras.size() && sets; ++c) {
    tally.excess_of_pixels.emplace_back((scene.cameras[c].pixel_count() / in.plan.camera_subsets +
                                         scene.cameras[c].height()) * sets);
    tally.excess_of_splats.emplace_back(in.plan.units.tiles(c) * sets);
  }
  for (const MeterSet& s : scene.meter_sets) {
    const size_t visited = in.plan.visited_meters(in.number, s.meters.size());
    tally.meters.emplace_back(visited);
    tally.landings.emplace_back();
    tally.separated.emplace_back(visited * in.plan.separation.columns.size());
    if (sets) tally.excess_of_meters.emplace_back(visited * sets);
  }
  for (const Goniometer& g : scene.goniometers) tally.goniometers.push_back(g.empty_tally());
}

}  // namespace

// Light paths for caustics alone start towards what focuses light. Each round finds more of that than the one before.
EmissionGuide Integrator::train_guide(const StopSignal& stop) {
  constexpr uint32_t rounds = 4, paths = 1u << 12;
  GuideTraining training;
  Plan small = plan_;
  small.light_paths = paths;
  small.shares.assign(plan_.units.count, {false, false, TechniqueShare::merge_caustics});
  TransportSettings of_pilot = settings_;
  of_pilot.seed = mix64(~settings_.seed);  // not the numbers of the pilots that choose
  for (uint32_t k = 0; k < rounds; ++k) {
    Iteration in = Iteration::of_pilot(*scene_, small, of_pilot, k, stop, Stream::pilot);
    in.trains_guide = true;
    IterationTally tally;
    reset(in, tally);
    trace_light_paths(in, SensorIndex(in, pool_), pool_, tally);
    if (stop.is_set()) break;
    for (const IterationTally::Start& s : tally.starts)
      training.add(scene_->emitters, small.guide, s.emitter, s.square, double(s.flux));
    small.guide = EmissionGuide(scene_->emitters, training);
  }
  return small.guide;
}

bool Integrator::trace(const Iteration& in, IterationTally& tally) {
  reset(in, tally);
  Photons photons;
  if (settings_.traces_light()) {
    const SensorIndex sensors(in, pool_);
    photons.paths = trace_light_paths(in, sensors, pool_, tally);
    tally.light_work = tally.work;
    if (in.stop.is_set()) return false;
    const double pixel_radius2 = plan_.radius2(largest_pixel_radius_, in.camera_shrinkage);
    if (in.has(UPS_TECHNIQUE_MERGE)) {
      size_t merged = 0;
      for (const LightVertex& v : photons.paths.vertices) merged += v.merge;
      photons.paths.share.take(2 * PhotonIndex::bytes(merged));
    }
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
  return !in.stop.is_set();
}

double Integrator::bytes_of_light_paths(const StopSignal& stop) const {
  constexpr uint32_t few = 1024;
  if (!settings_.traces_light() || plan_.light_paths == 0) return 0;
  const Iteration in = Iteration::of_pilot(*scene_, plan_, settings_, 0, stop, Stream::pilot);
  return count_light_pass(in, SensorIndex(in, pool_), pool_, few).bytes(plan_.light_paths);
}

bool Integrator::run(uint32_t iteration, const StopSignal& stop, IterationTally& tally) {
  if (iteration > 0 && plan_.meter_pass(iteration) == 0)
    look_around_meters(*scene_, pool_, stop, iteration, plan_);
  const Iteration in(*scene_, plan_, settings_, iteration, stop);
  WorkCounts shadow_rays;
  direct_.find(in, pool_, shadow_rays);
  if (!trace(in, tally)) return false;
  direct_.add(in, tally);
  tally.work.add(shadow_rays);
  return true;
}

}  // namespace ups
