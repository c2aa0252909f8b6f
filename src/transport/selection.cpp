// See selection.h.
#include "transport/selection.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ups {

void Moments::add(double value, const mis::Classes& relative, double* excess) const {
  const double square = value * value, sum = relative.sum();
  if (!(square > 0) || !std::isfinite(square)) return;
  excess[count() + 3] += value;
  excess[count() + 4] += value * relative.caustic / sum;
  for (size_t j = 0; j < sets_.size(); ++j) {
    const mis::Classes& f = sets_[j];
    const double own = f.eye * relative.eye + f.connect * relative.connect + f.light * relative.light +
                       f.caustic * relative.caustic + f.merge * relative.merge;
    excess[j] += square * (sum / own - 1);  // infinite where the set has no technique for the path
  }
}

namespace {

constexpr uint32_t pilot_rounds = 3, pilot_paths = 1u << 12;
// Where caustics are more of the light, a pilot is too short to see how rare their brightest photons are: light paths
// stay whole and many.
constexpr double most_caustic = 0.02;
// Nor does it see what eye paths find once in a while only; that of light paths does, and says how much it would be.
constexpr double most_excess = 20;  // over the variance of all techniques
constexpr double least_gain = 1.15;  // below, the choice stays as it would be without a pilot

// A set of techniques that a sensor's part may take, at a share of the light paths.
struct Candidate {
  double light_paths;  // over those of the plan
  TechniqueShare share;
  bool needs_whole_paths() const { return share.connect || share.light || share.merge == TechniqueShare::merge_all; }
  // More photons than a pilot's are not taken to help: they share their noise with each other.
  mis::Classes counts() const {
    return {.eye = 1,
            .connect = double(share.connect),
            .light = light_paths * share.light,
            .caustic = light_paths * (share.merge != TechniqueShare::no_merge),
            .merge = light_paths * (share.merge == TechniqueShare::merge_all)};
  }
};

constexpr double light_shares[] = {1.0, 1.0 / 4, 1.0 / 16};
constexpr double caustic_shares[] = {1.0 / 64, 1.0 / 4};  // where only caustics need light paths

TechniqueShare eye_paths_alone(const TransportSettings& s) {
  return {false, false, s.has(UPS_TECHNIQUE_MERGE) ? TechniqueShare::merge_caustics : TechniqueShare::no_merge};
}

// The first has all techniques.
std::vector<Candidate> candidates(const TransportSettings& s) {
  std::vector<Candidate> out;
  for (const double n : light_shares)
    for (const auto merge : {TechniqueShare::merge_all, TechniqueShare::merge_caustics, TechniqueShare::no_merge})
      for (const bool connect : {true, false})
        for (const bool light : {true, false}) {
          const bool possible = (merge == TechniqueShare::no_merge) != s.has(UPS_TECHNIQUE_MERGE) &&
                                (!connect || s.has(UPS_TECHNIQUE_CONNECT)) &&
                                (!light || s.has(UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_SENSOR_HIT));
          if (possible) out.push_back({n, {connect, light, merge}});
        }
  for (const double n : caustic_shares) out.push_back({n, eye_paths_alone(s)});
  return out;
}

// What a pilot measured, by unit.
struct Measured {
  std::vector<double> variance;             // of an iteration
  std::vector<double> independent;          // the same, had its samples not been stratified
  std::vector<std::vector<double>> excess;  // of each set of techniques over that
  std::vector<double> eye_share;            // of all eye paths
  std::vector<double> light, caustic;       // what was found, and by photons of caustics
  WorkCounts light_work, all;
};

// Counted operations in units of a ray that is traced and shaded.
struct Costs {
  double eye = 0, connect = 0, merge = 0, light = 0, caustic_light = 0;
};
// meter_paths: eye paths of an iteration where there is no camera.
Costs costs_of(const Measured& m, double photons, double meter_paths) {
  constexpr double start = 4;  // of a light path: its emitter and direction
  const double light_rays = double(m.light_work.rays), vertices = double(m.light_work.light_vertices),
               paths = std::max<double>(1, double(m.light_work.light_paths));
  Costs c;
  c.eye = double(m.all.rays) - light_rays - double(m.all.connections);
  c.connect = double(m.all.connections) * (1 + 0.25 * vertices / paths);
  c.merge = 0.5 * photons * double(m.all.merges - m.light_work.merges) + 0.2 * double(m.all.eye_paths);
  c.light = start * paths + light_rays + 0.5 * vertices + 0.5 * photons * double(m.light_work.merges);
  c.caustic_light = start * paths + 1.5 * double(m.light_work.caster_rays);
  // A pilot of meters alone takes all light paths, and few of the meters.
  const double eye = meter_paths > 0 ? meter_paths * pilot_rounds / double(m.all.eye_paths) : 1;
  for (double* of_eye : {&c.eye, &c.connect, &c.merge}) *of_eye *= eye;
  return c;
}

// Sums over the eye paths of one sensor's point.
struct Point {
  double sum = 0, square = 0;
  uint32_t count = 0;
  double variance() const { return count < 2 ? 0.0 : std::max(0.0, (square - sum * sum / count) / (count - 1)); }
};

class Pilot {
 public:
  // moments: null where only the variance of what it traces is asked for.
  Pilot(const Snapshot& scene, const Plan& plan, const Moments* moments)
      : scene_(scene), plan_(plan), sets_(moments ? moments->count() : 0), row_(moments ? moments->row() : 0) {
    for (auto* v : {&m_.variance, &m_.independent, &m_.eye_share, &m_.light, &m_.caustic}) v->resize(plan.units.count);
    m_.excess.assign(plan.units.count, std::vector<double>(sets_));
    for (const Camera& c : scene.cameras) points_.emplace_back(c.pixel_count());
    for (const MeterSet& s : scene.meter_sets) points_.emplace_back(s.meters.size());
  }

  void add(const Iteration& in, const IterationTally& tally) {
    const Units& units = plan_.units;
    const size_t cameras = scene_.cameras.size();
    for (size_t c = 0; c < cameras; ++c) {
      const Camera& camera = scene_.cameras[c];
      plan_.for_visited_pixels(in.number, camera.width(), camera.height(), [&](uint32_t i, uint32_t pixel) {
        points_[c][pixel].of_iterations.add(luminance(tally.pixels[c][i]));
        m_.eye_share[units.of_pixel(c, pixel)] += 1;
        if (row_) take(units.of_pixel(c, pixel), &tally.excess_of_pixels[c][i * row_], 1, 1, points_[c][pixel]);
      });
      // An iteration sees one of camera_subsets times that a pixel gets splats between two visits.
      Point none;
      for (uint32_t t = 0; t < (row_ ? units.tiles(c) : 0); ++t)
        take(units.begin(c) + t, &tally.excess_of_splats[c][t * row_], plan_.camera_subsets, 0, none);
      for (const Splat& s : tally.splats[c]) {
        const double v = luminance(s.value);
        m_.variance[units.of_pixel(c, s.pixel)] += v * v * plan_.camera_subsets / pilot_rounds;
      }
    }
    for (size_t s = 0; s < scene_.meter_sets.size(); ++s)
      for (size_t i = 0; i < tally.meters[s].size(); ++i) {
        Point& point = points_[cameras + s][plan_.visited_meter(in.number, i)];
        point.of_iterations.add(tally.meters[s][i].value);
        m_.eye_share[units.of_set(s)] += plan_.meter_samples;
        if (row_) take(units.of_set(s), &tally.excess_of_meters[s][i * row_], 1, plan_.meter_samples, point);
      }
    m_.all.add(tally.work);
    m_.light_work.add(tally.light_work);
  }

  const Measured& measured() {
    const size_t cameras = scene_.cameras.size();
    for (size_t s = 0; s < points_.size(); ++s)
      for (uint32_t p = 0; p < points_[s].size(); ++p) {
        const uint32_t unit = s < cameras ? plan_.units.of_pixel(s, p) : plan_.units.of_set(s - cameras);
        m_.variance[unit] += points_[s][p].of_iterations.variance();
        m_.independent[unit] += points_[s][p].of_paths.variance() * (s < cameras ? 1 : plan_.meter_samples);
      }
    double paths = 0;
    for (const double share : m_.eye_share) paths += share;
    for (double& share : m_.eye_share) share /= std::max(1.0, paths);
    return m_;
  }

 private:
  struct Sums {
    double sum = 0, square = 0;
    uint32_t count = 0;
    void add(double v) { sum += v, square += v * v, ++count; }
    double variance() const { return count < 2 ? 0.0 : std::max(0.0, (square - sum * sum / count) / (count - 1)); }
  };
  struct Point {
    Sums of_iterations, of_paths;
  };
  void take(uint32_t unit, const double* row, double scale, uint32_t eye_paths, Point& point) {
    for (size_t j = 0; j < sets_; ++j) m_.excess[unit][j] += row[j] * scale / pilot_rounds;
    m_.independent[unit] += row[sets_ + 2] * scale / pilot_rounds;
    m_.light[unit] += row[sets_ + 3] * scale;
    m_.caustic[unit] += row[sets_ + 4] * scale;
    point.of_paths.sum += row[sets_], point.of_paths.square += row[sets_ + 1], point.of_paths.count += eye_paths;
  }

  const Snapshot& scene_;
  const Plan& plan_;
  const size_t sets_, row_;
  Measured m_;
  std::vector<std::vector<Point>> points_;  // cameras' pixels, then sets' meters
};

// Tiles are noisy: each is judged with its neighbours.
void pool_tiles(const Units& units, size_t camera, Measured& m) {
  const Measured own = m;
  const auto columns = int(units.columns(camera)), rows = int(units.tiles(camera)) / columns;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const uint32_t unit = units.begin(camera) + uint32_t(y * columns + x);
      for (int j = std::max(0, y - 1); j <= std::min(rows - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(columns - 1, x + 1); ++i) {
          const uint32_t other = units.begin(camera) + uint32_t(j * columns + i);
          if (other == unit) continue;
          m.variance[unit] += own.variance[other], m.independent[unit] += own.independent[other];
          for (size_t k = 0; k < m.excess[unit].size(); ++k) m.excess[unit][k] += own.excess[other][k];
        }
    }
}

class Chooser {
 public:
  Chooser(const Units& units, const std::vector<Candidate>& all, const Measured& m, const Measured& eye, double photons,
          double meter_paths, const Snapshot& scene, bool trusts_eye_paths)
      : units_(units), all_(all), m_(m), eye_(eye), trusts_eye_paths_(trusts_eye_paths), needs_landings_(units.count),
        cost_(costs_of(m, photons, meter_paths)) {
    // A point's light by way of mirrors alone meets a cell, where nothing is merged, by landing.
    for (size_t s = 0; s < scene.meter_sets.size(); ++s)
      needs_landings_[units.of_set(s)] = scene.meter_sets[s].is_cell() && !scene.effects.path_tracing_complete;
  }

  // The best at one number of light paths, each unit by itself.
  struct Outcome {
    std::vector<size_t> choice;  // index of a candidate, by unit
    std::vector<double> variance_ratio;
    double operations = 0, score = INFINITY, light_paths = 1;
  };
  // whole: with techniques that need whole light paths in some units.
  Outcome at(double light_paths, bool whole) const {
    Outcome out;
    const double shared = light_paths * (whole ? cost_.light : cost_.caustic_light);
    for (uint32_t u = 0; u < units_.count; ++u) {
      size_t best = all_.size();
      double least = INFINITY;
      for (size_t j = 0; j < all_.size(); ++j) {
        if (all_[j].light_paths != light_paths || (all_[j].needs_whole_paths() && !whole)) continue;
        if (needs_landings_[u] && !all_[j].share.light) continue;
        const double score = ratio(u, j) * (eye_operations(u, j) + shared / units_.count);
        if (score < least) least = score, best = j;
      }
      if (best == all_.size()) return {};
      out.choice.push_back(best);
      out.variance_ratio.push_back(ratio(u, best));
      out.operations += eye_operations(u, best);
    }
    out.operations += shared;
    out.score = mean_over_sensors(out.variance_ratio) * out.operations;
    out.light_paths = light_paths;
    return out;
  }
  double operations_of_all() const {
    double sum = cost_.light;
    for (uint32_t u = 0; u < units_.count; ++u) sum += eye_operations(u, 0);
    return sum;
  }
  // Sensors count alike, and the tiles of one.
  double mean_over_sensors(const std::vector<double>& by_unit) const {
    double sum = 0;
    for (size_t s = 0; s < units_.sensors(); ++s) {
      double own = 0;
      for (uint32_t u = units_.begin(s); u < units_.end(s); ++u) own += by_unit[u];
      sum += own / (units_.end(s) - units_.begin(s));
    }
    return sum / double(units_.sensors());
  }

 private:
  // Eye paths alone have a pilot of their own: stratification helps them more than those that meet photons, and a guide
  // their photons. What leaving out others, or photons of theirs, adds to the variance is told by moments.
  double variance(uint32_t u, size_t j) const {
    if (!std::isfinite(m_.excess[u][j])) return INFINITY;  // there is light that the set has no technique for
    const double traced = m_.independent[u];
    if (!all_[j].needs_whole_paths()) {
      const bool rare = eye_.caustic[u] > most_caustic * eye_.light[u] || m_.excess[u].back() > most_excess * traced;
      if (rare && !trusts_eye_paths_) return INFINITY;
      return eye_.variance[u] + (all_[j].light_paths < caustic_shares[1] ? eye_.excess[u][0] : 0.0);
    }
    return traced > 0 ? m_.variance[u] * std::max(1 + m_.excess[u][j] / traced, 1.0) : m_.variance[u];
  }
  // To the variance of all techniques, the first candidate's.
  double ratio(uint32_t u, size_t j) const {
    const double v = variance(u, 0), own = variance(u, j);
    return v > 0 ? own / v : own > 0 ? INFINITY : 1.0;
  }
  double eye_operations(uint32_t u, size_t j) const {
    const TechniqueShare& s = all_[j].share;
    const double merge = s.merge == TechniqueShare::merge_all        ? cost_.merge
                         : s.merge == TechniqueShare::merge_caustics ? 0.2 * cost_.merge
                                                                     : 0.0;
    return m_.eye_share[u] * (cost_.eye + s.connect * cost_.connect + merge);
  }

  const Units& units_;
  const std::vector<Candidate>& all_;
  const Measured &m_, &eye_;
  const bool trusts_eye_paths_;  // the scene alone says that they find all light
  std::vector<bool> needs_landings_;
  const Costs cost_;
};

// A few sensors' iterations as they will be, by few light paths.
Plan pilot_plan(const Snapshot& scene, const Plan& plan, const TransportSettings& settings) {
  Plan pilot = plan;
  set_path_counts(scene, settings, pilot_paths, pilot);
  pilot.meter_samples = plan.meter_samples;
  size_t meters = 0;
  for (const MeterSet& s : scene.meter_sets) meters += s.meters.size();
  const size_t times = meters * plan.meter_samples / (pilot_paths * plan.meter_subsets);
  pilot.meter_subsets = plan.meter_subsets * uint32_t(times | 1);
  if (scene.cameras.empty()) pilot.light_paths = plan.light_paths;
  return pilot;
}

uint32_t light_paths_of(const Plan& plan, double share) { return std::max(64u, uint32_t(plan.light_paths * share)); }

bool run_pilot(const Snapshot& scene, const Plan& plan, const TransportSettings& settings, const StopSignal& stop,
               const TraceIteration& trace, const Moments* moments, Measured& out) {
  Pilot pilot(scene, plan, moments);
  IterationTally tally;
  for (uint32_t k = 0; k < pilot_rounds; ++k) {  // the same pixels and meters again
    Iteration in =
        Iteration::of_pilot(scene, plan, settings, k * plan.camera_subsets * plan.meter_subsets, stop, Stream::pilot);
    in.light_visit = in.camera_visit = in.meter_visit = {k, 0};
    in.moments = moments;
    if (!trace(in, tally)) return false;
    pilot.add(in, tally);
  }
  out = pilot.measured();
  for (size_t c = 0; c < scene.cameras.size(); ++c) pool_tiles(plan.units, c, out);
  return true;
}

}  // namespace

Selection select_techniques(const Snapshot& scene, const Plan& plan, const TransportSettings& settings,
                            const EmissionGuide& guide, const StopSignal& stop, const TraceIteration& trace) {
  const std::vector<Candidate> all = candidates(settings);
  TransportSettings of_pilot = settings;
  of_pilot.seed = ~settings.seed;
  Plan small = pilot_plan(scene, plan, settings);
  const double photons = double(plan.light_paths) / small.light_paths;
  std::vector<mis::Classes> sets;
  for (const Candidate& c : all) sets.push_back(c.counts());
  const Moments moments(std::move(sets));
  Measured m, eye;
  Selection out;
  if (!run_pilot(scene, small, of_pilot, stop, trace, &moments, m)) return out;
  small.shares.assign(plan.units.count, eye_paths_alone(settings));
  small.guide = guide;
  small.light_paths = light_paths_of(plan, caustic_shares[1]);
  const double fewer = caustic_shares[0] / caustic_shares[1];
  const Moments fewer_photons({{.eye = 1, .caustic = fewer}});
  if (!run_pilot(scene, small, of_pilot, stop, trace, &fewer_photons, eye)) return out;

  double meter_paths = 0;
  for (const MeterSet& s : scene.meter_sets)
    if (scene.cameras.empty()) meter_paths += double(s.meters.size()) / plan.meter_subsets * plan.meter_samples;
  const Chooser chooser(plan.units, all, m, eye, photons, meter_paths, scene, settings.prefers_eye_paths);
  const double whole = chooser.operations_of_all();
  Chooser::Outcome best, plain;
  const auto take = [](Chooser::Outcome& of, Chooser::Outcome o) {
    if (o.score * least_gain < of.score) of = std::move(o);
  };
  for (const double n : caustic_shares) take(plain, chooser.at(n, false));
  best = plain;
  for (const double n : light_shares) take(best, chooser.at(n, true));
  if (!settings.prefers_eye_paths && !(best.score * least_gain < whole)) return out;
  if (best.choice.empty()) return out;
  out.light_paths = light_paths_of(plan, best.light_paths);
  for (const size_t j : best.choice) out.shares.push_back(all[j].share);
  for (size_t s = 0; s < plan.units.sensors(); ++s) {
    ups_sensor_choice& sensor = out.sensors.emplace_back();
    const bool camera = s < scene.cameras.size();
    const uint32_t light = camera ? UPS_TECHNIQUE_SENSOR_CONNECT : UPS_TECHNIQUE_SENSOR_HIT;
    double variance = 0;
    sensor.techniques = settings.techniques & (UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE);
    for (uint32_t u = plan.units.begin(s); u < plan.units.end(s); ++u) {
      const TechniqueShare& share = out.shares[u];
      if (share.connect) sensor.techniques |= UPS_TECHNIQUE_CONNECT;
      if (share.light) sensor.techniques |= light & settings.techniques;
      if (share.merge != TechniqueShare::no_merge) sensor.techniques |= UPS_TECHNIQUE_MERGE;
      sensor.photons = std::max<ups_photons>(sensor.photons, share.merge);
      variance += best.variance_ratio[u] / (plan.units.end(s) - plan.units.begin(s));
    }
    sensor.predicted_gain = whole / (variance * best.operations);
  }
  return out;
}

void complete(const Snapshot& scene, const Plan& plan, const TransportSettings& settings,
              std::vector<ups_sensor_choice>& choices) {
  const Method& method = settings.method;
  const bool from_surfaces = method.eye_end == Method::EyeEnd::first_surface,
             lands = method.eye_end == Method::EyeEnd::first_merge;
  std::vector<uint32_t> idle;
  for (const Camera& c : scene.cameras)
    idle.push_back(UPS_TECHNIQUE_SENSOR_HIT | (from_surfaces && !c.illuminance() ? UPS_TECHNIQUE_CONNECT : 0));
  for (const MeterSet& s : scene.meter_sets)
    idle.push_back(UPS_TECHNIQUE_SENSOR_CONNECT | (method.hits_after_specular ? UPS_TECHNIQUE_EMITTER_HIT : 0) |
                   (!s.is_cell()    ? UPS_TECHNIQUE_SENSOR_HIT
                    : from_surfaces ? UPS_TECHNIQUE_CONNECT
                    : lands         ? UPS_TECHNIQUE_MERGE
                                    : 0));
  idle.resize(idle.size() + scene.goniometers.size(), ~uint32_t(UPS_TECHNIQUE_SENSOR_HIT));
  choices.resize(idle.size(), {0, settings.techniques, 0, UPS_PHOTONS_ALL, 1});
  for (size_t i = 0; i < idle.size(); ++i) {
    ups_sensor_choice& c = choices[i];
    c.struct_size = sizeof c;
    c.techniques &= ~idle[i];
    c.light_paths_per_iteration = settings.traces_light() ? plan.light_paths : 0;
    if (!(c.techniques & UPS_TECHNIQUE_MERGE)) c.photons = UPS_PHOTONS_NONE;
  }
}

}  // namespace ups
