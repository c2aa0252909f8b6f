// See radii.h: a pixel's radius from its footprint, that of the walks from the spacing of pilot photons, those of
// meters' discs from their spacing.
#include "transport/radii.h"

#include <bit>
#include <limits>

#include "transport/light_pass.h"
#include "transport/photon_index.h"
#include "transport/walk.h"

namespace ups {

namespace {

constexpr double max_radius_rays = 1u << 18;
constexpr size_t few_meters = 16;

// r_1 = 1.5 sqrt(A / pi), A the pixel's footprint at the first diffuse point; of a square of pixels that of its middle,
// so that the rays of a large image take no longer than an iteration.
std::vector<float> pixel_radii(const Snapshot& scene, size_t c, ThreadPool& pool, const StopSignal& stop) {
  const Camera& camera = scene.cameras[c];
  const MediaStack& media = scene.media_stacks[scene.media_of_camera[c]];
  const uint32_t side = uint32_t(std::ceil(std::sqrt(double(camera.pixel_count()) / max_radius_rays))),
                 columns = (camera.width() + side - 1) / side, rows = (camera.height() + side - 1) / side;
  std::vector<float> radii(size_t(columns) * rows);
  pool.for_blocks(radii.size(), 1024, [&](size_t, size_t begin, size_t end) {
    if (stop.is_set()) return;
    for (size_t p = begin; p < end; ++p) {
      const uint32_t x = std::min(uint32_t(p % columns) * side + side / 2, camera.width() - 1),
                     y = std::min(uint32_t(p / columns) * side + side / 2, camera.height() - 1);
      const std::optional<Vec3> d = camera.ray(x, y, {0.5f, 0.5f});
      if (!d) continue;
      Encounter seen;
      Vec3 direction = *d;
      const float distance = first_diffuse(scene, camera.position(), *d, media, 0.5f, seen, direction);
      const float cosine = std::abs(dot(direction, seen.surface.ng));
      const float area = distance * distance / (camera.pdf_w(*d) * std::max(cosine, 0.1f));
      radii[p] = 1.5f * std::sqrt(area * inv_pi);
    }
  });
  // Pixels that see nothing to merge at get the median of the others;
  // far outliers are drawn to it, so that one grid serves.
  std::vector<float> seen;
  for (float r : radii)
    if (r > 0) seen.push_back(r);
  std::vector<float> of_pixels(camera.pixel_count());
  if (seen.empty()) return of_pixels;
  const float typical = median(seen);
  for (float& r : radii) r = r > 0 ? std::clamp(r, typical / 4, typical * 4) : typical;
  for (uint32_t y = 0, p = 0; y < camera.height(); ++y)
    for (uint32_t x = 0; x < camera.width(); ++x) of_pixels[p++] = radii[size_t(y / side) * columns + x / side];
  return of_pixels;
}

// Median distance of a photon to the next one: a query finds about one. Wider discs hardly lessen the noise, but they
// reach past more edges and so lose more light. Photons of the same place are one: of paths that repeat a file's ray.
float typical_spacing(const LightPaths& photons, float largest, const StopSignal& stop) {
  if (!(largest > 0)) return 0;
  const PhotonIndex index(photons, largest);
  const size_t step = std::max<size_t>(1, photons.begin.back() / 256);
  std::vector<float> spacings;
  size_t running = 0;
  photons.each([&](uint32_t, const LightVertex& v) {
    if (running++ % step != 0 || stop.is_set()) return;
    float next = INFINITY;
    index.query(v.p, largest, [&](const PhotonIndex::Photon&, float distance2) {
      if (distance2 > 0) next = std::min(next, distance2);
    });
    spacings.push_back(std::isfinite(next) ? std::sqrt(next) : largest);
  });
  if (spacings.empty()) return largest;
  return median(spacings);
}

// The caller's, 0 for none. A disc beyond the scene finds nothing more, and its square may be no float any more.
float given_radius(const Snapshot& scene, const TransportSettings& settings) {
  return std::min(settings.merge_radius, 2 * scene.radius);
}

// How far discs may reach, and how many rays find how far they do.
void plan_meter_discs(const Snapshot& scene, const TransportSettings& settings, Plan& plan) {
  constexpr size_t rays_an_iteration = size_t(1) << 20, most_rays = 256, least_rays = 32;
  const bool whole = settings.actual_perturbation;  // path integration draws from one disc, whatever is around
  const uint32_t rings = whole ? 1 : MeterDiscs::rings_for(ring_rows(scene, plan.separation));
  for (const MeterSet& set : scene.meter_sets) {
    // Half the spacing would keep discs apart; 8 times its area is as far as noise may widen them. Few meters may lie as
    // close as they like, and share photons.
    const float spacing = std::max(meter_spacing(set), set.meters.size() <= few_meters ? 0.01f * scene.radius : 0.0f),
                given = given_radius(scene, settings), fixed = given > 0 ? std::max(given, plan.min_radius) : 0;
    const float largest = fixed > 0 ? fixed : std::min(largest_meter_disc * scene.radius, std::sqrt(2.0f) * spacing);
    const size_t visited = std::max<size_t>(1, set.meters.size() / plan.meter_subsets);
    const uint32_t rays = uint32_t(std::bit_floor(std::clamp(rays_an_iteration / visited, least_rays, most_rays)));
    const bool catches = !set.is_cell() && largest > 0;
    if (catches && set.across())
      plan.meter_discs.push_back(MeterDiscs::across(set.meters.size(), rings, largest, rays));
    else
      plan.meter_discs.push_back(catches ? MeterDiscs(set.meters.size(), rings, largest, whole ? 0 : rays)
                                         : MeterDiscs());
    plan.meter_reach.push_back(catches && !whole ? largest : 0);
  }
}

}  // namespace

void choose_radii(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool, const StopSignal& stop,
                  double share, Plan& plan) {
  if (!settings.has(UPS_TECHNIQUE_MERGE) && !settings.actual_perturbation) return;
  const float fixed = given_radius(scene, settings);
  for (size_t c = 0; c < scene.cameras.size(); ++c)
    plan.pixel_radius.push_back(fixed > 0 ? std::vector<float>(scene.cameras[c].pixel_count(), fixed)
                                          : pixel_radii(scene, c, pool, stop));
  plan_meter_discs(scene, settings, plan);
  look_around_meters(scene, pool, stop, 0, plan);
  plan.walk_radius = fixed;
  if (fixed > 0) return;
  TransportSettings pilot = settings;  // its light paths say how dense light is, and are thrown away
  pilot.method.weighted = false;
  pilot.techniques &= ~uint32_t(UPS_TECHNIQUE_SENSOR_CONNECT);
  Iteration in = Iteration::of_pilot(scene, plan, pilot, 0, stop, Stream::pilot);
  in.stores_vertices = true;
  LightPass light;
  plan.walk_radius =
      typical_spacing(light.trace_pilot(in, pool), 0.05f * scene.radius, stop) * float(std::sqrt(share));
  // A coarse image's pixels are wider than the light's detail that photons can show. Of a camera whose middles of pixels
  // all see nothing to merge at, other parts of pixels may.
  const float widest = 4 * plan.walk_radius;
  for (auto& radii : plan.pixel_radius)
    for (float& r : radii) r = r > 0 ? std::min(r, widest) : widest;
}

void look_around_meters(const Snapshot& scene, ThreadPool& pool, const StopSignal& stop, uint32_t iteration,
                        Plan& plan) {
  for (size_t s = 0; s < plan.meter_reach.size(); ++s) {
    const MeterSet& set = scene.meter_sets[s];
    if (!(plan.meter_reach[s] > 0) || !plan.merges_at(s)) continue;
    pool.for_blocks(plan.visited_meters(iteration, set.meters.size()), 64, [&](size_t, size_t begin, size_t end) {
      if (stop.is_set()) return;
      for (size_t i = begin; i < end; ++i) {
        const uint32_t m = plan.visited_meter(iteration, i);
        if (set.across())
          plan.meter_discs[s].look_all_around(scene, set.meters[m], m, plan.meter_reach[s]);
        else
          plan.meter_discs[s].look_around(scene, set.meters[m], m, plan.meter_reach[s]);
      }
    });
  }
}

}  // namespace ups
