// What the C API's handles point to. Children share what they need with their parents, so the order of destruction does
// not matter. Included by src/api alone.
#pragma once
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "api/fixture_parts.h"
#include "base/parallel.h"
#include "photometry/photometry.h"
#include "render/method.h"
#include "scene/description.h"
#include "scene/snapshot.h"
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

}  // namespace ups

struct ups_context {
  std::shared_ptr<ups::ContextCore> core;
};

struct ups_profile {
  std::shared_ptr<const photometry::Photometry> data;
};

struct ups_fixture {
  std::vector<std::shared_ptr<const ups::api::FixturePart>> parts;
};

struct ups_scene {
  std::shared_ptr<ups::ContextCore> context;
  ups::Description description;
  std::shared_ptr<const ups::Snapshot> snapshot;  // of the last commit; null before
  ups::MethodChoice method{};                     // that UPS_METHOD_AUTO stands for on it
  ups::IdTable<ups::api::PlacedFixture> fixtures;
  std::map<std::shared_ptr<const ups::api::FixturePart>, ups_mesh_id> fixture_meshes;  // of parts that do not emit
};
