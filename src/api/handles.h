// What the C API's handles point to. Children share what they need with their parents, so the order of destruction does
// not matter. Included by src/api alone.
#pragma once
#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "api/guard.h"
#include "base/owner.h"
#include "base/parallel.h"
#include "fixture/placed.h"
#include "photometry/photometry.h"
#include "render/commit.h"
#include "scene/description.h"
#include "ups/ups.h"

namespace ups {

// Threads and log of a context; lives as long as the context or any of its children.
class ContextCore {
 public:
  explicit ContextCore(int thread_count) : pool(std::make_shared<ThreadPool>(thread_count)) {}
  const std::shared_ptr<ThreadPool> pool;

  void log(ups_log_level level, std::string text);
  struct Message {
    ups_log_level level;
    std::string text;
  };
  // visit(message or null) with the oldest message; true from it removes the message.
  template <class Visit>
  void pop(const Visit& visit) {
    const std::lock_guard lock(mutex_);
    if (log_.empty())
      visit(nullptr);
    else if (visit(&log_.front()))
      log_.pop_front();
  }

 private:
  std::mutex mutex_;
  std::deque<Message> log_;
};

namespace api {

using ups::destroy;

// A handle that must not be NULL, and this copy's own. For other pointers see guard.h.
template <HandleType T>
T& require(T* handle, const char* argument) {
  if (!handle) fail_argument(std::string(argument) + " is NULL");
  if (!handle->owner.is_ours())
    fail_argument(std::string(argument) + " is no handle of its kind that this library made: another loaded copy of " +
                  "it did, or it was destroyed already");
  return *handle;
}

}  // namespace api
}  // namespace ups

struct ups_context {
  ups::Owner<ups_context> owner;
  std::shared_ptr<ups::ContextCore> core;
};

struct ups_profile {
  ups::Owner<ups_profile> owner;
  std::shared_ptr<const photometry::Photometry> data;
};

struct ups_fixture {
  ups::Owner<ups_fixture> owner;
  ups::Fixture data;
};

struct ups_scene {
  ups::Owner<ups_scene> owner;
  std::shared_ptr<ups::ContextCore> context;
  ups::Description description{std::make_shared<const ups::SceneTag>()};
  std::shared_ptr<ups::SceneBuilds> builds = std::make_shared<ups::SceneBuilds>();
  ups::PlacedFixtures fixtures{description};

  bool is_dirty() const {
    const auto build = builds->last();
    return !build || build->revision != description.revision();
  }
};

namespace ups::api {

// What the last commit has built.
inline std::shared_ptr<const SceneBuild> committed(const ups_scene* scene) {
  auto build = require(scene, "scene").builds->last();
  if (!build) throw Error(UPS_ERROR_INVALID_STATE, "the scene was never committed; call ups_scene_commit first");
  return build;
}

}  // namespace ups::api
