// The symmetries of planes through an axis. Mirror images copy planes; nothing is ever turned by relabelling angles.
#include "photometry/planes.h"

#include <algorithm>

#include "photometry/text_reader.h"

namespace photometry {
namespace {

using Planes = std::vector<Plane>;

// Into [0, 360).
double wrapped(double c_deg) {
  const double c = std::fmod(c_deg + 720, 360);
  return std::abs(c - 360) < 1e-9 ? 0 : c;
}

void sort_planes(Planes& planes) {
  std::stable_sort(planes.begin(), planes.end(), [](const Plane& a, const Plane& b) { return a.c_deg < b.c_deg; });
}

// Adds the mirror image of every plane about the plane through `about_deg`; planes that are their own image stay
// single.
void mirror(Planes& planes, double about_deg) {
  const size_t n = planes.size();
  for (size_t i = 0; i < n; ++i) planes.push_back({wrapped(2 * about_deg - planes[i].c_deg), planes[i].intensity_cd});
  sort_planes(planes);
  const auto same = [](const Plane& a, const Plane& b) { return std::abs(a.c_deg - b.c_deg) < 1e-9; };
  planes.erase(std::unique(planes.begin(), planes.end(), same), planes.end());
}

// A table must have a plane at 0; where the file has none, the interpolated one changes nothing.
void start_at_zero(Planes& planes) {
  if (planes.front().c_deg < 1e-9) {
    planes.front().c_deg = 0;
    return;
  }
  const Plane &after = planes.front(), &before = planes.back();
  const double s = (360 - before.c_deg) / (360 - before.c_deg + after.c_deg);
  Plane zero{0, {}};
  for (size_t v = 0; v < after.intensity_cd.size(); ++v)
    zero.intensity_cd.push_back(before.intensity_cd[v] * (1 - s) + after.intensity_cd[v] * s);
  planes.insert(planes.begin(), std::move(zero));
}

// The index of an angle in an ascending list, or the list's size.
size_t find_angle(const std::vector<double>& angle, double wanted) {
  const auto at = std::lower_bound(angle.begin(), angle.end(), wanted - 1e-9);
  return at != angle.end() && *at < wanted + 1e-9 ? size_t(at - angle.begin()) : angle.size();
}

// Whether rows and planes have their images: image(index) gives the index of the mirrored one, or past the end.
template <class PlaneImage, class RowImage>
bool repeats(const Distribution& d, const PlaneImage& plane_image, const RowImage& row_image, double share = 1e-12) {
  const size_t planes = d.c_deg().size(), rows = d.gamma_deg().size();
  const double tolerance = share * d.peak_cd();
  for (size_t i = 0; i < planes; ++i) {
    const size_t k = plane_image(i);
    if (k >= planes) return false;
    for (size_t j = 0; j < rows; ++j) {
      const size_t m = row_image(j);
      if (m >= rows || std::abs(d.at(i, j) - d.at(k, m)) > tolerance) return false;
    }
  }
  return true;
}

}  // namespace

void complete_circle(Planes& planes, Symmetry symmetry) {
  if (symmetry == Symmetry::axial) {
    planes.resize(1);
    planes[0].c_deg = 0;
    return;
  }
  for (Plane& p : planes) p.c_deg = wrapped(p.c_deg);
  if (symmetry == Symmetry::c0_c180 || symmetry == Symmetry::quadrants) mirror(planes, 0);
  if (symmetry == Symmetry::c90_c270 || symmetry == Symmetry::quadrants) mirror(planes, 90);
  sort_planes(planes);
  start_at_zero(planes);
}

double open_end_deg(const std::vector<double>& c_deg) {
  double widest = 0;
  for (size_t i = 0; i + 1 < c_deg.size(); ++i) widest = std::max(widest, c_deg[i + 1] - c_deg[i]);
  const double open = 360 - c_deg.back();
  return c_deg.size() > 1 && open > 2 * widest - 1e-3 ? open : 0;
}

void join_ends(Planes& planes, size_t line, std::vector<std::string>& warnings) {
  double peak = 0, difference = 0;
  for (const Plane& p : planes)
    peak = std::max(peak, *std::max_element(p.intensity_cd.begin(), p.intensity_cd.end()));
  for (size_t v = 0; v < planes.front().intensity_cd.size(); ++v) {
    double& a = planes.front().intensity_cd[v];
    const double b = planes.back().intensity_cd[v];
    difference = std::max(difference, std::abs(a - b));
    a = 0.5 * (a + b);
  }
  planes.pop_back();
  if (difference > 0.01 * peak)
    warnings.push_back(at_line(line, "the planes 0 and 360 differ by " + shown(100 * difference / peak) +
                                         " % of the peak; their mean is taken"));
}

void check_poles(const Distribution& d, size_t line, std::vector<std::string>& warnings) {
  const struct {
    size_t row;
    double gamma_deg;
    const char* name;
  } poles[] = {{0, 0, "nadir"}, {d.gamma_deg().size() - 1, 180, "zenith"}};
  if (d.type() != PhotometricType::c) return;
  for (const auto& pole : poles) {
    if (d.gamma_deg()[pole.row] != pole.gamma_deg) continue;
    double low = d.at(0, pole.row), high = low;
    for (size_t i = 1; i < d.c_deg().size(); ++i)
      low = std::min(low, d.at(i, pole.row)), high = std::max(high, d.at(i, pole.row));
    if (high - low > 0.01 * d.peak_cd())
      warnings.push_back(at_line(line, std::string("at the ") + pole.name +
                                           ", which is one direction, the planes are from " + shown(low) + " to " +
                                           shown(high) + " cd; they are used as they are"));
  }
}

Distribution distribution_of(PhotometricType type, Planes planes, std::vector<double> row_deg) {
  std::vector<double> plane_deg, table;
  for (const Plane& p : planes) {
    plane_deg.push_back(p.c_deg);
    table.insert(table.end(), p.intensity_cd.begin(), p.intensity_cd.end());
  }
  return Distribution(type, std::move(plane_deg), std::move(row_deg), std::move(table));
}

Symmetry symmetry_of(const Distribution& d, double tolerance) {
  const std::vector<double>& c = d.c_deg();
  const auto same_row = [](size_t j) { return j; };
  if (repeats(d, [](size_t) { return size_t(0); }, same_row, tolerance)) return Symmetry::axial;
  const auto has = [&](double angle) { return find_angle(c, angle) < c.size(); };
  const auto mirrored = [&](double about) {
    return repeats(d, [&](size_t i) { return find_angle(c, wrapped(2 * about - c[i])); }, same_row, tolerance);
  };
  const bool lateral = has(180) && mirrored(0), across = has(90) && has(270) && mirrored(90);
  return lateral && across ? Symmetry::quadrants
         : lateral         ? Symmetry::c0_c180
         : across          ? Symmetry::c90_c270
                           : Symmetry::none;
}

Symmetry mirror_symmetry_of(const Distribution& d) {
  const auto image = [](const std::vector<double>& angle) {
    return [&angle](size_t i) { return find_angle(angle, -angle[i]); };
  };
  const auto same = [](size_t i) { return i; };
  const auto has_zero = [](const std::vector<double>& angle) { return find_angle(angle, 0) < angle.size(); };
  const bool planes = has_zero(d.c_deg()) && repeats(d, image(d.c_deg()), same);
  const bool rows = has_zero(d.gamma_deg()) && repeats(d, same, image(d.gamma_deg()));
  const bool h = d.type() == PhotometricType::a ? planes : rows, v = d.type() == PhotometricType::a ? rows : planes;
  return h && v ? Symmetry::quadrants : h ? Symmetry::c0_c180 : v ? Symmetry::c90_c270 : Symmetry::none;
}

}  // namespace photometry
