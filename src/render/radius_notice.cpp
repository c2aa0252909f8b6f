// See radius_notice.h.
#include "render/radius_notice.h"

#include "scene/check.h"

namespace ups {

std::string radius_notice(const Integrator& integrator, uint32_t iterations) {
  const Plan& plan = integrator.plan();
  const Snapshot& scene = integrator.scene();
  const double alpha = integrator.settings().radius_alpha;
  const uint32_t last = iterations - 1;
  std::string text;
  const auto tell = [&](const std::string& where, const std::string& whose, const Plan::AtFloor& at,
                        uint32_t iterations_a_visit) {
    if (at.count > 0)
      text += where + ": from iteration " + std::to_string(at.since * iterations_a_visit + 1) +
              " on, the merge radius " + whose + "is kept at " + check::text(double(plan.min_radius)) +
              " m, the least that the coordinates of this scene resolve; its bias shrinks no further\n";
  };
  for (size_t c = 0; c < plan.pixel_radius.size(); ++c) {
    const Plan::AtFloor at = plan.at_floor(plan.pixel_radius[c], plan.pass(last), alpha);
    tell("camera " + std::to_string(scene.camera_ids[c]),
         "of " + std::to_string(at.count) + " of " + std::to_string(plan.pixel_radius[c].size()) + " pixels ", at,
         plan.camera_subsets);
  }
  if (integrator.settings().has(UPS_TECHNIQUE_MERGE) &&
      integrator.settings().method.eye_end == Method::EyeEnd::of_path)
    tell("after the first surface", "", plan.at_floor({plan.walk_radius}, last, alpha), 1);
  return text;
}

}  // namespace ups
