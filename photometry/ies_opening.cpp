// Opening codes of IES LM-63 as tables of signs. A curved dimension is negative; which one may be is what editions
// changed.
#include "photometry/ies_opening.h"

#include <cmath>
#include <string_view>

namespace photometry {
namespace {

enum class Extent { as_written, x_from_width, y_from_height, x_from_height };

struct Code {
  const char* signs;  // width, length, height: '0', '+' or '-'
  OpeningShape shape;
  Extent extent;  // where a dimension written as 0 comes from
  int axis;       // of a cylinder
};

// Codes that all editions share.
constexpr Code common[] = {
    {"000", OpeningShape::point, Extent::as_written, 2},     {"++0", OpeningShape::rectangle, Extent::as_written, 2},
    {"+++", OpeningShape::box, Extent::as_written, 2},       {"0++", OpeningShape::rectangle, Extent::as_written, 2},
    {"+0+", OpeningShape::rectangle, Extent::as_written, 2}, {"+00", OpeningShape::rectangle, Extent::as_written, 2},
    {"0+0", OpeningShape::rectangle, Extent::as_written, 2}, {"00+", OpeningShape::rectangle, Extent::as_written, 2},
};
constexpr Code codes_1986[] = {
    {"-00", OpeningShape::disc, Extent::x_from_width, 2},
    {"-0+", OpeningShape::cylinder, Extent::x_from_width, 2},
    {"-+0", OpeningShape::disc, Extent::as_written, 2},
    {"-++", OpeningShape::sphere, Extent::as_written, 2},
};
constexpr Code codes_1995[] = {
    {"-00", OpeningShape::disc, Extent::x_from_width, 2},
    {"-0-", OpeningShape::sphere, Extent::x_from_width, 2},
    {"-0+", OpeningShape::cylinder, Extent::x_from_width, 2},
    {"0+-", OpeningShape::cylinder, Extent::y_from_height, 0},
    {"+0-", OpeningShape::cylinder, Extent::x_from_height, 1},
    {"-++", OpeningShape::cylinder, Extent::as_written, 2},
    {"+-+", OpeningShape::cylinder, Extent::as_written, 2},
    {"-+-", OpeningShape::sphere, Extent::as_written, 2},
    {"+--", OpeningShape::sphere, Extent::as_written, 2},
    {"-+0", OpeningShape::disc, Extent::as_written, 2},  // not in its table: the elliptical cylinders without a height
    {"+-0", OpeningShape::disc, Extent::as_written, 2},
};
constexpr Code codes_2002[] = {
    {"--0", OpeningShape::disc, Extent::as_written, 2},     {"--+", OpeningShape::cylinder, Extent::as_written, 2},
    {"---", OpeningShape::sphere, Extent::as_written, 2},   {"-+-", OpeningShape::cylinder, Extent::as_written, 0},
    {"+--", OpeningShape::cylinder, Extent::as_written, 1}, {"-0-", OpeningShape::disc, Extent::as_written, 2},
};

template <size_t N>
const Code* find(const Code (&codes)[N], std::string_view signs) {
  for (const Code& code : codes)
    if (signs == code.signs) return &code;
  return nullptr;
}

const Code* find(IesEdition edition, std::string_view signs) {
  if (const Code* code = find(common, signs)) return code;
  if (edition <= IesEdition::y1991) return find(codes_1986, signs);
  return edition == IesEdition::y1995 ? find(codes_1995, signs) : find(codes_2002, signs);
}

}  // namespace

OpeningMatch ies_opening(IesEdition edition, double width, double length, double height, Opening& out) {
  const auto sign = [](double v) { return v > 0 ? '+' : v < 0 ? '-' : '0'; };
  const char signs[] = {sign(width), sign(length), sign(height)};
  const std::string_view key(signs, 3);
  OpeningMatch match = OpeningMatch::edition;
  const Code* code = find(edition, key);
  for (IesEdition other : {IesEdition::y2019, IesEdition::y1995, IesEdition::y1986}) {
    if (code) break;
    code = find(other, key);
    match = OpeningMatch::other_edition;
  }
  const double w = std::abs(width), l = std::abs(length), h = std::abs(height);
  const Code bounds = {"", h > 0 ? OpeningShape::box : OpeningShape::rectangle, Extent::as_written, 2};
  if (!code) code = &bounds, match = OpeningMatch::unknown;
  const Extent extent = code->extent;
  out.shape = code->shape;
  out.axis = code->axis;
  out.size_m[0] = float(extent == Extent::x_from_width ? w : extent == Extent::x_from_height ? h : l);
  out.size_m[1] = float(extent == Extent::y_from_height ? h : w);
  out.size_m[2] = float(h);
  return match;
}

}  // namespace photometry
