// Shapes of lighting optics as triangles: reflectors, lenses and collimators, surfaces of revolution about z with exact
// normals at the vertices, as fine as the caller's tolerances ask for. Called by src/api for the parts of fixtures. The
// standard library only.
//
// Light goes down, along -z. A profile is walked in the (r, z) half-plane with the surface's front on the right: a
// solid from the axis at its bottom over its outside to the axis at its top, a reflector from its vertex to its rim.
// What is out of range throws std::invalid_argument that names the field as the C API does.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace optics {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr size_t max_triangles = 4'000'000;

struct Point {
  double r, z;
};

// What the triangles between two rings stand for: the quadric of revolution
//   square_r (r^2 - from.r^2) + square_z h^2 + linear h = 0,   h = z - from.z,
// from one circle to another; it is the profile's surface to 1e-7 of the largest radius and 1e-4 rad.
struct Band {
  Point from, to;
  double square_r = 0, square_z = 0, linear = 0;  // the gradient points to the front
  double bulge = 0;                               // the curve is no farther from its chord

  double value(double r, double z) const;
  void gradient(double r, double z, double& along_r, double& along_z) const;
};

// Front sides are counter-clockwise; the normals, of length 1, point to the front.
struct Mesh {
  std::vector<float> positions, normals;  // 3 a vertex
  std::vector<uint32_t> indices;          // 3 a triangle
  // Of a round shape; a band's triangles follow those of the one before: columns of them where an end is on the axis,
  // else 2 a column, around from the x axis.
  std::vector<Band> bands{};
  uint32_t columns = 0;

  size_t triangle_count() const { return indices.size() / 3; }
};

struct ProfilePoint {
  double r, z;
  double normal_r, normal_z;  // length 1
};

// One smooth piece; neighbours meet in a crease, or smoothly where their normals agree.
struct Section {
  std::function<ProfilePoint(double)> at;  // [0, 1]
  uint32_t facets_along = 0;               // > 0: replaced by so many straight pieces between points of it
};

struct Profile {
  std::vector<Section> sections;
  uint32_t facets_around = 0;  // > 0: flat around the axis between so many corners on the circle
};

double largest_radius(const Profile& profile);

// Largest distance of the mesh from the surface, and angle between its interpolated normals and the surface's. A
// surface with facets is the true one: its corners lie on the smooth surface. Within chord_m of the tip of a cone,
// where there is no normal, the angle is not kept.
struct Tolerance {
  double chord_m, normal_rad;
};

// Fails where more than max_triangles would be needed. Without facets around, the mesh has bands.
Mesh tessellate(const Profile& profile, const Tolerance& tolerance);

// ---- reflectors: open sheets, the front inside ----

// Focus at the origin, vertex at z = +focal_length_m; from a hole of inner_radius_m (0: none) to the aperture.
Profile paraboloid(double focal_length_m, double inner_radius_m, double aperture_radius_m);
// Upper focus at the origin, the other at z = -2 half_distance_m; from the hole to depth_m below the vertex, or, where
// that is 0, to aperture_radius_m above the widest place.
Profile ellipsoid(double semi_axis_m, double half_distance_m, double inner_radius_m, double aperture_radius_m,
                  double depth_m);
// From inner_radius_m at z = 0 to aperture_radius_m at z = -depth_m.
Profile cone(double inner_radius_m, double aperture_radius_m, double depth_m);
// Straight pieces, or, smooth, a cubic spline through the points (r, z); `field` is what errors call them.
Profile polyline(const std::vector<Point>& points, bool smooth, const std::string& field = "profile_rz_m");

// ---- solids ----

// sag(r) = c r^2 / (1 + sqrt(1 - (1 + conic) c^2 r^2)) + sum of coefficients[i] r^(4 + 2i), c = 1 / radius_m
// (ISO 10110-12), towards the inside of the lens: radius_m > 0 is convex, < 0 concave; 0: flat.
struct Face {
  double radius_m = 0, conic = 0;
  std::array<double, 4> coefficients{};
};
// Entry face above, its vertex at the origin; exit face below, its vertex at z = -thickness_m.
Profile lens(const Face& entry, const Face& exit, double radius_m, double thickness_m);

// A source at the origin, in the mouth of a cylindrical cavity of the top, shines through a lens at the cavity's bottom
// and through its wall, behind which total reflection turns the light down to the exit face.
struct Collimator {
  double cavity_radius_m = 0, cavity_depth_m = 0;  // depth: to the vertex of the lens
  double wall_thickness_m = 0;                     // of the rim around the mouth, collimating and polyline ignored
  double ior = 1.5;
  Face lens;  // radius 0: the hyperboloid that makes light from the origin parallel (conic -ior^2); infinite: flat
  enum class Wall { collimating, paraboloid, polyline } wall = Wall::collimating;
  double focal_length_m = 0;  // paraboloid: focus at the origin
  double height_m = 0;        // from the mouth to the exit face's rim; 0: where the collimating wall or polyline ends
  std::vector<Point> wall_points;  // polyline: from the mouth's plane, z = 0, down
  bool smooth = true;              // polyline
  Face exit;
  uint32_t exit_facets_along = 0, facets_around = 0;
};
Profile collimator(const Collimator& collimator);

// ---- emitters ----

Profile disc(double radius_m);                       // faces down
Profile sphere(double radius_m);                     // about the origin
Profile cylinder(double radius_m, double length_m);  // closed, about the origin, along z
Mesh rectangle(double width_m, double length_m);     // along x and y, faces down

// ---- measures of a mesh ----

double area(const Mesh& mesh);
double volume(const Mesh& mesh);  // of a closed one that is turned outwards; negative: inwards
// Vertices at one place, bit for bit, are one.
struct Topology {
  bool closed;    // each edge is shared by two triangles in opposite directions
  int64_t euler;  // vertices - edges + triangles: 2 for a ball, 0 for a ring
};
Topology topology(const Mesh& mesh);

// "radius_m is -1; it must be ..." as std::invalid_argument.
[[noreturn]] void fail(const std::string& field, double value, const std::string& requirement);
std::string text(double value);  // shortest, to single precision

}  // namespace optics
