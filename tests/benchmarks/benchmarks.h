// What every benchmark file shares: how one is registered, and which rates are compared at the end of a run.
#pragma once
#include <benchmark/benchmark.h>

#include <functional>
#include <string>

namespace ups::benchmarks {

// Registered by hand, so that the generated inputs choose the names: group/what/size/threads.
benchmark::internal::Benchmark* add(const std::string& name, std::function<void(benchmark::State&)> body);

// Counts `per_iteration` of something every iteration; reported as a rate.
inline void count(benchmark::State& state, const char* what, double per_iteration) {
  state.counters[what] = benchmark::Counter(per_iteration, benchmark::Counter::kIsIterationInvariantRate);
}

// Asks for rate(numerator) / rate(denominator) of the counter `what`, printed where both have run.
void compare(const std::string& numerator, const std::string& denominator, const std::string& what);

void register_geometry();
void register_bsdf();
void register_emitters();
void register_photon_index();
void register_transport();

}  // namespace ups::benchmarks
