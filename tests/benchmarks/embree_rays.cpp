// What is Embree's own part of a render? A library to be loaded before ups (LD_PRELOAD): notes the rays of one render, up
// to UPS_EMBREE_RAYS of them, traces the same ones again at once and prints to standard error, as one line of JSON, the
// CPU time that takes. For a render by one thread. Called by throughput.py.
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "geometry/embree.h"

namespace {

double cpu_s() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

struct Noted {
  RTCScene scene;
  RTCRay ray;
  bool closest;
};

struct Notes {
  size_t limit = 0;
  RTCScene surfaces = nullptr;  // the first that is asked for closest hits; indices of discs never are
  std::vector<Noted> rays;
  Notes() {
    if (const char* limit_text = std::getenv("UPS_EMBREE_RAYS")) limit = std::strtoull(limit_text, nullptr, 10);
    rays.reserve(limit);
  }
};
Notes& notes() {
  static Notes instance;
  return instance;
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

#if UPS_EMBREE_MAJOR >= 4
using Intersect = void (*)(RTCScene, RTCRayHit*, RTCIntersectArguments*);
using Occluded = void (*)(RTCScene, RTCRay*, RTCOccludedArguments*);
#else
using Intersect = void (*)(RTCScene, RTCIntersectContext*, RTCRayHit*);
using Occluded = void (*)(RTCScene, RTCIntersectContext*, RTCRay*);
#endif

namespace {

const Intersect intersect_1 = next<Intersect>("rtcIntersect1");
const Occluded occluded_1 = next<Occluded>("rtcOccluded1");

// By the functions below, which let them pass: enough are noted.
void trace_again() {
  const double before = cpu_s();
  for (const Noted& n : notes().rays) {
    ups::embree::QueryContext context;
    if (n.closest) {
      RTCRayHit query;
      query.ray = n.ray;
      query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      ups::embree::intersect(n.scene, context, query);
    } else {
      RTCRay ray = n.ray;
      ups::embree::occluded(n.scene, context, ray);
    }
  }
  std::fprintf(stderr, "{\"rays\": %zu, \"embree_s\": %.6f}\n", notes().rays.size(), cpu_s() - before);
}

void note(RTCScene scene, const RTCRay& ray, bool is_closest) {
  Notes& all = notes();
  if (is_closest && !all.surfaces) all.surfaces = scene;
  if (scene != all.surfaces || all.rays.size() >= all.limit) return;
  all.rays.push_back({scene, ray, is_closest});
  if (all.rays.size() == all.limit) trace_again();
}

}  // namespace

extern "C" {

#if UPS_EMBREE_MAJOR >= 4
__attribute__((visibility("default"))) void rtcIntersect1(RTCScene scene, RTCRayHit* query,
                                                          RTCIntersectArguments* arguments) {
  if (!arguments || !arguments->filter) note(scene, query->ray, true);
  intersect_1(scene, query, arguments);
}
__attribute__((visibility("default"))) void rtcOccluded1(RTCScene scene, RTCRay* ray,
                                                         RTCOccludedArguments* arguments) {
  note(scene, *ray, false);
  occluded_1(scene, ray, arguments);
}
#else
__attribute__((visibility("default"))) void rtcIntersect1(RTCScene scene, RTCIntersectContext* context,
                                                          RTCRayHit* query) {
  if (!context->filter) note(scene, query->ray, true);
  intersect_1(scene, context, query);
}
__attribute__((visibility("default"))) void rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {
  note(scene, *ray, false);
  occluded_1(scene, context, ray);
}
#endif

}
