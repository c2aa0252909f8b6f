// See replay.h.
#include "render/replay.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <unordered_map>

#include "base/error.h"
#include "platform/numbers.h"
#include "transport/replay.h"

namespace ups {

namespace {

std::string format(const char* pattern, ...) {
  const platform::PointInNumbers point;
  char line[512];
  va_list values;
  va_start(values, pattern);
  std::vsnprintf(line, sizeof line, pattern, values);
  va_end(values);
  return line;
}

// What the sample says, against what the render traces.
SampleAddress address_of(const Integrator& integrator, const ups_sample& s) {
  const Snapshot& scene = integrator.scene();
  const auto index = [&](const std::vector<uint32_t>& ids) {
    return size_t(std::find(ids.begin(), ids.end(), s.sensor.v) - ids.begin());
  };
  SampleAddress a;
  a.element = s.index, a.iteration = s.iteration;
  size_t count;
  if (const size_t c = index(scene.camera_ids); c < scene.cameras.size()) {
    a.camera = true, a.sensor = uint32_t(c), count = scene.cameras[c].pixel_count();
  } else if (const size_t set = index(scene.meter_set_ids); set < scene.meter_sets.size()) {
    a.sensor = uint32_t(set), count = scene.meter_sets[set].count();
  } else {
    fail_argument("sample->sensor: id " + std::to_string(s.sensor.v) + " is not a camera nor meters of the scene");
  }
  if (s.index >= count)
    fail_argument("sample->index is " + std::to_string(s.index) + "; the sensor has " + std::to_string(count) +
                  (a.camera ? " pixels" : " meters"));
  if (!a.camera) a.element = scene.meter_sets[a.sensor].index_of(s.index);
  if (a.element == none)
    fail_argument("sample->index is " + std::to_string(s.index) + "; that meter has no area to measure on");
  if (s.iteration >= 0xfffffff0u) fail_argument("sample->iteration is " + std::to_string(s.iteration));
  if (s.walk != UPS_WALK_EYE && s.walk != UPS_WALK_LIGHT)
    fail_argument("sample->walk: " + std::to_string(s.walk) + " is not a UPS_WALK_* value");
  if (s.path >= PathNumber::light_bit)
    fail_argument("sample->path is " + std::to_string(s.path) + "; paths are numbered from 0 to 2^31 - 1");
  a.path = s.walk == UPS_WALK_LIGHT ? PathNumber::light(s.path) : PathNumber{s.path};
  if (s.walk == UPS_WALK_LIGHT) return a;
  const uint32_t eye_paths = a.camera ? 1 : integrator.plan().meter_samples;
  const bool sides = !a.camera && scene.meter_sets[a.sensor].kind == UPS_METER_VECTOR;  // one after the other
  const uint32_t all = sides ? eye_paths * vector_sides : eye_paths;
  if (s.path >= all)
    fail_argument("sample->path is " + std::to_string(s.path) + "; eye paths of a " + (a.camera ? "pixel" : "meter") +
                  " are " + std::to_string(all) + " an iteration, numbered from 0");
  if (sides) a.element += s.path / eye_paths * uint32_t(count), a.path.bits = s.path % eye_paths;
  return a;
}

class Teller {
 public:
  Teller(const Integrator& integrator, const ups_sample& sample, const Replayed& replayed)
      : scene_(integrator.scene()), plan_(integrator.plan()), sample_(sample), r_(replayed) {}

  PathReplay tell() {
    out_.info.struct_size = sizeof out_.info;
    out_.info.walks = uint32_t(1 + r_.light_paths.size());
    for (uint32_t k = 0; k < r_.light_paths.size(); ++k) walk_of_[r_.light_paths[k].path] = k + 1;
    out_.info.value = r_.value;
    out_.info.contributions = uint32_t(r_.contributions.size());
    head();
    walk(r_.walk, 0);
    contributions();
    for (uint32_t k = 0; k < r_.light_paths.size(); ++k) walk(r_.light_paths[k], k + 1);
    return std::move(out_);
  }

 private:
  void line(const std::string& text) { out_.text += text + "\n"; }
  uint32_t eye_paths() const {
    if (r_.address.camera) return 1;
    const bool sides = scene_.meter_sets[r_.address.sensor].kind == UPS_METER_VECTOR;
    return plan_.meter_samples * (sides ? vector_sides : 1);
  }
  const char* unit() const { return r_.address.camera ? "cd/m2" : "lx"; }
  Vec3d world(const Vec3& p) const { return Vec3d(p) + scene_.origin; }
  std::string place(const Vec3& p) const {
    const Vec3d at = world(p);
    return format("(%.6g, %.6g, %.6g) m", at.x, at.y, at.z);
  }

  void head() {
    if (r_.address.camera) {
      const uint32_t width = scene_.cameras[r_.address.sensor].width();
      line(format("Sample: camera %u, pixel column %u, row %u; iteration %u, seed %llu", sample_.sensor.v,
                  sample_.index % width, sample_.index / width, sample_.iteration,
                  (unsigned long long)sample_.seed));
    } else {
      line(format("Sample: meters %u, index %u; iteration %u, seed %llu", sample_.sensor.v, sample_.index,
                  sample_.iteration, (unsigned long long)sample_.seed));
    }
    if (sample_.walk == UPS_WALK_EYE)
      line(format("Brought by eye path %u of %u that the iteration traces there: %.6g %s", sample_.path,
                  eye_paths(), r_.value, unit()));
    else
      line(format("Brought by light path %u of %u: %.6g %s", sample_.path, plan_.light_paths, r_.value, unit()));
  }

  std::string title(const ReplayedWalk& w) const {
    if (!w.light) return "Eye path from " + place(w.p);
    return format("Light path %u from %s at ", w.path, scene_.emitter_names[w.emitter].c_str()) + place(w.p) +
           format("; density %.4g / m2, %.4g / sr; starts with %.6g lm", double(w.pdf_position_a),
                  double(w.pdf_direction_w), double(luminance(w.carried)));
  }

  void walk(const ReplayedWalk& w, uint32_t number) {
    line("");
    line(title(w));
    ups_path_vertex start = vertex(w.p, w.n, number);
    start.throughput = luminance(w.carried);
    start.pdf = w.pdf_direction_w;
    start.survival = 1;
    start.event = UPS_EVENT_START;
    out_.vertices.push_back(start);
    for (size_t i = 0; i < w.vertices.size(); ++i) {
      const ReplayedVertex& v = w.vertices[i];
      ups_path_vertex out = vertex(v.p, v.ng, number);
      out.instance.v = scene_.instance_ids[v.instance];
      out.event = event_of(v);
      out.throughput = v.scattered ? luminance(v.carried) : 0;
      out.pdf = v.pdf, out.pdf_reverse = v.pdf_reverse;
      out.survival = v.scattered ? v.survival : 0;
      out_.vertices.push_back(out);
      std::string text = format("  %2zu  instance %u at ", i + 1, out.instance.v) + place(v.p) +
                         format(", %.5g m on, cosine %.4f", double(v.distance), double(v.cos_in));
      if (v.pass < 1) text += format(", through panes with probability %.4f", v.pass);
      if (!v.scattered) {
        line(text + ": ends there");
        continue;
      }
      text += std::string(": ") + names[out.event] +
              format(v.delta ? ", probability %.4g, backwards %.4g" : ", density %.4g / sr, backwards %.4g", double(v.pdf),
                     double(v.pdf_reverse)) +
              format(", weight %.4g", double(luminance(v.weight)));
      if (v.survival < 1) text += format(", roulette %.3g", double(v.survival));
      line(text + format(w.light ? "; carries %.5g lm" : "; throughput %.5g", double(luminance(v.carried))));
    }
    if (w.vertices.empty() || w.vertices.back().scattered) line("      nothing more is met");
  }

  ups_path_vertex vertex(const Vec3& p, const Vec3& n, uint32_t walk) const {
    ups_path_vertex out{};
    const Vec3d at = world(p);
    for (int i = 0; i < 3; ++i) out.position_m[i] = at[i], out.normal[i] = n[i];
    out.walk = walk;
    return out;
  }
  static ups_path_event event_of(const ReplayedVertex& v) {
    return !v.scattered ? UPS_EVENT_END
           : !v.delta   ? UPS_EVENT_SCATTERED
                        : v.transmitted ? UPS_EVENT_REFRACTED : UPS_EVENT_MIRRORED;
  }

  void contributions() {
    if (r_.contributions.empty()) return line("\nIt found no light.");
    const size_t told = r_.told;
    const size_t all = r_.contributions.size();
    line(told < all ? format("\nThe %zu largest of %zu contributions; the others bring %.2g %% together:", told, all,
                             100 * r_.untold_share)
                    : format("\nContributions: %zu", all));
    for (size_t i = 0; i < r_.contributions.size(); ++i) {
      out_.contributions.push_back(contribution(r_.contributions[i]));
      if (i < told) tell(r_.contributions[i], out_.contributions.back());
    }
  }

  ups_path_contribution contribution(const ReplayedContribution& c) const {
    ups_path_contribution out{};
    const Vec3d from = c.has_edge ? world(c.from) : Vec3d(), to = c.has_edge ? world(c.to) : Vec3d();
    for (int i = 0; i < 3; ++i) out.from_m[i] = from[i], out.to_m[i] = to[i];
    out.value = float(c.value() * r_.scale);
    out.weight = float(c.brought.weight);
    out.technique = c.kind;
    out.edges = c.technique.edges;
    out.light_vertices = c.technique.s;
    out.light_path = c.light_path;
    if (const auto walk = walk_of_.find(c.light_path); walk != walk_of_.end()) out.walk = walk->second;
    const Source& source = scene_.sources[scene_.source_of_emitter[c.emitter]];
    out.source_kind = source.kind;
    out.source = source.id;
    return out;
  }

  void tell(const ReplayedContribution& c, const ups_path_contribution& as_told) {
    std::string text = format("  %10.5g %s  ", double(as_told.value), unit());
    switch (c.kind) {
      case UPS_TECHNIQUE_EMITTER_HIT: text += "runs into an emitter"; break;
      case UPS_TECHNIQUE_LIGHT_SAMPLE: text += "next-event estimation, from " + place(c.from) + " to " + place(c.to);
        break;
      case UPS_TECHNIQUE_MIRROR_SAMPLE:
        text += "next-event estimation by way of a mirror, from " + place(c.from) + " to " + place(c.to) + " in it";
        break;
      case UPS_TECHNIQUE_CONNECT:
        text += format("connected to vertex %u of light path %u, from ", c.light_vertex, c.light_path) +
                place(c.from) + " to " + place(c.to);
        break;
      case UPS_TECHNIQUE_SENSOR_CONNECT: text += "joined to the camera from " + place(c.from); break;
      case UPS_TECHNIQUE_SENSOR_HIT: text += "lands on the meter's cell at " + place(c.to); break;
      default:
        text += c.light_path != none
                    ? format("merged with the photon at vertex %u of light path %u", c.light_vertex, c.light_path)
                    : "merged at the meter's disc, at " + place(c.to);
    }
    line(text + format("; %u edges, light of %s", c.technique.edges, scene_.emitter_names[c.emitter].c_str()));
    const mis::Classes& d = c.relative;
    line(format("              weight %.4g of %.5g %s; densities of all techniques over its own: hits and light samples "
                "%.3g, connections %.3g, light to sensors %.3g, merges of caustics %.3g, other merges %.3g",
                c.brought.weight, double(luminance(c.brought.unweighted)) * r_.scale, unit(), d.eye, d.connect, d.light,
                d.caustic, d.merge));
  }

  static constexpr const char* names[] = {"starts", "ends", "scatters", "mirrored", "refracted"};
  const Snapshot& scene_;
  const Plan& plan_;
  const ups_sample& sample_;
  const Replayed& r_;
  std::unordered_map<uint32_t, uint32_t> walk_of_;  // of a light path, by its number
  PathReplay out_;
};

}  // namespace

PathReplay replay(Integrator& integrator, const ups_sample& sample, const StopSignal& stop) {
  Replayed r = integrator.replay(address_of(integrator, sample), stop);
  if (sample.walk == UPS_WALK_LIGHT && !r.contributions.empty()) r.value = r.contributions[0].value() * r.scale;
  if (r.value < 0)
    fail_argument("sample: iteration " + std::to_string(sample.iteration) + " of this render traces no such path (" +
                  (sample.walk == UPS_WALK_LIGHT ? "light path " : "eye path ") + std::to_string(sample.path) +
                  ", index " + std::to_string(sample.index) +
                  "); are scene and desc those of the render that the sample is of?");
  return Teller(integrator, sample, r).tell();
}

}  // namespace ups
