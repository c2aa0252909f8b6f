// See searched.h.
#include "scene/searched.h"

#include <map>

#include "base/text.h"
#include "scene/close_surfaces.h"
#include "scene/doubts.h"
#include "scene/duplicates.h"
#include "scene/length_text.h"
#include "scene/swallowed.h"

namespace ups {
namespace {

using Warnings = std::vector<std::string>;

void find_overlaps(const Snapshot& scene, ThreadPool& threads, Warnings& warn) {
  constexpr size_t most_named = 8;
  const std::vector<PartialOverlap> overlaps = find_partial_overlaps(scene, scene.instances, threads);
  for (size_t i = 0; i < std::min(overlaps.size(), most_named); ++i)
    warn.push_back("instances " + std::to_string(scene.instance_ids[overlaps[i].instance_a]) + " and " +
         std::to_string(scene.instance_ids[overlaps[i].instance_b]) +
         " are glass of different index and overlap in part: where they do the smaller one counts; give the material "
         "of the one that should a higher priority");
  if (overlaps.size() > most_named)
    warn.push_back(std::to_string(overlaps.size() - most_named) + " more pairs of glass instances overlap in part");
}

void find_odd_triangles(const Snapshot& scene, ThreadPool& threads, Warnings& warn) {
  const Duplicates duplicates = find_duplicates(scene.meshes, scene.instances, scene.media);
  if (duplicates.count > 0) {
    const auto name = [&](const Duplicates::Triangle& t) {
      return "triangle " + std::to_string(t.primitive) + " of instance " + std::to_string(scene.instance_ids[t.instance]);
    };
    warn.push_back(std::to_string(duplicates.count) + (duplicates.count == 1 ? " triangle lies" : " triangles lie") +
         " exactly on another, such as " + name(duplicates.second) + " on " + name(duplicates.first) +
         ": rounding decides which of them a ray hits");
  }
  const FlatTriangles flat = find_flat_triangles(scene, threads);
  if (flat.count == 0) return;
  const bool one_mesh = flat.meshes == 1;
  warn.push_back((flat.count == 1 ? "1 triangle" : std::to_string(flat.count) + " triangles") + " of " +
       (one_mesh ? "mesh " + std::to_string(scene.mesh_numbers[flat.mesh]) : std::to_string(flat.meshes) + " meshes") +
       (flat.count == 1 ? " has" : " have") + " no area" +
       (flat.count == 1 ? ", triangle " : ", the first triangle ") + std::to_string(flat.triangle) +
       (one_mesh ? "" : " of mesh " + std::to_string(scene.mesh_numbers[flat.mesh])) + ": nothing is seen of " +
       (flat.count == 1 ? "it" : "them"));
}

// Of each kind one of its emitters is the example; of luminaires and of emissive instances.
void find_swallowed(const Snapshot& scene, ThreadPool& threads, Warnings& warn) {
  const std::vector<SwallowedLight> found = find_swallowed_light(scene, threads);
  struct Group {
    std::vector<uint32_t> ids;
    size_t first = 0;
  };
  std::map<std::pair<SwallowedLight::Kind, ups_source_kind>, Group> groups;
  for (size_t i = 0; i < found.size(); ++i) {
    if (found[i].kind == SwallowedLight::no) continue;
    const Source& source = scene.sources[scene.source_of_emitter[i]];
    Group& group = groups[{found[i].kind, source.kind}];
    if (group.ids.empty()) group.first = i;
    group.ids.push_back(source.id);
  }
  for (const auto& [what, group] : groups) {
    const SwallowedLight& light = found[group.first];
    const std::string surface = (light.from_behind ? "the back of instance " : "instance ") +
                                std::to_string(scene.instance_ids[light.instance]);
    const std::string whose =
        group.ids.size() > 1 ? " (that of " + scene.emitter_names[group.first] + ")" : std::string();
    const std::string text =
        what.first == SwallowedLight::in_gap
            ? "the light is swallowed at once: it meets " + surface + " within " + length_text(double(light.gap_m)) +
                  " of its source" + whose
            : "the light is swallowed at once: it meets " + surface + " and stays in a closed space of " +
                  length_text(double(light.extent_m.x)) + " x " + length_text(double(light.extent_m.y)) + " x " +
                  length_text(double(light.extent_m.z)) + " around its source" + whose;
    warn.push_back(listed(what.second == UPS_SOURCE_INSTANCE ? "instance" : "luminaire", group.ids) + ": " + text);
  }
}

void find_glass_without_room(const Snapshot& scene, ThreadPool& threads, Warnings& warn) {
  std::vector<uint32_t> ids;
  for (const uint32_t i : find_thin_glass(scene, threads)) ids.push_back(scene.instance_ids[i]);
  if (!ids.empty())
    warn.push_back(listed("instance", ids) +
                   ": a solid of glass that is thinner than single precision resolves so far from the middle of the "
                   "scene: light that enters it does not meet its other side; make it a pane (glazing), or the scene "
                   "smaller");
}

void find_overlaid_surfaces(const Snapshot& scene, ThreadPool& threads, const Monitor* monitor, Warnings& warn) {
  const std::vector<Overlaid> found = find_overlaid(scene, threads, monitor);
  if (found.empty()) return;
  std::vector<uint32_t> ids;
  float resolved_m = 0;
  for (const Overlaid& o : found)
    ids.push_back(scene.instance_ids[o.instance]), resolved_m = std::max(resolved_m, o.resolved_m);
  warn.push_back(listed("instance", ids) + ": in the very plane of another surface of another material (" +
                 std::to_string(ids[0]) + " in that of instance " +
                 std::to_string(scene.instance_ids[found[0].beneath]) +
                 "): rounding decides which of them a ray hits; move one off the other by " +
                 length_text(double(resolved_m)) + " or more, or cut an opening");
}

void find_covered_sheets(const Snapshot& scene, ThreadPool& pool, const Monitor* monitor, Warnings& warn) {
  constexpr float told = 0.25f;
  for (const SheetOnSurface& sheet : find_sheets_on_surfaces(scene, pool, monitor))
    if (sheet.covered > told)
      warn.push_back("instance " + std::to_string(scene.instance_ids[sheet.instance]) +
                     ": it lets light through, and lies on instance " +
                     std::to_string(scene.instance_ids[sheet.opaque]) +
                     ", which no light goes through: what should meet that starts behind it and is lost; move it off by " +
                     length_text(double(sheet.resolved_m)) + " or more, or cut an opening there");
}

template <class Find>
void search(SearchedWarnings& searched, Warnings& out, const Find& find) {
  const std::lock_guard alone(searched.searching);
  Warnings found;
  if (!searched.known) find(found);  // which this thread alone may change
  const std::lock_guard lock(searched.mutex);
  if (!searched.known) searched.texts = std::move(found), searched.known = true;
  out.insert(out.end(), searched.texts.begin(), searched.texts.end());
}

}  // namespace

std::vector<std::string> searched_warnings(const Snapshot& scene, ThreadPool& pool, const Monitor* monitor) {
  Warnings out;
  const auto run = [&](auto find, Warnings& found) {
    if (monitor) monitor->check();
    find(scene, pool, found);
  };
  search(*scene.surface_search, out, [&](Warnings& found) {
    for (const auto find : {find_overlaps, find_odd_triangles, find_glass_without_room}) run(find, found);
    find_overlaid_surfaces(scene, pool, monitor, found);
    find_covered_sheets(scene, pool, monitor, found);
  });
  search(*scene.light_search, out, [&](Warnings& found) { run(find_swallowed, found); });
  return out;
}

std::vector<std::string> known_warnings(const Snapshot& scene) {
  Warnings out;
  for (SearchedWarnings* searched : {scene.surface_search.get(), scene.light_search.get()}) {
    if (!searched) continue;
    const std::lock_guard lock(searched->mutex);
    out.insert(out.end(), searched->texts.begin(), searched->texts.end());
  }
  return out;
}

}  // namespace ups
