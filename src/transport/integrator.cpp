// See integrator.h: radii of the iteration, the light pass, the photon index, and the eye passes of all sensors.
#include "transport/integrator.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "transport/eye_pass.h"
#include "transport/pilot.h"
#include "transport/radii.h"
#include "transport/replay.h"

namespace ups {

namespace {

// Of light paths towards small casters, over those elsewhere. At meters caustics have discs of their own. A pixel merges
// photons of all kinds in one, where what is noise and what a caustic's edge is told by their number: of a mirror of 10 cm
// bounds there are a third of those at 16 all the same, and of single pixels no more miss theirs.
constexpr double densest_among_others = 128;

bool finds_all_emitters(const Snapshot& scene, const Plan& plan) {
  for (size_t i = 0; i < plan.exact.size(); ++i)
    if (!plan.exact[i] && max_component(scene.emitters[i].flux_rgb()) > 0) return false;
  return true;
}

bool scatters(const Snapshot& scene) {
  for (const Material& material : scene.materials)
    if (const MaterialTraits t = traits_of(material); t.delta || t.continuous) return true;
  return false;
}

}  // namespace

Integrator::Integrator(std::shared_ptr<const Snapshot> scene, const TransportSettings& settings, ThreadPool& pool,
                       const StopSignal& stop)
    : scene_(std::move(scene)), settings_(settings), pool_(pool), plan_(make_plan(*scene_, settings)),
      direct_(*scene_, plan_, settings_) {
  plan_.exact_direct = direct_.finds_all() && finds_all_emitters(*scene_, plan_);
  plan_.exact_light = plan_.exact_direct && (settings_.max_path_length == 1 || !scatters(*scene_));
  std::optional<CasterAims> aims;
  if (settings_.has(UPS_TECHNIQUE_MERGE)) {
    const bool shown = scene_->flat_mirrors.complete && settings_.has(UPS_TECHNIQUE_MIRROR_SAMPLE);
    aims.emplace(*scene_, shown, pool_);
    plan_.guide = EmissionGuide(scene_->emitters, aims->missed_by(plan_.light_paths, densest_among_others));
  }
  choose_first_radii(stop);
  for (const auto& radii : plan_.pixel_radius)
    for (const float r : radii) largest_pixel_radius_ = std::max(largest_pixel_radius_, r);
  if (settings_.automatic && !stop.is_set()) select(aims, stop);
  complete(*scene_, plan_, settings_, selection_.sensors);
}

// A choice of techniques may leave few light paths: it takes few to find a radius, whose noise is known for any number.
void Integrator::choose_first_radii(const StopSignal& stop) {
  const uint32_t all = plan_.light_paths, few = settings_.automatic ? std::min(all, 1u << 12) : all;
  plan_.light_paths = few;
  choose_radii(*scene_, settings_, pool_, stop, all > 0 ? double(few) / all : 1, plan_);
  plan_.light_paths = all;
}

void Integrator::select(const std::optional<CasterAims>& aims, const StopSignal& stop) {
  const EmissionGuide guide = aims ? train_guide(*aims, stop) : EmissionGuide();
  const Plan of_pilots = pilot_plan(*scene_, plan_, settings_);
  direct_.find(Iteration(*scene_, of_pilots, settings_, 0, stop), pool_, pilot_shadow_rays_);
  selection_ = select_techniques(*scene_, plan_, settings_, guide, stop,
                                 [this](const Iteration& in, IterationTally& tally) {
                                   const bool is_whole = trace(in, tally);
                                   direct_.add(in, tally);
                                   return is_whole;
                                 });
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
      techniques[c].reset(in.settings.technique_edges, scene.cameras[c].pixel_count(), in.stop);
    tally.techniques = std::move(techniques);
  }
  tally.pixels.resize(scene.cameras.size());
  if (in.has(UPS_TECHNIQUE_MERGE)) tally.pixel_merges.resize(scene.cameras.size());
  tally.illuminance.resize(scene.cameras.size());
  tally.first_hits.resize(scene.cameras.size());
  tally.first_ids.resize(scene.cameras.size());
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
EmissionGuide Integrator::train_guide(const CasterAims& aims, const StopSignal& stop) {
  constexpr uint32_t rounds = 4, paths = 1u << 12;
  GuideTraining training = aims.missed_by(paths, INFINITY);
  Plan small = plan_;
  small.light_paths = paths;
  small.shares.assign(plan_.units.count, {false, false, TechniqueShare::merge_caustics});
  small.guide = EmissionGuide(scene_->emitters, training);
  TransportSettings of_pilot = settings_;
  of_pilot.seed = mix64(~settings_.seed);  // not the numbers of the pilots that choose
  for (uint32_t k = 0; k < rounds; ++k) {
    Iteration in = Iteration::of_pilot(*scene_, small, of_pilot, k, stop, Stream::pilot);
    in.trains_guide = true;
    IterationTally tally;
    reset(in, tally);
    light_pass_.trace(in, SensorIndex(in), pool_, tally);
    if (stop.is_set()) break;
    for (const IterationTally::Start& s : tally.starts)
      training.add(scene_->emitters, small.guide, s.emitter, s.square, double(s.flux));
    small.guide = EmissionGuide(scene_->emitters, training);
  }
  return small.guide;
}

Photons Integrator::trace_light(const Iteration& in, const SensorIndex& sensors, IterationTally& tally) {
  Photons photons;
  photons.paths = light_pass_.trace(in, sensors, pool_, tally);
  tally.light_work = tally.work;
  if (in.stop.is_set()) return photons;
  const double pixel_radius2 = plan_.radius2(largest_pixel_radius_, in.camera_shrinkage);
  if (in.has(UPS_TECHNIQUE_MERGE)) photons.paths.share.take(2 * PhotonIndex::bytes(photons.paths.merged));
  pool_.for_blocks(in.has(UPS_TECHNIQUE_MERGE) ? 2 : 0, 1, [&](size_t, size_t which, size_t) {
    const float radius = float(std::sqrt(which == 0 ? pixel_radius2 : in.walk_radius2));
    if (radius > 0)
      (which == 0 ? photons.of_pixels : photons.of_walks) = PhotonIndex(photons.paths, radius, in.stop);
  });
  return photons;
}

bool Integrator::trace(const Iteration& in, IterationTally& tally) {
  reset(in, tally);
  Photons photons;
  if (settings_.traces_light()) {
    const SensorIndex sensors(in, sensor_discs_);
    if (plan_.meter_subsets == 1) sensor_discs_ = sensors.discs();
    photons = trace_light(in, sensors, tally);
  }
  if (in.stop.is_set()) return false;
  uint32_t path = 0;
  for (uint32_t c = 0; c < scene_->cameras.size(); ++c) path = trace_camera_paths(in, photons, c, path, pool_, tally);
  for (uint32_t s = 0; s < scene_->meter_sets.size(); ++s)
    path = trace_meter_paths(in, photons, direct_, s, path, pool_, tally);
  return !in.stop.is_set();
}

void Integrator::look_from_meters(uint32_t iteration, const StopSignal& stop, WorkCounts& work) {
  if (plan_.meter_pass(iteration) > 0) return;
  if (iteration > 0) look_around_meters(*scene_, pool_, stop, iteration, plan_);
  work.add(std::exchange(pilot_shadow_rays_, {}));
  direct_.find(Iteration(*scene_, plan_, settings_, iteration, stop), pool_, work);
}

double Integrator::bytes_of_light_paths(const StopSignal& stop) const {
  constexpr uint32_t few = 1024;
  if (!settings_.traces_light() || plan_.light_paths == 0) return 0;
  const Iteration in = Iteration::of_pilot(*scene_, plan_, settings_, 0, stop, Stream::pilot);
  return count_light_pass(in, SensorIndex(in), pool_, few).bytes(plan_.light_paths);
}

bool Integrator::run(uint32_t iteration, const StopSignal& stop, IterationTally& tally) {
  WorkCounts shadow_rays;
  look_from_meters(iteration, stop, shadow_rays);
  const Iteration in(*scene_, plan_, settings_, iteration, stop);
  if (!trace(in, tally)) return false;
  direct_.add(in, tally);
  tally.work.add(shadow_rays);
  return true;
}

// Sensors take their eye paths one after another, which pairs each with a light path.
double Integrator::replay_eye_path(const Iteration& in, const Photons& photons, const SampleAddress& a,
                                   IterationTally& tally) {
  uint32_t first_path = 0;
  for (uint32_t c = 0; c < scene_->cameras.size(); ++c) {
    if (a.camera && c == a.sensor) return retrace_pixel(in, photons, c, first_path, a.element, tally);
    const Camera& camera = scene_->cameras[c];
    plan_.for_visited_pixels(in.number, camera.width(), camera.height(), [&](uint32_t, uint32_t) { ++first_path; });
  }
  for (uint32_t s = 0; s < a.sensor; ++s) first_path += uint32_t(tally.meters[s].size()) * plan_.meter_samples;
  return retrace_meter(in, photons, direct_, a.sensor, first_path, a.element, a.path.number(), tally);
}

namespace {

// Of contributions, the largest first.
void choose_told(Replayed& r) {
  const std::vector<ReplayedContribution>& all = r.contributions;
  double sum = 0, told = 0;
  for (const ReplayedContribution& c : all) sum += c.value();
  const size_t most = std::min(all.size(), most_told);
  while (r.told < most && (r.told < least_told || told < told_share * sum)) told += all[r.told++].value();
  r.untold_share = sum > 0 ? std::max(0.0, 1 - told / sum) : 0;
}

}  // namespace

Replayed Integrator::replay(const SampleAddress& a, const StopSignal& stop) {
  WorkCounts unused;
  for (uint32_t i = 0; i <= a.iteration && plan_.meter_pass(i) == 0; ++i) look_from_meters(i, stop, unused);
  Iteration in(*scene_, plan_, settings_, a.iteration, stop);
  IterationTally tally;
  reset(in, tally);
  const SensorIndex sensors = settings_.traces_light() ? SensorIndex(in) : SensorIndex();
  const Photons photons = settings_.traces_light() ? trace_light(in, sensors, tally) : Photons();
  const auto retrace = [&](uint32_t path, ReplayRecorder& recorder) {
    in.recorder = &recorder;
    retrace_light_path(in, sensors, path);
    recorder.walk.path = path;
  };
  Replayed r;
  r.address = a;
  ReplayRecorder recorder(in, a.path.is_light() ? nullptr : &photons.paths, a);
  if (!a.path.is_light()) {
    in.recorder = &recorder;
    r.value = replay_eye_path(in, photons, a, tally);
    if (!a.camera) r.scale = 1.0 / plan_.meter_samples;
  } else if (settings_.traces_light() && a.path.number() < plan_.light_paths) {
    retrace(a.path.number(), recorder);
    if (a.camera) r.scale = 1.0 / plan_.camera_subsets;
  }
  r.walk = std::move(recorder.walk);
  r.contributions = std::move(recorder.contributions);
  std::erase_if(r.contributions, [](const ReplayedContribution& c) { return !std::isfinite(c.value()); });  // dropped
  std::stable_sort(r.contributions.begin(), r.contributions.end(),
                   [](const ReplayedContribution& x, const ReplayedContribution& y) { return x.value() > y.value(); });
  choose_told(r);
  std::unordered_set<uint32_t> retraced;
  for (size_t i = 0; i < r.told && !stop.is_set(); ++i) {
    const uint32_t path = r.contributions[i].light_path;
    if (path == none || !retraced.insert(path).second) continue;
    ReplayRecorder light(in, nullptr, a);
    retrace(path, light);
    r.light_paths.push_back(std::move(light.walk));
  }
  return r;
}

}  // namespace ups
