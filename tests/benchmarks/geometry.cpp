// How many rays a second? Cosine-distributed rays from random surface points of generated rooms: closest hits, and
// occlusion of segments of which about half are free.
#include <atomic>
#include <map>

#include "base/parallel.h"
#include "benchmarks.h"
#include "rooms.h"

namespace ups::benchmarks {

namespace {

constexpr float infinity = INFINITY;
constexpr size_t ray_count = 1u << 18, rays_per_block = 1u << 10;
constexpr size_t sizes[] = {1'000, 100'000, 1'000'000};
constexpr const char* size_names[] = {"1e3", "1e5", "1e6"};
constexpr int thread_counts[] = {1, 2};
enum Stream : uint32_t { direction = 3 };

struct Ray {
  Vec3 origin, direction;
  float segment;  // up to twice the way to the closest hit
};

std::vector<Ray> make_rays(const Room& room) {
  std::vector<Ray> rays;
  for (uint32_t i = 0; i < ray_count; ++i) {
    const SurfacePoint from = room.random_point(i);
    const Numbers u = random_numbers(i, direction);
    const Vec3 d = Frame(from.ng).to_world(square_to_cosine_hemisphere({u.a, u.b}));
    Ray ray{from.ray_origin(d), d, infinity};
    Hit hit;
    if (room.tracer().intersect(ray.origin, ray.direction, infinity, hit)) ray.segment = 2 * u.c * hit.t;
    rays.push_back(ray);
  }
  return rays;
}

const std::vector<Ray>& rays_of(size_t triangles) {
  static std::map<size_t, std::vector<Ray>> rays;
  auto& these = rays[triangles];
  if (these.empty()) these = make_rays(room_of(triangles));
  return these;
}

// Every iteration traces all rays on the library's own threads.
template <class Trace>
void trace_all(benchmark::State& state, size_t triangles, int threads, const Trace& trace) {
  const Raytracer& tracer = room_of(triangles).tracer();
  const std::vector<Ray>& rays = rays_of(triangles);
  ThreadPool pool(threads);
  std::atomic<size_t> found = 0;
  for (auto _ : state)
    pool.for_blocks(rays.size(), rays_per_block, [&](size_t, size_t begin, size_t end) {
      size_t here = 0;
      for (size_t i = begin; i < end; ++i) here += trace(tracer, rays[i]);
      found.fetch_add(here, std::memory_order_relaxed);
    });
  benchmark::DoNotOptimize(found.load());
  count(state, "rays", double(rays.size()));
}

bool closest(const Raytracer& tracer, const Ray& ray) {
  Hit hit;
  return tracer.intersect(ray.origin, ray.direction, infinity, hit);
}
bool occluded(const Raytracer& tracer, const Ray& ray) {
  return tracer.occluded(ray.origin, ray.direction, ray.segment);
}

std::string name_of(const char* query, size_t size, int threads) {
  return std::string("geometry/") + query + "/" + size_names[size] + "/threads:" + std::to_string(threads);
}

void register_query(const char* query, bool (*trace)(const Raytracer&, const Ray&)) {
  for (size_t i = 0; i < std::size(sizes); ++i) {
    for (const int threads : thread_counts)
      add(name_of(query, i, threads), [=](benchmark::State& s) {
        trace_all(s, sizes[i], threads, trace);
      })->UseRealTime();
    compare(name_of(query, i, 2), name_of(query, i, 1), "rays");
    if (i > 0) compare(name_of(query, i, 1), name_of(query, 0, 1), "rays");
  }
}

}  // namespace

void register_geometry() {
  register_query("closest", closest);
  register_query("occlusion", occluded);
  for (size_t i = 0; i < std::size(sizes); ++i) compare(name_of("occlusion", i, 1), name_of("closest", i, 1), "rays");
}

}  // namespace ups::benchmarks
