// See glare.h.
#include "transport/glare.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/rng.h"
#include "transport/encounter.h"
#include "transport/walk.h"

namespace ups {

namespace {

constexpr int few_rays = 8, many_rays = 16;  // along either side of an emitter's square
constexpr size_t most_parts = 1024;           // of a surface
constexpr double least_covered = 0.05;        // of a source's light
constexpr double most_at_once = 0.25;         // a surface's radius over its distance, to be rated by its centre alone
constexpr double rule_of_three = 3;           // where so many hits are expected there is one, with 95 %

// Light of an emitter that arrives at the eye from places of it, each weighed by its light.
struct Look {
  double light = 0, squares = 0;  // all, and its square
  double visible = 0, arriving = 0;  // that nothing hides, and what panes and media leave of that
  double covered = 0;                // that ends on what lets light through, and scatters or bends it
  bool is_finite = true;             // all of it: what is not is left out
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

  // Of a place in view, 1 / p^2; elsewhere 0.
  double weight_of(const Vec3& direction) const {
    const double index = index_of(direction);
    return index > 0 ? 1 / (index * index) : 0;
  }

  // From one place in each of side * side cells, by chance within it: things in rows would hide all places or none.
  // by_place: light counts by how much it troubles there.
  Look look_at(const GlareParts::Part& source, int side, bool by_place = false) const {
    const Emitter& emitter = *source.emitter;
    Look out;
    WorkCounts work;
    const Vec3 from = lifted(meter.p, meter.frame.n, meter.error);
    const auto place = [&](int cell, uint32_t bits) {
      return std::min((float(cell) + to_unit_float(bits)) / float(side), 0x1.fffffep-1f);
    };
    for (int i = 0; i < side * side; ++i) {
      DirectSample s;
      const auto random = philox({source.index, uint32_t(i), uint32_t(side), source.number}, {0, 0});
      const Vec2 u{place(i % side, random[0]), place(i / side, random[1])};
      if (!emitter.sample_direct(meter.p, u, s)) continue;
      if (!is_finite(s.weight)) {
        out.is_finite = false;
        continue;
      }
      const double share = by_place ? weight_of(s.wi) : 1, light = share * luminance(s.weight);
      if (!(light > 0)) continue;
      out.light += light;
      out.squares += light * light;
      Passage way;
      if (!segment_free(scene, media, from, lifted(s.p, s.n, s.error), work, way)) {
        if (is_covered(from, s.p)) out.covered += light;
        continue;
      }
      out.visible += light;
      out.arriving += share * luminance(s.weight * attenuation_ahead(scene, media, s.distance) * way.transmittance);
    }
    return out;
  }

  // All that hides it lets light through.
  bool is_covered(Vec3 from, const Vec3& to) const {
    constexpr int most_surfaces = 16;
    bool covered = false;
    for (int i = 0; i < most_surfaces; ++i) {
      const Vec3 d = normalize(to - from);
      Hit hit;
      if (!intersect_beyond_panes(scene, from, d, hit) || hit.t >= 0.9999f * length(to - from)) return covered;
      const SurfacePoint s = scene.raytracer->surface_at(hit);
      if (!traits_of(scene.materials[s.material]).transmits) return false;
      covered = true;
      from = s.ray_origin(d);
    }
    return false;
  }

  double index_of(const Vec3& direction) const {
    const Vec3 local = observer.frame.to_local(direction);
    return photometry::position_index(observer.position_index, double(local.x), double(local.y), -double(local.z));
  }
  bool is_in_view(const Emitter& emitter) const { return index_of(emitter.center() - meter.p) >= 0; }

  // As if nothing hid it. The term stays 0 where it troubles nobody, whatever hides it.
  void rate(const GlareParts::Part& source, SeenSource& out) const {
    Sight sight;
    if (!source.emitter->seen_from(meter.p, sight)) return;
    const auto* surface = dynamic_cast<const AreaEmitter*>(source.emitter);
    out.by_place = surface && double(surface->radius()) > most_at_once * sight.distance;
    const double area = sight.solid_angle_sr * sight.distance * sight.distance;
    const AreaEmitter::Stretch seen =
        out.by_place ? surface->stretch_over(meter.p, [&](const Vec3& d) { return weight_of(d); })
                     : AreaEmitter::Stretch{weight_of(sight.direction), area};
    if (!(seen.weight > 0)) return;
    out.glare.position_index = 1 / std::sqrt(seen.weight);
    out.emitter = source.index;
    out.direction = sight.direction;
    out.glare.luminance_cd_m2 = area > 0 ? sight.intensity_cd / area : -1;
    out.glare.solid_angle_sr = out.largest_sr = sight.solid_angle_sr;
    out.glare.intensity_cd = sight.intensity_cd;
    out.glare.distance_m = sight.distance;
    out.glare.is_small = seen.area_m2 < photometry::small_source_m2;
    const double term = photometry::glare_term(out.glare);
    out.is_unrated = !std::isfinite(term);
    if (!out.is_unrated) out.term = std::max(0.0, term);
  }

  // What is left of it. A source that is far less than the worst needs fewer rays to be known as well.
  void look_for(double worst, const GlareParts::Part& of, SeenSource& source) const {
    const bool is_point = of.emitter->is_delta();
    int side = is_point ? 1 : 4 * source.term >= worst ? many_rays : few_rays;
    Look look = look_at(of, side, source.by_place);
    source.is_unrated = !look.is_finite;
    if (!is_point && look.share() > 0 && look.share() < 1) look = look_at(of, side = many_rays, source.by_place);
    source.is_covered = look.covered > least_covered * look.light;
    source.is_unrated |= !look.is_finite;
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
double ceiling_coverage(const Eye& eye, const std::vector<GlareParts::Part>& parts,
                        const std::vector<SeenSource>& rated, const StopSignal& stop) {
  const auto is_large = [](double area_m2) { return area_m2 > photometry::large_source_m2; };
  const auto looks_large = [&](size_t i) {
    const photometry::GlareSource& g = rated[i].glare;
    return rated[i].term > 0 && (is_large(g.solid_angle_sr * g.distance_m * g.distance_m) ||
                                 is_large(area_from_below(*parts[i].emitter)));
  };
  bool sees_large = false;
  for (size_t i = 0; i < parts.size() && !sees_large && !stop.is_set(); ++i) sees_large = looks_large(i);
  if (!sees_large) return 0;
  double sum = 0;
  for (size_t i = 0; i < parts.size() && !stop.is_set(); ++i)
    if (const double area = area_from_below(*parts[i].emitter);
        is_large(area) && eye.look_at(parts[i], few_rays).visible > 0)
      sum += area;
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

// Of one emitter, the worst part first: place and kind stay that one's, its position index becomes that of the sum.
void add_part(const SeenSource& part, SeenSource& all) {
  photometry::GlareSource& g = all.glare;
  const double light = all.term * g.position_index * g.position_index +
                       part.term * part.glare.position_index * part.glare.position_index,
               solid_angle = g.solid_angle_sr + part.glare.solid_angle_sr,
               whole = g.solid_angle_sr / all.visible_share + part.glare.solid_angle_sr / part.visible_share;
  all.term += part.term;
  all.term_error = std::hypot(all.term_error, part.term_error);
  all.largest_sr = std::max(all.largest_sr, part.largest_sr);
  g.position_index = std::sqrt(light / all.term);
  if (!(solid_angle > 0)) return;
  all.visible_share = solid_angle / whole;
  g.luminance_cd_m2 = (g.luminance_cd_m2 * g.solid_angle_sr +
                       part.glare.luminance_cd_m2 * part.glare.solid_angle_sr) / solid_angle;
  g.solid_angle_sr = solid_angle;
  g.intensity_cd += part.glare.intensity_cd;
}

void sort_and_join(std::vector<SeenSource>& sources) {
  const auto by_term = [](const SeenSource& a, const SeenSource& b) { return a.term > b.term; };
  std::stable_sort(sources.begin(), sources.end(), by_term);
  std::map<uint32_t, size_t> place;
  size_t kept = 0;
  for (size_t i = 0; i < sources.size(); ++i) {
    const SeenSource source = sources[i];  // a copy: it may be written over
    const auto [at, is_new] = place.try_emplace(source.emitter, kept);
    if (is_new) sources[kept++] = source;
    else add_part(source, sources[at->second]);
  }
  sources.resize(kept);
  std::stable_sort(sources.begin(), sources.end(), by_term);
}

}  // namespace

GlareParts::GlareParts(const Snapshot& scene, ThreadPool& pool, const StopSignal& stop) : own_(scene.emitters.size()) {
  parallel_for(pool, own_.size(), [&](size_t i) {
    const auto* area = dynamic_cast<const AreaEmitter*>(&scene.emitters[i]);
    if (area && !stop.is_set()) own_[i] = area->separate_parts(most_parts);
  });
  for (uint32_t i = 0; i < own_.size(); ++i) {
    if (own_[i].empty()) all_.push_back({&scene.emitters[i], i, 0});
    for (uint32_t k = 0; k < own_[i].size(); ++k) all_.push_back({&own_[i][k], i, k + 1});
  }
}

SeenGlare find_glare(const Snapshot& scene, const GlareParts& parts, const Observer& observer, ThreadPool& pool,
                     const StopSignal& stop) {
  const Eye eye(scene, observer);
  std::vector<SeenSource> all(parts.all().size());
  const auto for_all = [&](const auto& work) {
    pool.for_blocks(all.size(), 4, [&](size_t, size_t begin, size_t end) {
      for (size_t i = begin; i < end && !stop.is_set(); ++i) work(i);
    });
  };
  for_all([&](size_t i) { eye.rate(parts.all()[i], all[i]); });
  double worst = 0, variance = 0;
  for (const SeenSource& source : all) worst = std::max(worst, source.term);
  for_all([&](size_t i) {
    if (all[i].term > 0) eye.look_for(worst, parts.all()[i], all[i]);
  });
  SeenGlare out;
  for (size_t i = 0; i < scene.emitters.size(); ++i) {
    const EmitterKind kind = scene.emitters[i].kind();
    out.has_unrated |= kind == EmitterKind::directional || kind == EmitterKind::rays;
    out.has_fixture |= scene.sources[scene.source_of_emitter[i]].of_fixture && eye.is_in_view(scene.emitters[i]);
  }
  out.ceiling_coverage = ceiling_coverage(eye, parts.all(), all, stop);
  if (stop.is_set()) return {};
  for (const SeenSource& source : all) {
    out.has_covered |= source.is_covered;
    out.has_unrated |= source.is_unrated;
    take(source, out);
    variance += source.term_error * source.term_error;
  }
  out.sum_error = std::sqrt(variance);
  sort_and_join(out.sources);
  return out;
}

}  // namespace ups
