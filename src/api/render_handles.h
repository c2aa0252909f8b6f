// Jobs and results as handles. Included by the files of src/api that render and that read results.
#pragma once
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

}  // namespace ups::api
