// Jobs and results as handles. Included by the files of src/api that render and that read results.
#pragma once
#include <algorithm>

#include "api/handles.h"
#include "render/job.h"

struct ups_job {
  ups::api::Owner<ups_job> owner;
  std::shared_ptr<ups::ContextCore> context;  // keeps threads and log alive
  std::unique_ptr<ups::RenderJob> job;
};

struct ups_result {
  ups::api::Owner<ups_result> owner;
  std::shared_ptr<const ups::RenderResult> data;
};

namespace ups::api {

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

inline const MeterSetReading& meters_of(const ups_result* result, ups_sensor_id sensor) {
  const RenderResult& r = data_of(result);
  return r.meter_sets[index_of(r, r.scene->meter_set_ids, sensor, "meter set")];
}

}  // namespace ups::api
