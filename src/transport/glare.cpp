// See glare.h.
#include "transport/glare.h"

#include <algorithm>
#include <cmath>

#include "transport/encounter.h"
#include "transport/walk.h"

namespace ups {

namespace {

// Light of an emitter that arrives at the eye from side * side places of it, each weighed by its light.
struct Look {
  double light = 0, visible = 0, arriving = 0;  // all; that nothing hides; and what panes and media leave of that
  double share() const { return light > 0 ? visible / light : 0; }
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

  Look look_at(const Emitter& emitter, int side) const {
    Look out;
    WorkCounts work;
    const Vec3 from = lifted(meter.p, meter.frame.n, meter.error);
    for (int i = 0; i < side * side; ++i) {
      DirectSample s;
      const Vec2 u{(float(i % side) + 0.5f) / float(side), (float(i / side) + 0.5f) / float(side)};
      if (!emitter.sample_direct(meter.p, u, s)) continue;
      const double light = luminance(s.weight);
      out.light += light;
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

  bool see(uint32_t index, SeenSource& out) const {
    const Emitter& emitter = scene.emitters[index];
    Sight sight;
    if (!emitter.seen_from(meter.p, sight)) return false;
    out.glare.position_index = index_of(sight.direction);
    if (out.glare.position_index < 0) return false;
    int side = emitter.is_delta() ? 1 : 8;
    Look look = look_at(emitter, side);
    if (look.share() > 0 && look.share() < 1) look = look_at(emitter, side = 16);
    if (!(look.arriving > 0)) return false;
    const double share = look.share(), passing = look.arriving / look.visible;
    const double area = sight.solid_angle_sr * sight.distance * sight.distance;
    out.emitter = index;
    out.direction = sight.direction;
    out.visible_share = share;
    out.glare.luminance_cd_m2 = area > 0 ? sight.intensity_cd / area * passing : -1;
    out.glare.solid_angle_sr = sight.solid_angle_sr * share;
    out.glare.intensity_cd = sight.intensity_cd * share * passing;
    out.glare.distance_m = sight.distance;
    out.glare.is_small = area < photometry::small_source_m2;
    out.term = photometry::glare_term(out.glare);
    const double rays = double(side) * side, power = out.glare.is_small ? 2 : 1;
    out.term_error = out.term * power * std::sqrt((1 - share) / (share * rays));
    return out.term > 0 && std::isfinite(out.term);
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

}  // namespace

SeenGlare find_glare(const Snapshot& scene, const Observer& observer, ThreadPool& pool, const StopSignal& stop) {
  const Eye eye(scene, observer);
  std::vector<SeenSource> all(scene.emitters.size());
  std::vector<uint8_t> is_seen(all.size());
  pool.for_blocks(all.size(), 4, [&](size_t, size_t begin, size_t end) {
    for (size_t i = begin; i < end && !stop.is_set(); ++i) is_seen[i] = eye.see(uint32_t(i), all[i]);
  });
  SeenGlare out;
  double variance = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    const EmitterKind kind = scene.emitters[i].kind();
    out.has_unrated |= kind == EmitterKind::directional || kind == EmitterKind::rays;
    out.has_fixture |= scene.sources[scene.source_of_emitter[i]].of_fixture && eye.is_in_view(scene.emitters[i]);
    if (!is_seen[i]) continue;
    out.sources.push_back(all[i]);
    out.sum += all[i].term;
    variance += all[i].term_error * all[i].term_error;
  }
  out.sum_error = std::sqrt(variance);
  out.ceiling_coverage = ceiling_coverage(scene, observer, out.sources);
  std::stable_sort(out.sources.begin(), out.sources.end(),
                   [](const SeenSource& a, const SeenSource& b) { return a.term > b.term; });
  return out;
}

}  // namespace ups
