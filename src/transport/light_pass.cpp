// See light_pass.h: one light path (LightWalk), blocks of paths on all threads, and what blocks found put in order.
#include "transport/light_pass.h"

#include <limits>

#include "transport/walk.h"

namespace ups {

namespace {

constexpr size_t paths_per_block = 1024;

// What one block of paths found; blocks are summed in their order, so the number of threads never shows.
struct Block {
  std::vector<LightVertex> vertices;
  std::vector<uint32_t> counts;  // vertices a path
  struct CameraSplat {
    Splat splat;
    Rgb unweighted;
    uint32_t camera, edges;
  };
  std::vector<CameraSplat> splats;
  struct Landing {
    uint32_t disc, emitter;
    MeterTally value;
    float distance2;
  };
  std::vector<Landing> landings;
  struct Escape {
    Vec3 direction;
    float flux;
  };
  std::vector<Escape> escapes;  // where there are goniometers
  WorkCounts work;
  std::vector<DiscIndex::Crossing> crossings;
};

// The event at the last vertex, not yet an edge: the next cosine and distance make it a LightState.
struct LightEdge {
  enum { emission, continuous, delta } kind = emission;
  mis::LightState state;
  bool merge = false;
  double pdf = 0, pdf_reverse = 0, cos_out = 0, chi = 0;
};

class LightWalk {
 public:
  LightWalk(const LightPassInput& in, const SensorIndex& sensors, Block& block, uint32_t path)
      : in_(in), scene_(in.scene), sensors_(sensors), block_(block), counts_(common()),
        rng_(in.settings.seed, in.stream, in.batch, in.batch_visit * in.plan.light_paths + path, in.iteration, path) {}

  void run() {
    if (!emit()) return;
    for (uint32_t a = 1;; ++a) {
      if (in_.settings.max_path_length && a > in_.settings.max_path_length) return;
      if (is_stopped(in_.stop, a)) return;
      meet(scene_, origin_, direction_, media_, block_.work, met_);
      if (!sensors_.empty()) cross_sensors(a);
      if (!met_.found) {
        if (!absorb(flux_ * met_.transmittance_of_earlier(scene_))) return;
        block_.work.escaped_lm += luminance(flux_);
        if (!scene_.goniometers.empty()) block_.escapes.push_back({direction_, luminance(flux_)});
        return;
      }
      if (!absorb(flux_ * met_.transmittance(scene_, met_.distance)) || !scatter(a)) return;
    }
  }

 private:
  mis::Counts common() const { return meter_counts(in_.plan, in_.settings, false, 0); }

  bool drop(Drop where) {
    block_.work.drop(where);
    return false;
  }

  // False where the path ends as what is left is not finite; the books then lack its flux.
  bool absorb(const Rgb& after) {
    if (!is_finite(after)) return drop(Drop::light_walk);
    block_.work.absorbed_lm += double(luminance(flux_)) - double(luminance(after));
    flux_ = after;
    return true;
  }

  bool emit() {
    ++block_.work.light_paths;
    const EmitterSet::Choice choice = scene_.emitters.choose_emission(rng_.get(0, Slot::choice));
    if (!(choice.probability > 0)) return false;
    emitter_index_ = choice.index;
    emit_probability_ = choice.probability;
    emitter_ = &scene_.emitters[choice.index];
    if (!emitter_->sample_emission(rng_.position(0), rng_.direction(0), start_)) return false;
    flux_ = start_flux_ = start_.flux / choice.probability;
    if (!is_finite(flux_)) return drop(Drop::emission);
    if (is_black(flux_)) return false;
    origin_ = emission_origin(start_.p, start_.n, start_.direction, start_.error);
    direction_ = start_.direction;
    media_ = scene_.media_stacks[scene_.media_of_emitter[choice.index]];
    return true;
  }

  // MIS state at a point that the current edge reaches:
  // x_1 needs to know how next-event estimation would have found x_0.
  mis::LightState arrive(const Receiver& at, float cos_in, float distance) const {
    const double d2 = double(distance) * distance;
    switch (edge_.kind) {
      case LightEdge::continuous:
        return mis::light_step(edge_.state, edge_.merge, edge_.pdf, edge_.pdf_reverse, edge_.cos_out, cos_in, d2);
      case LightEdge::delta: return mis::light_step_delta(edge_.state, edge_.chi, edge_.cos_out, cos_in);
      case LightEdge::emission: break;
    }
    const double choose = counts_.light_sample > 0
                              ? double(scene_.emitters.direct_probability(at, emitter_index_)) / emit_probability_
                              : 0.0;
    if (emitter_->is_directional())
      return mis::light_first_directional(counts_, choose, 1.0 / start_.pdf_position_a, cos_in);
    if (emitter_->is_delta())
      return mis::light_first(counts_, choose, start_.pdf_direction_w, d2, cos_in, false, 1.0, 1.0);
    EmitterHit hit;
    const uint32_t primitive = start_.primitive == EmissionSample::invalid ? 0 : start_.primitive;
    const bool seen = emitter_->eval_hit(at.p, start_.p, primitive, start_.direction, hit);
    const double pf_0 = double(emit_probability_) * start_.pdf_position_a;
    const double ratio = seen ? choose * hit.pdf_nee_a / start_.pdf_position_a : 0.0;
    return mis::light_first(counts_, ratio, start_.pdf_direction_w, d2, cos_in, true, start_.cos_0, pf_0);
  }

  void cross_sensors(uint32_t a) {
    if (a == 1 && !in_.plan.gates.merge_at_first && !in_.settings.has(UPS_TECHNIQUE_SENSOR_HIT)) return;
    block_.crossings.clear();
    sensors_.crossings(origin_, direction_, met_.distance, block_.crossings);
    for (const DiscIndex::Crossing& c : block_.crossings) land(a, c);
  }

  // A point meter merges the photon, a cell counts it.
  void land(uint32_t a, const DiscIndex::Crossing& crossing) {
    const SensorIndex::Entry& e = sensors_.entry(crossing.disc);
    const MeterSet& set = scene_.meter_sets[e.set];
    const Meter& meter = set.meters[e.meter];
    const float cos_in = -dot(direction_, meter.frame.n);
    if (cos_in < min_cosine || !(crossing.t > 0)) return;
    const Vec3 p = origin_ + direction_ * crossing.t;
    const Vec3 offset = p - lifted(meter.p, meter.frame.n, meter.error);
    const bool cell = set.is_cell();
    if (cell && (std::abs(dot(offset, meter.frame.s)) * 2 > set.cell_width ||
                 std::abs(dot(offset, meter.frame.t)) * 2 > set.cell_height))
      return;
    if (!cell && a == 1 && !in_.plan.gates.merge_at_first) return;
    const double unweighted =
        luminance(flux_ * met_.transmittance(scene_, crossing.t)) /
        (double(in_.plan.light_paths) * (cell ? double(set.cell_area()) : 3.14159265358979323846 * e.radius2));
    double w = 1;
    if (!in_.settings.weightless()) {
      const mis::LightState s = arrive({p, meter.frame.n}, cos_in, crossing.t);
      const double reverse = cos_in * inv_pi;
      w = cell ? mis::weight_land(s, e.counts, set.cell_area(), reverse)
               : mis::weight_merge_at_sensor(s, e.counts, e.eta, reverse);
    }
    const double value = unweighted * w;
    if (!std::isfinite(value)) return block_.work.drop(cell ? Drop::sensor_hit : Drop::merge);
    const float d2 = length2(offset);
    // The disc of half the area: its photons count twice,
    // so that the difference sees the curvature of illuminance alone.
    const double bias = cell ? 0.0 : 2.0 * (value - (2.0 * d2 < e.radius2 ? 2.0 * value : 0.0));
    block_.landings.push_back({crossing.disc, emitter_index_, {value, a == 1 ? value : 0.0, bias}, d2});
  }

  bool scatter(uint32_t a) {
    const float cos_in = std::abs(dot(direction_, surface_.ng));
    if (cos_in < min_cosine) return false;
    const Bsdf bsdf = met_.bsdf(scene_);
    const Vec3 wo = -direction_, local = surface_.shading.to_local(wo);
    const mis::LightState state = arrive(receiver_at(surface_, wo, bsdf), cos_in, met_.distance);
    if (!consistent_side(surface_, wo, local)) {
      absorb(Rgb(0.0f));
      return false;
    }
    const bool merge = merge_gate(bsdf) && (a > 1 || in_.plan.gates.merge_at_first);
    if (in_.store_vertices && (merge || bsdf.has_continuous())) store(a, wo, state, merge);
    if (bsdf.has_continuous() && in_.settings.has(UPS_TECHNIQUE_SENSOR_CONNECT))
      for (uint32_t c = 0; c < scene_.cameras.size(); ++c) splat(c, a, bsdf, local, state, merge);
    return continue_walk(a, bsdf, wo, local, state, merge);
  }

  void store(uint32_t a, const Vec3& wo, const mis::LightState& state, bool merge) {
    LightVertex v;
    v.p = surface_.p;
    v.ng = surface_.ng;
    v.ns = surface_.shading.n;
    v.wo = wo;
    v.uv = surface_.uv;
    v.flux = flux_;
    v.error = surface_.error;
    v.material = surface_.material;
    v.emitter = emitter_index_;
    v.relative_ior = met_.relative_ior;
    v.depth = uint16_t(std::min<uint32_t>(a, 0xffff));
    v.merge = merge;
    v.mis = state;
    block_.vertices.push_back(v);
    ++block_.counts.back();
    ++block_.work.light_vertices;
  }

  // t = 1: an edge from this vertex to a camera's point.
  void splat(uint32_t c, uint32_t a, const Bsdf& bsdf, const Vec3& local_wo, const mis::LightState& state, bool merge) {
    const Camera& camera = scene_.cameras[c];
    if (a == 1 && !in_.plan.gates.sensor_connect_at_first) return;
    if (in_.settings.max_path_length && a + 1 > in_.settings.max_path_length) return;
    const Vec3 to = camera.position() - surface_.p;
    const float d2 = length2(to);
    if (!(d2 > 0)) return;
    const Vec3 d = to / std::sqrt(d2);
    const auto pixel = camera.pixel_of(-d);
    if (!pixel) return;
    const Vec3 local = surface_.shading.to_local(d);
    if (!consistent_side(surface_, d, local)) return;
    const Scattering scattering = bsdf.evaluate(local_wo, local, TransportMode::importance);
    const Rgb f = scattering.value * light_correction(surface_, -direction_, d);
    if (is_black(f)) return;
    const float pdf_w = camera.pdf_w(-d), cos_out = std::abs(dot(d, surface_.ng));
    double w = 1;
    if (!in_.settings.light_tracing) {
      const float r = in_.plan.pixel_radius.empty() ? 0.0f : in_.plan.pixel_radius[c][*pixel];
      const mis::Counts n =
          camera_counts(in_.plan, in_.settings, in_.plan.radius2(r, in_.camera_radius_factor), in_.walk_radius2);
      w = mis::weight_sensor_connect(state, n, true, {}, merge, double(pdf_w) * cos_out / d2,
                                     scattering.pdf_reverse, 0.0);
    }
    const MediaStack& media = met_.beyond(d);
    const Rgb unweighted =
        flux_ * f * attenuation_ahead(scene_, media, std::sqrt(d2)) *
        float(pdf_w / (double(d2) * in_.plan.light_paths));
    Rgb value = unweighted * float(w);
    if (is_black(value)) return;
    Rgb passed(1.0f);
    if (is_finite(value) &&
        !segment_free(scene_, media, surface_.ray_origin(d), camera.position(), block_.work, passed))
      return;
    value *= passed;
    if (!is_finite(value)) return block_.work.drop(Drop::sensor_connect);
    block_.splats.push_back({{*pixel, value}, unweighted * passed, c, a + 1});
  }

  bool continue_walk(uint32_t a, const Bsdf& bsdf, const Vec3& wo, const Vec3& local_wo, const mis::LightState& state,
                     bool merge) {
    BsdfSample s;
    if (!bsdf.sample(local_wo, rng_.get(a, Slot::lobe), rng_.direction(a), TransportMode::importance, s)) {
      absorb(Rgb(0.0f));
      return false;
    }
    if (!is_finite(s.weight)) return drop(Drop::light_walk);
    const Vec3 wi = surface_.shading.to_world(s.wi);
    if (!consistent_side(surface_, wi, s.wi)) {
      absorb(Rgb(0.0f));
      return false;
    }
    const float correction = s.delta ? shading_correction(surface_, wo, wi) : light_correction(surface_, wo, wi);
    if (!absorb(flux_ * s.weight * correction)) return false;
    const bool lossless = s.delta && max_component(s.weight) > 0.9f;
    const float q = survival(flux_, start_flux_, a, lossless);
    if (is_black(flux_) || rng_.get(a, Slot::roulette) >= q) return false;
    flux_ *= 1 / q;
    edge_.kind = s.delta ? LightEdge::delta : LightEdge::continuous;
    edge_.state = state;
    edge_.merge = merge;
    edge_.pdf = s.pdf;
    edge_.pdf_reverse = s.pdf_reverse;
    edge_.cos_out = std::abs(dot(wi, surface_.ng));
    edge_.chi = double(s.pdf_reverse) / s.pdf * s.delta_jacobian;
    media_ = met_.beyond(wi);
    origin_ = surface_.ray_origin(wi);
    direction_ = wi;
    return true;
  }

  const LightPassInput& in_;
  const Snapshot& scene_;
  const SensorIndex& sensors_;
  Block& block_;
  mis::Counts counts_;
  PathSampler rng_;

  const Emitter* emitter_ = nullptr;
  uint32_t emitter_index_ = 0;
  float emit_probability_ = 1;
  EmissionSample start_;
  LightEdge edge_;
  Encounter met_;  // where the current edge ends
  const SurfacePoint& surface_ = met_.surface;
  Vec3 origin_, direction_;
  Rgb flux_, start_flux_;
  MediaStack media_;  // where the current edge starts
};

std::vector<Block> run_blocks(const LightPassInput& in, const SensorIndex& sensors, ThreadPool& pool) {
  std::vector<Block> blocks((in.plan.light_paths + paths_per_block - 1) / paths_per_block);
  pool.for_blocks(in.plan.light_paths, paths_per_block, [&](size_t b, size_t begin, size_t end) {
    Block& block = blocks[b];
    if (in.stop.is_set()) return;
    block.counts.reserve(end - begin);
    for (size_t path = begin; path < end; ++path) {
      block.counts.push_back(0);
      LightWalk(in, sensors, block, uint32_t(path)).run();
    }
  });
  return blocks;
}

}  // namespace

LightPaths trace_light_paths(const LightPassInput& in, const SensorIndex& sensors, ThreadPool& pool,
                             IterationTally& tally) {
  const std::vector<Block> blocks = run_blocks(in, sensors, pool);
  LightPaths paths;
  paths.begin.reserve(in.plan.light_paths + 1);
  size_t total = 0;
  for (const Block& b : blocks) total += b.vertices.size();
  paths.vertices.reserve(total);
  const size_t columns = in.plan.separation.columns.size();
  uint32_t at = 0;
  for (const Block& b : blocks) {
    for (uint32_t n : b.counts) {
      paths.begin.push_back(at);
      at += n;
    }
    paths.vertices.insert(paths.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Block::CameraSplat& s : b.splats) {
      tally.splats[s.camera].push_back(s.splat);
      if (!tally.techniques.empty())
        tally.techniques[s.camera].add({Family::path_integration, s.edges, s.edges}, s.splat.pixel, s.splat.value,
                                       s.unweighted);
    }
    for (const Block::Landing& l : b.landings) {
      const SensorIndex::Entry& e = sensors.entry(l.disc);
      tally.meters[e.set][e.visited].add(l.value);
      if (columns)
        tally.separated[e.set][e.visited * columns + in.plan.separation.column_of_emitter[l.emitter]].add(l.value);
    }
    for (size_t g = 0; g < tally.goniometers.size(); ++g)
      for (const Block::Escape& e : b.escapes)
        in.scene.goniometers[g].add(e.direction, double(e.flux) / in.plan.light_paths, tally.goniometers[g]);
    tally.work.merges += b.landings.size();
    tally.work.add(b.work);
  }
  paths.begin.push_back(at);
  return paths;
}

PilotPaths trace_pilot_paths(const LightPassInput& in, const SensorIndex& sensors, ThreadPool& pool) {
  PilotPaths paths;
  for (const Block& b : run_blocks(in, sensors, pool)) {
    for (const Block::Landing& l : b.landings) {
      if (paths.crossings.size() <= l.disc) paths.crossings.resize(l.disc + 1);
      paths.crossings[l.disc].push_back({l.distance2, l.value.value});
    }
    paths.vertices.insert(paths.vertices.end(), b.vertices.begin(), b.vertices.end());
  }
  return paths;
}

}  // namespace ups
