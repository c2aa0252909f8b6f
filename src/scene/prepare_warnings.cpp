// See builder.h: what a commit tells that is no error, but hardly meant.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "base/text.h"
#include "scene/builder.h"
#include "scene/check.h"
#include "scene/doubts.h"
#include "scene/duplicates.h"
#include "scene/swallowed.h"

namespace ups {

namespace {

// Two digits are enough for people.
std::string short_text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.1e", value);
  return check::text(std::strtod(buffer, nullptr));
}
// 0.1 mm, 4 km.
std::string length_text(double m) {
  return m < 0.0995 ? short_text(m * 1000) + " mm" : m < 1000 ? short_text(m) + " m" : short_text(m / 1000) + " km";
}

}  // namespace

void Builder::add_warnings() {
  warn_of_overlaps();
  warn_of_triangles();
  if (out_->emitters.size() == 0) warn("nothing in the scene emits light");
  if (out_->cameras.empty() && out_->meter_sets.empty() && out_->goniometers.empty())
    warn("the scene has no camera, no meters and no goniometer: there is nothing to measure");
  for (size_t i = 0; !out_->goniometers.empty() && i < out_->emitters.size(); ++i)
    if (out_->emitters[i].is_directional())
      warn_of(out_->sources[out_->source_of_emitter[i]],
              "parallel light: where it leaves the scene, a goniometer's intensity depends on its grid, as it would be "
              "infinite");
  warn_of_swallowed_light();
  warn_of_unit();
  warn_of_maintenance();
  for (const auto& [what, ids] : shared_warnings_) warn(listed(what.first, ids) + ": " + what.second);
}

void Builder::warn_of_overlaps() {
  constexpr size_t most_named = 8;
  const std::vector<PartialOverlap> overlaps = find_partial_overlaps(*out_, instances_, threads_);
  for (size_t i = 0; i < std::min(overlaps.size(), most_named); ++i)
    warn("instances " + std::to_string(out_->instance_ids[overlaps[i].instance_a]) + " and " +
         std::to_string(out_->instance_ids[overlaps[i].instance_b]) +
         " are glass of different index and overlap in part: where they do the smaller one counts; give the material "
         "of the one that should a higher priority");
  if (overlaps.size() > most_named)
    warn(std::to_string(overlaps.size() - most_named) + " more pairs of glass instances overlap in part");
}

void Builder::warn_of_triangles() {
  const Duplicates duplicates = find_duplicates(out_->meshes, instances_, out_->media);
  if (duplicates.count > 0) {
    const auto name = [&](const Duplicates::Triangle& t) {
      return "triangle " + std::to_string(t.primitive) + " of instance " + std::to_string(out_->instance_ids[t.instance]);
    };
    warn(std::to_string(duplicates.count) + (duplicates.count == 1 ? " triangle lies" : " triangles lie") +
         " exactly on another, such as " + name(duplicates.second) + " on " + name(duplicates.first) +
         ": rounding decides which of them a ray hits");
  }
  const FlatTriangles flat = find_flat_triangles(*out_, instances_, threads_);
  if (flat.count == 0) return;
  const bool one_mesh = flat.meshes == 1;
  warn((flat.count == 1 ? "1 triangle" : std::to_string(flat.count) + " triangles") + " of " +
       (one_mesh ? "mesh " + std::to_string(flat.mesh + 1) : std::to_string(flat.meshes) + " meshes") +
       (flat.count == 1 ? " has" : " have") + " no area" +
       (flat.count == 1 ? ", triangle " : ", the first triangle ") + std::to_string(flat.triangle) +
       (one_mesh ? "" : " of mesh " + std::to_string(flat.mesh + 1)) + ": nothing is seen of " +
       (flat.count == 1 ? "it" : "them"));
}

// Of each kind one of its emitters is the example; of luminaires and of emissive instances.
void Builder::warn_of_swallowed_light() {
  const std::vector<SwallowedLight> found = find_swallowed_light(*out_, threads_);
  struct Group {
    std::vector<uint32_t> ids;
    size_t first = 0;
  };
  std::map<std::pair<SwallowedLight::Kind, ups_source_kind>, Group> groups;
  for (size_t i = 0; i < found.size(); ++i) {
    if (found[i].kind == SwallowedLight::no) continue;
    const Source& source = out_->sources[out_->source_of_emitter[i]];
    Group& group = groups[{found[i].kind, source.kind}];
    if (group.ids.empty()) group.first = i;
    group.ids.push_back(source.id);
  }
  for (const auto& [what, group] : groups) {
    const SwallowedLight& light = found[group.first];
    const std::string surface = (light.from_behind ? "the back of instance " : "instance ") +
                                std::to_string(out_->instance_ids[light.instance]);
    const std::string whose =
        group.ids.size() > 1 ? " (that of " + out_->emitter_names[group.first] + ")" : std::string();
    const std::string text =
        what.first == SwallowedLight::in_gap
            ? "the light is swallowed at once: it meets " + surface + " within " + length_text(double(light.gap_m)) +
                  " of its source" + whose
            : "the light is swallowed at once: it meets " + surface + " and stays in a closed space of " +
                  length_text(double(light.extent_m.x)) + " x " + length_text(double(light.extent_m.y)) + " x " +
                  length_text(double(light.extent_m.z)) + " around its source" + whose;
    warn(listed(what.second == UPS_SOURCE_INSTANCE ? "instance" : "luminaire", group.ids) + ": " + text);
  }
}

// Metres are expected; a room in millimetres is kilometres wide, and what luminaires emit is lost in it.
void Builder::warn_of_maintenance() {
  if (in_.maintenance_factor() == 1 || unmaintained_ == 0) return;
  warn("the maintenance factor " + check::text(in_.maintenance_factor()) + " is of luminaires and fixtures alone: " +
       std::to_string(unmaintained_) + (unmaintained_ == 1 ? " light or emitting surface keeps its"
                                                           : " lights and emitting surfaces keep their") +
       " initial flux");
}

void Builder::warn_of_unit() {
  constexpr double large_m = 500, dark_lx = 0.01;
  const Vec3 size = out_->raytracer->bounds_max() - out_->raytracer->bounds_min();
  const double width = double(std::max({size.x, size.y, size.z}));
  if (!(width >= large_m)) return;
  const double lx = brightest_first_light_lx(*out_);
  if (lx < 0 || lx >= dark_lx) return;
  warn("the scene is " + length_text(width) + " wide, and its luminaires light what they shine at with about " +
       short_text(lx) + " lx: lengths are in metres; were millimetres meant?");
}

}  // namespace ups
