// See far_field.h.
#include "photometry/far_field.h"

#include <algorithm>
#include <cmath>

namespace photometry {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;
constexpr size_t rays_per_node = 30;

size_t step_deg(size_t rays) {
  for (size_t step : {1, 2, 3, 5, 10, 15})
    if (rays / (360 / step * (180 / step + 1)) >= rays_per_node) return step;
  return 30;
}

// Integrals over gamma, times sin(gamma), of the hats of the two ends of [a, a + h]: falling from a, rising to a + h.
void add_hats(double a, double h, double& falling, double& rising) {
  const double up = (std::sin(a + h) - std::sin(a)) / h - std::cos(a + h);
  rising += up;
  falling += std::cos(a) - std::cos(a + h) - up;
}

}  // namespace

Distribution far_field(const std::vector<Ray>& rays) {
  const size_t step = step_deg(rays.size()), planes = 360 / step, rows = 180 / step + 1;
  const double h = double(step) * degree;
  std::vector<double> flux(planes * rows, 0.0);
  for (const Ray& r : rays) {
    const double x = r.direction[0], y = r.direction[1], z = r.direction[2];
    double c = std::atan2(y, x) / h;
    if (c < 0) c += double(planes);
    const double g = std::atan2(std::hypot(x, y), -z) / h;
    const size_t i = std::min(size_t(c), planes - 1), j = std::min(size_t(g), rows - 2);
    const double s = std::clamp(c - double(i), 0.0, 1.0), t = std::clamp(g - double(j), 0.0, 1.0);
    const size_t next = (i + 1) % planes;
    flux[i * rows + j] += r.flux_lm * (1 - s) * (1 - t);
    flux[i * rows + j + 1] += r.flux_lm * (1 - s) * t;
    flux[next * rows + j] += r.flux_lm * s * (1 - t);
    flux[next * rows + j + 1] += r.flux_lm * s * t;
  }
  // All planes meet at the poles, where one direction has one intensity.
  for (size_t pole : {size_t(0), rows - 1}) {
    double sum = 0;
    for (size_t i = 0; i < planes; ++i) sum += flux[i * rows + pole];
    for (size_t i = 0; i < planes; ++i) flux[i * rows + pole] = sum / double(planes);
  }
  std::vector<double> hat(rows, 0.0), c_deg, gamma_deg;
  for (size_t j = 0; j + 1 < rows; ++j) add_hats(double(j) * h, h, hat[j], hat[j + 1]);
  for (size_t i = 0; i < planes; ++i) c_deg.push_back(double(i * step));
  for (size_t j = 0; j < rows; ++j) gamma_deg.push_back(double(j * step));
  for (size_t i = 0; i < flux.size(); ++i) flux[i] /= h * hat[i % rows];
  return {std::move(c_deg), std::move(gamma_deg), std::move(flux)};
}

}  // namespace photometry
