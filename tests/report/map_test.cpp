// Maps: where isolines run, what the colours and verdicts are, how they are drawn.
#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string_view>

#include "report/map_data.h"
#include "report/map_plot.h"

namespace ups::report {
namespace {

constexpr double pi = 3.14159265358979;

// A grid over a square of 4 m around the origin.
template <class Value>
MapData grid_of(uint32_t columns, uint32_t rows, const Value& value) {
  MapData data;
  data.title = "plane";
  data.quantity = "Illuminance";
  data.unit = "lx";
  data.columns = columns, data.rows = rows;
  for (uint32_t r = 0; r < rows; ++r)
    for (uint32_t c = 0; c < columns; ++c) {
      const Place p{-2 + 4 * (c + 0.5) / columns, -2 + 4 * (r + 0.5) / rows};
      data.values.push_back({p, value(p), 1});
    }
  return data;
}

std::multiset<std::string> labels_of(const Drawing& drawing) {
  std::multiset<std::string> labels;
  for (const auto& part : drawing.parts)
    if (const auto* label = std::get_if<Label>(&part)) labels.insert(label->text);
  return labels;
}

// Of a rectangle of its PNG, a unit a pixel.
std::set<uint32_t> colours_within(const Drawing& drawing, int left, int top, int right, int bottom) {
  const std::string png = to_png(drawing, 1);
  std::string_view rest = png;
  const auto read = [](void* from, unsigned char* to, unsigned int size) {
    auto& bytes = *static_cast<std::string_view*>(from);
    if (bytes.size() < size) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(to, bytes.data(), size);
    bytes.remove_prefix(size);
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* surface = cairo_image_surface_create_from_png_stream(read, &rest);
  EXPECT_EQ(cairo_surface_status(surface), CAIRO_STATUS_SUCCESS);
  const unsigned char* pixels = cairo_image_surface_get_data(surface);
  std::set<uint32_t> colours;
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      uint32_t pixel;
      std::memcpy(&pixel, pixels + y * cairo_image_surface_get_stride(surface) + 4 * x, 4);
      colours.insert(pixel & 0xffffff);
    }
  cairo_surface_destroy(surface);
  return colours;
}

TEST(Isolines, OfARadialFieldAreCircles) {
  const MapData data = grid_of(40, 30, [](const Place& p) { return 1000 / (1 + p.x * p.x + p.y * p.y); });
  const MapField field(data);
  const std::vector<double> levels = {300, 400, 500, 750};
  const std::vector<Isoline> lines = isolines_of(field, levels);
  ASSERT_EQ(lines.size(), levels.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    const double radius = std::sqrt(1000 / levels[i] - 1);
    EXPECT_EQ(lines[i].level, levels[i]);
    EXPECT_EQ(lines[i].points.front().x, lines[i].points.back().x) << "it is closed";
    double length = 0;
    for (size_t k = 0; k < lines[i].points.size(); ++k) {
      const Place p = lines[i].points[k];
      EXPECT_NEAR(std::hypot(p.x, p.y), radius, 0.004) << levels[i];  // a 25th of a cell
      if (k > 0) length += std::hypot(p.x - lines[i].points[k - 1].x, p.y - lines[i].points[k - 1].y);
    }
    EXPECT_NEAR(length, 2 * pi * radius, 0.01 * radius);
  }
}

TEST(Isolines, EndAtTheBorderAndAtGaps) {
  MapData data = grid_of(8, 8, [](const Place& p) { return 100 + 10 * p.x; });
  for (const Isoline& line : isolines_of(MapField(data), {105})) {
    EXPECT_NEAR(std::min(line.points.front().y, line.points.back().y), -2, 1e-9);
    EXPECT_NEAR(std::max(line.points.front().y, line.points.back().y), 2, 1e-9);
    for (const Place& p : line.points) EXPECT_NEAR(p.x, 0.5, 1e-6);
  }
  for (MapValue& v : data.values)
    if (v.at.y > 0) v.value = -1;  // not known
  const std::vector<Isoline> lines = isolines_of(MapField(data), {105});
  ASSERT_EQ(lines.size(), 1u);
  for (const Place& p : lines[0].points) EXPECT_LE(p.y, 1e-9);
}

// However many meters there are.
TEST(Isolines, GoAroundASingleMeter) {
  for (const uint32_t side : {7u, 110u, 130u, 300u}) {
    MapData data = grid_of(side, side, [](const Place&) { return 600.0; });
    data.values[(side / 2) * (side + 1)].value = 400;
    EXPECT_EQ(isolines_of(MapField(data), {500}).size(), 1u) << side;
  }
}

// A grid's image has a meter a pixel: a mean over its neighbours would be 475 lx.
TEST(Isolines, OfAnImageOfAGridAreThoseOfItsMeters) {
  MapData data = grid_of(16, 12, [](const Place&) { return 300.0; });
  data.values[100].value = 1000;
  data.is_image = true;
  const MapData calm = calmed(data);
  const std::vector<Isoline> lines = isolines_of(MapField(calm), {500}), own = isolines_of(MapField(data), {500});
  ASSERT_EQ(own.size(), 1u);
  ASSERT_EQ(lines.size(), 1u);
  ASSERT_EQ(lines[0].points.size(), own[0].points.size());
  for (size_t i = 0; i < own[0].points.size(); ++i) {
    EXPECT_EQ(lines[0].points[i].x, own[0].points[i].x);
    EXPECT_EQ(lines[0].points[i].y, own[0].points[i].y);
  }
  EXPECT_EQ(calmed(grid_of(100, 75, [](const Place&) { return 300.0; })).columns, 50u) << "of more pixels blocks";
}

TEST(Isolines, OfASaddleDoNotCross) {
  const MapData data = grid_of(20, 20, [](const Place& p) { return 100 + 20 * p.x * p.y; });
  const std::vector<Isoline> lines = isolines_of(MapField(data), {99.9, 100.1});
  EXPECT_EQ(lines.size(), 4u);
  for (const Isoline& line : lines)
    for (const Place& p : line.points) EXPECT_GT((line.level - 100) * p.x * p.y, -1e-9) << "on its own side";
}

TEST(Isolines, HaveLevelsThatPeopleRead) {
  EXPECT_EQ(isoline_levels(0, 1000, MapScale::linear),
            (std::vector<double>{100, 200, 300, 400, 500, 600, 700, 800, 900, 1000}));
  EXPECT_EQ(isoline_levels(420, 610, MapScale::linear),
            (std::vector<double>{420, 440, 460, 480, 500, 520, 540, 560, 580, 600}));
  EXPECT_EQ(isoline_levels(50, 800, MapScale::logarithmic),
            (std::vector<double>{50, 75, 100, 150, 200, 300, 500, 750}));
  EXPECT_TRUE(isoline_levels(5, 5, MapScale::linear).empty());
}

TEST(MapField, StaysBetweenTheValuesAround) {
  const MapData data = grid_of(6, 6, [](const Place& p) { return p.x > 0 ? 1000.0 : 0.0; });  // an edge of shadow
  const MapField field(data);
  for (double x = 0.01; x < 6; x += 0.07)
    for (double y = 0.01; y < 6; y += 0.31) {
      const double v = field.between(x, y, int64_t(x), int64_t(y));
      EXPECT_GE(v, 0);
      EXPECT_LE(v, 1000);
    }
  EXPECT_EQ(field.between(2.5, 3.5, 2, 3), 0);
  EXPECT_EQ(field.between(3.5, 3.5, 3, 3), 1000);
  EXPECT_NEAR(field.between(2.999999, 3.2, 2, 3), field.between(3.000001, 3.2, 3, 3), 0.01);
}

// The points of EN 12464-1 in an L of 4 m, a quarter left out.
MapData points_in_an_l() {
  MapData data = grid_of(8, 8, [](const Place& p) { return 300 + 20 * p.x; });
  data.columns = data.rows = 0;
  std::erase_if(data.values, [](const MapValue& v) { return v.at.x > 0 && v.at.y > 0; });
  std::reverse(data.values.begin(), data.values.end());
  return data;
}

TEST(MapField, FindsTheLatticeOfPointsAndDrawsNothingInItsGaps) {
  const MapData data = points_in_an_l();
  const MapField field(data);
  ASSERT_TRUE(field.lattice());
  EXPECT_EQ(field.lattice()->columns, 8u);
  EXPECT_EQ(field.lattice()->rows, 8u);
  EXPECT_EQ(field.nearest({1.2, 1.2}), Lattice::none);
  EXPECT_NE(field.nearest({1.2, -0.1}), Lattice::none);
  const Drawing drawing = map_drawing(data, {});
  const auto is_picture = [](const auto& part) { return std::holds_alternative<Picture>(part); };
  const auto& picture = std::get<Picture>(*std::find_if(drawing.parts.begin(), drawing.parts.end(), is_picture));
  size_t filled = 0;
  for (size_t i = 3; i < picture.rgba.size(); i += 4) filled += picture.rgba[i] == 255;
  EXPECT_NEAR(double(filled) / double(picture.columns * picture.rows), 0.75, 0.005);
}

TEST(MapField, OfPointsWithoutALatticeGivesEachItsSurroundings) {
  MapData data;
  for (int i = 0; i < 30; ++i)
    data.values.push_back({{std::fmod(i * 0.618034, 1) * 5, i * 0.1 + 0.003 * i * i}, 100.0 + i, 1});
  const MapField field(data);
  ASSERT_FALSE(field.lattice());
  for (size_t i = 0; i < data.values.size(); ++i) {
    EXPECT_EQ(field.nearest(data.values[i].at), i);
    for (const Place& p : field.cell(i))  // its corners are no nearer to another point
      for (const MapValue& other : data.values)
        EXPECT_GE(std::hypot(p.x - other.at.x, p.y - other.at.y) + 1e-9,
                  std::hypot(p.x - data.values[i].at.x, p.y - data.values[i].at.y));
  }
}

TEST(Verdicts, FollowTheBounds) {
  EXPECT_EQ(verdict_of({{0, 0}, 510, 9}, 500), Verdict::met);
  EXPECT_EQ(verdict_of({{0, 0}, 510, 11}, 500), Verdict::not_sure);
  EXPECT_EQ(verdict_of({{0, 0}, 490, 11}, 500), Verdict::not_sure);
  EXPECT_EQ(verdict_of({{0, 0}, 490, 9}, 500), Verdict::not_met);
  EXPECT_EQ(verdict_of({{0, 0}, 900, -1}, 500), Verdict::not_sure) << "an unknown error crosses every threshold";
  EXPECT_EQ(verdict_of({{0, 0}, -1, 1}, 500), Verdict::unknown);
}

TEST(Colours, RiseInLightnessFromLowToHigh) {
  const auto lightness = [](const Ink& ink) {  // CIE L*
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    const double r = linear(ink[0] / 255.0), g = linear(ink[1] / 255.0), b = linear(ink[2] / 255.0);
    const double y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
  };
  for (const MapColours colours : {MapColours::viridis, MapColours::cividis, MapColours::grey}) {
    for (int i = 0; i < 50; ++i)
      EXPECT_LT(lightness(colour_at(colours, i / 50.0)), lightness(colour_at(colours, (i + 1) / 50.0))) << i;
    EXPECT_GT(lightness(colour_at(colours, 1)) - lightness(colour_at(colours, 0)), 65);
  }
  EXPECT_GT(lightness(ink_of(Verdict::met)) - lightness(ink_of(Verdict::not_met)), 30) << "told apart in grey too";
}

TEST(MapRange, IsRoundedAndSaysWhatLiesBeyond) {
  const MapData data = grid_of(10, 10, [](const Place& p) { return 500 + 200 * p.x; });
  const MapRange range = range_of(data, {});
  EXPECT_EQ(range.low, 0);
  EXPECT_EQ(range.high, 900);
  MapStyle style;
  style.low = 200, style.high = 600;
  const auto labels = labels_of(map_drawing(data, style));
  EXPECT_TRUE(labels.count("\u2265 600"));
  EXPECT_TRUE(labels.count("\u2264 200"));
  style.scale = MapScale::logarithmic;
  EXPECT_NEAR(range_of(data, style).share(std::sqrt(200.0 * 600.0)), 0.5, 1e-9);
}

TEST(MapRange, HasBothItsEndsBesideLevelsThatAreNear) {
  MapData data = grid_of(10, 10, [](const Place& p) { return 250 + 100 * p.x; });
  data.values[5].value = 5000;
  MapStyle style;
  style.low = 0, style.high = 510;
  const auto labels = labels_of(map_drawing(data, style));
  EXPECT_TRUE(labels.count("\u2265 510"));
  EXPECT_TRUE(labels.count("0"));
  EXPECT_TRUE(labels.count("400"));
}

// Images of few pixels are enlarged, and between two pixels nothing is known.
TEST(Map, OfCellsOrVerdictsHasNoColoursBetweenThem) {
  MapData data = grid_of(4, 4, [](const Place& p) { return p.x * p.y > 0 ? 700.0 : 300.0; });
  data.is_image = true;
  MapStyle cells, verdicts;
  cells.cells = true, cells.isolines = false;
  verdicts.threshold = 500;
  for (const MapStyle& style : {cells, verdicts}) {  // 4 x 115 units a side, from (14, 60) on
    EXPECT_EQ(colours_within(map_drawing(data, style), 17, 63, 470, 516).size(), 2u) << style.threshold;
  }
  MapStyle smooth;
  smooth.isolines = false;
  EXPECT_GT(colours_within(map_drawing(data, smooth), 17, 63, 470, 516).size(), 20u);
}

// 499.6 lx is not 500 lx where 500 are wanted.
TEST(Map, NumbersAreOnTheSideOfTheirVerdict) {
  const MapData data = grid_of(4, 4, [](const Place& p) { return p.x * p.y > 0 ? 700.0 : 499.6; });
  MapStyle style;
  style.threshold = 500;
  const auto labels = labels_of(map_drawing(data, style));
  EXPECT_TRUE(labels.count("499.6") || labels.count("min 499.6"));
  EXPECT_FALSE(labels.count("min 500"));
  EXPECT_LE(labels.count("500"), 2u) << "beside those of the scale and of the line";
}

TEST(Map, HasItsWordsAndNoTwoNumbersInOnePlace) {
  MapData data = grid_of(24, 18, [](const Place& p) { return 200 + 600 * std::exp(-p.x * p.x - p.y * p.y); });
  data.summary = "mean 123 lx";
  data.luminaires = {{{0, 0}, {{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.3, 0.3}}}};
  data.observers = {{{1, -1}, {0, 1}, "desk 1"}};
  data.room = {{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}, {-2, -2}}, true}};
  data.north_y = 1;
  const Drawing drawing = map_drawing(data, {});
  const auto labels = labels_of(drawing);
  for (const char* words :
       {"Illuminance, lx: plane", "mean 123 lx", "lx", "N", "0.5 m", "luminaire", "observer", "desk 1"})
    EXPECT_TRUE(labels.count(words)) << words;
  EXPECT_GE(labels.count("400"), 2u) << "at the scale and on its line";
  EXPECT_LE(drawing.width, 680);
  EXPECT_LE(drawing.height, 570);
  std::vector<const Label*> numbers;
  for (const auto& part : drawing.parts)
    if (const auto* label = std::get_if<Label>(&part); label && label->anchor == Anchor::middle && label->text != "N")
      numbers.push_back(label);
  EXPECT_GT(numbers.size(), 60u);
  for (const Label* a : numbers)
    for (const Label* b : numbers) {
      if (a == b || a->turn_rad != 0 || b->turn_rad != 0) continue;
      const double apart = 0.5 * (width_of(a->text, a->size, a->bold) + width_of(b->text, b->size, b->bold));
      EXPECT_TRUE(std::abs(a->at.x - b->at.x) > apart || std::abs(a->at.y - b->at.y) > 7) << a->text << " " << b->text;
    }
  EXPECT_EQ(map_description(data, {}).find("Illuminance, lx: plane. mean 123 lx."), 0u);
  MapStyle style;
  style.threshold = 500;
  EXPECT_TRUE(labels_of(map_drawing(data, style)).count("\u2265 500 lx"));
  EXPECT_NE(map_description(data, style).find("not met at"), std::string::npos);
  MapData nearly = grid_of(50, 50, [](const Place&) { return 600.0; });
  nearly.values[1275].value = 400;
  EXPECT_FALSE(labels_of(map_drawing(nearly, style)).count("100 %")) << "one of 2500 fails";
  EXPECT_TRUE(labels_of(map_drawing(nearly, style)).count("99.96 %"));
}

TEST(Map, IsTheSameBytesEachTimeAndItsIdsCanBeToldApart) {
  const MapData data = grid_of(6, 5, [](const Place& p) { return 500 + 50 * p.x; });
  const Drawing drawing = map_drawing(data, {});
  const Words words{"a title <&>", "what is seen"};
  const std::string svg = to_svg(drawing, words, "a-");
  EXPECT_EQ(svg, to_svg(map_drawing(data, {}), words, "a-"));
  EXPECT_EQ(to_pdf(drawing, words), to_pdf(drawing, words));
  EXPECT_EQ(to_png(drawing, 1), to_png(drawing, 1));
  EXPECT_NE(svg.find("<title id=\"a-ititle\">a title &lt;&amp;&gt;</title>"), std::string::npos);
  for (size_t at = svg.find(" id=\""); at != std::string::npos; at = svg.find(" id=\"", at + 1))
    EXPECT_EQ(svg.compare(at + 5, 3, "a-i"), 0);
}

TEST(Maps, OfOneValueHaveAScaleAndColours) {
  for (const double value : {1.0, 3.0, 7.0, 7.5, 1e-30, 1e30}) {
    const MapData data = grid_of(4, 3, [&](const Place&) { return value; });
    for (const MapScale scale : {MapScale::linear, MapScale::logarithmic}) {
      MapStyle style;
      style.scale = scale;
      const MapRange range = range_of(data, style);
      EXPECT_LT(range.low, range.high) << value;
      EXPECT_GE(range.share(value), 0) << value;
      EXPECT_LE(range.share(value), 1 + 1e-9) << value;
      EXPECT_FALSE(map_drawing(data, style).parts.empty());
    }
  }
  EXPECT_EQ(colour_at(MapColours::viridis, NAN), colour_at(MapColours::viridis, 0));
}

TEST(MapData, OfALeaningWallIsSeenFromItsFront) {
  // A grid that leans back by 45 degrees, facing south and up; columns run east.
  std::vector<MeterPoint> points;
  std::vector<double> positions;
  const double s = std::sqrt(0.5);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) {
      points.push_back({{1.0 * c, r * s, 2 + r * s}, {0, -s, s}, 100.0 + c, 1});
      positions.insert(positions.end(), points.back().position_m, points.back().position_m + 3);
    }
  EXPECT_EQ(columns_of(positions.data(), points.size()), 4u);
  const auto data = meter_map("wall", points, 4, nullptr);
  ASSERT_TRUE(data);
  EXPECT_NEAR(data->values[1].at.x - data->values[0].at.x, 1, 1e-9);
  EXPECT_NEAR(data->values[4].at.y - data->values[0].at.y, 1, 1e-9);
  EXPECT_NEAR(data->values[4].at.x, data->values[0].at.x, 1e-9);
  // The same as a list in any order; on a line or in space there is no map.
  std::reverse(points.begin(), points.end());
  EXPECT_TRUE(MapField(*meter_map("wall", points, 0, nullptr)).lattice());
  EXPECT_FALSE(meter_map("line", {points[0], points[1], points[2]}, 0, nullptr));
  points[5].position_m[2] += 0.3;
  EXPECT_FALSE(meter_map("space", points, 0, nullptr));
}

// From the top and from the west, as one reads: north is up, and nothing is mirrored.
TEST(MapData, OfAListInReadingOrderIsNoMirrorImage) {
  std::vector<MeterPoint> points;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) points.push_back({{1.0 * c, 3.0 - r, 0.75}, {0, 0, 1}, 100.0 + 10 * r + c, 1});
  const auto data = meter_map("read", points, 4, nullptr);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->north, "N");
  EXPECT_NEAR(data->north_y, 1, 1e-9);
  for (const MapValue& v : data->values) {  // x from the west, y from the south
    const Place at{v.at.x - data->values[0].at.x, v.at.y - data->values[0].at.y};
    const int c = int(std::lround(at.x)), r = 2 - int(std::lround(at.y));
    EXPECT_EQ(v.value, 100 + 10 * r + c);
  }
  ASSERT_TRUE(MapField(*data).lattice());
  EXPECT_EQ(MapField(*data).lattice()->step_y, 1);
}

// Seen from above its columns run west, as its image file shows them: a list of points would be turned.
TEST(MapData, OfAMirroredGridHasItsRow0Below) {
  std::vector<MeterPoint> points;
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 3; ++c) points.push_back({{-1.0 * c, 1.0 * r, 0.75}, {0, 0, 1}, 100.0 + 10 * r + c, 1});
  const auto data = meter_map("mirrored", points, 3, nullptr, true);
  ASSERT_TRUE(data);
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(data->values[i].value, points[i].illuminance_lx);
    EXPECT_NEAR(data->values[i].at.x - data->values[0].at.x, double(i % 3), 1e-9);
    EXPECT_NEAR(data->values[i].at.y - data->values[0].at.y, double(i / 3), 1e-9);
  }
  EXPECT_NEAR(data->north_y, 1, 1e-9);
  EXPECT_EQ(meter_map("listed", points, 3, nullptr)->values[0].value, points[3].illuminance_lx);
}

TEST(MapData, OfALeaningLatticeIsNoGridOfRectangles) {
  std::vector<double> positions;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 5; ++c) positions.insert(positions.end(), {c + 0.5 * r, 1.0 * r, 0});
  EXPECT_EQ(columns_of(positions.data(), 20), 0u);
}

// 200 x 200 points, a gap of two steps in the middle (before: of so many points a whole row's shift was rounding).
TEST(MapData, ManyPointsWithAGapAreNoGrid) {
  for (const bool gap : {false, true}) {
    std::vector<double> positions;
    for (int r = 0; r < 200; ++r)
      for (int c = 0; c < 200; ++c) positions.insert(positions.end(), {0.1 * c, 0.1 * (r + (gap && r > 99 ? 2 : 0)), 0});
    EXPECT_EQ(columns_of(positions.data(), 40000), gap ? 0u : 200u);
  }
}

TEST(MapData, OfAFisheyeIsOfItsImageCircle) {
  SensorInfo camera{};
  camera.width = camera.height = 20;
  camera.projection = UPS_EQUIDISTANT;
  const std::vector<float> all(400, 100.0f), seen = within_image(camera, all);
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 20; ++column) {  // whole pixels: what lies beyond the circle is black
      const double x = std::max(10 - column, column - 9), y = std::max(10 - row, row - 9);
      EXPECT_EQ(seen[size_t(row * 20 + column)], x * x + y * y <= 100 ? 100 : -1) << column << ", " << row;
    }
  EXPECT_NE(image_map("sky", "Luminance", "cd/m2", seen, {}, 20, 20).summary.find("mean 100 cd/m2, min 100"),
            std::string::npos);
  camera.projection = UPS_PERSPECTIVE;
  EXPECT_EQ(within_image(camera, all), all);
}

TEST(MapData, OfACamerasIlluminanceHasNoUniformity) {
  const std::vector<float> lux = {100, 200, 300, 400};
  EXPECT_EQ(image_map("view", "Illuminance", "lx", lux, {}, 2, 2).summary, "mean 250 lx, min 100, max 400 lx");
  EXPECT_EQ(image_map("grid", "Illuminance", "lx", lux, {}, 2, 2, {}).summary,
            "mean 250 lx, min 100, max 400 lx, U0 0.400");
}

TEST(MapData, OfATurnedLatticeLiesStraight) {
  std::vector<MeterPoint> points;
  const double c = std::cos(0.3), s = std::sin(0.3);
  for (int i = 0; i < 30; ++i)
    if (i % 7 != 6)
      points.push_back({{c * (i % 6) - s * (i / 6), s * (i % 6) + c * (i / 6), 0.75}, {0, 0, 1}, 10.0 + i, 1});
  const auto data = meter_map("turned", points, 0, nullptr);
  ASSERT_TRUE(data);
  ASSERT_TRUE(MapField(*data).lattice());
  EXPECT_NEAR(std::atan2(data->north_x, data->north_y), 0.3, 1e-6);  // north turned the other way on paper
}

}  // namespace
}  // namespace ups::report
