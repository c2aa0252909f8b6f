// See glare.h.
#include "transport/glare.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "transport/encounter.h"
#include "transport/walk.h"

namespace ups {

namespace {

constexpr int few_rays = 8, many_rays = 16;  // along either side of an emitter's square
constexpr double rule_of_three = 3;           // where so many hits are expected there is one, with 95 %

// Light of an emitter that arrives at the eye from places of it, each weighed by its light.
struct Look {
  double light = 0, squares = 0;  // all, and its square
  double visible = 0, arriving = 0;  // that nothing hides, and what panes and media leave of that
  double share() const { return light > 0 ? visible / light : 0; }
  double rays() const { return squares > 0 ? light * light / squares : 1; }  // of the same weight, as good
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
  Look look_at(uint32_t index, int side) const {
    const Emitter& emitter = scene.emitters[index];
    Look out;
    WorkCounts work;
    const Vec3 from = lifted(meter.p, meter.frame.n, meter.error);
    const auto place = [&](int cell, uint32_t bits) {
      return std::min((float(cell) + to_unit_float(bits)) / float(side), 0x1.fffffep-1f);
    };
    for (int i = 0; i < side * side; ++i) {
      DirectSample s;
      const auto random = philox({index, uint32_t(i), uint32_t(side), 0}, {0, 0});
      const Vec2 u{place(i % side, random[0]), place(i / side, random[1])};
      if (!emitter.sample_direct(meter.p, u, s) || !is_finite(s.weight)) continue;
      const double light = luminance(s.weight);
      out.light += light;
      out.squares += light * light;
      Passage way;
      if (!segment_free(scene, media, from, lifted(s.p, s.n, s.error), work, way)) continue;
      out.visible += light;
      out.arriving += luminance(s.weight * attenuation_ahead(scene, media, s.distance) * way.transmittance);
    }
    return out;
  }

  double index_of(const Vec3& direction) const {
    const Vec3 local = observer.frame.to_local(direction);
    return photometry::position_index(observer.position_index, double(local.x), double(local.y), -double(local.z));
  }
  bool is_in_view(const Emitter& emitter) const { return index_of(emitter.center() - meter.p) >= 0; }

  // As if nothing hid it. The term stays 0 where it troubles nobody, whatever hides it.
  void rate(uint32_t index, SeenSource& out) const {
    const Emitter& emitter = scene.emitters[index];
    Sight sight;
    if (!emitter.seen_from(meter.p, sight)) return;
    out.glare.position_index = index_of(sight.direction);
    if (out.glare.position_index < 0) return;
    const double area = sight.solid_angle_sr * sight.distance * sight.distance;
    out.emitter = index;
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
  void look_for(double worst, SeenSource& source) const {
    const bool is_point = scene.emitters[source.emitter].is_delta();
    int side = is_point ? 1 : 4 * source.term >= worst ? many_rays : few_rays;
    Look look = look_at(source.emitter, side);
    if (!is_point && look.share() > 0 && look.share() < 1) look = look_at(source.emitter, side = many_rays);
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

// CIE 147's CC. The sources behind the eye cover the ceiling, too.
double ceiling_coverage(const Snapshot& scene, const Observer& observer, const std::vector<SeenSource>& seen) {
  const auto is_large = [](double area_m2) { return area_m2 > photometry::large_source_m2; };
  const auto looks_large = [&](const SeenSource& s) {
    return is_large(area_from_below(scene.emitters[s.emitter])) ||
           is_large(s.glare.solid_angle_sr * s.glare.distance_m * s.glare.distance_m);
  };
  if (std::none_of(seen.begin(), seen.end(), looks_large)) return 0;
  double area = 0;
  for (size_t i = 0; i < scene.emitters.size(); ++i)
    if (const double own = area_from_below(scene.emitters[i]); is_large(own)) area += own;
  const Vec3 extent = scene.raytracer->bounds_max() - scene.raytracer->bounds_min();
  const double ceiling = observer.ceiling_area > 0 ? observer.ceiling_area : double(extent.x) * double(extent.y);
  return ceiling > 0 ? std::min(1.0, area / ceiling) : 0;
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
  std::vector<SeenSource> all(scene.emitters.size());
  const auto for_all = [&](const auto& work) {
    pool.for_blocks(all.size(), 4, [&](size_t, size_t begin, size_t end) {
      for (size_t i = begin; i < end && !stop.is_set(); ++i) work(uint32_t(i));
    });
  };
  for_all([&](uint32_t i) { eye.rate(i, all[i]); });
  double worst = 0, variance = 0;
  for (const SeenSource& source : all) worst = std::max(worst, source.term);
  for_all([&](uint32_t i) {
    if (all[i].term > 0) eye.look_for(worst, all[i]);
  });
  if (stop.is_set()) return {};
  SeenGlare out;
  for (size_t i = 0; i < all.size(); ++i) {
    const EmitterKind kind = scene.emitters[i].kind();
    out.has_unrated |= kind == EmitterKind::directional || kind == EmitterKind::rays;
    out.has_fixture |= scene.sources[scene.source_of_emitter[i]].of_fixture && eye.is_in_view(scene.emitters[i]);
    take(all[i], out);
    variance += all[i].term_error * all[i].term_error;
  }
  out.sum_error = std::sqrt(variance);
  out.ceiling_coverage = ceiling_coverage(scene, observer, out.sources);
  std::stable_sort(out.sources.begin(), out.sources.end(),
                   [](const SeenSource& a, const SeenSource& b) { return a.term > b.term; });
  return out;
}

}  // namespace ups
