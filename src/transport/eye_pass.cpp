// See eye_pass.h: which light path an eye path is paired with, which pixels an iteration visits, and the two loops.
#include "transport/eye_pass.h"

#include "transport/eye_walk.h"
#include "transport/selection.h"

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
    if (light_.begin.size() < 2) return;
    const uint32_t n = uint32_t(light_.begin.size() - 1), i = (path * odd_ + shift_) & (n - 1);
    sensor.first_light_vertex = light_.begin[i];
    sensor.end_light_vertex = light_.begin[i + 1];
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

}  // namespace

namespace {

// What the pixel sees first that is not a mirror or clear glass, measured like a meter that faces the eye.
float pixel_illuminance(const Iteration& in, const Photons& photons, const Camera& camera, const Vec3& d,
                        EyeSensor sensor, const PathSampler& rng, WorkCounts& work) {
  Encounter seen;
  Vec3 direction;
  if (first_diffuse(in.scene, camera.position(), d, *sensor.media, seen, direction) <= 0) return 0;
  const SurfacePoint& surface = seen.surface;
  sensor.camera = false;
  sensor.techniques = nullptr;
  const double eta = merge_gate(seen.bsdf(in.scene)) ? sensor.counts.eta_first : 0;
  sensor.counts.sensor_connect = 0;
  sensor.own_point = mis::at_meter(sensor.counts, eta, 0);
  const Frame frame(dot(direction, surface.ng) < 0 ? surface.ng : -surface.ng);
  sensor.media = &seen.media;
  ++work.eye_paths;
  return luminance(EyeWalk(in, photons, sensor, rng, work).from_surface(surface, frame).value);
}

}  // namespace

uint32_t trace_camera_paths(const Iteration& in, const Photons& photons, uint32_t c, uint32_t first_path,
                            ThreadPool& pool, IterationTally& tally) {
  const Camera& camera = in.scene.cameras[c];
  const std::vector<uint32_t> pixels = visited_pixels(in.plan, camera, in.number);
  const Pairing pairing(in, photons.paths);
  const float walk_radius = float(std::sqrt(in.walk_radius2));
  tally.pixels[c].resize(pixels.size());
  if (!tally.pixel_bias.empty()) tally.pixel_bias[c].resize(pixels.size());
  if (camera.illuminance()) tally.illuminance[c].resize(pixels.size());
  std::vector<WorkCounts> work((pixels.size() + pixels_per_block - 1) / pixels_per_block);
  pool.for_blocks(pixels.size(), pixels_per_block, [&](size_t b, size_t begin, size_t end) {
    if (in.stop.is_set()) return;
    for (size_t i = begin; i < end; ++i) {
      const uint32_t pixel = pixels[i];
      EyeSensor sensor;
      sensor.camera = true;
      sensor.counts = in.camera_counts(c, pixel);
      if (sensor.counts.eta_first > 0 || in.settings.actual_perturbation)
        sensor.first = {float(std::sqrt(in.pixel_radius2(c, pixel))), &photons.of_pixels};
      if (sensor.counts.eta > 0 || in.settings.actual_perturbation) sensor.later = {walk_radius, &photons.of_walks};
      sensor.media = &in.scene.media_stacks[in.scene.media_of_camera[c]];
      sensor.techniques = tally.techniques.empty() ? nullptr : &tally.techniques[c];
      sensor.pixel = pixel;
      if (in.moments) sensor.excess = &tally.excess_of_pixels[c][i * in.moments->row()];
      pairing.assign(first_path + uint32_t(i), sensor);
      const auto sampler = [&](Stream::Kind kind) {
        return PathSampler(in.settings.seed, {kind, c}, hash_combine(in.camera_visit.batch, pixel), in.camera_visit.number,
                           in.number, pixel);
      };
      PathSampler rng = sampler(Stream::camera);
      const Vec3 d = camera.ray(pixel % camera.width(), pixel / camera.width(), rng.direction(0));
      ++work[b].eye_paths;
      const EyeTally found =
          EyeWalk(in, photons, sensor, rng, work[b]).from_camera(camera.position(), d, camera.pdf_w(d));
      tally.pixels[c][i] = found.value;
      if (!tally.pixel_bias.empty()) tally.pixel_bias[c][i] = found.bias;
      if (in.moments) in.moments->add_eye_path(luminance(tally.pixels[c][i]), sensor.excess);
      if (camera.illuminance())
        tally.illuminance[c][i] =
            pixel_illuminance(in, photons, camera, d, sensor, sampler(Stream::illuminance), work[b]);
    }
  });
  add_work(work, tally);
  return first_path + uint32_t(pixels.size());
}

uint32_t trace_meter_paths(const Iteration& in, const Photons& photons, const DirectLight& direct, uint32_t s,
                           uint32_t first_path, ThreadPool& pool, IterationTally& tally) {
  const MeterSet& set = in.scene.meter_sets[s];
  const uint32_t samples = in.plan.meter_samples;
  const size_t meters_per_block = std::max<size_t>(1, paths_per_block / samples), visited = tally.meters[s].size();
  const Pairing pairing(in, photons.paths);
  const float walk_radius = float(std::sqrt(in.walk_radius2));
  std::vector<WorkCounts> work((visited + meters_per_block - 1) / meters_per_block);
  pool.for_blocks(visited, meters_per_block, [&](size_t b, size_t begin, size_t end) {
    if (in.stop.is_set()) return;
    for (size_t i = begin; i < end; ++i) {
      const uint32_t m = in.plan.visited_meter(in.number, i);
      const Meter& meter = set.meters[m];
      EyeSensor sensor;
      sensor.cell = set.is_cell();
      const double radius2 = sensor.cell ? 0 : in.meter_radius2(s, m);
      sensor.counts = in.meter_counts(s);
      const bool merges = sensor.counts.eta > 0;
      sensor.own_point = mis::at_meter(sensor.counts, merges ? in.eta(radius2) / samples : 0, set.cell_area());
      sensor.first.radius = float(std::sqrt(radius2));
      if (merges || in.settings.actual_perturbation) sensor.later = {walk_radius, &photons.of_walks};
      if (in.moments) sensor.excess = &tally.excess_of_meters[s][i * in.moments->row()];
      sensor.media = &in.scene.media_stacks[in.scene.media_of_meter[s][m]];
      sensor.direct_found_from = direct.found_from(s, m);
      MeterTally sum;
      const size_t columns = in.plan.separation.columns.size();
      sensor.separated = columns ? &tally.separated[s][i * columns] : nullptr;
      sensor.share = 1.0 / samples;
      for (uint32_t k = 0; k < samples; ++k) {
        const uint32_t path = m * samples + k;
        pairing.assign(first_path + uint32_t(i) * samples + k, sensor);
        PathSampler rng(in.settings.seed, {Stream::meters, s}, hash_combine(in.meter_visit.batch, m),
                        in.meter_visit.number * samples + k, in.number, path);
        Vec3 p = meter.p;
        if (sensor.cell)
          p += meter.frame.s * ((rng.get(0, Slot::cell_x) - 0.5f) * set.cell_width) +
               meter.frame.t * ((rng.get(0, Slot::cell_y) - 0.5f) * set.cell_height);
        ++work[b].eye_paths;
        const EyeTally found = EyeWalk(in, photons, sensor, rng, work[b]).from_meter(p, meter.error, meter.frame);
        sum.add(MeterTally::of_path(luminance(found.value), found.direct, found.bias));
        if (in.moments) in.moments->add_eye_path(luminance(found.value) * sensor.share, sensor.excess);
      }
      tally.meters[s][i].add(sum, sensor.share);
    }
  });
  add_work(work, tally);
  return first_path + uint32_t(visited) * samples;
}

}  // namespace ups
