// ups_render.h: how much memory a render will take.
#include "api/desc.h"
#include "api/render_handles.h"

using namespace ups;
using namespace ups::api;

ups_status ups_scene_estimate_memory(const ups_scene* scene, const ups_render_desc* desc, ups_memory_estimate* out) {
  return guard(__func__, [&] {
    const auto build = committed(scene);
    require(out, "out");
    write_info(out, RenderJob(build->snapshot, read_desc(desc, &ups_render_desc_init), scene->context->pool).estimate(), "out");
  });
}

ups_status ups_job_get_memory_estimate(const ups_job* job, ups_memory_estimate* out) {
  return guard(__func__, [&] { write_info(out, render_of(job).memory(), "out"); });
}
