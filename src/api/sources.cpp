// ups_render.h: what a committed scene has that may emit.
#include <algorithm>

#include "api/desc.h"
#include "api/handles.h"

using namespace ups;
using namespace ups::api;

namespace {

const Source& source_at(const Snapshot& scene, uint32_t index) {
  if (index >= scene.sources.size())
    fail_argument("source " + std::to_string(index) + ": the scene has " + std::to_string(scene.sources.size()));
  return scene.sources[index];
}

// Emitters are in the order of their sources.
double flux_of(const Snapshot& scene, uint32_t index) {
  const std::vector<uint32_t>& sources = scene.source_of_emitter;
  double sum = 0;
  for (auto at = std::lower_bound(sources.begin(), sources.end(), index); at != sources.end() && *at == index; ++at)
    sum += scene.emitters[size_t(at - sources.begin())].flux_lm();
  return sum;
}

void copy(const Vec3d& from, double (&to)[3]) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

}  // namespace

ups_status ups_scene_get_source_count(const ups_scene* scene, uint32_t* out) {
  return guard(__func__, [&] { require(out, "out") = uint32_t(committed(scene)->snapshot->sources.size()); });
}

ups_status ups_scene_get_source(const ups_scene* scene, uint32_t index, ups_scene_source* source) {
  return guard(__func__, [&] {
    const auto build = committed(scene);
    const Snapshot& s = *build->snapshot;
    const Source& from = source_at(s, index);
    ups_scene_source info{};
    info.kind = from.kind;
    info.id = s.tag->bits() | from.id;
    info.group = from.group;
    info.light_kind = from.light_kind;
    info.maintained = from.profile || from.of_fixture;
    info.flux_lm = flux_of(s, index);
    std::copy(std::begin(from.to_world.m), std::end(from.to_world.m), info.to_world);
    copy(from.bounds_min, info.bounds_min_m);
    copy(from.bounds_max, info.bounds_max_m);
    write_info(source, info, "source");
  });
}

ups_status ups_scene_get_source_profile(const ups_scene* scene, uint32_t index, ups_profile** out) {
  return guard(__func__, [&] {
    require(out, "out");
    const auto build = committed(scene);
    const Source& source = source_at(*build->snapshot, index);
    if (!source.profile)
      fail_argument("source " + std::to_string(index) + " is no luminaire, so it has no profile");
    auto profile = std::make_unique<ups_profile>();
    profile->data = source.profile;
    *out = profile.release();
  });
}
