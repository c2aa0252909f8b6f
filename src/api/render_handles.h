// Jobs and results as handles. Included by the files of src/api that render and that read results.
#pragma once
#include <algorithm>
#include <map>
#include <mutex>

#include "api/handles.h"
#include "render/job.h"

struct ups_job {
  ups::Owner<ups_job> owner;
  std::shared_ptr<ups::ContextCore> context;  // keeps threads and log alive
  std::unique_ptr<ups::RenderJob> render;     // this,
  std::unique_ptr<ups::CommitJob> commit;     // or this
};

struct ups_result {
  ups::Owner<ups_result> owner;
  std::shared_ptr<const ups::RenderResult> data;
  // Sets of which some meters do not measure, whole, from the first look at them on.
  mutable std::mutex whole_mutex;
  mutable std::map<const ups::MeterSet*, std::vector<ups_meter_reading>> whole;
};

namespace ups::api {

inline const RenderJob& render_of(const ups_job* job) {
  const ups_job& j = require(job, "job");
  if (!j.render) throw Error(UPS_ERROR_INVALID_STATE, "the job is a commit, which finds no light: ask a render's job");
  return *j.render;
}

inline const RenderResult& data_of(const ups_result* result) { return *require(result, "result").data; }

// numbers: of the sensors of one kind, or of several, in the scene as the result is of it.
inline size_t index_of(const RenderResult& r, const std::vector<uint32_t>& numbers, ups_sensor_id sensor,
                       const char* noun) {
  const uint32_t number = own_number_of(sensor.v, r.scene->tag->bits(), "sensor");
  const auto it = std::find(numbers.begin(), numbers.end(), number);
  if (it == numbers.end())
    fail_argument("sensor id " + std::to_string(number) + " is not a " + noun + " of the scene as it was committed");
  return size_t(it - numbers.begin());
}

inline const MeterSet& set_of(const ups_result* result, ups_sensor_id sensor) {
  const RenderResult& r = data_of(result);
  return r.scene->meter_sets[index_of(r, r.scene->meter_set_ids, sensor, "meter set")];
}
inline const MeterSetReading& meters_of(const ups_result* result, ups_sensor_id sensor) {
  const RenderResult& r = data_of(result);
  return r.meter_sets[index_of(r, r.scene->meter_set_ids, sensor, "meter set")];
}

}  // namespace ups::api
