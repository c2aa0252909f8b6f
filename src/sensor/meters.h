// A set of illuminance meters: where they are, points, or flat shapes over which the mean is measured: rectangles, discs,
// or triangles of surfaces; and of which kind.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "sensor/response.h"

namespace ups {

struct Meter {
  Vec3 p;       // relative to the scene's origin; a rectangle's, disc's or surface's centre
  Frame frame;  // n: the normal; s, t: a rectangle's sides
  // Of p; a planar meter that lies on a surface stands on the side of its normal. Others are there already: 0.
  float error = 0;
  float moved = 0;  // how far it is from where it was put
};

// A part of a meter that measures on a surface.
struct MeterTriangle {
  Meter at;           // a corner; s leads to the second one
  float second = 0;   // along s
  Vec2 third;         // along s, t
  float up_to = 1;    // share of its meter's area that it and those before it have

  Vec2 centroid() const { return {(second + third.x) / 3, third.y / 3}; }
  bool covers(float x, float y) const;
};

struct MeterSet {
  ups_meter_kind kind = UPS_METER_PLANAR;
  // Those that measure; of a vector set all of them six times, for one side after the other.
  std::vector<Meter> meters;
  float cell_width = 0, cell_height = 0;  // of rectangles, along frame.s, frame.t
  float disc_radius = 0;                  // of discs
  // On surfaces: meter m has triangles first_triangle[m] to first_triangle[m + 1], of areas[m] together, most of it in
  // triangle surface_triangle[m] of the surfaces, which is left empty where every triangle has a meter of its own.
  std::vector<MeterTriangle> triangles;
  std::vector<uint32_t> first_triangle, surface_triangle;
  std::vector<double> areas;
  // The program counts `declared` meters. Those that have no area to measure on are left out of all above.
  uint32_t declared = 0;
  std::vector<uint32_t> numbers;  // the program's, by index, ascending; empty: all measure
  std::shared_ptr<const std::vector<Vec3d>> positions;  // as the program gave them, in the world; null on surfaces

  bool is_cell() const { return cell_width > 0 || disc_radius > 0 || on_surface(); }  // a mean, not a point
  bool on_surface() const { return !triangles.empty(); }
  double area(size_t m) const;  // of a cell; 0: a point
  double weight(size_t m) const { return on_surface() ? areas[m] : 1; }  // in the set's mean
  // A cell is made of so many flat pieces; a piece's place, and whether a point of its plane lies in it: x, y along its
  // frame's s and t from its p.
  size_t piece_count(size_t m) const { return on_surface() ? first_triangle[m + 1] - first_triangle[m] : 1; }
  const Meter& piece(size_t m, size_t k) const { return on_surface() ? triangles[first_triangle[m] + k].at : meters[m]; }
  bool covers(size_t m, size_t k, float x, float y) const;
  // What surrounds a piece: a disc about a point of its plane, and how far the piece reaches from there along each axis;
  // < 0: as far as the disc.
  struct Extent {
    Vec3 center;
    float radius;
    Vec3 reach;
  };
  Extent extent(size_t m, size_t k) const;
  // A point of a cell, uniformly over its area.
  Meter sample(size_t m, const Vec2& u) const;

  bool across() const { return kind != UPS_METER_PLANAR && !is_cell(); }
  MeterResponse response(size_t m) const {
    if (kind == UPS_METER_PLANAR) return {};
    return {kind, across(), kind == UPS_METER_VECTOR ? uint8_t(m / count()) : uint8_t(0)};
  }

  // As the program counts them.
  uint32_t count() const {
    if (!numbers.empty()) return declared;
    return uint32_t(kind == UPS_METER_VECTOR ? meters.size() / vector_sides : meters.size());
  }
  uint32_t number(size_t m) const {
    if (!numbers.empty()) return numbers[m];
    return uint32_t(kind == UPS_METER_VECTOR ? m % count() : m);
  }
  uint32_t index_of(uint32_t number) const;  // UINT32_MAX: it does not measure
  size_t bytes() const;
};

}  // namespace ups
