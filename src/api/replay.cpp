// ups_replay.h: the samples that weigh most, and paths traced again.
#include "api/desc.h"
#include "api/render_handles.h"

struct ups_path {
  ups::Owner<ups_path> owner;
  ups::PathReplay data;
};

using namespace ups;
using namespace ups::api;

ups_status ups_result_read_largest_samples(const ups_result* result, ups_sensor_id sensor, ups_sample* samples,
                                           size_t capacity, size_t* needed) {
  return guard(__func__, [&] {
    const RenderResult& r = data_of(result);
    std::vector<uint32_t> ids = r.scene->camera_ids;
    ids.insert(ids.end(), r.scene->meter_set_ids.begin(), r.scene->meter_set_ids.end());
    const auto& all = r.largest_samples[index_of(r, ids, sensor, "camera or meter set")];
    copy_array(all.size(), samples, capacity, needed, "samples", [&](size_t i) {
      ups_sample s = all[i];
      s.sensor.v |= r.scene->tag->bits();
      return s;
    });
  });
}

ups_status ups_replay(const ups_scene* scene, const ups_render_desc* desc, const ups_sample* sample, ups_path** out) {
  return guard(__func__, [&] {
    const auto build = committed(scene);
    const uint32_t tag = build->snapshot->tag->bits();
    ups_sample own = require(sample, "sample");
    require(out, "out");
    ups_render_desc render = read_desc(desc, &ups_render_desc_init);
    render.iteration_count = 1;
    render.time_limit_s = 0, render.target_relative_error = 0, render.flux_paths = 0;
    own.sensor.v = own_number_of(own.sensor.v, tag, "sensor");
    PathReplay data = RenderJob(build->snapshot, render, scene->context->pool).replay(own);
    for (ups_path_vertex& v : data.vertices)
      if (v.instance.v) v.instance.v |= tag;
    for (ups_path_contribution& c : data.contributions) c.source |= tag;
    *out = new ups_path{.data = std::move(data)};
  });
}

void ups_path_destroy(ups_path* path) { destroy(path); }

ups_status ups_path_get_info(const ups_path* path, ups_path_info* info) {
  return guard(__func__, [&] { write_info(info, require(path, "path").data.info, "info"); });
}

ups_status ups_path_read_vertices(const ups_path* path, ups_path_vertex* vertices, size_t capacity, size_t* needed) {
  return guard(__func__, [&] {
    const auto& all = require(path, "path").data.vertices;
    copy_array(all.size(), vertices, capacity, needed, "vertices", [&](size_t i) { return all[i]; });
  });
}

ups_status ups_path_read_contributions(const ups_path* path, ups_path_contribution* contributions, size_t capacity,
                                       size_t* needed) {
  return guard(__func__, [&] {
    const auto& all = require(path, "path").data.contributions;
    copy_array(all.size(), contributions, capacity, needed, "contributions", [&](size_t i) { return all[i]; });
  });
}

ups_status ups_path_get_text(const ups_path* path, char* text, size_t capacity, size_t* needed) {
  return guard(__func__, [&] { copy_text(require(path, "path").data.text, text, capacity, needed); });
}
