// Embree 3.13 and 4 behind one face: the calls whose names or arguments differ, and owners that release what they hold.
// Included by this folder's .cpp files alone. The build says which version it links (UPS_EMBREE_MAJOR).
#pragma once
#if !defined(UPS_EMBREE_MAJOR) && __has_include(<embree4/rtcore.h>)
#define UPS_EMBREE_MAJOR 4
#elif !defined(UPS_EMBREE_MAJOR)
#define UPS_EMBREE_MAJOR 3
#endif
#if UPS_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/floating_point.h"
#include "base/memory_budget.h"
#include "base/monitor.h"
#include "base/parallel.h"
#include "base/vec.h"
#include "geometry/raytracer.h"

namespace ups {

struct TracedMesh;

namespace embree {

// How the surfaces of a ray tracer's meshes with holes are textured. Such a mesh may be another ray tracer's too.
using Holes = std::map<const TracedMesh*, SurfaceTexturing>;

#if UPS_EMBREE_MAJOR >= 4
using PlainContext = RTCRayQueryContext;
inline void init(PlainContext& context) { rtcInitRayQueryContext(&context); }
#else
using PlainContext = RTCIntersectContext;
inline void init(PlainContext& context) { rtcInitIntersectContext(&context); }
#endif
// Every query of this folder has one. User geometry must call the filter of its query itself. holes: where there are
// some.
struct QueryContext : PlainContext {
  RTCFilterFunctionN filter_of_all = nullptr;
  const Holes* holes = nullptr;
  QueryContext() { init(*this); }
};
inline RTCFilterFunctionN filter_of(const PlainContext* context) {
  return static_cast<const QueryContext*>(context)->filter_of_all;
}
inline const SurfaceTexturing* holes_of(const PlainContext* context, const TracedMesh& mesh) {
  const Holes* holes = static_cast<const QueryContext*>(context)->holes;
  if (!holes) return nullptr;
  const auto found = holes->find(&mesh);
  return found == holes->end() ? nullptr : &found->second;
}

#if UPS_EMBREE_MAJOR >= 4
inline void intersect(RTCScene scene, QueryContext& context, RTCRayHit& ray) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  const TrapsMasked masked;
  rtcIntersect1(scene, &ray, &arguments);
}
inline void occluded(RTCScene scene, QueryContext& context, RTCRay& ray) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  const TrapsMasked masked;
  rtcOccluded1(scene, &ray, &arguments);
}
inline constexpr int with_query_filters = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;
// `filter` sees every hit of every geometry, after the geometry's own filter; it finds the context as args->context.
inline void intersect(RTCScene scene, QueryContext& context, RTCRayHit& ray, RTCFilterFunctionN filter) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  arguments.filter = context.filter_of_all = filter;
  arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
  const TrapsMasked masked;
  rtcIntersect1(scene, &ray, &arguments);
}
#else
inline void intersect(RTCScene scene, QueryContext& context, RTCRayHit& ray) {
  const TrapsMasked masked;
  rtcIntersect1(scene, &context, &ray);
}
inline void occluded(RTCScene scene, QueryContext& context, RTCRay& ray) {
  const TrapsMasked masked;
  rtcOccluded1(scene, &context, &ray);
}
inline constexpr int with_query_filters = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;
inline void intersect(RTCScene scene, QueryContext& context, RTCRayHit& ray, RTCFilterFunctionN filter) {
  context.filter = context.filter_of_all = filter;
  const TrapsMasked masked;
  rtcIntersect1(scene, &context, &ray);
}
#endif

inline RTCRay make_ray(const Vec3& o, const Vec3& d, float tmax) {
  RTCRay ray;
  ray.org_x = o.x, ray.org_y = o.y, ray.org_z = o.z, ray.tnear = 0;
  ray.dir_x = d.x, ray.dir_y = d.y, ray.dir_z = d.z, ray.time = 0;
  ray.tfar = tmax, ray.mask = 0xffffffffu, ray.id = 0, ray.flags = 0;
  return ray;
}

// Owns a device; keeps the first error that Embree reports, whichever thread it came from.
class Device {
 public:
  Device() : device_(rtcNewDevice(nullptr)) {
    if (!device_) {
      const RTCError code = rtcGetDeviceError(nullptr);
      if (code == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
      throw Error(UPS_ERROR_INTERNAL, "Embree: no device, error " + std::to_string(code));
    }
    rtcSetDeviceErrorFunction(device_, &Device::on_error, this);
    rtcSetDeviceMemoryMonitorFunction(device_, &Device::on_memory, this);
  }
  ~Device() {
    rtcSetDeviceMemoryMonitorFunction(device_, nullptr, nullptr);  // what is left of it may outlive this
    rtcReleaseDevice(device_);
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  operator RTCDevice() const { return device_; }
  // Of trees and what they are built from, without buffers that are shared with it.
  size_t bytes() const { return size_t(std::max<ssize_t>(0, bytes_.load(std::memory_order_relaxed))); }

  // Until the next call: what may be taken beside what there is; more is refused. limit: which one ends there, in
  // words.
  void allow(uint64_t bytes, std::string limit) {
    const size_t taken = this->bytes();
    limit_ = std::move(limit);
    refused_.store(false);
    most_.store(ssize_t(std::min<uint64_t>(bytes, uint64_t(most_bytes) - taken) + taken));
  }
  // Once anything went wrong but that a build was cancelled or refused memory: where that is exhausted a build may
  // leave the device in disorder. What it has built stands.
  bool is_spoiled() const { return spoiled_.load(); }
  // Throws what went wrong since the last time.
  void check() {
    const std::lock_guard lock(mutex_);
    const RTCError code = std::exchange(code_, RTC_ERROR_NONE);
    if (code == RTC_ERROR_NONE) return;
    const bool refused = refused_.exchange(false);
    if (code == RTC_ERROR_CANCELLED) throw Cancelled();
    if (refused)
      throw Error(UPS_ERROR_OUT_OF_MEMORY, "the index of the scene's surfaces wants more memory than " + limit_ +
                                               " allows; fewer triangles, or more memory, would be right");
    const ups_status status = code == RTC_ERROR_OUT_OF_MEMORY ? UPS_ERROR_OUT_OF_MEMORY : UPS_ERROR_INTERNAL;
    throw Error(status, std::string("Embree: ") + message_);
  }

 private:
  static void on_error(void* self, RTCError code, const char* text) {
    Device& device = *static_cast<Device*>(self);
    const std::lock_guard lock(device.mutex_);
    if (code != RTC_ERROR_CANCELLED && !device.refused_.load()) device.spoiled_.store(true);
    if (device.code_ != RTC_ERROR_NONE) return;
    device.code_ = code;
    std::snprintf(device.message_, sizeof device.message_, "%s", text ? text : "unknown error");
  }
  // done: it is taken already.
  static bool on_memory(void* self, ssize_t bytes, bool done) {
    Device& device = *static_cast<Device*>(self);
    const ssize_t now = device.bytes_.fetch_add(bytes, std::memory_order_relaxed) + bytes;
    if (bytes <= 0 || done || now <= device.most_.load(std::memory_order_relaxed)) return true;
    device.bytes_.fetch_sub(bytes, std::memory_order_relaxed);
    device.refused_.store(true);
    return false;
  }
  static constexpr ssize_t most_bytes = std::numeric_limits<ssize_t>::max();
  std::atomic<bool> spoiled_{false}, refused_{false};
  std::atomic<ssize_t> most_{most_bytes};
  std::string limit_;
  std::atomic<ssize_t> bytes_{0};  // before the device, which tells of its end
  RTCDevice device_;
  std::mutex mutex_;
  RTCError code_ = RTC_ERROR_NONE;
  char message_[256] = "";  // no string: Embree may be calling because memory is exhausted
};

// Owns a scene. Robust: rays do not slip between triangles that share an edge. query_filters: for intersect() with a
// filter; other queries are a little slower then.
class Scene {
 public:
  explicit Scene(Device& device, bool query_filters = false) : device_(&device), scene_(rtcNewScene(device)) {
    try {
      device.check();
    } catch (...) {  // of what somebody else asked of the device, too
      if (scene_) rtcReleaseScene(scene_);
      throw;
    }
    rtcSetSceneFlags(scene_, query_filters ? RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | with_query_filters)
                                           : RTC_SCENE_FLAG_ROBUST);
  }
  ~Scene() { rtcReleaseScene(scene_); }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  operator RTCScene() const { return scene_; }

  // Takes over the geometry's one reference.
  void attach(RTCGeometry geometry, uint32_t id) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, id);
    rtcReleaseGeometry(geometry);
    device_->check();
  }
  // Embree builds in the arena of its caller: a device's own thread setting would change the whole process. monitor may
  // be null; begin, end: what its fraction is before and after. Throws Cancelled.
  void commit(ThreadPool& pool, Monitor* monitor = nullptr, float begin = 0, float end = 1) {
    Progress progress{monitor, begin, end};
    if (monitor) rtcSetSceneProgressMonitorFunction(scene_, &Scene::on_progress, &progress);
    pool.run_tasks([&] { rtcCommitScene(scene_); });  // which masks traps
    if (monitor) rtcSetSceneProgressMonitorFunction(scene_, nullptr, nullptr);
    device_->check();
  }

 private:
  struct Progress {
    Monitor* monitor;
    float begin, end;
  };
  static bool on_progress(void* to, double done) {
    const Progress& p = *static_cast<const Progress*>(to);
    p.monitor->report(p.begin + (p.end - p.begin) * std::clamp(float(done), 0.0f, 1.0f));
    return !p.monitor->is_cancelled();
  }

  Device* device_;
  RTCScene scene_;
};

}  // namespace embree
}  // namespace ups
