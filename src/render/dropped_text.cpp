// See dropped_text.h.
#include "render/dropped_text.h"

#include <algorithm>

#include "scene/check.h"

namespace ups {

namespace {

std::string path_text(const Integrator& integrator, const PathAddress& at) {
  const Snapshot& scene = integrator.scene();
  const std::string iteration = " of iteration " + std::to_string(at.iteration);
  switch (at.stream.kind()) {
    case Stream::flux:
      return "light path " + std::to_string(at.path) + " of part " + std::to_string(at.iteration) +
             " of those that book flux";
    case Stream::camera:
    case Stream::illuminance: {
      const uint32_t c = at.stream.index(), width = scene.cameras[c].width();
      return "camera " + std::to_string(scene.camera_ids[c]) + ", " +
             (at.stream.kind() == Stream::illuminance ? "illuminance at pixel (" : "pixel (") +
             std::to_string(at.path % width) + ", " + std::to_string(at.path / width) + ")" + iteration;
    }
    case Stream::meters: {
      const uint32_t s = at.stream.index();
      return "meters " + std::to_string(scene.meter_set_ids[s]) + ", meter " +
             std::to_string(scene.meter_sets[s].number(at.path / integrator.plan().meter_samples)) + iteration;
    }
    default: return "light path " + std::to_string(at.path) + iteration;
  }
}

std::string place_text(const Snapshot& scene, const Vec3& p) {
  if (!is_finite(p)) return "at no finite point";
  return "near (" + check::text(p.x + scene.origin.x) + ", " + check::text(p.y + scene.origin.y) + ", " +
         check::text(p.z + scene.origin.z) + ") m";
}

}  // namespace

std::string dropped_text(const Integrator& integrator, const WorkCounts& work) {
  std::string text;
  for (size_t d = 0; d < work.dropped.size(); ++d) {
    if (work.dropped[d] == 0) continue;
    const DroppedSample& first = *std::find_if(work.first_dropped.begin(), work.first_dropped.end(),
                                               [&](const DroppedSample& s) { return size_t(s.where) == d; });
    text += std::string(drop_names[d]) + ": " + std::to_string(work.dropped[d]) +
            " samples were not finite, the first in " + path_text(integrator, first.path) + ", " +
            place_text(integrator.scene(), first.p) + "\n";
  }
  return text;
}

}  // namespace ups
