// ups_render.h: renders, jobs and results. A render is a job that the call waits for.
#include <algorithm>
#include <cmath>

#include "api/desc.h"
#include "api/render_handles.h"
#include "photometry/writer_text.h"
#include "render/beam_error.h"
#include "scene/check.h"

using namespace ups;
using namespace ups::api;

namespace {

std::unique_ptr<ups_job> start(const ups_scene* scene, const ups_render_desc* desc) {
  const auto build = committed(scene);
  auto job = std::make_unique<ups_job>();
  job->context = scene->context;
  job->render = std::make_unique<RenderJob>(build->snapshot, read_desc(desc, &ups_render_desc_init),
                                            scene->context->pool);
  if (build->revision != scene->description.revision()) {
    const char* text = "the scene has edits that were not committed: this is the scene of the last commit";
    job->render->add_notice(text);
    scene->context->log(UPS_LOG_WARNING, std::string("render: ") + text);
  }
  job->render->start();
  return job;
}

ups_result* wrap(std::shared_ptr<const RenderResult> data) { return new ups_result{.data = std::move(data)}; }

// meters: of those that measure; the others' are 0.
template <class Reading>
void copy_readings(const MeterSet& set, const std::vector<Reading>& meters, Reading* out, size_t count) {
  require(out, "out");
  if (count != set.count())
    fail_argument("count is " + std::to_string(count) + "; the set has " + std::to_string(set.count()) + " meters");
  std::fill(out, out + count, Reading{});
  for (size_t m = 0; m < meters.size(); ++m) out[set.number(m)] = meters[m];
}

void check_part(ups_light_part part) {
  if (part < UPS_LIGHT_PART_DIRECT || part > UPS_LIGHT_PART_ALL)
    fail_argument("part: " + std::to_string(part) + " is not a UPS_LIGHT_PART_* value");
}

const std::vector<ups_vector_part_reading>& vectors_of(const ups_result* result, ups_sensor_id sensor,
                                                       ups_light_part part) {
  const MeterSetReading& set = meters_of(result, sensor);
  check_part(part);
  if (set_of(result, sensor).kind != UPS_METER_VECTOR)
    fail_argument("sensor: the meters are not of kind UPS_METER_VECTOR");
  return set.vectors[size_t(part)];
}

void check_source(const RenderResult& r, uint32_t index) {
  if (index >= r.sources.size())
    fail_argument("source " + std::to_string(index) + ": there are " + std::to_string(r.sources.size()) +
                  " (ups_render_desc.separation)");
}

const GoniometerReading& goniometer_of(const ups_result* result, ups_sensor_id sensor) {
  const RenderResult& r = data_of(result);
  return r.goniometers[index_of(r, r.scene->goniometer_ids, sensor, "goniometer")];
}

struct Plane {
  const std::vector<float>& values;
  uint32_t channels;
};
Plane layer_of(const std::vector<float>& values, uint32_t channels, const std::string& name, const char* end = "") {
  if (values.empty())
    fail_argument("channel UPS_CHANNEL_" + name + end + ": this camera's desc did not ask for UPS_LAYER_" + name +
                  " in `layers`");
  return {values, channels};
}
Plane illuminance_of(const ImageReading& image, std::vector<float> IlluminanceReading::*values, const char* end) {
  if (!image.illuminance)
    fail_argument(std::string("channel UPS_CHANNEL_ILLUMINANCE") + end +
                  ": this camera's desc did not set `illuminance`");
  return {*image.illuminance.*values, 1};
}
Plane plane_of(const ImageReading& image, ups_channel channel) {
  switch (channel) {
    case UPS_CHANNEL_LUMINANCE_RGB: return {image.luminance_rgb, 3};
    case UPS_CHANNEL_STANDARD_ERROR_RGB: return {image.standard_error_rgb, 3};
    case UPS_CHANNEL_ROBUST_RGB: return {image.robust_rgb, 3};
    case UPS_CHANNEL_BIAS: return {image.bias, 1};
    case UPS_CHANNEL_ERROR_BOUND: return {image.error_bound, 1};
    case UPS_CHANNEL_ILLUMINANCE: return illuminance_of(image, &IlluminanceReading::lx, "");
    case UPS_CHANNEL_ILLUMINANCE_STANDARD_ERROR:
      return illuminance_of(image, &IlluminanceReading::standard_error, "_STANDARD_ERROR");
    case UPS_CHANNEL_ILLUMINANCE_BIAS: return illuminance_of(image, &IlluminanceReading::bias, "_BIAS");
    case UPS_CHANNEL_ILLUMINANCE_ERROR_BOUND:
      return illuminance_of(image, &IlluminanceReading::error_bound, "_ERROR_BOUND");
    case UPS_CHANNEL_PATH_INTEGRATION_RGB:
    case UPS_CHANNEL_DENSITY_ESTIMATION_RGB: {
      const bool edge = channel == UPS_CHANNEL_PATH_INTEGRATION_RGB;
      const auto& values = image.families[size_t(edge ? Family::path_integration : Family::density_estimation)];
      if (values.empty())
        fail_argument("channel: the parts of the image are there only where ups_render_desc.technique_images was set");
      return {values, 3};
    }
    case UPS_CHANNEL_ALBEDO_RGB: return layer_of(image.layers.albedo_rgb, 3, "ALBEDO", "_RGB");
    case UPS_CHANNEL_NORMAL: return layer_of(image.layers.normal, 3, "NORMAL");
    case UPS_CHANNEL_DEPTH: return layer_of(image.layers.depth, 1, "DEPTH");
    case UPS_CHANNEL_ID: return layer_of(image.layers.id, 1, "ID");
    default: fail_argument("channel: " + std::to_string(channel) + " is not a UPS_CHANNEL_* value");
  }
}

void copy_plane(const ImageReading& image, const Plane& plane, float* out, size_t row_stride_bytes, size_t size_bytes) {
  require(out, "out");
  const size_t row = size_t(image.width) * plane.channels * sizeof(float);
  const size_t stride = row_stride_bytes ? row_stride_bytes : row;
  if (stride < row || stride % sizeof(float))
    fail_argument("row_stride_bytes is " + std::to_string(stride) + "; a row has " + std::to_string(row) + " bytes");
  // Divisions, so that no product can wrap around.
  if (size_bytes < row || (size_bytes - row) / stride < image.height - 1)
    throw Error(UPS_ERROR_BUFFER_TOO_SMALL, "size_bytes is " + std::to_string(size_bytes) + "; " +
                                                std::to_string(image.height) + " rows of " + std::to_string(stride) +
                                                " bytes do not fit");
  for (uint32_t y = 0; y < image.height; ++y)
    std::memcpy(reinterpret_cast<char*>(out) + y * stride,
                plane.values.data() + size_t(y) * image.width * plane.channels, row);
}

const ImageReading& image_of(const ups_result* result, ups_sensor_id camera) {
  const RenderResult& r = data_of(result);
  return r.images[index_of(r, r.scene->camera_ids, camera, "camera")];
}

const TechniqueReading& technique_of(const ImageReading& image, uint32_t index) {
  if (index >= image.techniques.size())
    fail_argument("index is " + std::to_string(index) + "; there are " + std::to_string(image.techniques.size()) +
                  " techniques (ups_render_desc.technique_images)");
  return image.techniques[index];
}

ups_technique_info info_of(const Technique& t) {
  const uint32_t kind = t.family == Family::density_estimation ? UPS_TECHNIQUE_MERGE
                        : t.s == 0                             ? UPS_TECHNIQUE_EMITTER_HIT
                        : t.t() == 1                           ? UPS_TECHNIQUE_SENSOR_CONNECT
                        : t.s == 1                             ? UPS_TECHNIQUE_LIGHT_SAMPLE
                                                               : UPS_TECHNIQUE_CONNECT;
  return {uint32_t(sizeof(ups_technique_info)), kind, t.s, t.t(), t.edges};
}

const std::string& text_of(const RenderResult& r, ups_result_text topic) {
  switch (topic) {
    case UPS_TEXT_WARNINGS: return r.warnings;
    case UPS_TEXT_EFFECTS: return r.effects;
    case UPS_TEXT_TECHNIQUES: return r.techniques;
    case UPS_TEXT_DROPPED: return r.dropped;
    default: fail_argument("topic: " + std::to_string(topic) + " is not a UPS_TEXT_* value");
  }
}

}  // namespace

void ups_render_desc_init(ups_render_desc* desc, uint32_t struct_size) {
  ups_render_desc d{};
  d.method = UPS_METHOD_AUTO;
  d.seed = 1;
  write_defaults(desc, struct_size, d);
}

ups_status ups_render(const ups_scene* scene, const ups_render_desc* desc, ups_result** out) {
  return guard(__func__, [&] {
    require(out, "out");
    const auto job = start(scene, desc);
    std::string message;
    ups_status status;
    while ((status = job->render->wait(UINT32_MAX, message)) == UPS_TIMEOUT) {}
    if (status < 0) throw Error(status, message);
    *out = wrap(job->render->result());
  });
}

ups_status ups_job_start(const ups_scene* scene, const ups_render_desc* desc, ups_job** out) {
  return guard(__func__, [&] {
    require(out, "out");
    *out = start(scene, desc).release();
  });
}

ups_status ups_job_poll(const ups_job* job, ups_progress* progress) {
  return guard(__func__, [&] {
    const ups_job& j = require(job, "job");
    write_info(progress, j.commit ? j.commit->progress() : j.render->progress(), "progress");
  });
}

ups_status ups_job_wait(const ups_job* job, uint32_t timeout_ms) {
  return guard(__func__, [&]() -> ups_status {
    std::string message;
    const ups_job& j = require(job, "job");
    const ups_status status = j.commit ? j.commit->wait(timeout_ms, message) : j.render->wait(timeout_ms, message);
    if (status < 0) throw Error(status, message);
    return status;
  });
}

void ups_job_cancel(ups_job* job) {
  if (!job || !job->owner.is_ours()) return;
  job->commit ? job->commit->cancel() : job->render->cancel();
}

ups_status ups_job_result(const ups_job* job, ups_result** out) {
  return guard(__func__, [&] {
    require(out, "out");
    *out = wrap(render_of(job).result());
  });
}

void ups_job_destroy(ups_job* job) { destroy(job); }

ups_status ups_result_get_info(const ups_result* result, ups_result_info* info) {
  return guard(__func__, [&] { write_info(info, data_of(result).info, "info"); });
}

ups_status ups_result_get_choice(const ups_result* result, ups_sensor_id sensor, ups_sensor_choice* choice) {
  return guard(__func__, [&] {
    const RenderResult& r = data_of(result);
    std::vector<uint32_t> ids = r.scene->camera_ids;
    for (const auto& v : {r.scene->meter_set_ids, r.scene->goniometer_ids}) ids.insert(ids.end(), v.begin(), v.end());
    write_info(choice, r.choices[index_of(r, ids, sensor, "sensor")], "choice");
  });
}

ups_status ups_result_read_meters(const ups_result* result, ups_sensor_id sensor, ups_meter_reading* out,
                                  size_t count) {
  return guard(__func__, [&] { copy_readings(set_of(result, sensor), meters_of(result, sensor).meters, out, count); });
}

ups_status ups_result_view_meters(const ups_result* result, ups_sensor_id sensor, const ups_meter_reading** readings,
                                  size_t* count) {
  return guard(__func__, [&] {
    const MeterSet& set = set_of(result, sensor);
    const std::vector<ups_meter_reading>* all = &meters_of(result, sensor).meters;
    require(readings, "readings");
    require(count, "count");
    if (all->size() != set.count()) {
      const std::lock_guard lock(result->whole_mutex);
      auto at = result->whole.find(&set);
      if (at == result->whole.end()) {
        std::vector<ups_meter_reading> whole(set.count());
        copy_readings(set, *all, whole.data(), whole.size());
        at = result->whole.emplace(&set, std::move(whole)).first;
      }
      all = &at->second;
    }
    *readings = all->data();
    *count = all->size();
  });
}

ups_status ups_result_read_vectors(const ups_result* result, ups_sensor_id sensor, ups_vector_reading* out,
                                   size_t count) {
  return guard(__func__, [&] {
    const auto& vectors = vectors_of(result, sensor, UPS_LIGHT_PART_ALL);
    std::vector<ups_vector_reading> whole(vectors.size());
    for (size_t m = 0; m < whole.size(); ++m) {
      std::copy_n(vectors[m].vector_lx, 3, whole[m].vector_lx);
      std::copy_n(vectors[m].standard_error_lx, 3, whole[m].standard_error_lx);
      std::copy_n(vectors[m].error_bound_lx, 3, whole[m].error_bound_lx);
    }
    copy_readings(set_of(result, sensor), whole, out, count);
  });
}

ups_status ups_result_read_vector_part(const ups_result* result, ups_sensor_id sensor, ups_light_part part,
                                       ups_vector_part_reading* out, size_t count) {
  return guard(__func__, [&] { copy_readings(set_of(result, sensor), vectors_of(result, sensor, part), out, count); });
}

ups_status ups_result_read_meter_part(const ups_result* result, ups_sensor_id sensor, ups_light_part part,
                                      ups_meter_part_reading* out, size_t count) {
  return guard(__func__, [&] {
    const MeterSetReading& set = meters_of(result, sensor);
    check_part(part);
    if (part != UPS_LIGHT_PART_ALL)
      return copy_readings(set_of(result, sensor), set.parts[size_t(part)], out, count);
    std::vector<ups_meter_part_reading> all;
    for (const ups_meter_reading& r : set.meters)
      all.push_back({r.illuminance_lx, r.standard_error_lx, r.bias_lx, r.error_bound_lx});
    copy_readings(set_of(result, sensor), all, out, count);
  });
}

ups_status ups_result_read_meter_flags(const ups_result* result, ups_sensor_id sensor, uint32_t* out, size_t count) {
  return guard(__func__, [&] { copy_readings(set_of(result, sensor), meters_of(result, sensor).flags, out, count); });
}

ups_status ups_result_get_source_count(const ups_result* result, uint32_t* out) {
  return guard(__func__, [&] { require(out, "out") = uint32_t(data_of(result).sources.size()); });
}

ups_status ups_result_get_source(const ups_result* result, uint32_t index, ups_source_info* info) {
  return guard(__func__, [&] {
    const RenderResult& r = data_of(result);
    check_source(r, index);
    ups_source_info source = r.sources[index];
    if (source.kind != UPS_SOURCE_GROUP) source.id |= r.scene->tag->bits();
    write_info(info, source, "info");
  });
}

ups_status ups_result_read_source_meters(const ups_result* result, uint32_t source, ups_sensor_id sensor,
                                         ups_meter_reading* out, size_t count) {
  return guard(__func__, [&] {
    const MeterSetReading& set = meters_of(result, sensor);
    check_source(data_of(result), source);
    copy_readings(set_of(result, sensor), set.separated[source], out, count);
  });
}

ups_status ups_result_get_meter_statistics(const ups_result* result, ups_sensor_id sensor, ups_meter_statistics* out) {
  return guard(__func__, [&] { write_info(out, meters_of(result, sensor).statistics, "out"); });
}

ups_status ups_result_get_goniometer_info(const ups_result* result, ups_sensor_id sensor, ups_goniometer_info* info) {
  return guard(__func__, [&] { write_info(info, goniometer_of(result, sensor).info, "info"); });
}

ups_status ups_result_read_goniometer(const ups_result* result, ups_sensor_id sensor, ups_intensity_reading* out,
                                      size_t count) {
  return guard(__func__, [&] {
    const auto& nodes = goniometer_of(result, sensor).nodes;
    require(out, "out");
    if (count != nodes.size())
      fail_argument("count is " + std::to_string(count) + "; the goniometer has " + std::to_string(nodes.size()) +
                    " nodes");
    std::copy(nodes.begin(), nodes.end(), out);
  });
}

ups_status ups_result_get_goniometer_angles(const ups_result* result, ups_sensor_id sensor, float* c_deg,
                                            size_t c_count, float* gamma_deg, size_t gamma_count) {
  return guard(__func__, [&] {
    const RenderResult& r = data_of(result);
    const Goniometer& g = r.scene->goniometers[index_of(r, r.scene->goniometer_ids, sensor, "goniometer")];
    require(c_deg, "c_deg");
    require(gamma_deg, "gamma_deg");
    if (c_count != g.c_deg().size() || gamma_count != g.gamma_deg().size())
      fail_argument("c_count, gamma_count are " + std::to_string(c_count) + ", " + std::to_string(gamma_count) +
                    "; the goniometer has " + std::to_string(g.c_deg().size()) + " planes of " +
                    std::to_string(g.gamma_deg().size()) + " angles");
    const auto to_float = [](double angle) { return float(angle); };
    std::transform(g.c_deg().begin(), g.c_deg().end(), c_deg, to_float);
    std::transform(g.gamma_deg().begin(), g.gamma_deg().end(), gamma_deg, to_float);
  });
}

ups_status ups_result_get_goniometer_beam(const ups_result* result, ups_sensor_id sensor, float c_deg, float fraction,
                                          ups_goniometer_beam* beam) {
  return guard(__func__, [&] {
    const RenderResult& r = data_of(result);
    const size_t index = index_of(r, r.scene->goniometer_ids, sensor, "goniometer");
    if (!std::isfinite(c_deg)) fail_argument("c_deg is not finite");
    if (!(fraction > 0 && fraction <= 1))
      fail_argument("fraction is " + check::text(double(fraction)) + "; it must be greater than 0 and at most 1");
    write_info(beam, beam_with_error(r.scene->goniometers[index], r.goniometers[index], c_deg, fraction), "beam");
  });
}

ups_status ups_result_get_goniometer_profile(const ups_result* result, ups_sensor_id sensor, ups_profile** out) {
  return guard(__func__, [&] {
    const RenderResult& r = data_of(result);
    const size_t index = index_of(r, r.scene->goniometer_ids, sensor, "goniometer");
    require(out, "out");
    const GoniometerReading& reading = r.goniometers[index];
    const Snapshot& scene = *r.scene;
    const Goniometer& g = scene.goniometers[index];
    std::vector<double> intensity;
    for (const ups_intensity_reading& node : reading.nodes) intensity.push_back(photometry::shorter(node.intensity_cd));
    photometry::Photometry data{photometry::Distribution(g.c_deg(), g.gamma_deg(), std::move(intensity))};
    if (const auto& opening = scene.goniometer_openings[index]; opening.shape != photometry::OpeningShape::point)
      data.opening = opening;  // a point's sizes stay behind
    data.symmetry = g.symmetry();
    data.rated_flux_lm = photometry::shorter(float(reading.info.emitted_flux_lm));
    data.format = "virtual goniophotometer";
    data.file_generation = 1.0001;  // LM-63-2019: a computer simulation
    *out = new ups_profile{.data = std::make_shared<const photometry::Photometry>(std::move(data))};
  });
}

ups_status ups_result_read_image(const ups_result* result, ups_sensor_id camera, ups_channel channel, float* out,
                                 size_t row_stride_bytes, size_t size_bytes) {
  return guard(__func__, [&] {
    const ImageReading& image = image_of(result, camera);
    copy_plane(image, plane_of(image, channel), out, row_stride_bytes, size_bytes);
  });
}

ups_status ups_result_view_image(const ups_result* result, ups_sensor_id camera, ups_channel channel,
                                 const float** pixels, uint32_t* width, uint32_t* height) {
  return guard(__func__, [&] {
    const ImageReading& image = image_of(result, camera);
    const Plane plane = plane_of(image, channel);
    require(pixels, "pixels");
    require(width, "width");
    require(height, "height") = image.height;
    *pixels = plane.values.data(), *width = image.width;
  });
}

ups_status ups_result_get_technique_count(const ups_result* result, ups_sensor_id camera, uint32_t* out) {
  return guard(__func__, [&] { require(out, "out") = uint32_t(image_of(result, camera).techniques.size()); });
}

ups_status ups_result_get_technique(const ups_result* result, ups_sensor_id camera, uint32_t index,
                                    ups_technique_info* info) {
  return guard(__func__,
               [&] { write_info(info, info_of(technique_of(image_of(result, camera), index).technique), "info"); });
}

ups_status ups_result_read_technique(const ups_result* result, ups_sensor_id camera, uint32_t index,
                                     ups_contribution contribution, float* out, size_t row_stride_bytes,
                                     size_t size_bytes) {
  return guard(__func__, [&] {
    const ImageReading& image = image_of(result, camera);
    const TechniqueReading& t = technique_of(image, index);
    if (contribution != UPS_CONTRIBUTION_WEIGHTED && contribution != UPS_CONTRIBUTION_UNWEIGHTED)
      fail_argument("contribution: " + std::to_string(contribution) + " is not a UPS_CONTRIBUTION_* value");
    copy_plane(image, {contribution == UPS_CONTRIBUTION_WEIGHTED ? t.weighted : t.unweighted, 3}, out, row_stride_bytes,
               size_bytes);
  });
}

ups_status ups_result_get_text(const ups_result* result, ups_result_text topic, char* text, size_t capacity,
                               size_t* needed) {
  return guard(__func__, [&] { copy_text(text_of(data_of(result), topic), text, capacity, needed); });
}

void ups_result_destroy(ups_result* result) { destroy(result); }
