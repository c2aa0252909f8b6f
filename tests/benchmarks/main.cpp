// Runs the benchmarks and prints their rates, then the ratios of rates that this run has measured side by side. Only
// the ratios mean something on another machine. Google Benchmark's options hold: --benchmark_filter=geometry, ...
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <vector>

#include "benchmarks.h"

namespace ups::benchmarks {
namespace {

struct Comparison {
  std::string numerator, denominator, what;
};
std::vector<Comparison>& comparisons() {
  static std::vector<Comparison> all;
  return all;
}

// In the order of registration.
std::vector<std::string>& names() {
  static std::vector<std::string> all;
  return all;
}

// Rates of one counter, one a repetition.
struct Rates {
  std::vector<double> values;
  double median() const {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const size_t n = sorted.size();
    return n % 2 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
  }
  // Half the range, relative to the median.
  double spread() const {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return (*high - *low) / 2 / median();
  }
};

// 3 digits and a prefix: "5.12 M", "340 n".
std::string engineering(double value) {
  static constexpr const char* prefixes[] = {"n", "u", "m", "", "k", "M", "G", "T"};
  int prefix = 3;
  for (; value >= 999.5 && prefix < 7; ++prefix) value /= 1000;
  for (; value < 0.9995 && value > 0 && prefix > 0; --prefix) value *= 1000;
  char text[32];
  std::snprintf(text, sizeof text, "%.*f %s", value < 9.995 ? 2 : value < 99.95 ? 1 : 0, value, prefixes[prefix]);
  return text;
}

class Reporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override {
    PrintBasicContext(&std::cerr, context);
    return true;
  }
  // All repetitions of one benchmark when the last of them is done; then their aggregates, which are not read.
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        for (const auto& [what, rate] : run.counters) rates_[run.run_name.function_name][what].values.push_back(rate);
    std::cerr << '.' << std::flush;
  }
  void Finalize() override {
    std::printf("\n%-34s %-12s %10s %10s %8s\n", "median of the repetitions", "", "a second", "s each", "spread");
    for (const std::string& name : names()) print_rates(name);
    std::printf("\nratios of rates\n");
    for (const Comparison& c : comparisons()) print_ratio(c);
  }

 private:
  void print_rates(const std::string& name) const {
    const auto found = rates_.find(name);
    if (found == rates_.end()) return;
    for (const auto& [what, rates] : found->second) {
      const double rate = rates.median();
      if (rate > 0)
        std::printf("%-34s %-12s %10s %10s %6.1f %%\n", name.c_str(), what.c_str(), engineering(rate).c_str(),
                    engineering(1 / rate).c_str(), 100 * rates.spread());
    }
  }
  void print_ratio(const Comparison& c) const {
    const Rates *a = find(c.numerator, c.what), *b = find(c.denominator, c.what);
    if (!a || !b || !(b->median() > 0)) return;
    std::printf("%8.3f  %s: %s / %s\n", a->median() / b->median(), c.what.c_str(), c.numerator.c_str(),
                c.denominator.c_str());
  }
  const Rates* find(const std::string& name, const std::string& what) const {
    const auto benchmark = rates_.find(name);
    if (benchmark == rates_.end()) return nullptr;
    const auto rates = benchmark->second.find(what);
    return rates == benchmark->second.end() ? nullptr : &rates->second;
  }

  std::map<std::string, std::map<std::string, Rates>> rates_;
};

// Defaults, before the caller's own options, which so win. Repetitions in random order: what else the machine does
// while they run falls on both sides of a ratio alike.
std::vector<std::string> arguments(int argc, char** argv) {
  std::vector<std::string> all = {argv[0], "--benchmark_repetitions=3", "--benchmark_enable_random_interleaving=true"};
  all.insert(all.end(), argv + 1, argv + argc);
  return all;
}

}  // namespace

benchmark::internal::Benchmark* add(const std::string& name, std::function<void(benchmark::State&)> body) {
  constexpr double seconds = 0.2;  // a repetition, at least
  names().push_back(name);
  return benchmark::RegisterBenchmark(name.c_str(), std::move(body))->MinTime(seconds);
}

void compare(const std::string& numerator, const std::string& denominator, const std::string& what) {
  comparisons().push_back({numerator, denominator, what});
}

}  // namespace ups::benchmarks

int main(int argc, char** argv) try {
  using namespace ups::benchmarks;
  std::vector<std::string> words = arguments(argc, argv);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  int count = int(words.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 2;
  register_geometry();
  register_bsdf();
  register_emitters();
  register_photon_index();
#ifdef UPS_BENCHMARK_SCENE
  register_transport();
#endif
  Reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
} catch (const std::exception& e) {
  std::fprintf(stderr, "ups_benchmarks: %s\n", e.what());
  return 1;
}
