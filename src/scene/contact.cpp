// See contact.h.
#include "scene/contact.h"

#include <algorithm>

#include "scene/emission_samples.h"

namespace ups {

// What touches between them in a spot is a small share of the light.
std::vector<EmittingPoint> emitting_points(const Emitter& emitter, bool both_sides) {
  std::vector<EmittingPoint> points;
  each_emission(emitter, 256, 0, [&](const EmissionSample& s) {
    points.push_back({s.p, s.n, s.error});
    if (both_sides) points.push_back({s.p, -s.n, s.error});
    return true;
  });
  return points;
}

TouchableParts::TouchableParts(std::vector<Part> parts, const Room& room)
    : parts_(std::move(parts)), rounding_(room.rounding), shadow_(room.shadow), reach_(room.most) {
  for (size_t i = 0; i < parts_.size(); ++i) {
    by_x_.emplace_back(parts_[i].box.lower.x, i);
    widest_ = std::max(widest_, parts_[i].box.upper.x - parts_[i].box.lower.x);
  }
  std::sort(by_x_.begin(), by_x_.end());
}

void TouchableParts::near(Box box, std::vector<ContactPart>& out) const {
  const Vec3d reach(reach_, reach_, reach_);
  box.lower = box.lower - reach, box.upper = box.upper + reach;
  auto at = std::lower_bound(by_x_.begin(), by_x_.end(), std::make_pair(box.lower.x - widest_, size_t(0)));
  for (; at != by_x_.end() && at->first <= box.upper.x; ++at) {
    const Box& b = parts_[at->second].box;
    if (box.lower.x <= b.upper.x && b.lower.y <= box.upper.y && box.lower.y <= b.upper.y &&
        b.lower.z <= box.upper.z && box.lower.z <= b.upper.z)
      out.push_back(parts_[at->second].what);
  }
}

std::vector<SearchedSurface> TouchableParts::choose_of(const std::set<std::shared_ptr<const void>>& meshes,
                                                       const std::vector<SurfaceTexturing>& texturing) {
  std::vector<SearchedSurface> out;
  traced_.clear();
  for (const Part& part : parts_) {
    if (meshes.count(part.what.shape) == 0) continue;
    traced_.push_back(part.instance);
    out.push_back({part.what, texturing[part.instance.material]});
  }
  return out;
}

void TouchableParts::trace(const std::vector<std::shared_ptr<const Mesh>>& meshes,
                           const std::vector<SurfaceTexturing>& texturing, ThreadPool& pool, Monitor& monitor) {
  raytracer_ = std::make_unique<const Raytracer>(meshes, traced_, texturing, pool, true, nullptr, &monitor);
}

const TouchableParts::Part* TouchableParts::part_of(uint32_t number) const {
  const auto at = std::lower_bound(parts_.begin(), parts_.end(), number,
                                   [](const Part& p, uint32_t n) { return p.what.number < n; });
  return at != parts_.end() && at->what.number == number ? &*at : nullptr;
}

// Light enters a solid by its front. On which side of a sheet an emitter lies must be seen.
bool TouchableParts::faces(const Part& part, const EmittingPoint& from, const SurfacePoint& surface,
                           double gap) const {
  return part.what.role == ContactPart::sheet ? gap > 0.5 * rounding_ : dot(from.n, surface.ng) < 0;
}

namespace {

// What points of an emitter lack of the room that they need.
struct Lacks {
  std::vector<std::pair<Vec3d, double>> list;  // with where light leaves to
  Vec3d sum;
  double closest = INFINITY;
  uint32_t touched = none, within = none;
  size_t shallow = 0;

  void add(const Vec3d& n, double lack, double gap, uint32_t number) {
    list.emplace_back(n, lack);
    sum += n;
    if (gap < closest) closest = gap, touched = number;
  }
  void set_back(Contact& out) const {
    const Vec3d back = length(sum) > 0 ? sum / -length(sum) : Vec3d();
    double distance = 0;
    for (const auto& [n, lack] : list) {
      const double along = -dot(n, back);
      if (!(along > 0.5)) out.squeezed = true;
      else distance = std::max(distance, lack / along);
    }
    if (!out.squeezed) out.shift = back * distance;
  }
};

}  // namespace

// Light starts off the emitter by twice its error, before the glass; shadow rays end there, too, less some rounding;
// what leaves the glass starts off it by twice that one's error, before the emitter. An emitter in the very surface of a
// solid that it shines into lies on it, not in it.
void TouchableParts::search(const std::vector<EmittingPoint>& points, Contact& out) const {
  constexpr size_t least_share = 100;  // less than a hundredth of the light is left as it is
  const bool raised = out.between[0].role == ContactPart::opening;  // eye paths find it in front of its place
  const float reach = float(reach_);
  Lacks lacks;
  std::vector<Hit> hits;
  for (const EmittingPoint& from : points) {
    hits.clear();
    const Vec3d n(from.n);
    raytracer_->intersect_all(from.p - from.n * reach, from.n, 2 * reach, hits);
    for (const Hit& hit : hits) {
      const SurfacePoint surface = raytracer_->surface_at(hit);
      const Part& part = *part_of(traced_[hit.instance].number);
      const double gap = dot(Vec3d(surface.p) - Vec3d(from.p), n);
      if (!faces(part, from, surface, gap)) continue;
      const double own = 2 * double(from.error), others = 2 * double(surface.error) + (raised ? own : 0),
                   lack = std::max(own + shadow_, others) + rounding_ - gap;
      if (!(gap > -2 * rounding_)) {
        if (gap > -shallow_m) ++lacks.shallow, lacks.within = part.what.number;
      } else if (lack > 0) {
        lacks.add(n, lack, gap, part.what.number);
      }
    }
  }
  if (!lacks.list.empty() && lacks.list.size() * least_share >= points.size())
    out.touched = lacks.touched, lacks.set_back(out);
  else if (2 * lacks.shallow > points.size())
    out.touched = lacks.within, out.shallow = true;
}

bool TouchableParts::is_blocked(const std::vector<EmittingPoint>& points, const Contact& contact, const Raytracer& all,
                                const std::vector<Raytracer::Instance>& instances) const {
  std::vector<Hit> hits;
  const ContactPart& own = contact.between[0];
  const bool surface = own.role == ContactPart::emits || own.role == ContactPart::emits_both_sides;
  for (const EmittingPoint& from : points) {
    const double height = -dot(contact.shift, Vec3d(from.n));
    if (!(height > 0)) continue;
    hits.clear();
    const Vec3 start(Vec3d(from.p) + contact.shift + Vec3d(from.n) * (0.5 * height));
    all.intersect_all(start, from.n, float(0.5 * height + 2 * rounding_), hits);
    for (const Hit& hit : hits) {
      const uint32_t number = instances[hit.instance].number;
      if (!part_of(number) && !(surface && number == own.number)) return true;
    }
  }
  return false;
}

}  // namespace ups
