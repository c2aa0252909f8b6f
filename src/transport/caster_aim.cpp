// See caster_aim.h.
#include "transport/caster_aim.h"

#include <algorithm>

#include "base/rng.h"
#include "scene/panes.h"

namespace ups {

namespace {

constexpr size_t most_points = size_t(1) << 17, of_emitter = 1024, of_caster = 128, fewest = 8;
constexpr double enough = 16;  // light paths that meet a surface

// Of so many casters, those that an emitter takes.
size_t looked_at(size_t casters, size_t points) { return std::min(casters, points / fewest); }

// Surfaces with a delta lobe or a sharp one; what a pane that shines lets through is one.
std::vector<uint32_t> casters_of(const Snapshot& scene) {
  std::vector<uint32_t> out;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const MaterialTraits t = traits_of(scene.materials[scene.instances[i].material]);
    const bool casts = t.delta || t.glossy || is_shining_pane(scene, i);
    if (casts && scene.meshes[scene.instances[i].mesh]->triangle_count() > 0) out.push_back(i);
  }
  return out;
}

}  // namespace

// Of one emitter.
class CasterAims::Search {
 public:
  Search(const Snapshot& scene, const std::vector<uint32_t>& casters, bool shown, size_t points, uint32_t emitter)
      : scene_(scene), casters_(casters), shown_(shown), emitter_(emitter), count_(looked_at(casters.size(), points)),
        points_(std::min(of_caster, points / count_)) {}

  // Where there are too many casters, an emitter takes some, another one others.
  std::vector<Caster> find() {
    std::vector<Caster> out;
    for (size_t k = 0; k < count_; ++k) {
      const double u = to_unit_float(random(uint32_t(k), none)[0]),
                   at = (double(k) + u) / double(count_) * double(casters_.size());
      const auto number = uint32_t(std::min(size_t(at), casters_.size() - 1));
      if (shown_ && shows(casters_[number])) continue;
      if (Caster c = look_at(number); c.share > 0 || !c.cells.empty()) out.push_back(std::move(c));
    }
    return out;
  }

 private:
  // A flat mirror with the emitter's image.
  bool shows(uint32_t instance) const {
    const FlatMirrors& mirrors = scene_.flat_mirrors;
    if (mirrors.empty() || mirrors.planes_of_instance[instance].size() != 1) return false;
    const uint32_t plane = mirrors.planes_of_instance[instance][0];
    return plane != none && mirrors.image_of(emitter_, plane) != none;
  }

  using Numbers = decltype(philox({}, {}));
  Numbers random(uint32_t a, uint32_t b) const { return philox({a, b, emitter_, 0}, {0x61696d, 0}); }

  // A triangle however small counts like the others, and a point of it like any other.
  Vec3 point_of(const Raytracer::Instance& instance, const Numbers& r) const {
    const Mesh& mesh = *scene_.meshes[instance.mesh];
    const size_t triangle = std::min(size_t(double(to_unit_float(r[0])) * double(mesh.triangle_count())),
                                     mesh.triangle_count() - 1);
    float a = to_unit_float(r[1]), b = to_unit_float(r[2]);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    const uint32_t* i = &mesh.indices[3 * triangle];
    const Vec3 &p = mesh.positions[i[0]], &q = mesh.positions[i[1]], &s = mesh.positions[i[2]];
    return Vec3(instance.to_scene.point(Vec3d(p + (q - p) * a + (s - p) * b)));
  }

  // The guided square's point of light that leaves the emitter for `point`.
  bool square_towards(const Vec3& point, const Numbers& u, Vec2& square) const {
    const Emitter& emitter = scene_.emitters[emitter_];
    EmissionSample from;
    if (!emitter.sample_emission({to_unit_float(u[0]), to_unit_float(u[1])},
                                 {to_unit_float(u[2]), to_unit_float(u[3])}, from))
      return false;
    if (emitter.is_directional()) return emitter.emission_square(point, 0, from.direction, square);
    const Vec3 to = point - from.p;
    const uint32_t primitive = from.primitive == EmissionSample::invalid ? 0 : from.primitive;
    return length2(to) > 0 && emitter.emission_square(from.p, primitive, normalize(to), square);
  }

  Caster look_at(uint32_t number) const {
    const uint32_t instance = casters_[number];
    Caster out{number, 0, {}};
    Vec2 low{1, 1}, high{0, 0};
    for (uint32_t k = 0; k < points_; ++k) {
      const Vec3 point = point_of(scene_.instances[instance], random(instance, 2 * k));
      Vec2 u;
      if (!square_towards(point, random(instance, 2 * k + 1), u)) continue;
      out.cells.push_back(GuideTraining::finest_cell(u));
      low = {std::min(low.x, u.x), std::min(low.y, u.y)}, high = {std::max(high.x, u.x), std::max(high.y, u.y)};
    }
    const size_t seen = out.cells.size();
    std::sort(out.cells.begin(), out.cells.end());
    out.cells.erase(std::unique(out.cells.begin(), out.cells.end()), out.cells.end());
    constexpr float cell = 1.0f / (1 << 2 * GuideTraining::finest);
    if (seen == 0) return out;
    // Or much of it is where the emitter does not shine, and too large is what it shines on.
    if (2 * seen < points_ || 2 * out.cells.size() > seen) return {number, 1, {}};
    out.share = std::min(float(out.cells.size()) * cell, (high.x - low.x) * (high.y - low.y));
    return out;
  }

  const Snapshot& scene_;
  const std::vector<uint32_t>& casters_;
  const bool shown_;
  const uint32_t emitter_;
  const size_t count_, points_;
};

CasterAims::CasterAims(const Snapshot& scene, bool shown, ThreadPool& pool) {
  const std::vector<uint32_t> casters = casters_of(scene);
  if (casters.empty() || scene.emitters.size() == 0) return;
  of_emitter_.resize(scene.emitters.size());
  const size_t points = std::clamp(most_points / scene.emitters.size(), fewest, of_emitter);
  parallel_for(pool, of_emitter_.size(), [&](size_t i) {
    if (scene.emitters[i].kind() != EmitterKind::rays && scene.emitters[i].flux_lm() > 0)
      of_emitter_[i] = Search(scene, casters, shown, points, uint32_t(i)).find();
  });
  share_.resize(casters.size());
  const double sampled = double(looked_at(casters.size(), points)) / double(casters.size());
  for (size_t i = 0; i < of_emitter_.size(); ++i)
    for (const Caster& c : of_emitter_[i])
      share_[c.number] += double(scene.emitters.emission_probability(i)) * c.share / sampled;
}

GuideTraining CasterAims::missed_by(double paths, double densest) const {
  std::vector<std::vector<GuideTraining::Aim>> aims(of_emitter_.size());
  bool any = false;
  for (size_t i = 0; i < aims.size(); ++i)
    for (const Caster& c : of_emitter_[i]) {
      if (c.cells.empty() || paths * share_[c.number] > enough) continue;
      for (const uint32_t cell : c.cells) aims[i].push_back({cell, 1 / float(c.cells.size())});
      any = true;
    }
  GuideTraining out;
  if (any) out.aim(std::move(aims), densest);
  return out;
}

}  // namespace ups
