// See torture.h.
#include "torture.h"

#include <cstdio>
#include <stdexcept>

namespace ups::test {

namespace {

void require_finite(std::initializer_list<double> values, const std::string& what) {
  for (const double v : values)
    if (!std::isfinite(v)) throw std::runtime_error("not finite: " + what);
}

// What Result's constructor leaves out.
void read_the_rest(const Result& result, const std::vector<Judged>& judged) {
  for (const Judged& j : judged) {
    result.part(j.meters, UPS_LIGHT_PART_DIRECT);
    result.part(j.meters, UPS_LIGHT_PART_INDIRECT);
    result.flags(j.meters);
    const ups_meter_statistics s = result.statistics(j.meters);
    require_finite({s.median_relative_error_bound, s.p95_relative_error_bound, s.worst_relative_error_bound},
                   "relative errors of a set");
    require_finite({result.choice(j.meters).predicted_gain}, "choice");
    for (uint32_t source = 0; source < result.sources().size(); ++source)
      for (const ups_meter_reading& r : result.readings_of_source(source, j.meters))
        require_finite({r.illuminance_lx, r.standard_error_lx, r.bias_lx, r.error_bound_lx, r.direct_lx, r.indirect_lx},
                       "reading of a source");
  }
}

const char* name_of(ups_method m) { return m == UPS_METHOD_AUTO ? "auto" : method_name(m); }

void expect_mean(const ups_meter_statistics& s, double expected, double tolerance, double worst_bound,
                 const std::string& what) {
  EXPECT_GE(s.mean_error_bound_lx, 0) << what << ": no bound";
  EXPECT_LE(s.mean_error_bound_lx, worst_bound * expected) << what << ": too noisy to judge " << s.mean_lx;
  EXPECT_LE(std::abs(s.mean_lx - expected), tolerance)
      << what << ": " << s.mean_lx << " +- " << s.mean_error_bound_lx << " lx (95 %), expected " << expected << " ("
      << 100 * (s.mean_lx / expected - 1) << " %)";
}

}  // namespace

std::vector<Result> survive(const std::string& name, Scene& scene, const std::vector<Judged>& judged,
                            const TortureOptions& options) {
  std::vector<Result> results;
  for (const ups_method method : options.methods) {
    SCOPED_TRACE(name + ", " + name_of(method));
    const uint32_t paths = options.light_paths * (method == UPS_METHOD_SPPM ? options.sppm_factor : 1);
    results.push_back(scene.render({.method = method,
                                    .iterations = options.iterations,
                                    .seed = 15,
                                    .light_paths = paths,
                                    .separation = options.separation,
                                    .flux_paths = 1u << 12}));
    const Result& result = results.back();
    read_the_rest(result, judged);
    const ups_result_info i = result.info();
    std::printf("%-24s %-4s %6.2f s, balance %9.2e of %8.2e lm\n", name.c_str(), name_of(method), i.elapsed_s,
                i.emitted_flux_lm - i.absorbed_flux_lm - i.escaped_flux_lm, i.flux_balance_standard_error_lm);
    const bool blind = std::find(options.blind.begin(), options.blind.end(), method) != options.blind.end();
    for (size_t k = 0; k < judged.size() && !blind; ++k) {
      const Judged& j = judged[k];
      const ups_meter_statistics s = result.statistics(j.meters), first = results[0].statistics(j.meters);
      const std::string what = name + ", set " + std::to_string(k) + ", " + name_of(method);
      const double worst_bound = j.worst_bound * (method == UPS_METHOD_SPPM ? 5 : 1);
      std::printf("%-24s %-4s set %zu: %.6g +- %.2g lx\n", name.c_str(), name_of(method), k, s.mean_lx,
                  s.mean_error_bound_lx);
      if (j.truth_lx >= 0)
        expect_mean(s, j.truth_lx, 2 * s.mean_error_bound_lx + j.truth_error * j.truth_lx,
                    worst_bound, what);
      else
        expect_mean(s, first.mean_lx,
                    2 * std::hypot(s.mean_error_bound_lx, first.mean_error_bound_lx) + 1e-5 * first.mean_lx,
                    worst_bound, what);
    }
  }
  return results;
}

Sensor add_small_camera(Scene& scene, const P3& p, const P3& direction) {
  return scene.add_camera(p, direction, 8, 8, 1, true);
}

Sensor add_cells(Scene& scene, const P3& corner, const P3& u, const P3& v, int n) {
  const std::vector<P3> centers = grid_points(corner, u, v, n);
  return scene.add_cells(centers, std::vector<P3>(centers.size(), normalize(cross(u, v))),
                         std::vector<P3>(centers.size(), normalize(u)), length(u) / n, length(v) / n);
}

std::vector<P3> grid_points(const P3& corner, const P3& u, const P3& v, int n) {
  std::vector<P3> points;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) points.push_back(corner + u * ((i + 0.5) / n) + v * ((j + 0.5) / n));
  return points;
}

}  // namespace ups::test
