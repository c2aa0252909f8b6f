// The numbers of metrics.h. Beams are followed along one plane from knot to knot of the table, where the interpolated
// intensity is linear, and bisected in the piece that crosses the level; flux by zones is summed ring by ring.
#include "photometry/metrics.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace photometry {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double nudge_deg = 1e-9;  // to either side of where the intensity may jump
constexpr double tie = 1e-9;        // relative difference of peaks that are equal but for rounding and nudges
constexpr double rounding = 1e-12;  // of an interpolated intensity, relative

double radians(double degrees) { return degrees / 180 * pi; }

double intensity_at(const Distribution& d, double c_deg, double gamma_deg) {
  const double c = radians(c_deg), g = radians(gamma_deg);
  return d.eval(std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g));
}

// Whether the table's own angles are C and gamma. Those of types A and B run about another axis.
bool is_c_gamma(const Photometry& p) { return p.distribution.type() == PhotometricType::c; }

// Gamma angles between which the intensity in any plane is linear, with both sides of the nadir's and of the table's
// ends. Of a table of type A or B it is that in the planes C0-C180 and C90-C270, where gamma runs along the table's
// angles; in others nearly so.
std::vector<double> knots_of(const Photometry& p) {
  std::vector<double> knots = {nudge_deg, 180};
  const auto add = [&](const std::vector<double>& angles) {
    for (double a : angles) knots.push_back(std::abs(a));
    for (double end : {angles.front(), angles.back()}) {
      knots.push_back(std::abs(end) - nudge_deg);
      knots.push_back(std::abs(end) + nudge_deg);
    }
  };
  add(p.distribution.gamma_deg());
  if (!is_c_gamma(p)) {
    add(p.distribution.c_deg());
    for (int i = 1; i < 3600; ++i) knots.push_back(0.05 * i);
  }
  knots.erase(std::remove_if(knots.begin(), knots.end(), [](double g) { return g < nudge_deg || g > 180; }),
              knots.end());
  std::sort(knots.begin(), knots.end());
  return knots;
}

// The plane C / C + 180 as a function of the signed angle of Beam, tabulated at its knots around the circle.
struct Section {
  const Distribution& distribution;
  double c_deg;
  std::vector<double> angle, value;

  Section(const Photometry& p, double c) : distribution(p.distribution), c_deg(c) {
    angle = knots_of(p);
    const size_t half = angle.size();
    for (size_t i = 0; i < half; ++i) angle.push_back(-angle[i]);
    std::sort(angle.begin(), angle.end());
    for (double a : angle) value.push_back((*this)(a));
  }
  double operator()(double a) const {
    a = std::remainder(a, 360);
    return intensity_at(distribution, a < 0 ? c_deg + 180 : c_deg, std::abs(a));
  }

  size_t peak() const {
    const double highest = *std::max_element(value.begin(), value.end());
    size_t best = angle.size();
    for (size_t i = 0; i < angle.size(); ++i) {
      if (value[i] < highest * (1 - tie)) continue;
      // Ascending angles: of two equally far from the nadir the second is on the side C.
      if (best == angle.size() || std::abs(angle[i]) <= std::abs(angle[best])) best = i;
    }
    return best;
  }

  // From knot `start` around the circle in steps of +1 or -1: where the value falls below the level. False: nowhere.
  bool edge(size_t start, int step, double level, double& result) const {
    const size_t n = angle.size();
    double inside = angle[start], turn = 0;
    for (size_t i = 1, at = start; i < n; ++i) {
      const size_t next = step > 0 ? (at + 1) % n : (at + n - 1) % n;
      if (step > 0 ? next < at : next > at) turn += 360 * step;
      at = next;
      double outside = angle[at] + turn;
      if (value[at] < level) {
        for (int k = 0; k < 60; ++k) {
          const double middle = 0.5 * (inside + outside);
          ((*this)(middle) < level ? outside : inside) = middle;
        }
        result = inside;
        return true;
      }
      inside = outside;
    }
    return false;
  }
};

// For each row of gamma, the integral of the intensity over C, by trapezoids.
std::vector<double> ring_integrals(const Distribution& d) {
  const size_t planes = d.c_deg().size(), rows = d.gamma_deg().size();
  std::vector<double> ring(rows);
  for (size_t i = 0; i < planes; ++i) {
    const double before = i > 0 ? d.c_deg()[i - 1] : d.c_deg()[planes - 1] - 360;
    const double after = i + 1 < planes ? d.c_deg()[i + 1] : d.c_deg()[0] + 360;
    const double weight = radians(0.5 * (after - before));
    for (size_t j = 0; j < rows; ++j) ring[j] += weight * d.at(i, j);
  }
  return ring;
}

double flux_of_rings(const Distribution& d, double from_deg, double to_deg, FluxRule rule) {
  const std::vector<double> ring = ring_integrals(d);
  double flux = 0;
  for (size_t j = 0; j + 1 < ring.size(); ++j) {
    const double low = d.gamma_deg()[j], high = d.gamma_deg()[j + 1];
    const double a = radians(std::max(low, from_deg)), b = radians(std::min(high, to_deg));
    if (!(b > a)) continue;
    const double slope = (ring[j + 1] - ring[j]) / radians(high - low);
    const double ring_a = ring[j] + slope * (a - radians(low)), ring_b = ring[j] + slope * (b - radians(low));
    if (rule == FluxRule::band) {
      flux += 0.5 * (ring[j] + ring[j + 1]) * 2 * std::sin(0.5 * (a + b)) * std::sin(0.5 * (b - a));  // cos a - cos b
    } else {
      flux += ring_a * std::cos(a) - ring_b * std::cos(b) + slope * (std::sin(b) - std::sin(a));
    }
  }
  return flux;
}

// from <= gamma < to; 180 belongs to the last zone.
double flux_of_rays(const std::vector<Ray>& rays, double from_deg, double to_deg) {
  double flux = 0;
  for (const Ray& r : rays) {
    const double gamma = std::atan2(std::hypot(double(r.direction[0]), r.direction[1]), -r.direction[2]) / pi * 180;
    if (gamma >= from_deg && (gamma < to_deg || to_deg >= 180)) flux += r.flux_lm;
  }
  return flux;
}

// Of a cell of a table of type A or B, by midpoints at most half a degree apart: what lies between two cosines of gamma,
// which are those of plane and row multiplied. Not scaled.
double flux_of_cell(const Distribution& d, size_t i, size_t j, int least, double above, double below) {
  const double plane = d.c_deg()[i], width = d.c_deg()[i + 1] - plane, row = d.gamma_deg()[j],
               height = d.gamma_deg()[j + 1] - row;
  const int columns = std::max(least, int(std::ceil(2 * width))), rows = std::max(least, int(std::ceil(2 * height)));
  double sum = 0;
  for (int k = 0; k < rows; ++k) {
    const double t = (k + 0.5) / rows, cosine = std::cos(radians(row + t * height));
    const double first = d.at(i, j) * (1 - t) + d.at(i, j + 1) * t,
                 second = d.at(i + 1, j) * (1 - t) + d.at(i + 1, j + 1) * t;
    for (int l = 0; l < columns; ++l) {
      const double s = (l + 0.5) / columns, of_gamma = cosine * std::cos(radians(plane + s * width));
      if (of_gamma > above && of_gamma <= below) sum += (first * (1 - s) + second * s) * cosine;
    }
  }
  return sum * width * height / (rows * columns);
}

// Of a table of type A or B, cell by cell, so that none is passed over however narrow it is: for shares alone.
double flux_of_cells(const Distribution& d, double from_deg, double to_deg) {
  const size_t planes = d.c_deg().size() - 1, rows = d.gamma_deg().size() - 1;
  const int least = planes * rows <= size_t(1) << 16 ? 4 : 1;
  const double above = to_deg >= 180 ? -2 : std::cos(radians(to_deg)),
               below = from_deg <= 0 ? 2 : std::cos(radians(from_deg));
  double sum = 0;
  for (size_t i = 0; i < planes; ++i)
    for (size_t j = 0; j < rows; ++j) sum += flux_of_cell(d, i, j, least, above, below);
  return sum;
}

}  // namespace

Beam beam_of(const Photometry& photometry, double c_deg, double fraction) {
  const Section section(photometry, c_deg);
  const size_t peak = section.peak();
  Beam beam;
  beam.peak_cd = section.value[peak];
  if (!(beam.peak_cd > 0)) return beam;
  beam.peak_deg = std::abs(section.angle[peak]) <= nudge_deg ? 0 : section.angle[peak];
  beam.from_deg = beam.to_deg = beam.peak_deg;
  double from, to;
  const double level = fraction * beam.peak_cd * (1 - rounding);  // a plateau at the level counts in
  if (!section.edge(peak, -1, level, from) || !section.edge(peak, 1, level, to)) return beam;
  beam.from_deg = from;
  beam.to_deg = to;
  beam.angle_deg = to - from;
  return beam;
}

double flux_lm(const Photometry& photometry) {
  const Distribution& d = photometry.distribution;
  return photometry.rays.empty() ? d.band_flux_lm() : d.interpolated_flux_lm();
}

double lamp_flux_lm(const Photometry& photometry) {
  const double rated = photometry.rated_flux_lm;
  return rated > 0 && flux_lm(photometry) <= most_output_ratio * rated ? rated : -1;
}

double zonal_flux_lm(const Photometry& photometry, double from_deg, double to_deg, FluxRule rule) {
  const Distribution& d = photometry.distribution;
  if (rule == FluxRule::band && !photometry.rays.empty()) return flux_of_rays(photometry.rays, from_deg, to_deg);
  if (is_c_gamma(photometry)) return flux_of_rings(d, from_deg, to_deg, rule);
  const double zone = flux_of_cells(d, from_deg, to_deg), all = flux_of_cells(d, 0, 180);
  const double whole = rule == FluxRule::band ? d.band_flux_lm() : d.interpolated_flux_lm();
  return all > 0 ? whole * zone / all : 0;
}

double projected_area_m2(const Opening& opening, double x, double y, double z) {
  const double length = std::hypot(x, y, z);
  const double n[3] = {x / length, y / length, z / length};
  const double s[3] = {opening.size_m[0], opening.size_m[1], opening.size_m[2]};
  const double faces[3] = {std::abs(n[0]) * s[1] * s[2], std::abs(n[1]) * s[0] * s[2], std::abs(n[2]) * s[0] * s[1]};
  switch (opening.shape) {
    case OpeningShape::point:
      return 0;
    case OpeningShape::rectangle:
    case OpeningShape::box:
      return faces[0] + faces[1] + faces[2];
    case OpeningShape::disc:
      if (s[0] == 0 || s[1] == 0 || s[2] == 0) return pi / 4 * (faces[0] + faces[1] + faces[2]);
      [[fallthrough]];  // one with a height shines as a cylinder does
    case OpeningShape::cylinder: {
      // An end, and a side as wide as the elliptical section is across the direction.
      const int k = opening.axis, i = (k + 1) % 3, j = (k + 2) % 3;
      return pi / 4 * faces[k] + std::hypot(faces[i], faces[j]);
    }
    case OpeningShape::sphere:
      return pi / 4 * std::hypot(faces[0], faces[1], faces[2]);
  }
  return 0;
}

double luminance_cd_m2(const Photometry& photometry, double x, double y, double z) {
  const Opening& opening = photometry.opening;
  const double largest =
      projected_area_m2(opening, 1, 0, 0) + projected_area_m2(opening, 0, 1, 0) + projected_area_m2(opening, 0, 0, 1);
  const double area = projected_area_m2(opening, x, y, z);
  return area > 1e-9 * largest ? photometry.distribution.eval(x, y, z) / area : -1;
}

Metrics metrics_of(const Photometry& photometry) {
  Metrics m;
  for (int i = 0; i < 2; ++i) {
    m.beam[i] = beam_of(photometry, Metrics::plane_deg[i], 0.5);
    m.field[i] = beam_of(photometry, Metrics::plane_deg[i], 0.1);
  }
  for (int i = 0; i < 5; ++i)
    m.zonal_flux_lm[i] = zonal_flux_lm(photometry, Metrics::zone_deg[i][0], Metrics::zone_deg[i][1], FluxRule::band);
  m.down_flux_lm = m.zonal_flux_lm[3];
  m.up_flux_lm = m.zonal_flux_lm[4];
  m.interpolated_down_flux_lm = zonal_flux_lm(photometry, 0, 90, FluxRule::interpolated);
  m.interpolated_up_flux_lm = zonal_flux_lm(photometry, 90, 180, FluxRule::interpolated);
  const double flux = flux_lm(photometry);
  if (const double lamps = lamp_flux_lm(photometry); lamps > 0) m.light_output_ratio = flux / lamps;
  if (photometry.input_power_w > 0) m.efficacy_lm_per_w = flux / photometry.input_power_w;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double c = radians(Metrics::luminance_c_deg[i]), g = radians(Metrics::luminance_gamma_deg[j]);
      m.luminance_cd_m2[i][j] =
          luminance_cd_m2(photometry, std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g));
    }
  }
  return m;
}

}  // namespace photometry
