// A mesh as Embree is given it: vertices of one frame, triangles without area left out, and a filter for holes and for
// false hits; or a surface of revolution, which asks for a mask itself (traced_revolution.cpp). Built by
// raytracer_build.cpp, read by raytracer.cpp.
#pragma once
#include <memory>
#include <vector>

#include "geometry/embree.h"
#include "geometry/raytracer.h"

namespace ups {

// In double: normals and barycentrics of slivers keep their digits.
struct Triangle {
  Vec3d p[3];
  Vec3d area_normal() const { return cross(p[1] - p[0], p[2] - p[0]); }
  double longest_edge2() const { return std::max({length2(p[1] - p[0]), length2(p[2] - p[1]), length2(p[0] - p[2])}); }
  Vec3d sum(const double (&weights)[3]) const { return p[0] * weights[0] + p[1] * weights[1] + p[2] * weights[2]; }
};

// Where the line o + t d meets the triangle's plane: weights of the three vertices. False where it runs within the
// plane.
bool meet_plane(const Triangle& triangle, const Vec3d& o, const Vec3d& d, double (&weights)[3], double& t);

// What a triangle of a baked mesh always is, found once. Meshes of their own frame have none: they may be large, and
// their vertices fit the caches where so much a triangle would not.
struct Facet {
  Vec3 ng;             // by its winding; unit, (0, 0, 1) where it has no area
  float longest_edge;
  float low_height;    // above the longest edge, rounded down
  bool is_flat;        // so say the normals of its vertices, too, or there are none
};

// Immutable once made: several builds may have it, whatever Embree has made of it.
struct TracedMesh {
  std::shared_ptr<const Mesh> source;
  bool has_holes = false;            // rays ask the texturing of its material
  std::vector<Vec3> positions;       // one more than used: Embree reads 16 bytes at a time
  bool complete = true;              // every triangle has an area; else these are the ones that do:
  std::vector<uint32_t> primitives;  // their numbers in the mesh
  std::vector<uint32_t> indices;     // their vertices
  bool has_thin = false;             // some triangle is so thin that Embree's hits of it are checked
  std::vector<Facet> facets;         // of a baked mesh of triangles, by their numbers in the mesh

  // Of a surface of revolution: from its own frame to Embree's and back, and what has a box of its own.
  struct Piece {
    uint32_t band, sector, sectors;
  };
  Affine to_frame, from_frame;
  std::vector<Piece> pieces;

  size_t bytes() const {
    return sizeof *this + positions.capacity() * sizeof(Vec3) + facets.capacity() * sizeof(Facet) +
           (primitives.capacity() + indices.capacity()) * sizeof(uint32_t) + pieces.capacity() * sizeof(Piece);
  }
  uint32_t primitive(uint32_t embree_primitive) const {
    return complete ? embree_primitive : primitives[embree_primitive];
  }
  Triangle triangle(uint32_t primitive) const {
    const uint32_t* i = &source->indices[3 * size_t(primitive)];
    return {{Vec3d(positions[i[0]]), Vec3d(positions[i[1]]), Vec3d(positions[i[2]])}};
  }
};

inline Vec3 interpolate(const Vec3& a, const Vec3& b, const Vec3& c, float u, float v) {
  return a * (1 - u - v) + b * u + c * v;
}

// Tangent and bitangent of the texture's u axis and of its upward direction, which is -v in glTF, at a point with the
// normal n of the triangle of vertices i; false where there are none. side: -1 where `to_scene` mirrors.
bool tangents_at(const Mesh& mesh, const uint32_t* i, const SurfacePoint& point, const Affine& to_scene, double side,
                 const Triangle& triangle, const Vec3d& n, Vec3d& tangent, Vec3d& bitangent);

// Weights of a point of a triangle that is kept off its edges by `inset`: right at an edge rounding would put it behind
// the next wall.
void keep_off_edges(const Triangle& triangle, double area, double longest_edge, double inset, double (&weights)[3]);

// Interpolated texture coordinates; 0 where the mesh has none.
Vec2 uv_at(const Mesh& mesh, uint32_t primitive, float u, float v);

// bake: the transform of the only instance; null: the mesh stays in its own frame.
std::shared_ptr<const TracedMesh> make_traced_mesh(std::shared_ptr<const Mesh> mesh, bool has_holes,
                                                   const Affine* bake, ThreadPool& pool);
// What Embree builds from: it reads the mesh's own arrays, which must outlive it. The caller owns it, has it committed
// and checks the device. Null: no triangle has an area.
RTCGeometry make_geometry(embree::Device& device, const TracedMesh& mesh);
// The two of a surface of revolution.
void cut_into_pieces(TracedMesh& mesh);
RTCGeometry make_revolution_geometry(embree::Device& device, const TracedMesh& mesh);

}  // namespace ups
