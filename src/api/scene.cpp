// ups_scene.h: defaults of the descs, what is added to a scene, commit, and what can be asked afterwards; for edits see
// edits.cpp.
#include "api/desc.h"
#include "api/render_handles.h"
#include "base/text.h"
#include "render/job_threads.h"
#include "scene/check.h"
#include "scene/outlines.h"
#include "scene/searched.h"
#include "scene/section.h"

using namespace ups;
using namespace ups::api;

namespace {

template <class Desc>
Desc placed() {
  Desc d{};
  set_identity(d.to_world);
  return d;
}

void fill(float (&rgb)[3], float value) { std::fill(std::begin(rgb), std::end(rgb), value); }

// Adds what `desc` describes and hands out its id.
template <class Desc, class Id, class Add>
ups_status add(const char* function, ups_scene* scene, const Desc* desc, void (*init)(Desc*, uint32_t), Id* out,
               const Add& add_to) {
  return guard(function, [&] {
    require(scene, "scene");
    require(out, "out");
    *out = add_to(scene->description, read_desc(desc, init));
  });
}

ups_scene_info info_of(const Snapshot& s, const MethodChoice& method) {
  ups_scene_info info{};
  info.maintenance_factor = s.maintenance_factor;
  info.revision = s.described->revision();
  info.effects = s.effects.effects;
  info.techniques = method.techniques;
  info.method = method.method;
  info.triangle_count = s.raytracer->triangle_count();
  info.luminaire_count = s.luminaire_count;
  info.light_count = s.light_count;
  info.emissive_instance_count = s.emissive_instance_count;
  for (const MeterSet& set : s.meter_sets) info.meter_count += set.count();
  info.pixel_count = s.pixel_count();
  info.emitted_flux_lm = s.emitters.flux_lm();
  const Vec3d low = Vec3d(s.raytracer->bounds_min()) + s.origin, high = Vec3d(s.raytracer->bounds_max()) + s.origin;
  for (int i = 0; i < 3; ++i) info.bounds_min_m[i] = low[i], info.bounds_max_m[i] = high[i];
  return info;
}

void log_warnings(ContextCore& context, const SceneBuild& build) {
  for (const auto& texts : {known_warnings(*build.snapshot), build.snapshot->warnings})
    for (const std::string& warning : texts) context.log(UPS_LOG_WARNING, "scene: " + warning);
}

void start_commit(ups_scene* scene, const ups_commit_desc& desc, ups_job** out) {
  ups_scene& s = require(scene, "scene");
  require(out, "out");
  check_priority(desc.priority);
  if (desc.reserved != 0) fail_argument("reserved is " + std::to_string(desc.reserved) + "; it must be 0");
  auto job = std::make_unique<ups_job>();
  job->context = s.context;
  job->commit = std::make_unique<CommitJob>(
      s.builds, s.description, JobThreads{s.context->pool, desc.thread_limit, desc.priority}, desc.memory_limit_bytes,
      [context = s.context](const SceneBuild& b) { log_warnings(*context, b); });
  *out = job.release();
}

// As callers give it.
struct Plane {
  Vec3d point, normal;

  Plane(const double* point_m, const double* normal_of_any_length) {
    check::pointer(point_m, "point_m");
    check::pointer(normal_of_any_length, "normal");
    point = {point_m[0], point_m[1], point_m[2]};
    normal = {normal_of_any_length[0], normal_of_any_length[1], normal_of_any_length[2]};
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(point[i])) fail_argument("point_m[" + std::to_string(i) + "] is not finite");
    if (!std::isfinite(dot(normal, normal)) || !(dot(normal, normal) > 0))
      fail_argument("normal has no finite length > 0");
  }
};

}  // namespace

// ---- defaults ----

void ups_texture_desc_init(ups_texture_desc* desc, uint32_t struct_size) {
  write_defaults(desc, struct_size, ups_texture_desc{});
}

void ups_material_desc_init(ups_material_desc* desc, uint32_t struct_size) {
  write_defaults(desc, struct_size, default_material());
}

void ups_mesh_desc_init(ups_mesh_desc* desc, uint32_t struct_size) {
  write_defaults(desc, struct_size, ups_mesh_desc{});
}

void ups_instance_desc_init(ups_instance_desc* desc, uint32_t struct_size) {
  write_defaults(desc, struct_size, placed<ups_instance_desc>());
}

void ups_light_desc_init(ups_light_desc* desc, uint32_t struct_size) {
  auto d = placed<ups_light_desc>();
  d.kind = UPS_LIGHT_POINT;
  fill(d.intensity_rgb, 1);
  d.outer_cone_rad = 0.25f * pi;
  write_defaults(desc, struct_size, d);
}

void ups_luminaire_desc_init(ups_luminaire_desc* desc, uint32_t struct_size) {
  auto d = placed<ups_luminaire_desc>();
  d.use_opening = 1;
  fill(d.color_rgb, 1);
  d.flux_lm = -1;
  d.dimming = d.intensity_scale = 1;
  write_defaults(desc, struct_size, d);
}

void ups_commit_desc_init(ups_commit_desc* desc, uint32_t struct_size) {
  write_defaults(desc, struct_size, ups_commit_desc{});
}

// ---- scene ----

ups_status ups_scene_create(ups_context* context, ups_scene** out) {
  return guard(__func__, [&] {
    require(out, "out");
    auto scene = std::make_unique<ups_scene>();
    scene->context = require(context, "context").core;
    *out = scene.release();
  });
}

void ups_scene_destroy(ups_scene* scene) { destroy(scene); }

ups_status ups_scene_add_texture(ups_scene* scene, const ups_texture_desc* desc, ups_texture_id* out) {
  return add(__func__, scene, desc, &ups_texture_desc_init, out,
             [](Description& d, const auto& desc_) { return d.add_texture(desc_); });
}

ups_status ups_scene_add_material(ups_scene* scene, const ups_material_desc* desc, ups_material_id* out) {
  return add(__func__, scene, desc, &ups_material_desc_init, out,
             [](Description& d, const auto& desc_) { return d.add_material(desc_); });
}

ups_status ups_scene_add_mesh(ups_scene* scene, const ups_mesh_desc* desc, ups_mesh_id* out) {
  return add(__func__, scene, desc, &ups_mesh_desc_init, out,
             [](Description& d, const auto& desc_) { return d.add_mesh(desc_); });
}

ups_status ups_scene_add_instance(ups_scene* scene, const ups_instance_desc* desc, ups_instance_id* out) {
  return add(__func__, scene, desc, &ups_instance_desc_init, out,
             [](Description& d, const auto& desc_) { return d.add_instance(desc_); });
}

ups_status ups_scene_add_light(ups_scene* scene, const ups_light_desc* desc, ups_luminaire_id* out) {
  return add(__func__, scene, desc, &ups_light_desc_init, out,
             [](Description& d, const auto& desc_) { return d.add_light(desc_); });
}

ups_status ups_scene_add_luminaire(ups_scene* scene, const ups_luminaire_desc* desc, ups_luminaire_id* out) {
  return add(__func__, scene, desc, &ups_luminaire_desc_init, out, [](Description& d, const auto& desc_) {
    return d.add_luminaire(desc_, require(desc_.profile, "profile").data);
  });
}

ups_status ups_scene_commit(ups_scene* scene) {
  return guard(__func__, [&] {
    ups_scene& s = require(scene, "scene");
    Monitor monitor;
    const auto build = s.builds->commit(s.description, *s.context->pool, monitor);
    if (!build) return;
    try {
      log_warnings(*s.context, *build);
    } catch (const std::bad_alloc&) {  // the build is there all the same
    }
  });
}

ups_status ups_scene_start_commit(ups_scene* scene, ups_job** out) {
  return guard(__func__, [&] { start_commit(scene, ups_commit_desc{}, out); });
}

ups_status ups_scene_start_commit_with(ups_scene* scene, const ups_commit_desc* desc, ups_job** out) {
  return guard(__func__, [&] {
    require(scene, "scene");
    require(out, "out");
    start_commit(scene, read_desc(desc, &ups_commit_desc_init), out);
  });
}

ups_status ups_scene_is_dirty(const ups_scene* scene, int32_t* out) {
  return guard(__func__, [&] {
    const ups_scene& s = require(scene, "scene");
    require(out, "out") = s.is_dirty();
  });
}

ups_status ups_scene_get_info(const ups_scene* scene, ups_scene_info* info) {
  return guard(__func__, [&] {
    const auto build = committed(scene);
    write_info(info, info_of(*build->snapshot, build->method), "info");
  });
}

ups_status ups_scene_get_text(const ups_scene* scene, ups_scene_text topic, char* text, size_t capacity,
                              size_t* needed) {
  return guard(__func__, [&] {
    const auto build = committed(scene);
    const Snapshot& s = *build->snapshot;
    check::enumeration(topic, UPS_SCENE_TEXT_TECHNIQUES, "topic", "UPS_SCENE_TEXT_*");
    const std::string from = topic == UPS_SCENE_TEXT_WARNINGS
                                 ? lines(searched_warnings(s, *scene->context->pool)) + lines(s.warnings) +
                                       lines(build->method.warnings)
                             : topic == UPS_SCENE_TEXT_EFFECTS ? s.effects.text
                                                               : build->method.text;
    copy_text(from, text, capacity, needed);
  });
}

ups_status ups_scene_read_section(const ups_scene* scene, const double point_m[3], const double normal[3],
                                  ups_segment* segments, size_t capacity, size_t* needed) {
  return guard(__func__, [&] {
    const auto build = committed(scene);
    const Snapshot& s = *build->snapshot;
    const Plane plane(point_m, normal);
    const std::vector<ups_segment> all = section(s, plane.point, plane.normal);
    copy_array(all.size(), segments, capacity, needed, "segments", [&](size_t i) { return all[i]; });
  });
}

ups_status ups_scene_read_outlines(const ups_scene* scene, const double point_m[3], const double normal[3],
                                   double depth_m, ups_segment* segments, size_t capacity, size_t* needed) {
  return guard(__func__, [&] {
    const auto build = committed(scene);
    const Snapshot& s = *build->snapshot;
    const Plane plane(point_m, normal);
    if (std::isnan(depth_m) || depth_m <= 0) fail_argument("depth_m is " + check::text(depth_m) + "; it must be > 0");
    const std::vector<ups_segment> all = outlines(s, plane.point, plane.normal, depth_m);
    copy_array(all.size(), segments, capacity, needed, "segments", [&](size_t i) { return all[i]; });
  });
}
