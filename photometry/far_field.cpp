// See far_field.h.
#include "photometry/far_field.h"

#include <algorithm>
#include <cmath>

#include "photometry/angle_nodes.h"

namespace photometry {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double rays_per_node = 100, rays_per_band = 1000;
constexpr double most_bands = 180, fewest_bands = 12;

struct Polar {
  double c_deg, gamma_deg, flux_lm;
};

// By gamma.
std::vector<Polar> sorted_polar(const std::vector<Ray>& rays) {
  std::vector<Polar> out;
  out.reserve(rays.size());
  for (const Ray& r : rays) {
    const double x = r.direction[0], y = r.direction[1], z = r.direction[2], c = std::atan2(y, x) / degree;
    out.push_back({c < 0 ? c + 360 : c, std::atan2(std::hypot(x, y), -z) / degree, r.flux_lm});
  }
  std::sort(out.begin(), out.end(), [](const Polar& a, const Polar& b) { return a.gamma_deg < b.gamma_deg; });
  return out;
}

// The number of rays of equal flux whose sum would be as noisy.
double effective_count(const std::vector<Polar>& rays) {
  double sum = 0, squares = 0;
  for (const Polar& r : rays) sum += r.flux_lm, squares += r.flux_lm * r.flux_lm;
  return squares > 0 ? sum * sum / squares : 1;
}

// Whether the flux in so many sectors of C in 10 bands of gamma of as many rays each differs from the bands' means by
// no more than the noise of independent rays: chi squared within 4.5 standard deviations of its mean.
bool is_even(const std::vector<Polar>& rays, size_t sectors) {
  constexpr size_t bands = 10;
  double chi2 = 0, freedom = 0;
  for (size_t b = 0; b < bands; ++b) {
    std::vector<double> flux(sectors, 0.0);
    double sum = 0, squares = 0;
    for (size_t i = b * rays.size() / bands; i < (b + 1) * rays.size() / bands; ++i) {
      flux[std::min(size_t(rays[i].c_deg / 360 * double(sectors)), sectors - 1)] += rays[i].flux_lm;
      sum += rays[i].flux_lm, squares += rays[i].flux_lm * rays[i].flux_lm;
    }
    if (!(squares > 0)) continue;
    const double n = double(sectors), mean = sum / n;
    for (double f : flux) chi2 += (f - mean) * (f - mean) / (squares / n);
    freedom += n - 1;
  }
  return chi2 < freedom + 4.5 * std::sqrt(2 * freedom);
}

// By a prime number, too: sectors of 30 degrees have equal shares of a hexagon and of whatever repeats with them.
bool looks_axial(const std::vector<Polar>& rays) { return is_even(rays, 12) && is_even(rays, 37); }

// The planes of rays that depend on C, ending with 360. Even, unless one of the sectors has four times its share.
std::vector<double> plane_nodes(const std::vector<Polar>& rays, double nodes) {
  size_t planes = 4;
  for (size_t n : {8, 12, 24, 36, 72, 120, 180, 360})
    if (double(n) <= std::sqrt(2 * nodes)) planes = n;
  std::vector<double> even, sector(planes, 0.0);
  for (size_t i = 0; i <= planes; ++i) even.push_back(360 * double(i) / double(planes));
  std::vector<WeightedAngle> angles;
  double sum = 0;
  for (const Polar& r : rays) {
    angles.push_back({r.c_deg, r.flux_lm * std::sin(r.gamma_deg * degree)});  // near the poles C says little
    sum += angles.back().weight;
    sector[std::min(size_t(r.c_deg / 360 * double(planes)), planes - 1)] += angles.back().weight;
  }
  if (*std::max_element(sector.begin(), sector.end()) <= 4 * sum / double(planes) && planes > 4) return even;
  std::sort(angles.begin(), angles.end(), [](const auto& a, const auto& b) { return a.deg < b.deg; });
  return angle_nodes(angles, {0, 360, false, std::max<size_t>(planes, 12), 30, 90});
}

// Integrals over gamma, times sin(gamma), of the hats of the two ends of [a, a + h]: falling from a, rising to a + h.
// With half width y and middle m, rising is sin(m) sin(y) + cos(m) (sin(y) - y cos(y)) / y, in which nothing cancels.
void add_hats(double a, double h, double& falling, double& rising) {
  const double y = 0.5 * h, m = a + y;
  const double moment =
      y > 0.1 ? (std::sin(y) - y * std::cos(y)) / y : y * y * (1.0 / 3 - y * y * (1.0 / 30 - y * y / 840));
  rising += std::sin(m) * std::sin(y) + std::cos(m) * moment;
  falling += std::sin(m) * std::sin(y) - std::cos(m) * moment;
}

struct Place {
  size_t index;
  double part;  // of the way to the next node
};
Place place_of(const std::vector<double>& nodes, double angle) {
  const auto next = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, angle);
  return {size_t(next - nodes.begin()) - 1, std::clamp((angle - next[-1]) / (next[0] - next[-1]), 0.0, 1.0)};
}

// Fluxes and their variances at nodes: planes[i], rows[j]. What belongs to a pole is gathered in plane 0.
struct NodeFlux {
  size_t planes, rows;
  std::vector<double> flux, square;

  void add(size_t plane, size_t row, double lm) {
    const bool pole = row == 0 || row + 1 == rows;
    const size_t at = (pole ? 0 : plane % planes) * rows + row;
    flux[at] += lm;
    square[at] += lm * lm;
  }
};

NodeFlux spread(const std::vector<Polar>& rays, const std::vector<double>& c, const std::vector<double>& gamma) {
  const size_t planes = c.size() - 1, rows = gamma.size();
  NodeFlux out{planes, rows, std::vector<double>(planes * rows, 0.0), std::vector<double>(planes * rows, 0.0)};
  for (const Polar& r : rays) {
    const Place p = place_of(c, r.c_deg), q = place_of(gamma, r.gamma_deg);
    for (size_t end : {0, 1}) {
      const double row_part = r.flux_lm * (end ? q.part : 1 - q.part);
      if (planes == 1) {
        out.add(0, q.index + end, row_part);
      } else {
        out.add(p.index, q.index + end, row_part * (1 - p.part));
        out.add(p.index + 1, q.index + end, row_part * p.part);
      }
    }
  }
  return out;
}

}  // namespace

FarField far_field(const std::vector<Ray>& rays) {
  const std::vector<Polar> polar = sorted_polar(rays);
  const double count = effective_count(polar), nodes = count / rays_per_node;
  const bool axial = looks_axial(polar);
  std::vector<double> c = axial ? std::vector<double>{0, 360} : plane_nodes(polar, nodes);
  const size_t planes = c.size() - 1;
  const double bands = axial ? count / rays_per_band : nodes / double(planes);
  std::vector<WeightedAngle> gammas;
  for (const Polar& r : polar) gammas.push_back({r.gamma_deg, r.flux_lm});
  std::vector<double> gamma =
      angle_nodes(gammas, {0, 180, true, size_t(std::clamp(bands, fewest_bands, most_bands)), 10, 90});

  NodeFlux at = spread(polar, c, gamma);
  double deviation = 0, flux = 0;
  for (size_t i = 0; i < at.flux.size(); ++i) deviation += std::sqrt(at.square[i]), flux += at.flux[i];
  const size_t rows = gamma.size();
  std::vector<double> hat(rows, 0.0), intensity(planes * rows);
  for (size_t j = 0; j + 1 < rows; ++j)
    add_hats(gamma[j] * degree, (gamma[j + 1] - gamma[j]) * degree, hat[j], hat[j + 1]);
  for (size_t i = 0; i < planes; ++i) {
    const double before = i > 0 ? c[i - 1] : c[planes - 1] - 360;
    for (size_t j = 0; j < rows; ++j) {
      // All planes meet at the poles, where one direction has one intensity.
      const bool pole = j == 0 || j + 1 == rows;
      const double width = pole ? 360 : 0.5 * (c[i + 1] - before);
      intensity[i * rows + j] = at.flux[(pole ? 0 : i) * rows + j] / (width * degree * hat[j]);
    }
  }
  c.pop_back();
  return {Distribution(std::move(c), std::move(gamma), std::move(intensity)), flux > 0 ? deviation / flux : 0};
}

}  // namespace photometry
