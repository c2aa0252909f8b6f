// The symmetries of IES LM-63 type C. Mirror images copy planes; nothing is ever turned by relabelling angles.
#include "photometry/ies_planes.h"

#include <algorithm>

#include "photometry/text_reader.h"

namespace photometry {
namespace {

using Planes = std::vector<IesPlane>;

// Into [0, 360).
double wrapped(double c_deg) {
  const double c = std::fmod(c_deg + 720, 360);
  return is_near(c, 360) ? 0 : c;
}

void sort_planes(Planes& planes) {
  std::stable_sort(planes.begin(), planes.end(),
                   [](const IesPlane& a, const IesPlane& b) { return a.c_deg < b.c_deg; });
}

// Adds the mirror image of every plane about the plane through `about_deg`; planes that are their own image stay
// single.
void mirror(Planes& planes, double about_deg) {
  const size_t n = planes.size();
  for (size_t i = 0; i < n; ++i) planes.push_back({wrapped(2 * about_deg - planes[i].c_deg), planes[i].intensity_cd});
  sort_planes(planes);
  const auto same = [](const IesPlane& a, const IesPlane& b) { return std::abs(a.c_deg - b.c_deg) < 1e-9; };
  planes.erase(std::unique(planes.begin(), planes.end(), same), planes.end());
}

// 0 to 360 states the first plane twice; without the last one, the circle must close with a step like the one before.
// False where it does not.
bool close_circle(Planes& planes, size_t line, std::vector<std::string>& warnings) {
  const double last = planes.back().c_deg, last_step = last - planes[planes.size() - 2].c_deg;
  if (!is_near(last, 360)) {
    warnings.push_back(at_line(line, "the plane 360 is missing; plane 0 closes the circle"));
    return is_near(last + last_step, 360);
  }
  double peak = 0, difference = 0;
  for (const IesPlane& p : planes)
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
  return true;
}

// A table must have a plane at 0; where the file has none, the interpolated one changes nothing.
void start_at_zero(Planes& planes) {
  if (planes.front().c_deg < 1e-9) {
    planes.front().c_deg = 0;
    return;
  }
  const IesPlane &after = planes.front(), &before = planes.back();
  const double s = (360 - before.c_deg) / (360 - before.c_deg + after.c_deg);
  IesPlane zero{0, {}};
  for (size_t v = 0; v < after.intensity_cd.size(); ++v)
    zero.intensity_cd.push_back(before.intensity_cd[v] * (1 - s) + after.intensity_cd[v] * s);
  planes.insert(planes.begin(), std::move(zero));
}

}  // namespace

Symmetry arrange_ies_planes(Planes& planes, IesEdition edition, size_t line, std::vector<std::string>& warnings) {
  if (planes.size() == 1) {
    planes[0].c_deg = 0;
    return Symmetry::axial;
  }
  const double first = planes.front().c_deg, last = planes.back().c_deg;
  const std::string range = "horizontal angles from " + shown(first) + " to " + shown(last);
  const auto between = [&](double a, double b) { return is_near(first, a) && is_near(last, b); };
  Symmetry symmetry = Symmetry::none;
  if (between(0, 90)) {
    symmetry = Symmetry::quadrants;
  } else if (between(0, 180) || between(180, 360)) {
    symmetry = Symmetry::c0_c180;
  } else if (between(90, 270) || between(-90, 90)) {
    symmetry = Symmetry::c90_c270;
  } else if (!(is_near(first, 0) && last < 360.001 && close_circle(planes, line, warnings))) {
    fail_at(line,
            range + " are not of type C; they must run from 0 to 90, 180 or 360, from 90 to 270, or be a single one");
  }
  if (between(180, 360) || between(-90, 90))
    warnings.push_back(at_line(line, range + " are not of type C; read as one half of a mirrored distribution"));
  if (between(90, 270) && edition != IesEdition::y1995)
    warnings.push_back(at_line(
        line, range + " are not of " + name_of(edition) + "; read as mirrored about the plane 90-270, as in 1995"));

  for (IesPlane& p : planes) p.c_deg = wrapped(p.c_deg);
  if (symmetry == Symmetry::c0_c180 || symmetry == Symmetry::quadrants) mirror(planes, 0);
  if (symmetry == Symmetry::c90_c270 || symmetry == Symmetry::quadrants) mirror(planes, 90);
  sort_planes(planes);
  start_at_zero(planes);
  return symmetry;
}

}  // namespace photometry
