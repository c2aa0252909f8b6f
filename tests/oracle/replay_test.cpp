// Is what the walks hand to the weights right? Every contribution of real light and eye paths is weighed again by the
// definition (slow_weights.h), from quantities that recorded_paths.h computes anew.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "recorded_paths.h"
#include "transport/direct_light.h"
#include "transport/sensor_index.h"

namespace ups::test {
namespace {

constexpr uint32_t all_techniques = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_CONNECT |
                                    UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_HIT;

struct Options {
  uint32_t techniques = all_techniques;
  std::vector<TechniqueShare> shares = {{}};  // taken in turn by the units
  bool guided = false;
  bool nested = false;
  Cells cells = Cells::rectangles;
};

class Replay {
 public:
  explicit Replay(const Options& options) : room_(make_room(options.nested, options.cells)), recorder_(room_) {
    settings_.method = *method_of(UPS_METHOD_UPS);
    settings_.techniques = options.techniques;
    settings_.light_paths = 1u << 14;
    settings_.max_path_length = 9;
    plan_ = make_plan(*room_.scene, settings_);
    plan_.camera_subsets = 2;
    plan_.meter_samples = 256;
    for (uint32_t i = 0; i < plan_.units.count; ++i) plan_.shares.push_back(options.shares[i % options.shares.size()]);
    set_radii();
    if (options.guided) plan_.guide = guide();
    run();
  }

  mis::Counts counts(const Replayed& r) const {
    const bool camera = r.sensor == SensorType::camera;
    const uint32_t unit = r.of_pixel ? plan_.units.of_pixel(0, r.pixel) : plan_.units.of_set(r.set);
    const TechniqueShare& share = plan_.shares[unit];
    const double paths = plan_.light_paths;
    mis::Counts n;
    n.hit = has(UPS_TECHNIQUE_EMITTER_HIT);
    n.light_sample = has(UPS_TECHNIQUE_LIGHT_SAMPLE);
    n.connect = share.connect && has(UPS_TECHNIQUE_CONNECT);
    n.merge_all = share.merge == TechniqueShare::merge_all;
    if (merges() && share.merge != TechniqueShare::no_merge) {
      n.eta = paths * pi_d * shrunk(plan_.walk_radius, of_pass);
      if (camera) n.eta_first = paths * pi_d * pixel_radius2(r);
    }
    if (camera && share.light && has(UPS_TECHNIQUE_SENSOR_CONNECT)) n.sensor_connect = paths * plan_.camera_subsets;
    if (r.sensor == SensorType::cell && share.light && has(UPS_TECHNIQUE_SENSOR_HIT))
      n.land = paths / plan_.meter_samples;
    return n;
  }
  double sensor_merge_share(const Replayed& r) const {
    if (!merges()) return 0;
    const double own = r.of_pixel ? pixel_radius2(r) : double(meter_radius) * meter_radius / plan_.meter_samples;
    return own / shrunk(plan_.walk_radius, of_pass);
  }
  // Within which a camera's path merges: at the first vertex that is no mirror or glass its pixel's, then that of walks.
  double merge_radius2(const Replayed& r) const {
    const bool first = std::all_of(r.by_eye.begin() + 1, r.by_eye.end() - 1, [](const Node& n) { return n.delta; });
    return first ? pixel_radius2(r) : shrunk(plan_.walk_radius, of_pass);
  }
  bool looks_into_mirrors() const { return has(UPS_TECHNIQUE_MIRROR_SAMPLE); }
  const Room& room() const { return room_; }
  const Plan& plan() const { return plan_; }
  const std::vector<Replayed>& paths() const { return recorder_.paths; }

 private:
  static constexpr uint32_t number = 3;   // of the iteration
  static constexpr uint32_t of_pass = 2;  // of the first one of its pass: walks have its radius
  static constexpr float meter_radius = 0.35f;

  bool has(uint32_t technique) const { return settings_.techniques & technique; }
  bool merges() const { return has(UPS_TECHNIQUE_MERGE); }
  double pixel_radius2(const Replayed& r) const { return shrunk(plan_.pixel_radius[0][r.pixel], number / 2); }
  // Squared, after so many earlier visits: r_{i+1}^2 = r_i^2 (i + alpha) / (i + 1) (Knaus, Zwicker 2011, Eq. 16).
  double shrunk(double radius, uint32_t visits) const {
    double square = radius * radius;
    for (uint32_t i = 1; i <= visits; ++i) square *= (i + settings_.radius_alpha) / (i + 1);
    return square;
  }
  // Different ones at every pixel.
  void set_radii() {
    if (!merges()) return;
    const Snapshot& scene = *room_.scene;
    plan_.pixel_radius.emplace_back(scene.cameras[0].pixel_count());
    for (size_t i = 0; i < plan_.pixel_radius[0].size(); ++i) plan_.pixel_radius[0][i] = 0.02f + 0.01f * float(i % 5);
    for (const MeterSet& set : scene.meter_sets)
      plan_.meter_discs.push_back(set.is_cell()  ? MeterDiscs()
                                  : set.across() ? MeterDiscs::across(set.meters.size(), max_rings, meter_radius, 0)
                                                 : MeterDiscs(set.meters.size(), max_rings, meter_radius));
    plan_.walk_radius = 0.04f;
  }
  EmissionGuide guide() const {
    GuideTraining training;
    const EmitterSet& emitters = room_.scene->emitters;
    Random random(5);
    for (int i = 0; i < 20000; ++i) {
      const Vec2 square{float(random.uniform(0, 0.9999)), float(random.uniform(0, 0.9999))};
      const uint32_t emitter = uint32_t(random.integer(0, int(emitters.size()) - 1));
      training.add(emitters, {}, emitter, square, 1 + 5 * double(square.x) * (1 - double(square.y)));
    }
    const EmissionGuide made(emitters, training);
    EXPECT_GT(made.histogram_count(), 0u);
    return made;
  }

  void run() {
    ThreadPool pool(1);
    const StopSignal stop;
    const Snapshot& scene = *room_.scene;
    Iteration in(scene, plan_, settings_, number, stop);
    in.recorder = &recorder_;
    IterationTally tally;
    tally.pixels.resize(1), tally.illuminance.resize(1), tally.splats.resize(1);
    tally.first_hits.resize(1), tally.first_ids.resize(1);
    for (const MeterSet& set : scene.meter_sets) tally.meters.emplace_back(set.meters.size());
    tally.landings.resize(scene.meter_sets.size());
    tally.separated.resize(scene.meter_sets.size());
    const SensorIndex sensors(in);
    Photons photons;
    LightPass light;
    photons.paths = light.trace(in, sensors, pool, tally);
    if (merges()) {
      photons.of_pixels = PhotonIndex(photons.paths, 0.1f);
      photons.of_walks = PhotonIndex(photons.paths, plan_.walk_radius);
    }
    const DirectLight direct(scene, plan_, settings_);
    uint32_t path = trace_camera_paths(in, photons, 0, 0, pool, tally);
    recorder_.of_pixels = false;
    for (uint32_t& s = recorder_.meter_set = 0; s < scene.meter_sets.size(); ++s)
      path = trace_meter_paths(in, photons, direct, s, path, pool, tally);
  }

  Room room_;
  Recorder recorder_;
  TransportSettings settings_;
  Plan plan_;
};

mis::Classes by_definition(const Path& path, const std::vector<Term>& terms, double own) {
  mis::Classes c;
  for (const Term& t : terms) {
    const double density = std::exp(t.log_density - own);
    const bool casters = std::all_of(path.caster.begin() + 1, path.caster.begin() + std::max(t.at, 1),
                                     [](bool caster) { return caster; });
    switch (t.technique) {
      case Technique::hit:
      case Technique::light_sample:
        c.eye += density;
        break;
      case Technique::sensor_connect:
        (path.camera() ? c.light : c.connect) += density;
        break;
      case Technique::connect:
        c.connect += density;
        break;
      case Technique::land:
        c.light += density;
        break;
      case Technique::merge:
        (casters ? c.caustic : c.merge) += density;
        break;
    }
  }
  return c;
}

std::string name_of(const Replayed& r, int k) {
  static const char* const sensors[] = {"camera", "meter", "cell"};
  static const char* const techniques[] = {"hit", "light sample", "connect", "sensor connect", "land", "merge"};
  const bool planar = r.by_eye.empty() ? r.by_light.back().is_planar() : r.by_eye.back().is_planar();
  const std::string name = !planar ? r.sensor == SensorType::cell ? "solid cell" : "solid point"
                           : r.sensor == SensorType::point_meter && r.of_pixel ? "pixel"
                                                                               : sensors[int(r.sensor)];
  return name + ", " + techniques[int(r.technique)] + (r.technique == Technique::merge && r.at == k ? " there" : "");
}

std::string describe(const Path& p, const Replayed& r, const mis::Classes& expected) {
  std::ostringstream out;
  out << name_of(r, p.k) << " at " << r.at << " of " << p.k << ", emitter " << r.emitter;
  for (const auto* c : {&r.found, &expected})
    out << (c == &expected ? "\n  oracle " : "\n  engine ") << c->eye << ' ' << c->connect << ' ' << c->light << ' '
        << c->caustic << ' ' << c->merge;
  for (int i = 0; i <= p.k; ++i) {
    out << "\n  x_" << i << ": delta " << p.delta[i] << ", caster " << p.caster[i] << ", merges " << p.merges[i]
        << ", pdf " << p.pdf_to_sensor[i] << ' ' << p.pdf_to_emitter[i] << ", jacobian " << p.jacobian[i];
    if (i < p.k)
      out << "; edge " << p.distance[i] << ", cos " << p.cos_near[i] << ' ' << p.cos_far[i] << ", pass " << p.pass[i];
  }
  return out.str();
}

// The largest relative difference of a class.
double difference(const mis::Classes& a, const mis::Classes& b) {
  double worst = 0;
  for (const auto of :
       {&mis::Classes::eye, &mis::Classes::connect, &mis::Classes::light, &mis::Classes::caustic, &mis::Classes::merge})
    if (const double larger = std::max(a.*of, b.*of); larger > 0)
      worst = std::max(worst, std::abs(a.*of - b.*of) / larger);
  return worst;
}

struct Weighed {
  Path path;
  Vec3d x_0;
  bool resolved = false, panes = false, of_image = false;
  std::optional<mis::Classes> expected;  // none: the technique could not have made the path
};
Weighed weigh(const Replay& replay, const Replayed& r) {
  const LocalQuantities local(replay.room(), replay.plan().guide, r, replay.looks_into_mirrors());
  Weighed out{local.path(), local.x_0(), local.resolved(), local.panes_crossed(), local.of_image(), {}};
  const bool at_emitter = r.technique == Technique::hit || r.technique == Technique::light_sample;
  const int at = r.at - (local.of_image() && !at_emitter);
  out.path.sensor_merge_share = replay.sensor_merge_share(r);
  const std::vector<Term> terms = slow_weights(out.path, replay.counts(r), replay.plan().gates[r.emitter]);
  for (const Term& t : terms)
    if (t.technique == r.technique && t.at == at) out.expected = by_definition(out.path, terms, t.log_density);
  return out;
}

// How much the definition itself changes where vertices move by their rounding, and as far as rays start off surfaces.
double spread(const Replay& replay, const Replayed& r, const Weighed& own, Random& random) {
  double worst = 0;
  for (int i = 0; i < 64; ++i) {
    Replayed moved = r;
    (r.by_light.empty() ? moved.by_eye : moved.by_light)[0].p = own.x_0;
    moved.lifted = false;
    for (auto* nodes : {&moved.by_light, &moved.by_eye})
      for (Node& n : *nodes) {
        const double reach = 2 * std::max(double(n.error), 0x1p-23 * replay.room().scene->radius);
        for (double* x : {&n.p.x, &n.p.y, &n.p.z}) *x += random.uniform(-reach, reach);
      }
    const Weighed w = weigh(replay, moved);
    if (w.expected && w.resolved) worst = std::max(worst, difference(*w.expected, *own.expected));
  }
  return worst;
}

// By technique and sensor; and of paths by what they met.
struct Count {
  size_t all = 0, with_panes = 0, above_1e3 = 0;
  double largest = 0;
};
using Counted = std::map<std::string, Count>;

// Of an edge of a tenth of a millimetre the ends' rounding may turn the direction by more than a delta lobe is found
// again by: such paths are not weighed. They come together, as one light path is joined to many; 3 of 10,000 at most.
//
// Floats give about 1e-5. What is further apart must be a path whose own definition changes as much where its vertices
// move by their rounding (edges of a millimetre, grazing angles, sharp lobes); and those are few.
constexpr double usual = 2e-4, rare = 1e-3, rare_share = 0.01;

void compare(const Replay& replay, const Replayed& r, Random& random, Counted& counted) {
  const Weighed w = weigh(replay, r);
  if (!w.resolved && *std::min_element(w.path.distance.begin(), w.path.distance.end()) < 2e-4) {
    ++counted["unresolved"].all;
    return;
  }
  ASSERT_TRUE(w.resolved && w.expected) << describe(w.path, r, {});
  if (r.technique == Technique::merge && r.sensor == SensorType::camera) {
    ASSERT_LT(length2(r.by_light.back().p - r.by_eye.front().p), 1.001 * replay.merge_radius2(r));
  }
  const double apart = difference(r.found, *w.expected);
  if (!(apart < usual)) {
    const double moved = spread(replay, r, w, random);
    ASSERT_LT(apart, 2 * moved) << describe(w.path, r, *w.expected);
  }
  const auto add = [&](const std::string& name) {
    Count& c = counted[name];
    ++c.all;
    c.with_panes += w.panes;
    c.above_1e3 += apart > rare;
    c.largest = std::max(c.largest, apart);
  };
  const Path& p = w.path;
  add(name_of(r, p.k));
  add("emitter " + std::to_string(r.emitter));
  bool refracted = false, mirrored = false, glossy = false;
  for (int i = 1; i < p.k; ++i) {
    const bool bent = std::abs(p.jacobian[i] - 1) > 1e-3;
    refracted |= p.delta[i] && bent, mirrored |= p.delta[i] && !bent, glossy |= p.caster[i] && !p.delta[i];
  }
  if (refracted) add("refracted");
  if (mirrored) add("mirrored");
  if (glossy) add("glossy casters");
  if (r.found.caustic > 0) add("caustics");
  if (w.of_image && p.emitter == EmitterType::directional) add("image: sun");
  if (w.of_image)
    add("image: " + std::string(r.technique == Technique::hit            ? "hit"
                                : r.technique == Technique::light_sample ? "light sample"
                                                                         : "others"));
}

// Every kind of contribution that the options leave is found so often.
constexpr size_t enough = 100, enough_with_panes = 10;

void run(const Options& options, const std::vector<std::string>& missing = {}) {
  const Replay replay(options);
  Random random(9);
  Counted counted;
  for (const Replayed& r : replay.paths()) ASSERT_NO_FATAL_FAILURE(compare(replay, r, random, counted));
  size_t above = 0;
  double largest = 0;
  for (const char* name : {"image: hit", "image: light sample", "image: others", "image: sun"})
    EXPECT_TRUE(counted[name].all >= (replay.looks_into_mirrors() ? enough : 0)) << name << ' ' << counted[name].all;
  std::vector<std::string> names = {"refracted", "mirrored", "glossy casters", "caustics"};
  for (const char* sensor : {"camera", "pixel", "meter", "cell", "solid point", "solid cell"})
    for (const char* technique : {"hit", "light sample", "connect", "sensor connect", "merge"})
      names.push_back(std::string(sensor) + ", " + technique);
  names.insert(names.end(),
               {"pixel, merge there", "meter, merge there", "solid point, merge there"});
  names.insert(names.end(), {"cell, land", "solid cell, land"});
  for (size_t i = 0; i < replay.room().scene->emitters.size(); ++i) names.push_back("emitter " + std::to_string(i));
  for (const std::string& name : names) {
    const Count& c = counted[name];
    const bool none = std::any_of(missing.begin(), missing.end(),
                                  [&](const std::string& part) { return name.find(part) != std::string::npos; });
    if (none) {
      EXPECT_EQ(c.all, 0u) << name;
    } else {
      EXPECT_GE(c.all, enough) << name;
      EXPECT_GE(c.with_panes, enough_with_panes) << name;
    }
    if (name.find(',') == std::string::npos) continue;
    above += c.above_1e3;
    largest = std::max(largest, c.largest);
  }
  EXPECT_LT(double(counted["unresolved"].all), 3e-4 * double(replay.paths().size()));
  std::printf("  %zu paths, differences above 1e-3: %zu, largest %.2g\n", replay.paths().size(), above, largest);
  EXPECT_LT(double(above), rare_share * double(replay.paths().size()));
}

TEST(Replay, AllTechniques) { run({}); }

TEST(Replay, ImagesInFlatMirrors) { run({.techniques = all_techniques | UPS_TECHNIQUE_MIRROR_SAMPLE}); }

TEST(Replay, ImagesWithGuidedEmission) {
  run({.techniques = all_techniques | UPS_TECHNIQUE_MIRROR_SAMPLE, .guided = true});
}

TEST(Replay, GuidedEmission) { run({.guided = true}); }

TEST(Replay, DiscsAsCells) { run({.cells = Cells::discs}); }

TEST(Replay, TrianglesOfASurfaceAsCells) { run({.cells = Cells::triangles}); }

TEST(Replay, MediaThatNest) { run({.nested = true}); }

TEST(Replay, TechniquesThatDifferByUnit) {
  using Share = TechniqueShare;
  run({.shares = {{true, true, Share::merge_caustics},
                  {true, true, Share::merge_all},
                  {false, true, Share::merge_caustics},
                  {true, false, Share::no_merge},
                  {false, false, Share::merge_all}}},
      {"meter, connect", "meter, sensor connect"});
}

TEST(Replay, WithoutLightSamples) {
  run({.techniques = all_techniques & ~uint32_t(UPS_TECHNIQUE_LIGHT_SAMPLE)}, {"light sample"});
}

TEST(Replay, WithoutMerges) {
  run({.techniques = all_techniques & ~uint32_t(UPS_TECHNIQUE_MERGE)}, {"merge", "caustics"});
}

TEST(Replay, CausticsAlone) { run({.shares = {{false, false, TechniqueShare::merge_caustics}}}, {"connect", "land"}); }

}  // namespace
}  // namespace ups::test
