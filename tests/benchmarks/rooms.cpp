// See rooms.h: spheres are added until the triangles are enough; points are chosen by area.
#include "rooms.h"

#include <map>

#include "support/shapes.h"

namespace ups::benchmarks {

namespace {

constexpr double length_m = 4, width_m = 3, height_m = 2.5;
enum Stream : uint32_t { place = 1, surface = 2 };

void append(Mesh& mesh, const test::Shape& shape, double scale, const Vec3d& to) {
  const uint32_t first = uint32_t(mesh.positions.size());
  for (const test::P3& p : shape.vertices) mesh.positions.push_back(Vec3(Vec3d(p.x, p.y, p.z) * scale + to));
  for (const auto& triangle : shape.triangles)
    for (uint32_t vertex : triangle) mesh.indices.push_back(first + vertex);
}

}  // namespace

Room::Room(size_t triangles) {
  add_walls();
  add_spheres(triangles);
  std::vector<double> areas;
  for (size_t t = 0; t < mesh_->triangle_count(); ++t) areas.push_back(area_of(t));
  by_area_ = DiscreteDistribution(areas);
  ThreadPool pool(0);
  tracer_ = std::make_unique<Raytracer>(std::vector<std::shared_ptr<const Mesh>>{mesh_},
                                        std::vector<Raytracer::Instance>{{0, Affine()}}, texturing_, pool);
}

void Room::add_walls() { append(*mesh_, test::box({0, 0, 0}, {length_m, width_m, height_m}).flipped(), 1, {}); }

void Room::add_spheres(size_t triangles) {
  const int level = triangles < 10'000 ? 1 : triangles < 500'000 ? 3 : 4;
  const test::Shape sphere = test::icosphere({0, 0, 0}, 1, level);
  const size_t count = (triangles - mesh_->triangle_count()) / sphere.triangles.size();
  // A third of the mean distance: some of them meet, rays still get through.
  const double radius = std::cbrt(length_m * width_m * height_m / double(count)) / 3;
  const auto within = [&](float u, double size) { return radius + double(u) * (size - 2 * radius); };
  for (size_t i = 0; i < count; ++i) {
    const Numbers u = random_numbers(uint32_t(i), place);
    append(*mesh_, sphere, radius, {within(u.a, length_m), within(u.b, width_m), within(u.c, height_m)});
  }
}

double Room::area_of(size_t triangle) const {
  const auto p = [&](int i) { return Vec3d(mesh_->positions[mesh_->indices[3 * triangle + size_t(i)]]); };
  return length(cross(p(1) - p(0), p(2) - p(0))) / 2;
}

SurfacePoint Room::random_point(uint32_t number) const {
  const Numbers u = random_numbers(number, surface);
  const Vec2 at = square_to_triangle({u.b, u.c});
  return tracer_->surface_at(0, uint32_t(by_area_.sample(u.a).index), at.x, at.y);
}

const Room& room_of(size_t triangles) {
  static std::map<size_t, Room> rooms;
  return rooms.try_emplace(triangles, triangles).first->second;
}

}  // namespace ups::benchmarks
