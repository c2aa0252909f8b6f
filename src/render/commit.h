// Commits: from a description to what renders start from, on the caller's thread or on one of their own. Called by api.
#pragma once
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "base/monitor.h"
#include "base/parallel.h"
#include "render/job_threads.h"
#include "render/method.h"
#include "scene/description.h"
#include "scene/snapshot.h"

namespace ups {

struct SceneBuild {
  std::shared_ptr<const Snapshot> snapshot;
  MethodChoice method;    // that UPS_METHOD_AUTO stands for on it
  uint64_t revision = 0;  // of the description
};

// The last build of a scene. Any thread.
class SceneBuilds {
 public:
  std::shared_ptr<const SceneBuild> last() const {
    const std::lock_guard lock(mutex_);
    return last_;
  }
  // Builds what has changed; null where nothing has. Throws Error (INVALID_STATE while another commit runs) and
  // Cancelled; the last build then stays.
  std::shared_ptr<const SceneBuild> commit(const Description& description, ThreadPool& pool, Monitor& monitor);

 private:
  friend class CommitJob;
  void begin();
  void end(std::shared_ptr<const SceneBuild> build);
  std::shared_ptr<const SceneBuild> build(const Description& description, ThreadPool& pool, Monitor& monitor) const;

  mutable std::mutex mutex_;
  std::shared_ptr<const SceneBuild> last_;  // null before the first
  bool is_committing_ = false;
};

class CommitJob {
 public:
  // on_build: with a new build, on the job's thread. memory_limit: bytes, 0: the system's. Throws Error.
  CommitJob(std::shared_ptr<SceneBuilds> builds, Description description, JobThreads threads, uint64_t memory_limit,
            std::function<void(const SceneBuild&)> on_build);
  ~CommitJob();  // cancels and joins

  void cancel() { monitor_.cancel(); }
  ups_progress progress() const;
  // As RenderJob::wait.
  ups_status wait(uint32_t timeout_ms, std::string& message) const;

 private:
  void run();

  const std::shared_ptr<SceneBuilds> builds_;
  std::optional<const Description> description_;  // until it is built: it keeps what is removed from the scene
  const JobThreads threads_;
  const std::function<void(const SceneBuild&)> on_build_;
  Monitor monitor_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();

  mutable std::mutex mutex_;  // guards what follows
  mutable std::condition_variable changed_;
  ups_job_state state_ = UPS_JOB_RUNNING;
  ups_status error_ = UPS_OK;
  std::string message_;
  double elapsed_ = 0;
  std::thread thread_;
};

}  // namespace ups
