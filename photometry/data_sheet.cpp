#include "photometry/data_sheet.h"

#include <algorithm>
#include <cmath>

#include "photometry/metrics.h"
#include "photometry/planes.h"

namespace photometry {
namespace {

constexpr double pi = 3.14159265358979323846, degree = pi / 180;
constexpr double rounding = 1e-9;  // of equal luminances the first counts

double intensity(const Photometry& p, double c_deg, double gamma_deg) {
  const double c = c_deg * degree, g = gamma_deg * degree;
  return p.distribution.eval(std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g));
}

double luminance(const Photometry& p, double c_deg, double gamma_deg) {
  const double c = c_deg * degree, g = gamma_deg * degree;
  return luminance_cd_m2(p, std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g));
}

// More angles of a table than these are finer than the steps that are looked at anyway.
constexpr size_t most_angles = 2000;

bool has_own_angles(const Photometry& p, const std::vector<double>& angles) {
  return p.type == PhotometricType::c && angles.size() <= most_angles;
}

// The table's own where it is of type C, and every degree.
std::vector<double> planes_of(const Photometry& p) {
  std::vector<double> planes;
  for (int c = 0; c < 360; ++c) planes.push_back(c);
  if (has_own_angles(p, p.distribution.c_deg()))
    planes.insert(planes.end(), p.distribution.c_deg().begin(), p.distribution.c_deg().end());
  return planes;
}

// The spacing at which `count` luminaires, each `reach` * spacing away in one of the planes, together give what one
// gives under it.
double criterion(const Photometry& p, const std::vector<double>& c_deg, double reach) {
  const double below = intensity(p, 0, 0);
  if (!(below > 0)) return -1;
  const auto enough = [&](double spacing) {
    const double gamma = std::atan(spacing * reach);
    double sum = 0;
    for (double c : c_deg) sum += intensity(p, c, gamma / degree);
    return sum * std::pow(std::cos(gamma), 3) >= below;
  };
  constexpr double step = 0.005, largest = 10;
  double inside = 0, outside = step;
  while (outside <= largest && enough(outside)) inside = outside, outside += step;
  if (outside > largest) return -1;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (inside + outside);
    (enough(middle) ? inside : outside) = middle;
  }
  return inside;
}

// The rating is the first column whose limits hold all; the limits of G0 to G4 and so on.
template <size_t n>
int rating(const double (&lumens)[n], const double (&limits)[n][5]) {
  int worst = 0;
  for (size_t i = 0; i < n; ++i)
    worst = std::max(worst, int(std::find_if(limits[i], limits[i] + 5, [&](double m) { return lumens[i] <= m; }) -
                                limits[i]));
  return worst;
}

// Addendum A to IES TM-15-11, tables: maximum zonal lumens.
constexpr double backlight_limits[3][5] = {
    {110, 500, 1000, 2500, 5000}, {220, 1000, 2500, 5000, 8500}, {110, 500, 1000, 2500, 5000}};  // BL, BM, BH
constexpr double uplight_limits[2][5] = {{0, 10, 50, 500, 1000}, {0, 10, 50, 500, 1000}};        // UL, UH
constexpr double glare_limits[4][5] = {{660, 1800, 5000, 7500, 12000},
                                       {10, 100, 225, 500, 750},
                                       {110, 500, 1000, 2500, 5000},
                                       {10, 100, 225, 500, 750}};  // FH, FVH, BH, BVH
constexpr double glare_limits_v[4][5] = {
    {660, 1800, 5000, 7500, 12000}, {10, 100, 225, 500, 750}, {660, 1800, 5000, 7500, 12000}, {10, 100, 225, 500, 750}};

// The same by the distribution's own samples, which miss nothing, for light that is too narrow for a quadrature.
double front_share_of_needles(const Photometry& p, double front_c_deg, double from, double to) {
  constexpr int side = 100;
  const double x = std::cos(front_c_deg * degree), y = std::sin(front_c_deg * degree);
  int front = 0, all = 0;
  for (int i = 0; i < side * side; ++i) {
    const Distribution::Sample s = p.distribution.sample((i / side + 0.5) / side, (i % side + 0.5) / side);
    const double gamma = std::atan2(std::hypot(s.x, s.y), -s.z) / degree;
    if (!(gamma >= from && gamma <= to && s.pdf_w > 0)) continue;
    ++all;
    front += s.x * x + s.y * y > 0;
  }
  return all > 0 ? double(front) / all : 0;
}

// Of the flux between two gammas, the share that goes to the front.
double front_share(const Photometry& p, double front_c_deg, double from, double to) {
  const int rows = std::max(1, int(std::ceil(2 * (to - from))));
  double front = 0, all = 0;
  for (int j = 0; j < rows; ++j) {
    const double g = from + (j + 0.5) * (to - from) / rows, sine = std::sin(g * degree);
    for (int i = 0; i < 360; ++i) {
      const double flux = intensity(p, front_c_deg - 90 + i + 0.5, g) * sine;
      all += flux;
      if (i < 180) front += flux;
    }
  }
  return all > 0 ? front / all : front_share_of_needles(p, front_c_deg, from, to);
}

}  // namespace

FluxCode flux_code(const Photometry& p) {
  const auto below = [&](double gamma) { return zonal_flux_lm(p, 0, gamma, FluxRule::band); };
  const double down = below(90), all = flux_lm(p), lamps = lamp_flux_lm(p);
  const auto percent = [](double part, double whole) { return whole > 0 ? 100 * part / whole : 0; };
  const double quarter = std::acos(0.75) / degree, three_quarters = std::acos(0.25) / degree;
  return {{percent(below(quarter), down), percent(below(60), down), percent(below(three_quarters), down),
           percent(down, all), lamps > 0 ? percent(all, lamps) : 100}};
}

HighLuminance high_luminance(const Photometry& p) {
  HighLuminance out;
  const std::vector<double> planes = planes_of(p);
  const auto look = [&](double gamma, double& at) {
    for (double c : planes) {
      const double l = luminance(p, c, gamma);
      at = std::max(at, l);
      if (l > out.highest_cd_m2 * (1 + rounding)) out.highest_cd_m2 = l, out.c_deg = c, out.highest_gamma_deg = gamma;
    }
  };
  for (int k = 0; k < 3; ++k) look(HighLuminance::gamma_deg[k], out.at_cd_m2[k]);
  double ignored = -1;
  for (int i = 131; i < 170; ++i) look(0.5 * i, ignored);
  if (!has_own_angles(p, p.distribution.gamma_deg())) return out;
  for (double gamma : p.distribution.gamma_deg())
    if (gamma > 65 && gamma < 85) look(gamma, ignored);
  return out;
}

SpacingCriterion spacing_criterion(const Photometry& p) {
  return {criterion(p, {0, 180}, 0.5), criterion(p, {90, 270}, 0.5), criterion(p, {45, 135, 225, 315}, std::sqrt(0.5))};
}

int nema_type(double field_angle_deg) {
  constexpr double above[] = {18, 29, 46, 70, 100, 130};
  if (!(field_angle_deg >= 10)) return 0;
  return 1 + int(std::count_if(std::begin(above), std::end(above), [&](double a) { return field_angle_deg > a; }));
}

BugRating bug_rating(const Photometry& p, double front_c_deg) {
  constexpr double edges[5] = {0, 30, 60, 80, 90};
  BugRating out{};
  for (int i = 0; i < 4; ++i) {
    const double flux = zonal_flux_lm(p, edges[i], edges[i + 1], FluxRule::band);
    out.front_lm[i] = flux * front_share(p, front_c_deg, edges[i], edges[i + 1]);
    out.back_lm[i] = flux - out.front_lm[i];
  }
  out.up_lm[0] = zonal_flux_lm(p, 90, 100, FluxRule::band);
  out.up_lm[1] = zonal_flux_lm(p, 100, 180, FluxRule::band);
  // Stated, or seen in values that are measured: a file may write the whole circle out.
  const auto is_v = [](Symmetry s) { return s == Symmetry::axial || s == Symmetry::quadrants; };
  out.type_v = is_v(p.symmetry) || (p.type == PhotometricType::c && is_v(symmetry_of(p.distribution, 0.01)));
  out.backlight = rating({out.back_lm[0], out.back_lm[1], out.back_lm[2]}, backlight_limits);
  out.uplight = rating({out.up_lm[0], out.up_lm[1]}, uplight_limits);
  const double high[4] = {out.front_lm[2], out.front_lm[3], out.back_lm[2], out.back_lm[3]};
  out.glare = rating(high, out.type_v ? glare_limits_v : glare_limits);
  return out;
}

UtilisationFactors utilisation_factors(const Photometry& p) {
  const double flux = flux_lm(p);
  const RoomRays rays(p.distribution);
  const double lamps = lamp_flux_lm(p), output_ratio = lamps > 0 ? flux / lamps : 1;
  UtilisationFactors out;
  for (int r = 0; r < UtilisationFactors::rooms; ++r) {
    const double side = 2 * UtilisationFactors::room_index[r];
    const RoomShape room{side, side};
    const RoomFlux direct = rays.direct_shares(room, 0, 0);
    for (int k = 0; k < UtilisationFactors::reflectance_sets; ++k)
      out.factor[r][k] = output_ratio * exchange(room, UtilisationFactors::reflectances[k], direct)[0];
  }
  return out;
}

}  // namespace photometry
