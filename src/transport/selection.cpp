// See selection.h.
#include "transport/selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "transport/pilot.h"
#include "transport/radii.h"

namespace ups {

void Moments::add(double value, const mis::Classes& relative, bool camera, double* excess) const {
  const double square = value * value, sum = relative.sum(), light = relative.light * (camera ? splats_ : 1.0);
  if (!(square > 0) || !std::isfinite(square)) return;
  excess[count() + 3] += value;
  excess[count() + 4] += value * relative.caustic / sum;
  for (size_t j = 0; j < sets_.size(); ++j) {
    const mis::Classes& f = sets_[j];
    const double own = f.eye * relative.eye + f.connect * relative.connect + f.light * light +
                       f.caustic * relative.caustic + f.merge * relative.merge;
    if (own > 0)
      excess[j] += square * (sum / own - 1);
    else if (!complete_)
      excess[j] = INFINITY;  // the set has no technique for the path; otherwise it is rounding
  }
}

namespace {

// Where caustics are more of the light, a pilot is too short to see how rare their brightest photons are: light paths
// stay whole and many.
constexpr double most_caustic = 0.02;
constexpr double most_focused = 0.25;  // of one meter's reading
// Nor does it see what eye paths find once in a while only; that of light paths does, and says how much it would be.
constexpr double most_excess = 20;  // over the variance of all techniques
// Below, the choice stays as it would be without a pilot, whose predictions differ by so much from one another.
constexpr double least_gain = 1.25;
// Over all techniques: up to 2 is foretold where nothing comes of it, as photons beyond a pilot's are not counted on;
// where it comes, 2.2 and more.
constexpr double least_gain_over_all = 2;
// Noise of a visit that nobody would see, over its mean; and over the largest mean of an image's tiles or of the sets of
// meters. In the sun's light a corridor has 1e-5.
constexpr double least_noise = 1e-5, least_light = 1e-9;

// Of an image's tiles: the light that a dark one is judged by, over the image's mean; the largest weight over the
// median's.
constexpr double dark = 0.1, most_weight = 8;

// A set of techniques that a sensor's part may take, at a share of the light paths.
struct Candidate {
  double light_paths;  // over those of the plan
  TechniqueShare share;
  bool needs_whole_paths() const { return share.connect || share.light || share.merge == TechniqueShare::merge_all; }
  // photons: light paths of the plan over those of a pilot. More than a pilot's are not taken to help merging: they
  // share their noise with each other. A share of whole paths is judged as if the pilot's were all.
  mis::Classes counts(double photons) const {
    const double caustics = needs_whole_paths() ? light_paths : std::min(1.0, photons * light_paths);
    return {.eye = 1,
            .connect = double(share.connect),
            .light = light_paths * share.light,
            .caustic = caustics * (share.merge != TechniqueShare::no_merge),
            .merge = light_paths * (share.merge == TechniqueShare::merge_all)};
  }
};

constexpr double light_shares[] = {1.0, 1.0 / 4, 1.0 / 16};  // the last where nothing is merged: see most_caustic
constexpr double caustic_shares[] = {1.0 / 64, 1.0 / 4};  // where only caustics need light paths
constexpr double whole_share[] = {1.0};

// A number of light paths that the user named stays.
std::span<const double> of_light(const TransportSettings& s) {
  if (s.light_paths) return whole_share;
  return std::span<const double>(light_shares).first(s.has(UPS_TECHNIQUE_MERGE) ? 2 : 3);
}
std::span<const double> of_caustics(const TransportSettings& s) {
  return s.light_paths ? std::span<const double>(whole_share) : caustic_shares;
}

TechniqueShare eye_paths_alone(const TransportSettings& s) {
  return {false, false, s.has(UPS_TECHNIQUE_MERGE) ? TechniqueShare::merge_caustics : TechniqueShare::no_merge};
}

// The first has all techniques.
std::vector<Candidate> candidates(const TransportSettings& s) {
  std::vector<Candidate> out;
  for (const double n : of_light(s))
    for (const auto merge : {TechniqueShare::merge_all, TechniqueShare::merge_caustics, TechniqueShare::no_merge})
      for (const bool connect : {true, false})
        for (const bool light : {true, false}) {
          const bool possible = (merge == TechniqueShare::no_merge) != s.has(UPS_TECHNIQUE_MERGE) &&
                                (!connect || s.has(UPS_TECHNIQUE_CONNECT)) &&
                                (!light || s.has(UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_SENSOR_HIT));
          if (possible) out.push_back({n, {connect, light, merge}});
        }
  for (const double n : of_caustics(s)) out.push_back({n, eye_paths_alone(s)});
  return out;
}

uint32_t light_paths_of(const Plan& plan, double share) {
  return std::max(std::min(64u, plan.light_paths), uint32_t(plan.light_paths * share));
}

// Counted operations in units of a ray that is traced and shaded.
struct Costs {
  double eye = 0, connect = 0, merge = 0, light = 0, caustic_light = 0;
};
// Those of pilots, as an iteration of the plan would have them. alone: by eye paths alone, in the same pixels and at the
// same meters. paths, photons: numbers of eye paths and light paths over those of a round. The factors are fitted to
// processor times of boxes, offices and the bathroom by five sets of techniques; the sum of all over eye paths alone
// comes within a third (samples/evaluation/README.md).
Costs costs_of(const Measured& m, const Measured& alone, double paths, double photons, bool tree, bool merges) {
  constexpr double start = 2;  // of a light path: its emitter and direction
  const double choosing = tree ? 1.8 : 0.0;  // an emitter by the light tree, an eye path's ray
  const double stored = merges ? 1.25 : 0.25;  // a light vertex: written, and sorted into a grid
  const double light_paths = double(m.light_work.light_paths), landings = double(m.light_work.merges);
  const double of_eye = paths / pilot_rounds, of_light = photons / pilot_rounds;
  Costs c;
  c.eye = of_eye * (1 + choosing) * (double(alone.all.rays) - double(alone.light_work.rays));
  c.connect = of_eye * double(m.all.connections);  // most share the shadow rays of next-event estimation
  if (merges) c.merge = of_eye * (0.5 * photons * (double(m.all.merges) - landings)) + 0.1 * c.eye / (1 + choosing);
  c.light = of_light * (start * light_paths + double(m.light_work.rays) +
                        stored * double(m.light_work.light_vertices) + 0.5 * paths * landings);
  if (merges) c.caustic_light = of_light * (start * light_paths + 1.5 * double(m.light_work.caster_rays));
  return c;
}

class Chooser {
 public:
  // photons: light paths of the plan over those of an iteration of the pilot.
  Chooser(const Snapshot& scene, const Plan& plan, const TransportSettings& settings, const std::vector<Candidate>& all,
          const Measured& m, const Measured& eye, double photons)
      : units_(plan.units), all_(all), m_(m), eye_(eye), photons_(photons),
        trusts_eye_paths_(settings.prefers_eye_paths), needs_landings_(units_.count), counts_(units_.count),
        weight_(units_.count) {
    double paths = 0;
    for (const Camera& c : scene.cameras)
      paths += double(c.pixel_count()) * (1 + c.illuminance()) / plan.camera_subsets;
    for (size_t s = 0; s < scene.meter_sets.size(); ++s) {
      paths += double(scene.meter_sets[s].meters.size()) / plan.meter_subsets * plan.meter_samples;
      // Caustics meet a cell, where nothing is merged, by landing: a point's light by way of mirrors by that alone, a
      // small lamp's or a polished metal's but for rare eye paths.
      needs_landings_[units_.of_set(s)] =
          scene.meter_sets[s].is_cell() &&
          ((plan.seeks_caustics && scene.effects.casts) || !scene.effects.path_tracing_complete);
    }
    for (size_t c = 0; c < scene.cameras.size(); ++c) leave_out_noiseless(units_.begin(c), units_.end(c));
    leave_out_noiseless(units_.begin(scene.cameras.size()), units_.count);
    weigh();
    cost_ = costs_of(m, eye, paths * pilot_rounds / std::max<double>(1, double(m.all.eye_paths)), photons,
                     scene.emitters.has_tree(), settings.has(UPS_TECHNIQUE_MERGE));
  }

  // The best at one number of light paths: mean variance x operations, to which each unit adds its part.
  struct Outcome {
    std::vector<TechniqueShare> shares;  // by unit
    std::vector<double> variance_ratio;
    double operations = 0, score = INFINITY, light_paths = 1;
  };
  // whole: with techniques that need whole light paths in some units.
  Outcome best_of(std::span<const double> light_paths, bool whole) const {
    Outcome best;
    for (const double n : light_paths)
      if (Outcome o = at(n, whole); o.score < best.score) best = std::move(o);
    return best;
  }
  // Light paths for caustics alone are few where these are little of the light, which says nothing of what none of them
  // has found yet: a bound of that falls with their number. So they may cost as much as a tenth of all else.
  void add_caustic_paths(Outcome& of) const {
    constexpr double tenth = 0.1;
    const double all_else = of.operations - of.light_paths * cost_.caustic_light;
    while (2 * of.light_paths <= 1 && 2 * of.light_paths * cost_.caustic_light <= tenth * all_else) {
      of.light_paths *= 2;
      of.operations = all_else + of.light_paths * cost_.caustic_light;
      of.score = mean(of.variance_ratio) * of.operations;
    }
  }
  const std::vector<double>& weights() const { return weight_; }  // by unit, of what its sensor gains
  double operations_of_all() const {
    double sum = cost_.light;
    for (uint32_t u = 0; u < units_.count; ++u) sum += eye_operations(u, {});
    return sum;
  }

 private:
  Outcome at(double light_paths, bool whole) const {
    const Outcome first = at(light_paths, whole, 1, operations_of_all());
    return first.shares.empty() ? first : at(light_paths, whole, first.score / first.operations, first.operations);
  }
  Outcome at(double light_paths, bool whole, double variance_of_all, double operations_of_all) const {
    Outcome out;
    const double shared = light_paths * (whole ? cost_.light : cost_.caustic_light);
    for (uint32_t u = 0; u < units_.count; ++u) {
      double least = INFINITY, least_ratio = INFINITY, operations = 0;
      TechniqueShare best;
      for (size_t j = 0; j < all_.size(); ++j) {
        const TechniqueShare& share = all_[j].share;
        if (all_[j].light_paths != light_paths || (all_[j].needs_whole_paths() && !whole)) continue;
        if (needs_landings_[u] && !share.light) continue;
        const double r = ratio(u, j);
        if (!std::isfinite(r)) continue;
        const double own = eye_operations(u, share),
                     score = weight_[u] * r * operations_of_all + variance_of_all * own;
        if (score < least) least = score, least_ratio = r, operations = own, best = share;
      }
      if (!std::isfinite(least)) return {};
      out.shares.push_back(best);
      out.variance_ratio.push_back(least_ratio);
      out.operations += operations;
    }
    out.operations += shared;
    out.score = mean(out.variance_ratio) * out.operations;
    out.light_paths = light_paths;
    return out;
  }
  double mean(const std::vector<double>& by_unit) const {
    return std::inner_product(by_unit.begin(), by_unit.end(), weight_.begin(), 0.0);
  }
  // A ratio to next to no noise, or of next to no light, says nothing.
  void leave_out_noiseless(uint32_t begin, uint32_t end) {
    double largest = 0;
    for (uint32_t u = begin; u < end; ++u) largest = std::max(largest, m_.reading[u] / visited(u));
    for (uint32_t u = begin; u < end; ++u) {
      const double noise = std::sqrt(m_.variance[u] / visited(u));
      counts_[u] = noise > least_noise * m_.reading[u] / visited(u) && noise > least_light * largest;
    }
  }
  // Sensors count alike; an image's tiles by their relative variance, as its squared error is a mean over pixels, but
  // the noisiest, where a few bright samples decide, by no more than most_weight times the median's.
  void weigh() {
    size_t sensors = 0;
    for (size_t s = 0; s < units_.sensors(); ++s) {
      const uint32_t begin = units_.begin(s), end = units_.end(s);
      const double floor = dark * mean_light(begin, end);
      std::vector<double> counted;
      for (uint32_t u = begin; u < end; ++u)
        if (counts_[u]) counted.push_back(weight_[u] = relative_variance(u, floor));
      if (counted.empty()) continue;
      ++sensors;
      const double most = most_weight * median(counted);
      double sum = 0;
      for (uint32_t u = begin; u < end; ++u) {
        if (!counts_[u]) continue;
        weight_[u] = most > 0 && std::isfinite(most) ? std::min(weight_[u], most) : 1.0;
        sum += weight_[u];
      }
      for (uint32_t u = begin; u < end; ++u) weight_[u] /= sum;
    }
    for (double& w : weight_) w = sensors > 0 ? w / double(sensors) : 1.0 / units_.count;
  }
  double mean_light(uint32_t begin, uint32_t end) const {
    double sum = 0, visits = 0;
    for (uint32_t u = begin; u < end; ++u) sum += m_.reading[u], visits += visited(u);
    return sum / visits;
  }
  double relative_variance(uint32_t u, double floor) const {  // of a visit
    const double light = m_.reading[u] / visited(u);
    return m_.variance[u] / visited(u) / (light * light + floor * floor);
  }
  double visited(uint32_t u) const { return std::max(1.0, m_.visited[u]); }

  // Eye paths alone have a pilot of their own: stratification helps them more than those that meet photons, and a guide
  // their photons. What leaving out others, or photons of theirs, adds to the variance is told by moments, and what
  // more splats take from it. The noise of what lands falls with the number of light paths.
  double variance(uint32_t u, size_t j) const {
    const double traced = m_.independent[u];
    if (!all_[j].needs_whole_paths()) {
      const bool rare = eye_.caustic[u] > most_caustic * eye_.light[u] || eye_.focused[u] > most_focused ||
                        m_.excess[u].back() > most_excess * traced;
      if (rare && !trusts_eye_paths_) return INFINITY;
      return eye_.variance[u] + (all_[j].light_paths < caustic_shares[1] ? eye_.excess[u][0] : 0.0);
    }
    if (!(traced > 0)) return m_.variance[u];
    const double landed = m_.landed[u] / traced, least = std::min(1.0, 1 / photons_);
    return m_.variance[u] * std::max(1 + m_.excess[u][j] / traced, least) * (1 - landed + landed / photons_);
  }
  // To that of all techniques, the first candidate's.
  double ratio(uint32_t u, size_t j) const {
    if (!std::isfinite(m_.excess[u][j])) return INFINITY;  // there is light that the set has no technique for
    if (!counts_[u]) return 1;
    const double v = variance(u, 0), own = variance(u, j);
    return v > 0 ? own / v : own > 0 ? INFINITY : 1.0;
  }
  double eye_operations(uint32_t u, const TechniqueShare& s) const {
    const double merge = s.merge == TechniqueShare::merge_all        ? cost_.merge
                         : s.merge == TechniqueShare::merge_caustics ? 0.2 * cost_.merge
                                                                     : 0.0;
    return m_.eye_share[u] * (cost_.eye + s.connect * cost_.connect + merge);
  }

  const Units& units_;
  const std::vector<Candidate>& all_;
  const Measured &m_, &eye_;
  const double photons_;
  const bool trusts_eye_paths_;  // the scene alone says that they find all light
  std::vector<bool> needs_landings_, counts_;  // by unit; counts_: has noise to be compared
  std::vector<double> weight_;                 // by unit
  Costs cost_;
};

// What a sensor's units take together.
ups_sensor_choice choice_of(const Chooser::Outcome& best, const std::vector<double>& weight, double operations_of_all,
                            const Plan& plan, const TransportSettings& settings, size_t sensor, bool camera) {
  ups_sensor_choice c{};
  const uint32_t light = camera ? UPS_TECHNIQUE_SENSOR_CONNECT : UPS_TECHNIQUE_SENSOR_HIT,
                 begin = plan.units.begin(sensor), end = plan.units.end(sensor);
  double variance = 0, weights = 0;
  c.techniques = settings.techniques &
                 (UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_MIRROR_SAMPLE);
  for (uint32_t u = begin; u < end; ++u) {
    const TechniqueShare& share = best.shares[u];
    if (share.connect) c.techniques |= UPS_TECHNIQUE_CONNECT;
    if (share.light) c.techniques |= light & settings.techniques;
    if (share.merge != TechniqueShare::no_merge) c.techniques |= UPS_TECHNIQUE_MERGE;
    c.photons = std::max<ups_photons>(c.photons, share.merge);
    variance += weight[u] * best.variance_ratio[u], weights += weight[u];
  }
  c.predicted_gain = variance > 0 ? weights * operations_of_all / (variance * best.operations) : 1;
  return c;
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
  for (const Candidate& c : all) sets.push_back(c.counts(photons));
  Measured m, eye;
  Selection out;
  const double splats = photons * plan.camera_subsets / small.camera_subsets;
  const Moments moments(std::move(sets), splats, settings.prefers_eye_paths);
  if (!run_pilot(scene, small, of_pilot, stop, trace, moments, m)) return out;
  small.shares.assign(plan.units.count, eye_paths_alone(settings));
  small.guide = guide;
  small.light_paths = light_paths_of(plan, caustic_shares[1]);
  const double fewer = caustic_shares[0] / caustic_shares[1];
  if (!run_pilot(scene, small, of_pilot, stop, trace, Moments({{.eye = 1, .caustic = fewer}}), eye)) return out;

  const Chooser chooser(scene, plan, settings, all, m, eye, photons);
  const double whole = chooser.operations_of_all();
  Chooser::Outcome plain = chooser.best_of(of_caustics(settings), false);
  if (!settings.light_paths && settings.has(UPS_TECHNIQUE_MERGE) && !plain.shares.empty())
    chooser.add_caustic_paths(plain);
  Chooser::Outcome best = chooser.best_of(of_light(settings), true);
  if (!(best.score * least_gain < plain.score)) best = std::move(plain);
  if (!settings.prefers_eye_paths && !(best.score * least_gain_over_all < whole)) return out;
  if (best.shares.empty()) return out;
  out.light_paths = light_paths_of(plan, best.light_paths);
  out.shares = best.shares;
  for (size_t s = 0; s < plan.units.sensors(); ++s)
    out.sensors.push_back(choice_of(best, chooser.weights(), whole, plan, settings, s, s < scene.cameras.size()));
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
