// See builder.h: what cameras, meters and emitters lie in, where there is glass that attenuates, or bends light by what
// lies around it.
#include <algorithm>
#include <optional>

#include "base/parallel.h"
#include "scene/builder.h"
#include "scene/emission_samples.h"
#include "scene/traced_box.h"

namespace ups {
namespace {

// Where may a point be in glass at all?
class GlassBoxes {
 public:
  explicit GlassBoxes(const Snapshot& scene) {
    const double margin = 0x1p-17 * double(scene.radius);  // no surface point's error is larger
    const Vec3d pad{margin, margin, margin};
    for (size_t i = 0; i < scene.instances.size(); ++i) {
      const uint32_t m = scene.media.of_instance[i];
      if (m == none) continue;
      open_ |= scene.media.by_rank[m].is_open();
      Box box = traced_box(scene, scene.instances[i]);
      box.lower = box.lower - pad, box.upper = box.upper + pad;
      boxes_.push_back(box);
    }
  }
  bool may_hold(const Vec3& p) const {
    const Box at{Vec3d(p), Vec3d(p)};
    return open_ || std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& b) { return b.holds(at); });
  }

 private:
  std::vector<Box> boxes_;
  bool open_ = false;
};

MediaStack media_of(const Snapshot& scene, const Meter& m) {
  return media_at(scene, m.p + m.frame.n * (2 * m.error));
}

// Nothing: they differ from place to place, as of a wall that a water's surface crosses.
std::optional<MediaStack> media_of(const Snapshot& scene, const GlassBoxes& glass, const MeterSet& set, size_t i) {
  if (!set.is_cell()) return media_of(scene, set.meters[i]);
  const Meter middle = set.sample(i, {0.5f, 0.5f});
  const MediaStack found = media_of(scene, middle);
  const bool may = glass.may_hold(middle.p);
  constexpr float low = 0.01f, high = 0.99f;
  for (const Vec2& u : {Vec2{low, low}, Vec2{low, high}, Vec2{high, low}, Vec2{high, high}}) {
    const Meter corner = set.sample(i, u);
    if ((may || glass.may_hold(corner.p)) && !(media_of(scene, corner) == found)) return {};
  }
  return found;
}

// Does light of an emitter, of which a place lies in `than`, start elsewhere, too?
bool starts_in_others(const Snapshot& scene, const Emitter& emitter, const MediaStack& than) {
  bool others = false;
  if (!emitter.is_delta())
    each_emission(emitter, 16, 8, [&](const EmissionSample& s) {
      others = !(media_at(scene, s.p + s.n * (2 * s.error)) == than);
      return !others;
    });
  return others;
}

}  // namespace

void Builder::find_media() {
  bool wanted = out_->media.nest;
  for (const Medium& m : out_->media.by_rank) wanted |= !is_black(out_->materials[m.material].absorption_per_m);
  std::vector<MediaStack>& stacks = out_->media_stacks;
  stacks.assign(1, MediaStack());
  const auto number = [&](const MediaStack& stack) {
    const auto at = std::find(stacks.begin(), stacks.end(), stack);
    if (at != stacks.end()) return uint32_t(at - stacks.begin());
    stacks.push_back(stack);
    return uint32_t(stacks.size() - 1);
  };
  const auto find = [&](const Vec3& p) { return wanted ? number(media_at(*out_, p)) : 0; };
  const bool is_same = same_places_ && sensors_are_same();
  if (wanted && is_same) {  // the emitters' own follow those of sensors
    stacks.assign(earlier_->media_stacks.begin(), earlier_->media_stacks.begin() + earlier_->sensor_media_count);
    out_->media_of_camera = earlier_->media_of_camera;
    out_->media_of_meter = earlier_->media_of_meter;
  }
  for (size_t c = out_->media_of_camera.size(); c < out_->cameras.size(); ++c)
    out_->media_of_camera.push_back(find(out_->cameras[c].position()));
  const GlassBoxes glass(*out_);
  for (size_t s = out_->media_of_meter.size(); s < out_->meter_sets.size(); ++s) {
    const MeterSet& set = out_->meter_sets[s];
    std::vector<uint32_t>& media = out_->media_of_meter.emplace_back(set.meters.size(), 0);
    if (!wanted) continue;
    std::vector<std::optional<MediaStack>> found(set.meters.size());
    parallel_for(threads_, found.size(), [&](size_t i) { found[i] = media_of(*out_, glass, set, i); });
    for (size_t i = 0; i < found.size(); ++i) media[i] = found[i] ? number(*found[i]) : none;
  }
  out_->sensor_media_count = stacks.size();
  for (size_t e = 0; e < emitter_fronts_.size(); ++e) {
    const uint32_t media = find(emitter_fronts_[e]);
    out_->media_of_emitter.push_back(wanted && starts_in_others(*out_, out_->emitters[e], stacks[media]) ? none : media);
  }
}

}  // namespace ups
