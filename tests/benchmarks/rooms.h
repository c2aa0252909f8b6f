// Generated scenes: a closed room of 4 m x 3 m x 2.5 m full of spheres, of a given number of triangles, and random
// points on its surfaces.
#pragma once
#include <memory>
#include <vector>

#include "base/discrete.h"
#include "base/rng.h"
#include "base/warp.h"
#include "geometry/raytracer.h"

namespace ups::benchmarks {

class Room {
 public:
  // As near to `triangles` as whole spheres come: more of them, and finer ones, in larger scenes.
  explicit Room(size_t triangles);

  const Raytracer& tracer() const { return *tracer_; }
  size_t triangle_count() const { return mesh_->triangle_count(); }
  double area() const { return by_area_.total(); }
  // Uniform over the surfaces, fronts up; the same for the same number.
  SurfacePoint random_point(uint32_t number) const;

 private:
  void add_walls();
  void add_spheres(size_t triangles);
  double area_of(size_t triangle) const;

  std::shared_ptr<Mesh> mesh_ = std::make_shared<Mesh>();
  std::vector<SurfaceTexturing> texturing_ = std::vector<SurfaceTexturing>(1);
  DiscreteDistribution by_area_;
  std::unique_ptr<Raytracer> tracer_;
};

// Made when first asked for, kept to the end: repetitions come in random order.
const Room& room_of(size_t triangles);

struct Numbers {
  float a, b, c, d;
};
inline Numbers random_numbers(uint32_t number, uint32_t stream) {
  const auto bits = philox({number, 0, 0, 0}, {stream, 0x62656e63u});
  return {to_unit_float(bits[0]), to_unit_float(bits[1]), to_unit_float(bits[2]), to_unit_float(bits[3])};
}

}  // namespace ups::benchmarks
