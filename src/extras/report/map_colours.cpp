// See map_colours.h.
#include "report/map_colours.h"

#include <algorithm>
#include <cmath>

namespace ups::report {
namespace {

constexpr int parts = 16;
using Table = Ink[parts + 1];

// Of matplotlib, at equal steps: viridis by van der Walt, Smith and Firing, cividis by Nunez, Anderton and Renslow
// (2018). Their lightness rises evenly, also to those who confuse red and green.
// clang-format off
constexpr Table viridis = {
    {68, 1, 84}, {72, 24, 106}, {71, 45, 123}, {66, 64, 134}, {59, 82, 139}, {51, 99, 141}, {44, 114, 142},
    {38, 130, 142}, {33, 145, 140}, {31, 160, 136}, {40, 174, 128}, {63, 188, 115}, {94, 201, 98}, {132, 212, 75},
    {173, 220, 48}, {216, 226, 25}, {253, 231, 37}};
constexpr Table cividis = {
    {0, 34, 78}, {0, 46, 106}, {26, 56, 111}, {50, 67, 109}, {67, 78, 108}, {83, 90, 109}, {97, 101, 111},
    {111, 112, 115}, {125, 124, 120}, {140, 136, 120}, {155, 148, 118}, {171, 160, 114}, {188, 174, 108},
    {205, 187, 99}, {222, 201, 88}, {240, 216, 70}, {254, 232, 56}};
// clang-format on
constexpr Table greys = {
    {60, 60, 60}, {72, 72, 72}, {84, 84, 84}, {95, 95, 95}, {107, 107, 107}, {119, 119, 119}, {130, 130, 130},
    {142, 142, 142}, {154, 154, 154}, {166, 166, 166}, {178, 178, 178}, {189, 189, 189}, {201, 201, 201},
    {213, 213, 213}, {224, 224, 224}, {236, 236, 236}, {248, 248, 248}};

const Table& table_of(MapColours colours) {
  return colours == MapColours::grey ? greys : colours == MapColours::cividis ? cividis : viridis;
}

// The last of the steps people read that is not above `value`.
double step_below(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  double step = power;
  for (const double s : {1.5, 2.0, 3.0, 5.0, 7.5})
    if (s * power <= value * (1 + 1e-9)) step = s * power;
  return step;
}

// The first of them that is not below it.
double step_above(double value) {
  const double below = step_below(value), power = std::pow(10.0, std::floor(std::log10(value)));
  if (below >= value * (1 - 1e-9)) return below;
  for (const double s : {1.5, 2.0, 3.0, 5.0, 7.5})
    if (s * power > below * (1 + 1e-9)) return s * power;
  return 10 * power;
}

}  // namespace

Ink colour_at(MapColours colours, double share) {
  const Table& table = table_of(colours);
  const double place = std::isgreater(share, 0.0) ? parts * std::min(share, 1.0) : 0;  // also of what is no number
  const int from = std::min(int(place), parts - 1);
  Ink ink;
  for (size_t k = 0; k < 3; ++k)
    ink[k] = uint8_t(std::lround(table[from][k] + (place - from) * (table[from + 1][k] - table[from][k])));
  return ink;
}

MapRange range_of(const MapData& data, const MapStyle& style) {
  std::vector<double> values;
  for (const MapValue& v : data.values)
    if (is_known(v)) values.push_back(v.value);
  std::sort(values.begin(), values.end());
  MapRange range;
  range.scale = style.scale;
  if (values.empty() || !(values.back() > 0)) {
    range.scale = MapScale::linear;
    range.low = 0, range.high = 1;
  } else {
    range.least = values.front(), range.most = values.back();
    // Of images single bright pixels would leave the rest dark.
    const double end = data.is_image ? values[size_t(0.995 * double(values.size() - 1))] : values.back();
    range.high = end > 0 ? end : values.back();
    if (style.scale == MapScale::logarithmic) {
      const auto positive = std::upper_bound(values.begin(), values.end(), 0.0);
      const double smallest = data.is_image ? values[size_t(0.005 * double(values.size() - 1))] : *positive;
      range.low = step_below(std::max({smallest, *positive, range.high / 1e4}));
      range.high = step_above(range.high);
      if (!(range.high > range.low)) range.high = step_above(1.01 * range.low);  // one value, which is a step
    } else {
      range.low = range.least > 0.5 * range.high ? range.least : 0;
      if (!(range.high - range.low > 0.02 * range.high)) range.low = 0;
    }
  }
  if (style.high > style.low) range.low = style.low, range.high = style.high;
  range.levels = isoline_levels(range.low, range.high, range.scale);
  if (style.high > style.low || range.scale == MapScale::logarithmic) return range;
  // To whole steps, so that the scale begins and ends with a number; a wider range may have wider steps.
  for (int pass = 0; pass < 3 && range.levels.size() >= 2; ++pass) {
    const double step = range.levels[1] - range.levels[0];
    range.low = step * std::floor(range.low / step + 1e-9);
    range.high = step * std::ceil(range.high / step - 1e-9);
    range.levels = isoline_levels(range.low, range.high, range.scale);
  }
  return range;
}

double MapRange::share(double value) const {
  if (scale == MapScale::linear) return (value - low) / (high - low);
  return value > 0 ? std::log(value / low) / std::log(high / low) : 0;
}

Verdict verdict_of(const MapValue& value, double threshold) {
  if (!is_known(value)) return Verdict::unknown;
  if (!(value.error_bound >= 0)) return Verdict::not_sure;  // an error that is not known crosses everything
  if (value.value - value.error_bound >= threshold) return Verdict::met;
  return value.value + value.error_bound < threshold ? Verdict::not_met : Verdict::not_sure;
}

Ink ink_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::met:
      return {166, 219, 196};
    case Verdict::not_met:
      return {201, 83, 32};
    case Verdict::not_sure:
      return {250, 224, 120};
    default:
      return {225, 225, 225};
  }
}

}  // namespace ups::report
