// See eye_pass.h: which light path an eye path is paired with, which pixels an iteration visits, and the two loops.
#include "transport/eye_pass.h"

#include <algorithm>
#include <limits>

#include "transport/eye_walk.h"
#include "transport/selection.h"
#include "ups/ups_sensor.h"

namespace ups {

namespace {

constexpr size_t pixels_per_block = 256;
constexpr size_t paths_per_block = 256;

// Eye path j meets light path (odd j + shift) mod N. Both are new in each iteration: a pixel must not meet the same
// stratum of the light paths again and again. N is a power of two, so every light path is met equally often.
class Pairing {
 public:
  Pairing(const Iteration& in, const LightPaths& light) : light_(light) {
    const auto numbers = Stream(Stream::pairing).numbers(in.settings.seed, in.number, 0, 0);
    odd_ = numbers[0] | 1u;
    shift_ = numbers[1];
  }
  void assign(uint32_t path, EyeSensor& sensor) const {
    if (const uint32_t n = light_.path_count()) sensor.light = light_.path((path * odd_ + shift_) & (n - 1));
  }

 private:
  const LightPaths& light_;
  uint32_t odd_, shift_;
};

std::vector<uint32_t> visited_pixels(const Plan& plan, const Camera& camera, uint32_t iteration) {
  std::vector<uint32_t> pixels;
  pixels.reserve(camera.pixel_count() / plan.camera_subsets + camera.height());
  plan.for_visited_pixels(iteration, camera.width(), camera.height(),
                          [&](uint32_t, uint32_t pixel) { pixels.push_back(pixel); });
  return pixels;
}

void add_work(const std::vector<WorkCounts>& blocks, IterationTally& tally) {
  for (const WorkCounts& w : blocks) tally.work.add(w);
}

// What the pixel sees first that is not a mirror or clear glass, measured like a meter that faces the eye.
PixelIlluminance pixel_illuminance(const Iteration& in, const Photons& photons, const Camera& camera, const Vec3& d,
                                   EyeSensor sensor, PathSampler rng, WorkCounts& work) {
  Encounter seen;
  Vec3 direction;
  const float u = in.scene.panes.blended.empty() ? 0 : rng.get(0, Slot::cell_x);
  const float distance = first_diffuse(in.scene, camera.position(), d, *sensor.media, u, seen, direction);
  if (distance <= 0) return {};
  const SurfacePoint& surface = seen.surface;
  sensor.own_area_m2 = float(in.plan.camera_subsets) * distance * distance /
                       (camera.pdf_w(d) * std::max(std::abs(dot(direction, surface.ng)), min_cosine));
  sensor.camera = false;
  sensor.techniques = nullptr;
  sensor.excess = nullptr;  // what a pilot judges by is luminance
  const double eta = merge_gate(seen.bsdf(in.scene)) ? sensor.counts.eta_first : 0;
  sensor.counts.sensor_connect = 0;
  sensor.own_point = mis::at_meter(sensor.counts, eta, 0);
  const Frame frame(dot(direction, surface.ng) < 0 ? surface.ng : -surface.ng);
  sensor.media = &seen.media;
  ++work.eye_paths;
  const EyeTally found = EyeWalk(in, photons, sensor, rng, work).from_surface(surface, frame);
  return {luminance(found.value()), found.merges()};
}

bool meet_first(const Snapshot& scene, const Camera& camera, const Vec3& d, Hit& hit) {
  return scene.raytracer->intersect(camera.position(), d, std::numeric_limits<float>::infinity(), hit);
}

FirstHit first_hit(const Snapshot& scene, const Camera& camera, const Vec3& d) {
  Hit hit;
  if (!meet_first(scene, camera, d, hit)) return {};
  const SurfacePoint s = scene.raytracer->surface_at(hit);
  return {base_colour(scene.materials[s.material], s.uv), dot(d, s.ng) > 0 ? -s.shading.n : s.shading.n, hit.t};
}

uint32_t first_id(const Snapshot& scene, const Camera& camera, uint32_t pixel) {
  const auto d = camera.ray(pixel % camera.width(), pixel / camera.width(), {0.5f, 0.5f});
  Hit hit;
  return d && meet_first(scene, camera, *d, hit) ? scene.instance_ids[hit.instance] : 0;
}

// The eye paths of a camera's pixels, by their running numbers among those that the iteration visits.
class CameraPaths {
 public:
  CameraPaths(const Iteration& in, const Photons& photons, uint32_t c, uint32_t first_path, IterationTally& tally)
      : in_(in), photons_(photons), c_(c), camera_(in.scene.cameras[c]), first_path_(first_path), tally_(tally),
        pixels_(visited_pixels(in.plan, camera_, in.number)), pairing_(in, photons.paths) {
    tally.pixels[c].resize(pixels_.size());
    if (!tally.pixel_merges.empty()) tally.pixel_merges[c].resize(pixels_.size());
    if (camera_.illuminance()) tally.illuminance[c].resize(pixels_.size());
    if (camera_.layers() & ~uint32_t(UPS_LAYER_ID)) tally.first_hits[c].resize(pixels_.size());
    if ((camera_.layers() & UPS_LAYER_ID) && in.plan.pass(in.number) == 0) tally.first_ids[c].resize(pixels_.size());
  }
  const std::vector<uint32_t>& pixels() const { return pixels_; }

  // Its luminance, then what asks for more.
  void trace(size_t i, WorkCounts& work) const {
    const EyeSensor sensor = sensor_of(i);
    const std::optional<Vec3> d = trace_luminance(i, sensor, work);
    if (in_.moments) in_.moments->add_eye_path(luminance(tally_.pixels[c_][i]), sensor.excess);
    if (!tally_.first_ids[c_].empty()) tally_.first_ids[c_][i] = first_id(in_.scene, camera_, pixels_[i]);
    if (!d) return;
    if (!tally_.first_hits[c_].empty()) tally_.first_hits[c_][i] = first_hit(in_.scene, camera_, *d);
    if (camera_.illuminance())
      tally_.illuminance[c_][i] =
          pixel_illuminance(in_, photons_, camera_, *d, sensor, sampler(i, Stream::illuminance), work);
  }
  // Returns the direction; none: outside of the image circle, which is black.
  std::optional<Vec3> trace_luminance(size_t i, const EyeSensor& sensor, WorkCounts& work) const {
    PathSampler rng = sampler(i, Stream::camera);
    const auto d = camera_.ray(pixels_[i] % camera_.width(), pixels_[i] / camera_.width(), rng.direction(0));
    if (!d) return d;
    ++work.eye_paths;
    const EyeTally found =
        EyeWalk(in_, photons_, sensor, rng, work).from_camera(camera_.position(), *d, camera_.pdf_w(*d));
    tally_.pixels[c_][i] = found.value();
    if (!tally_.pixel_merges.empty()) tally_.pixel_merges[c_][i] = found.merges();
    return d;
  }
  EyeSensor sensor_of(size_t i) const {
    const uint32_t pixel = pixels_[i];
    EyeSensor sensor;
    sensor.camera = true;
    sensor.counts = in_.camera_counts(c_, pixel);
    if (sensor.counts.eta_first > 0 || in_.settings.actual_perturbation)
      sensor.first = {float(std::sqrt(in_.pixel_radius2(c_, pixel))), &photons_.of_pixels};
    if (sensor.counts.eta > 0 || in_.settings.actual_perturbation) sensor.later = {walk_radius_, &photons_.of_walks};
    sensor.media = &in_.scene.media_stacks[in_.scene.media_of_camera[c_]];
    sensor.techniques = tally_.techniques.empty() ? nullptr : &tally_.techniques[c_];
    sensor.pixel = pixel;
    if (in_.moments) sensor.excess = &tally_.excess_of_pixels[c_][i * in_.moments->row()];
    pairing_.assign(first_path_ + uint32_t(i), sensor);
    return sensor;
  }

 private:
  PathSampler sampler(size_t i, Stream::Kind kind) const {
    const uint32_t pixel = pixels_[i];
    return PathSampler(in_.settings.seed, {kind, c_}, hash_combine(in_.camera_visit.batch, pixel),
                       in_.camera_visit.number, in_.number, pixel);
  }

  const Iteration& in_;
  const Photons& photons_;
  const uint32_t c_;
  const Camera& camera_;
  const uint32_t first_path_;
  IterationTally& tally_;
  const std::vector<uint32_t> pixels_;
  const Pairing pairing_;
  const float walk_radius_ = float(std::sqrt(in_.walk_radius2));
};

// Those of a set's meters, by theirs.
class MeterPaths {
 public:
  MeterPaths(const Iteration& in, const Photons& photons, const DirectLight& direct, uint32_t s, uint32_t first_path,
             IterationTally& tally)
      : in_(in), photons_(photons), direct_(direct), s_(s), set_(in.scene.meter_sets[s]), first_path_(first_path),
        tally_(tally), pairing_(in, photons.paths) {}

  // Paths from `begin` to `end` of the meter's own.
  MeterTally trace(size_t i, uint32_t begin, uint32_t end, WorkCounts& work) const {
    EyeSensor sensor = sensor_of(i);
    MeterTally sum;
    for (uint32_t k = begin; k < end; ++k) sum.add(trace_one(i, k, sensor, work));
    MeterTally share;
    share.add(sum, sensor.share);
    return share;
  }

 private:
  EyeSensor sensor_of(size_t i) const {
    const uint32_t m = in_.plan.visited_meter(in_.number, i), samples = in_.plan.meter_samples;
    EyeSensor sensor;
    sensor.cell = set_.is_cell();
    sensor.response = set_.response(m);
    const double radius2 = sensor.cell ? 0 : in_.meter_radius2(s_, m);
    sensor.counts = in_.meter_counts(s_);
    const bool merges = sensor.counts.eta > 0;
    sensor.own_point = mis::at_meter(sensor.counts, merges ? in_.eta(radius2) / samples : 0, set_.area(m));
    sensor.first.radius = float(std::sqrt(radius2));
    if (merges || in_.settings.actual_perturbation) sensor.later = {walk_radius_, &photons_.of_walks};
    if (in_.moments) sensor.excess = &tally_.excess_of_meters[s_][i * in_.moments->row()];
    const uint32_t media = in_.scene.media_of_meter[s_][m];
    sensor.media = media == none ? nullptr : &in_.scene.media_stacks[media];
    sensor.direct_found_from = direct_.found_from(s_, m);
    sensor.image_found_from = direct_.image_found_from(s_, m);
    const size_t columns = in_.plan.separation.columns.size();
    sensor.separated = columns ? &tally_.separated[s_][i * columns] : nullptr;
    sensor.share = 1.0 / samples;
    sensor.counts_hits = in_.plan.hits_alone_at(s_);
    return sensor;
  }
  MeterTally trace_one(size_t i, uint32_t k, EyeSensor& sensor, WorkCounts& work) const {
    const uint32_t m = in_.plan.visited_meter(in_.number, i), samples = in_.plan.meter_samples;
    pairing_.assign(first_path_ + uint32_t(i) * samples + k, sensor);
    PathSampler rng(in_.settings.seed, {Stream::meters, s_}, hash_combine(in_.meter_visit.batch, m),
                    uint64_t(in_.meter_visit.number) * samples + k, in_.number, m * samples + k);
    const Meter at = sensor.cell ? set_.sample(m, {rng.get(0, Slot::cell_x), rng.get(0, Slot::cell_y)}) : set_.meters[m];
    ++work.eye_paths;
    MediaStack here;  // of a cell that is partly in glass
    const bool differ = !sensor.media;
    if (differ) here = media_at(in_.scene, at.p + at.frame.n * (2 * at.error)), sensor.media = &here;
    const EyeTally found = EyeWalk(in_, photons_, sensor, rng, work).from_meter(at.p, at.error, at.frame);
    if (differ) sensor.media = nullptr;
    if (in_.moments) in_.moments->add_eye_path(luminance(found.value()) * sensor.share, sensor.excess);
    MeterTally tally = MeterTally::of_path(luminance(found.value()), found.direct, found.bias, {k});
    tally.caustics = found.hits;
    return tally;
  }

  const Iteration& in_;
  const Photons& photons_;
  const DirectLight& direct_;
  const uint32_t s_;
  const MeterSet& set_;
  const uint32_t first_path_;
  IterationTally& tally_;
  const Pairing pairing_;
  const float walk_radius_ = float(std::sqrt(in_.walk_radius2));
};

}  // namespace

uint32_t trace_camera_paths(const Iteration& in, const Photons& photons, uint32_t c, uint32_t first_path,
                            ThreadPool& pool, IterationTally& tally) {
  const CameraPaths paths(in, photons, c, first_path, tally);
  const size_t count = paths.pixels().size();
  std::vector<WorkCounts> work((count + pixels_per_block - 1) / pixels_per_block);
  pool.for_blocks(count, pixels_per_block, [&](size_t b, size_t begin, size_t end) {
    if (in.stop.is_set()) return;
    for (size_t i = begin; i < end; ++i) paths.trace(i, work[b]);
  });
  add_work(work, tally);
  return first_path + uint32_t(count);
}

uint32_t trace_meter_paths(const Iteration& in, const Photons& photons, const DirectLight& direct, uint32_t s,
                           uint32_t first_path, ThreadPool& pool, IterationTally& tally) {
  const MeterPaths paths(in, photons, direct, s, first_path, tally);
  const uint32_t samples = in.plan.meter_samples;
  const size_t meters_per_block = std::max<size_t>(1, paths_per_block / samples), visited = tally.meters[s].size();
  std::vector<WorkCounts> work((visited + meters_per_block - 1) / meters_per_block);
  pool.for_blocks(visited, meters_per_block, [&](size_t b, size_t begin, size_t end) {
    if (in.stop.is_set()) return;
    for (size_t i = begin; i < end; ++i) tally.meters[s][i].add(paths.trace(i, 0, samples, work[b]));
  });
  add_work(work, tally);
  return first_path + uint32_t(visited) * samples;
}

float retrace_pixel(const Iteration& in, const Photons& photons, uint32_t c, uint32_t first_path, uint32_t pixel,
                    IterationTally& tally) {
  const CameraPaths paths(in, photons, c, first_path, tally);
  const auto at = std::find(paths.pixels().begin(), paths.pixels().end(), pixel);
  if (at == paths.pixels().end()) return -1;
  const size_t i = size_t(at - paths.pixels().begin());
  paths.trace_luminance(i, paths.sensor_of(i), tally.work);
  return luminance(tally.pixels[c][i]);
}

float retrace_meter(const Iteration& in, const Photons& photons, const DirectLight& direct, uint32_t s,
                    uint32_t first_path, uint32_t meter, uint32_t path, IterationTally& tally) {
  const MeterPaths paths(in, photons, direct, s, first_path, tally);
  for (size_t i = 0; i < tally.meters[s].size(); ++i)
    if (in.plan.visited_meter(in.number, i) == meter && path < in.plan.meter_samples)
      return paths.trace(i, path, path + 1, tally.work).paths[whole_light].largest;
  return -1;
}

}  // namespace ups
