// How long does it take to choose an emitter? For next-event estimation, among downlights above a hall of 40 m x 40 m x
// 5 m, from its floor; and the building of the choice.
#include <cmath>
#include <map>

#include "benchmarks.h"
#include "emitter/emitter_set.h"
#include "emitter/profile.h"
#include "rooms.h"

namespace ups::benchmarks {

namespace {

constexpr float side = 40, height = 4.9f;
constexpr size_t receiver_count = 1u << 12;
constexpr size_t sizes[] = {8, 64, 1024, 10'000};
enum Stream : uint32_t { places = 7, floor_points = 8 };

std::shared_ptr<const photometry::Distribution> downlight() {
  std::vector<double> gamma, table;
  for (int i = 0; i <= 36; ++i) {
    gamma.push_back(5 * i);
    table.push_back(i < 18 ? 1000 * std::pow(std::cos(5 * i * double(pi) / 180), 4) : 0);
  }
  return std::make_shared<photometry::Distribution>(std::vector<double>{0}, gamma, table);
}

std::vector<std::shared_ptr<const Emitter>> downlights(size_t size) {
  static const auto distribution = downlight();
  std::vector<std::shared_ptr<const Emitter>> out;
  for (uint32_t i = 0; i < size; ++i) {
    const Numbers n = random_numbers(i, places);
    out.push_back(std::make_shared<ProfilePointEmitter>(distribution, Frame(), Vec3(n.a * side, n.b * side, height),
                                                        Rgb(1), 1e-6f));
  }
  return out;
}

void build(benchmark::State& state, size_t size) {
  for (auto _ : state) {
    state.PauseTiming();
    auto emitters = downlights(size);
    state.ResumeTiming();
    const EmitterSet set(std::move(emitters));
    benchmark::DoNotOptimize(set.flux_lm());
  }
  count(state, "emitters", double(size));
}

void choose(benchmark::State& state, size_t size) {
  const EmitterSet set(downlights(size));
  std::vector<std::pair<Receiver, float>> receivers;
  for (uint32_t i = 0; i < receiver_count; ++i) {
    const Numbers n = random_numbers(i, floor_points);
    receivers.push_back({{Vec3(n.a * side, n.b * side, 0), Vec3(0, 0, 1)}, n.c});
  }
  for (auto _ : state)
    for (const auto& [receiver, u] : receivers) benchmark::DoNotOptimize(set.choose_direct(receiver, u));
  count(state, "choices", double(receiver_count));
}

std::string name_of(const char* what, size_t size) {
  return std::string("emitters/") + what + "/" + std::to_string(size);
}

}  // namespace

void register_emitters() {
  for (const size_t size : sizes) {
    add(name_of("choose", size), [=](benchmark::State& s) { choose(s, size); });
    if (size > sizes[0]) compare(name_of("choose", size), name_of("choose", sizes[0]), "choices");
  }
  for (const size_t size : {size_t(10'000), size_t(100'000)})
    add(name_of("build", size), [=](benchmark::State& s) { build(s, size); });
}

}  // namespace ups::benchmarks
