// How many paths a second? The sample bathroom through the public C API alone, loaded as the program loads it: a fixed
// number of iterations of each method with 1 and 2 threads. A pair is a light path and an eye path, so a method has as
// many as it has of the rarer. The time is that of the result: rendering, with the choice of the merge radii, without
// loading the scene.
#include <algorithm>
#include <map>

#include "benchmarks.h"
#include "tool/handles.h"

namespace ups::benchmarks {

namespace {

constexpr uint32_t width = 320, height = 240;
constexpr uint32_t iteration_count = 6;  // every pixel twice: a third of them are visited in each
constexpr int thread_counts[] = {1, 2};

struct Method {
  const char* name;
  ups_method method;
};
constexpr Method methods[] = {{"ups", UPS_METHOD_UPS},
                              {"bpt", UPS_METHOD_BIDIRECTIONAL},
                              {"pt", UPS_METHOD_PATH_TRACING},
                              {"ppm", UPS_METHOD_PPM}};

// The number of threads belongs to the scene's context; each is loaded once.
const ups_scene* bathroom_of(int threads) {
  static std::map<int, tool::LoadedScene> scenes;
  tool::LoadedScene& loaded = scenes[threads];
  if (!loaded.scene) loaded = tool::load_scene(UPS_BENCHMARK_SCENE, {threads, width, height});
  return loaded.scene;
}

ups_result_info render(int threads, ups_method method, uint64_t seed) {
  ups_render_desc desc;
  ups_render_desc_init(&desc, sizeof desc);
  desc.method = method;
  desc.seed = seed;
  desc.iteration_count = iteration_count;
  ups_result* result = nullptr;
  tool::check(ups_render(bathroom_of(threads), &desc, &result));
  const tool::Result owner(result);
  ups_result_info info{};
  info.struct_size = sizeof info;
  tool::check(ups_result_get_info(result, &info));
  return info;
}

void run(benchmark::State& state, int threads, ups_method method) {
  uint64_t light = 0, eye = 0, rays = 0, seed = 1;
  for (auto _ : state) {
    const ups_result_info info = render(threads, method, seed++);
    state.SetIterationTime(info.elapsed_s);
    light += info.light_paths;
    eye += info.eye_paths;
    rays += info.rays;
  }
  const double n = double(state.iterations());
  count(state, "eye paths", double(eye) / n);
  count(state, "light paths", double(light) / n);
  count(state, "path pairs", double(std::min(light, eye)) / n);
  count(state, "rays", double(rays) / n);
}

std::string name_of(const Method& m, int threads) {
  return std::string("transport/") + m.name + "/threads:" + std::to_string(threads);
}

}  // namespace

void register_transport() {
  for (const Method& m : methods)
    for (const int threads : thread_counts)
      add(name_of(m, threads), [=](benchmark::State& s) { run(s, threads, m.method); })->UseManualTime();
  for (const Method& m : methods) compare(name_of(m, 2), name_of(m, 1), "eye paths");
  for (const Method& m : methods)
    if (m.method != UPS_METHOD_UPS) compare(name_of(methods[0], 1), name_of(m, 1), "eye paths");
}

}  // namespace ups::benchmarks
