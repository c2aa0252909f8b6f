// See glare.h.
#include "transport/glare.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "emitter/area.h"
#include "transport/encounter.h"
#include "transport/walk.h"

namespace ups {

namespace {

constexpr int few_rays = 8, many_rays = 16;  // along either side of an emitter's square
constexpr size_t most_parts = 4096;           // of an emitter, that are rated each by itself
constexpr double least_covered = 0.05;        // of a source's light
constexpr double rule_of_three = 3;           // where so many hits are expected there is one, with 95 %

// Light of an emitter that arrives at the eye from places of it, each weighed by its light.
struct Look {
  double light = 0, squares = 0;  // all, and its square
  double visible = 0, arriving = 0;  // that nothing hides, and what panes and media leave of that
  double covered = 0;                // that ends on what lets light through, and scatters or bends it
  double share() const { return light > 0 ? visible / light : 0; }
  double rays() const { return squares > 0 ? light * light / squares : 1; }  // of the same weight, as good
};

// What is rated as one source: an emitter, or a part of one.
struct Bright {
  const Emitter* emitter;
  uint32_t index, part;
};

struct Eye {
  const Snapshot& scene;
  const Observer& observer;
  const Meter& meter;
  const MediaStack& media;

  Eye(const Snapshot& s, const Observer& o)
      : scene(s),
        observer(o),
        meter(s.meter_sets[o.meter_set].meters[0]),
        media(s.media_stacks[s.media_of_meter[o.meter_set][0]]) {}

  // From one place in each of side * side cells, by chance within it: things in rows would hide all places or none.
  Look look_at(const Bright& source, int side) const {
    const Emitter& emitter = *source.emitter;
    Look out;
    WorkCounts work;
    const Vec3 from = lifted(meter.p, meter.frame.n, meter.error);
    const auto place = [&](int cell, uint32_t bits) {
      return std::min((float(cell) + to_unit_float(bits)) / float(side), 0x1.fffffep-1f);
    };
    for (int i = 0; i < side * side; ++i) {
      DirectSample s;
      const auto random = philox({source.index, uint32_t(i), uint32_t(side), source.part}, {0, 0});
      const Vec2 u{place(i % side, random[0]), place(i / side, random[1])};
      if (!emitter.sample_direct(meter.p, u, s) || !is_finite(s.weight)) continue;
      const double light = luminance(s.weight);
      out.light += light;
      out.squares += light * light;
      Passage way;
      if (!segment_free(scene, media, from, lifted(s.p, s.n, s.error), work, way)) {
        if (is_covered(from, s.p)) out.covered += light;
        continue;
      }
      out.visible += light;
      out.arriving += luminance(s.weight * attenuation_ahead(scene, media, s.distance) * way.transmittance);
    }
    return out;
  }

  // What hides it lets light through.
  bool is_covered(const Vec3& from, const Vec3& to) const {
    Hit hit;
    return intersect_beyond_panes(scene, from, normalize(to - from), hit) &&
           traits_of(scene.materials[scene.raytracer->surface_at(hit).material]).transmits;
  }

  double index_of(const Vec3& direction) const {
    const Vec3 local = observer.frame.to_local(direction);
    return photometry::position_index(observer.position_index, double(local.x), double(local.y), -double(local.z));
  }
  bool is_in_view(const Emitter& emitter) const { return index_of(emitter.center() - meter.p) >= 0; }

  // As if nothing hid it. The term stays 0 where it troubles nobody, whatever hides it.
  void rate(const Bright& source, SeenSource& out) const {
    Sight sight;
    if (!source.emitter->seen_from(meter.p, sight)) return;
    out.glare.position_index = index_of(sight.direction);
    if (out.glare.position_index < 0) return;
    const double area = sight.solid_angle_sr * sight.distance * sight.distance;
    out.emitter = source.index;
    out.direction = sight.direction;
    out.glare.luminance_cd_m2 = area > 0 ? sight.intensity_cd / area : -1;
    out.glare.solid_angle_sr = sight.solid_angle_sr;
    out.glare.intensity_cd = sight.intensity_cd;
    out.glare.distance_m = sight.distance;
    out.glare.is_small = area < photometry::small_source_m2;
    const double term = photometry::glare_term(out.glare);
    if (term > 0 && std::isfinite(term)) out.term = term;
  }

  // What is left of it. A source that is far less than the worst needs fewer rays to be known as well.
  void look_for(double worst, const Bright& of, SeenSource& source) const {
    const bool is_point = of.emitter->is_delta();
    int side = is_point ? 1 : 4 * source.term >= worst ? many_rays : few_rays;
    Look look = look_at(of, side);
    if (!is_point && look.share() > 0 && look.share() < 1) look = look_at(of, side = many_rays);
    source.is_covered = look.covered > least_covered * look.light;
    const double share = look.share(), power = source.glare.is_small ? 2 : 1;
    const double missed = is_point ? 0 : -std::expm1(-rule_of_three / look.rays());  // a share
    if (!(look.arriving > 0)) {
      source.missed = look.visible > 0 ? 0 : source.term * std::pow(missed, power);
      source.term = 0;
      return;
    }
    const double passing = look.arriving / look.visible;
    source.visible_share = share;
    if (source.glare.luminance_cd_m2 >= 0) source.glare.luminance_cd_m2 *= passing;
    source.glare.solid_angle_sr *= share;
    source.glare.intensity_cd = source.glare.intensity_cd * share * passing;
    source.term = std::max(0.0, photometry::glare_term(source.glare));
    source.term_error = source.term * power * std::sqrt((1 - share) / (share * look.rays()));
    if (share == 1) source.missed = source.term * (1 - std::pow(1 - missed, power));
  }
};

// As the floor far below sees it.
double area_from_below(const Emitter& emitter) {
  const double away = 1000 * double(emitter.radius());
  Sight sight;
  if (!(away > 0) || !emitter.seen_from(emitter.center() - Vec3(0, 0, float(away)), sight)) return 0;
  return sight.solid_angle_sr * away * away;
}

// CIE 147's CC, by the sources that the eye sees where it turns round: they cover its room's ceiling, too.
double ceiling_coverage(const Eye& eye, const std::vector<Bright>& sources, const std::vector<SeenSource>& rated) {
  const auto is_large = [](double area_m2) { return area_m2 > photometry::large_source_m2; };
  std::vector<double> area(sources.size());
  bool sees_large = false;
  for (size_t i = 0; i < sources.size(); ++i) {
    area[i] = area_from_below(*sources[i].emitter);
    const photometry::GlareSource& g = rated[i].glare;
    sees_large |= rated[i].term > 0 && (is_large(area[i]) || is_large(g.solid_angle_sr * g.distance_m * g.distance_m));
  }
  if (!sees_large) return 0;
  double sum = 0;
  for (size_t i = 0; i < sources.size(); ++i)
    if (is_large(area[i]) && eye.look_at(sources[i], few_rays).visible > 0) sum += area[i];
  const Snapshot& scene = eye.scene;
  const Vec3 extent = scene.raytracer->bounds_max() - scene.raytracer->bounds_min();
  const double ceiling =
      eye.observer.ceiling_area > 0 ? eye.observer.ceiling_area : double(extent.x) * double(extent.y);
  return ceiling > 0 ? std::min(1.0, sum / ceiling) : 0;
}

// The chance that rays miss shares of several sources is exp(-sum of share * rays): what they miss is, with 95 %, three
// rays' worth together, and worst where it is all of one source. So the sum has the largest bound that one of them has.
void take(const SeenSource& source, SeenGlare& out) {
  if (!(source.term > 0)) {
    out.unseen = std::max(out.unseen, source.missed);
    return;
  }
  out.hidden = std::max(out.hidden, source.missed);
  out.sources.push_back(source);
  out.sum += source.term;
}

}  // namespace

SeenGlare find_glare(const Snapshot& scene, const Observer& observer, ThreadPool& pool, const StopSignal& stop) {
  const Eye eye(scene, observer);
  std::vector<std::vector<AreaEmitter>> parts(scene.emitters.size());
  parallel_for(pool, parts.size(), [&](size_t i) {
    const auto* area = dynamic_cast<const AreaEmitter*>(&scene.emitters[i]);
    if (area) parts[i] = area->separate_parts(most_parts);
  });
  std::vector<Bright> sources;
  for (uint32_t i = 0; i < parts.size(); ++i) {
    if (parts[i].empty()) sources.push_back({&scene.emitters[i], i, 0});
    for (uint32_t k = 0; k < parts[i].size(); ++k) sources.push_back({&parts[i][k], i, k + 1});
  }
  std::vector<SeenSource> all(sources.size());
  const auto for_all = [&](const auto& work) {
    pool.for_blocks(all.size(), 4, [&](size_t, size_t begin, size_t end) {
      for (size_t i = begin; i < end && !stop.is_set(); ++i) work(i);
    });
  };
  for_all([&](size_t i) { eye.rate(sources[i], all[i]); });
  double worst = 0, variance = 0;
  for (const SeenSource& source : all) worst = std::max(worst, source.term);
  for_all([&](size_t i) {
    if (all[i].term > 0) eye.look_for(worst, sources[i], all[i]);
  });
  if (stop.is_set()) return {};
  SeenGlare out;
  for (size_t i = 0; i < scene.emitters.size(); ++i) {
    const EmitterKind kind = scene.emitters[i].kind();
    out.has_unrated |= kind == EmitterKind::directional || kind == EmitterKind::rays;
    out.has_fixture |= scene.sources[scene.source_of_emitter[i]].of_fixture && eye.is_in_view(scene.emitters[i]);
  }
  out.ceiling_coverage = ceiling_coverage(eye, sources, all);
  for (const SeenSource& source : all) {
    out.has_covered |= source.is_covered;
    take(source, out);
    variance += source.term_error * source.term_error;
  }
  out.sum_error = std::sqrt(variance);
  std::stable_sort(out.sources.begin(), out.sources.end(),
                   [](const SeenSource& a, const SeenSource& b) { return a.term > b.term; });
  return out;
}

}  // namespace ups
