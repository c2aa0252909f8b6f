// See glare_warnings.h.
#include "render/glare_warnings.h"

#include <algorithm>

#include "scene/check.h"

namespace ups {

std::string glare_warnings(const Snapshot& scene, uint32_t observer_id, const SeenGlare& glare) {
  const std::string who = "observer " + std::to_string(observer_id) + ": ";
  std::string text;
  const auto worst = [&](const auto& is_one, const char* what) {
    size_t count = 0;
    const SeenSource* first = nullptr;  // they are in the order of their terms
    for (const SeenSource& s : glare.sources)
      if (is_one(s)) first = count++ == 0 ? &s : first;
    if (count == 0) return;
    text += who + scene.emitter_names[first->emitter] +
            (count > 1 ? " and " + std::to_string(count - 1) + " more" : "") + what + "\n";
  };
  worst([](const SeenSource& s) { return s.largest_sr > photometry::large_source_sr; },
        ": seen under more than 0.1 sr, for which UGR is not made and too low; rated like the others (the rating by "
        "CIE 147, ggr, is for those above 1.5 m2)");
  worst([](const SeenSource& s) { return s.glare.luminance_cd_m2 < 0; },
        ": light comes from a point, so there is no luminance: rated as a small source, by its intensity (CIE 147)");
  if (glare.has_fixture)
    text += who + "fixtures are in view: of them only light straight from their emitters counts as glare, what their "
                  "reflectors, lenses and covers send as background, so that the rating is too low; a profile measured "
                  "by the goniometer, placed instead, is rated as a whole\n";
  if (glare.has_covered)
    text += who + "a source is in view behind glass or a diffuser that is no thin pane: what these send counts as "
                  "background, so that the rating is too low; a profile of the whole luminaire, or the cover itself as "
                  "what emits, is rated\n";
  if (glare.has_unrated)
    text += who + "parallel light, luminaires that emit the rays of a file and light beyond what numbers hold have no "
                  "part in its rating\n";
  return text;
}

}  // namespace ups
