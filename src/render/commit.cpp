// See commit.h.
#include "render/commit.h"

#include "base/error.h"
#include "base/thread.h"
#include "scene/prepare.h"

namespace ups {

void SceneBuilds::begin() {
  const std::lock_guard lock(mutex_);
  if (is_committing_)
    throw Error(UPS_ERROR_INVALID_STATE, "another commit of this scene runs: wait for its job, or cancel it");
  is_committing_ = true;
}

// build: null keeps the last one.
void SceneBuilds::end(std::shared_ptr<const SceneBuild> build) {
  const std::lock_guard lock(mutex_);
  is_committing_ = false;
  if (build) last_.swap(build);
}

std::shared_ptr<const SceneBuild> SceneBuilds::build(const Description& description, ThreadPool& pool,
                                                     Monitor& monitor) const {
  const auto before = last();
  if (before && before->revision == description.revision()) return nullptr;
  auto snapshot = prepare(description, pool, before ? before->snapshot : nullptr, &monitor);
  MethodChoice method = choose_method(*snapshot, {.method = UPS_METHOD_AUTO});
  return std::make_shared<const SceneBuild>(SceneBuild{std::move(snapshot), std::move(method), description.revision()});
}

std::shared_ptr<const SceneBuild> SceneBuilds::commit(const Description& description, ThreadPool& pool,
                                                      Monitor& monitor) {
  begin();
  std::shared_ptr<const SceneBuild> made;
  try {
    made = build(description, pool, monitor);
  } catch (...) {
    end(nullptr);
    throw;
  }
  end(made);
  return made;
}

CommitJob::CommitJob(std::shared_ptr<SceneBuilds> builds, Description description, JobThreads threads,
                     uint64_t memory_limit, std::function<void(const SceneBuild&)> on_build)
    : builds_(std::move(builds)), description_(std::move(description)), threads_(std::move(threads)),
      on_build_(std::move(on_build)) {
  monitor_.limit_memory(memory_limit);
  builds_->begin();
  try {
    thread_ = start_thread("commit", [this] { run(); });
  } catch (...) {
    builds_->end(nullptr);
    throw;
  }
}

CommitJob::~CommitJob() {
  cancel();
  if (thread_.joinable()) thread_.join();
}

void CommitJob::run() {
  std::shared_ptr<const SceneBuild> made;
  ups_job_state state = UPS_JOB_FAILED;
  JobError error;
  try {
    made = builds_->build(*description_, *threads_.take(), monitor_);
    monitor_.check();
    state = UPS_JOB_FINISHED;
    if (made) on_build_(*made);
  } catch (const Cancelled&) {
    state = UPS_JOB_CANCELLED;
  } catch (...) {
    error.keep();
  }
  description_.reset();
  builds_->end(state == UPS_JOB_FINISHED ? std::move(made) : nullptr);
  const std::lock_guard lock(mutex_);
  state_ = state, error_ = error.status;
  message_.swap(error.message);
  elapsed_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  changed_.notify_all();
}

ups_progress CommitJob::progress() const {
  const std::lock_guard lock(mutex_);
  ups_progress p{};
  p.struct_size = sizeof p;
  p.state = state_;
  p.elapsed_s = state_ != UPS_JOB_RUNNING
                    ? elapsed_
                    : std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  p.remaining_s = state_ == UPS_JOB_RUNNING ? -1 : 0;
  p.fraction = state_ == UPS_JOB_FINISHED ? 1 : monitor_.fraction();
  p.worst_relative_error = p.median_relative_error = -1;
  return p;
}

ups_status CommitJob::wait(uint32_t timeout_ms, std::string& message) const {
  std::unique_lock lock(mutex_);
  const auto done = [&] { return state_ != UPS_JOB_RUNNING; };
  if (!changed_.wait_for(lock, std::chrono::milliseconds(timeout_ms), done)) return UPS_TIMEOUT;
  message = message_;
  return state_ == UPS_JOB_FAILED ? error_ : state_ == UPS_JOB_CANCELLED ? UPS_CANCELLED : UPS_OK;
}

}  // namespace ups
