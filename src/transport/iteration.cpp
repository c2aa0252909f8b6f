// See iteration.h.
#include "transport/iteration.h"

namespace ups {

Iteration::Iteration(const Snapshot& of_scene, const Plan& by_plan, const TransportSettings& by_settings,
                     uint32_t running_number, const StopSignal& stop_signal)
    : scene(of_scene), plan(by_plan), settings(by_settings), stop(stop_signal), number(running_number) {
  const auto visit = [](uint32_t pass) { return Visit{pass % batch_count, pass / batch_count}; };
  const uint32_t camera_pass = plan.pass(number), meter_pass = plan.meter_pass(number);
  light_visit = visit(number);
  camera_visit = visit(camera_pass);
  meter_visit = visit(meter_pass);
  camera_shrinkage = Plan::radius2_factor(camera_pass, settings.radius_alpha);
  // One radius a pass: all its iterations' splats weigh against the one eye path of a pixel by the same density.
  walk_radius2 =
      plan.radius2(plan.walk_radius, Plan::radius2_factor(camera_pass * plan.camera_subsets, settings.radius_alpha));
  stores_vertices = has(UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_CONNECT);
  light_samples_alone = !settings.traces_light() && !scene.emitters.have_extent();
}

Iteration Iteration::of_pilot(const Snapshot& of_scene, const Plan& by_plan, const TransportSettings& by_settings,
                              uint32_t running_number, const StopSignal& stop_signal, Stream stream) {
  Iteration in(of_scene, by_plan, by_settings, running_number, stop_signal);
  in.light_visit = {0, running_number};
  in.light_stream = stream;
  in.camera_shrinkage = 1;
  in.walk_radius2 = by_plan.radius2(by_plan.walk_radius, 1);
  return in;
}

double Iteration::eta(double radius2) const {
  return has(UPS_TECHNIQUE_MERGE) ? double(plan.light_paths) * pi_d * radius2 : 0.0;
}

double Iteration::photon_norm(double radius2) const {
  return 1.0 / (double(plan.light_paths) * pi_d * radius2);
}

mis::Counts Iteration::counts(const TechniqueShare& share) const {
  mis::Counts n;
  n.hit = has(UPS_TECHNIQUE_EMITTER_HIT) && !settings.method.hits_after_specular;
  n.light_sample = has(UPS_TECHNIQUE_LIGHT_SAMPLE);
  n.connect = share.connect && has(UPS_TECHNIQUE_CONNECT);
  n.eta = share.merge == TechniqueShare::no_merge ? 0 : eta(walk_radius2);
  n.merge_all = share.merge == TechniqueShare::merge_all;
  return n;
}

mis::Counts Iteration::camera_counts(size_t c, uint32_t pixel) const {
  const TechniqueShare own = share([&] { return plan.units.of_pixel(c, pixel); });
  mis::Counts n = counts(own);
  n.eta_first = own.merge == TechniqueShare::no_merge ? 0 : eta(pixel_radius2(c, pixel));
  if (own.light && has(UPS_TECHNIQUE_SENSOR_CONNECT)) n.sensor_connect = double(plan.light_paths) * plan.camera_subsets;
  return n;
}

mis::Counts Iteration::meter_counts(size_t set) const {
  mis::Counts n = counts(share([&] { return plan.units.of_set(set); }));
  if (scene.meter_sets[set].is_cell() && has(UPS_TECHNIQUE_SENSOR_HIT) && plan.lands_on_cells(set))
    n.land = double(plan.light_paths) / plan.meter_samples;
  return n;
}

}  // namespace ups
