// The angle ranges of IES LM-63. Type C: parts of a circle, by edition. Types A and B: from -90 to 90, or from 0 where
// the other half is the mirror image; tables that end earlier are read as dark beyond.
#include "photometry/ies_planes.h"

#include <algorithm>

#include "photometry/text_reader.h"

namespace photometry {
namespace {

struct Context {
  IesEdition edition;
  AngleLines lines;
  std::vector<std::string>& warnings;
  void warn(size_t line, const std::string& what) const { warnings.push_back(at_line(line, what)); }
};

std::string range_text(const char* kind, double first, double last) {
  return std::string(kind) + " angles from " + shown(first) + " to " + shown(last);
}

// Without the plane 360, the circle must close with a step like the one before. False where it does not.
bool close_circle(std::vector<Plane>& planes, const Context& context) {
  const double last = planes.back().c_deg, last_step = last - planes[planes.size() - 2].c_deg;
  if (last == 360) {
    join_ends(planes, context.lines.horizontal, context.warnings);
    return true;
  }
  context.warn(context.lines.horizontal, "the plane 360 is missing; plane 0 closes the circle");
  return is_near(last + last_step, 360);
}

Distribution arrange_c(IesTable table, const Context& context, Symmetry& symmetry) {
  std::vector<double>& vertical = table.vertical_deg;
  double &lowest = vertical.front(), &highest = vertical.back();
  if (is_near(lowest, 0)) lowest = 0;  // or the pole itself would be dark
  if (is_near(highest, 180)) highest = 180;
  if (lowest < 0 || highest > 180)
    fail_at(context.lines.vertical, range_text("vertical", lowest, highest) + " are not within 0 to 180 of type C");
  if (!(is_near(lowest, 0) || is_near(lowest, 90)) || !(is_near(highest, 90) || is_near(highest, 180)))
    context.warn(context.lines.vertical, range_text("vertical", lowest, highest) +
                 " do not reach the poles or the horizon; nothing is emitted beyond them");

  std::vector<Plane>& planes = table.planes;
  symmetry = Symmetry::axial;
  if (planes.size() > 1) {
    double &first = planes.front().c_deg, &last = planes.back().c_deg;
    for (double* end : {&first, &last})
      for (double nominal : {-90.0, 0.0, 90.0, 180.0, 270.0, 360.0})
        if (is_near(*end, nominal)) *end = nominal;
    const std::string range = range_text("horizontal", first, last);
    const auto between = [&](double a, double b) { return first == a && last == b; };
    const bool half = between(180, 360) || between(-90, 90), across = between(90, 270);
    symmetry = between(0, 90)                        ? Symmetry::quadrants
               : between(0, 180) || between(180, 360) ? Symmetry::c0_c180
               : across || between(-90, 90)           ? Symmetry::c90_c270
                                                      : Symmetry::none;
    if (symmetry == Symmetry::none && !(first == 0 && last <= 360 && close_circle(planes, context)))
      fail_at(context.lines.horizontal,
              range + " are not of type C; they must run from 0 to 90, 180 or 360, from 90 to 270, or be a single one");
    if (half)
      context.warn(context.lines.horizontal, range + " are not of type C; read as one half of a mirrored distribution");
    if (across && context.edition != IesEdition::y1995)
      context.warn(context.lines.horizontal, range + " are not of " + name_of(context.edition) +
                   "; read as mirrored about the plane 90-270, as in 1995");
  }
  complete_circle(planes, symmetry);
  Distribution out = distribution_of(PhotometricType::c, std::move(planes), std::move(vertical));
  check_poles(out, context.lines.horizontal, context.warnings);
  return out;
}

// Whether the angles state one half of what is mirrored about 0. Warns about what is not -90 or 0 to 90.
bool is_half(std::vector<double>& angle, const char* kind, size_t line, const Context& context) {
  const auto snap = [](double& a) {
    for (double nominal : {-90.0, 0.0, 90.0})
      if (is_near(a, nominal)) a = nominal;
  };
  snap(angle.front());
  snap(angle.back());
  const bool half = angle.front() == 0;
  if ((!half && angle.front() != -90) || angle.back() != 90)
    context.warn(line, range_text(kind, angle.front(), angle.back()) + " do not run from -90 or 0 to 90" +
                 (half ? "; they are mirrored about 0, and nothing is emitted beyond them"
                       : "; nothing is emitted beyond them"));
  return half;
}

void mirror_planes(std::vector<Plane>& planes) {
  for (size_t i = 1, n = planes.size(); i < n; ++i) planes.push_back({-planes[i].c_deg, planes[i].intensity_cd});
  std::sort(planes.begin(), planes.end(), [](const Plane& a, const Plane& b) { return a.c_deg < b.c_deg; });
}

// Rows become planes and planes rows.
void transpose(std::vector<Plane>& planes, std::vector<double>& row_deg) {
  std::vector<Plane> turned;
  for (size_t j = 0; j < row_deg.size(); ++j) {
    turned.push_back({row_deg[j], {}});
    for (const Plane& p : planes) turned.back().intensity_cd.push_back(p.intensity_cd[j]);
  }
  row_deg.clear();
  for (const Plane& p : planes) row_deg.push_back(p.c_deg);
  planes = std::move(turned);
}

Distribution arrange_a_or_b(IesTable table, const Context& context, Symmetry& symmetry) {
  const char* name = table.type == PhotometricType::a ? "A" : "B";
  if (table.planes.size() < 2)
    fail_at(context.lines.horizontal, std::string("there is a single horizontal angle; a table of type ") + name +
                              " needs at least 2, as it is not symmetric about its axis");
  std::vector<double> horizontal;
  for (const Plane& p : table.planes) horizontal.push_back(p.c_deg);
  const bool h = is_half(horizontal, "horizontal", context.lines.horizontal, context),
             v = is_half(table.vertical_deg, "vertical", context.lines.vertical, context);
  for (size_t i = 0; i < horizontal.size(); ++i) table.planes[i].c_deg = horizontal[i];
  symmetry = h && v ? Symmetry::quadrants : h ? Symmetry::c0_c180 : v ? Symmetry::c90_c270 : Symmetry::none;
  if ((h && v ? 4 : h || v ? 2 : 1) * table.planes.size() * table.vertical_deg.size() > Distribution::max_values)
    fail_at(context.lines.horizontal, "with their mirror images the candelas are too many; at most 4000000 are kept");
  if (h) mirror_planes(table.planes);
  transpose(table.planes, table.vertical_deg);  // planes of equal V
  if (v) mirror_planes(table.planes);
  if (table.type == PhotometricType::a) transpose(table.planes, table.vertical_deg);
  return distribution_of(table.type, std::move(table.planes), std::move(table.vertical_deg));
}

}  // namespace

Distribution arrange_ies_table(IesTable table, IesEdition edition, const AngleLines& lines, Symmetry& symmetry,
                               std::vector<std::string>& warnings) {
  const Context context{edition, lines, warnings};
  return table.type == PhotometricType::c ? arrange_c(std::move(table), context, symmetry)
                                          : arrange_a_or_b(std::move(table), context, symmetry);
}

}  // namespace photometry
