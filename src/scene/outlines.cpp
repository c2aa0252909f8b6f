// See outlines.h. An edge is drawn where a surface ends, folds, or turns away from who looks; of it the pieces from
// which a ray back to the plane is free.
#include "scene/outlines.h"

#include <cstring>
#include <unordered_map>

namespace ups {
namespace {

constexpr double sharp_cosine = 0.87;  // of a fold of 30 degrees: finer ones are a smooth surface's
constexpr int most_pieces = 64;

struct Corner {
  Vec3d p;
  bool operator==(const Corner& b) const { return p.x == b.p.x && p.y == b.p.y && p.z == b.p.z; }
};
struct HashCorner {
  size_t operator()(const Corner& c) const {
    uint64_t h = 0;
    for (int i = 0; i < 3; ++i) {
      const double value = c.p[i] == 0 ? 0 : c.p[i];  // -0 is 0
      uint64_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      h = (h ^ bits) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return size_t(h);
  }
};

struct Edge {
  Vec3d first, second;  // normals of the triangles at it
  uint32_t from = 0, to = 0;  // as the first one passes it
  uint32_t count = 0;
  bool drawn = false;
};

class Edges {
 public:
  explicit Edges(const Vec3d& up) : up_(up) {}

  void add_triangle(const Vec3d (&p)[3]) {
    const Vec3d across = cross(p[1] - p[0], p[2] - p[0]);
    if (!(length(across) > 0)) return;
    uint32_t corner[3];
    for (int i = 0; i < 3; ++i) corner[i] = number_of(p[i]);
    for (int i = 0; i < 3; ++i) add_edge(corner[i], corner[(i + 1) % 3], normalize(across));
  }

  // visit(from, to) of each that is drawn, in the order in which they were found.
  template <class Visit>
  void each(const Visit& visit) const {
    for (const Edge& e : edges_)
      if (e.count == 1 || e.drawn) visit(corners_[e.from], corners_[e.to]);
  }

 private:
  uint32_t number_of(const Vec3d& p) {
    const auto [place, is_new] = numbers_.try_emplace(Corner{p}, uint32_t(corners_.size()));
    if (is_new) corners_.push_back(p);
    return place->second;
  }

  void add_edge(uint32_t from, uint32_t to, const Vec3d& normal) {
    const uint64_t key = uint64_t(std::min(from, to)) << 32 | std::max(from, to);
    const auto [place, is_new] = by_ends_.try_emplace(key, uint32_t(edges_.size()));
    if (is_new) {
      edges_.push_back({normal, {}, from, to, 1, false});
      return;
    }
    Edge& e = edges_[place->second];
    ++e.count;
    // Neighbours of one surface pass their edge in opposite directions; else one of them is wound the other way.
    const Vec3d second = e.from == from ? -normal : normal;
    const bool turns_away = faces_up(e.first) != faces_up(second);
    e.drawn = e.drawn || turns_away || dot(e.first, second) < sharp_cosine;
  }

  bool faces_up(const Vec3d& n) const { return dot(n, up_) > 1e-6; }  // upright ones do not, whatever their rounding

  Vec3d up_;
  std::vector<Vec3d> corners_;
  std::vector<Edge> edges_;
  std::unordered_map<Corner, uint32_t, HashCorner> numbers_;
  std::unordered_map<uint64_t, uint32_t> by_ends_;
};

class View {
 public:
  View(const Snapshot& scene, const Vec3d& point, const Vec3d& up, double depth)
      : scene_(scene), point_(point - scene.origin), up_(up), depth_(depth), step_(scene.radius / 200) {}

  // The pieces of an edge that are seen, joined where they follow one another.
  void add(Vec3d a, Vec3d b, std::vector<ups_segment>& out) const {
    if (!cut(a, b)) return;
    const Vec3d along = b - a, flat = along - up_ * dot(along, up_);
    const double seen = length(flat);
    if (!(seen > 1e-6 * double(scene_.radius))) return;  // end on
    const Vec3d aside = normalize(cross(up_, flat)) * (2e-4 * double(scene_.radius));
    const int pieces = std::clamp(int(std::ceil(seen / step_)), 1, most_pieces);
    int start = -1;
    for (int i = 0; i <= pieces; ++i) {
      const bool free = i < pieces && is_free(a + along * ((i + 0.5) / pieces), aside);
      if (free && start < 0) start = i;
      if (free || start < 0) continue;
      const Vec3d from = a + along * (double(start) / pieces) + scene_.origin;
      const Vec3d to = a + along * (double(i) / pieces) + scene_.origin;
      out.push_back({{from.x, from.y, from.z}, {to.x, to.y, to.z}});
      start = -1;
    }
  }

 private:
  double height(const Vec3d& p) const { return dot(p - point_, up_); }

  // To what lies between the plane and `depth` beneath it. False: nothing does.
  bool cut(Vec3d& a, Vec3d& b) const {
    const double low = -depth_;
    double from = 0, to = 1;
    const double ha = height(a), hb = height(b);
    for (const auto& [side, limit] : {std::pair{1.0, 0.0}, std::pair{-1.0, low}}) {
      const double over_a = side * (ha - limit), over_b = side * (hb - limit);  // > 0: outside
      if (over_a >= 0 && over_b >= 0) return false;
      if (over_a > 0) from = std::max(from, over_a / (over_a - over_b));
      if (over_b > 0) to = std::min(to, over_a / (over_a - over_b));
    }
    if (!(from < to)) return false;
    const Vec3d start = a;
    a = start + (b - start) * from;
    b = start + (b - start) * to;
    return true;
  }

  // Beside the edge on both sides: a ray right from it may graze its own faces.
  bool is_free(const Vec3d& p, const Vec3d& aside) const {
    for (const double side : {1.0, -1.0}) {
      const Vec3d from = p + aside * side + up_ * (1e-4 * double(scene_.radius));
      const double reach = -height(from);
      if (!(reach > 0) || !scene_.raytracer->occluded(Vec3(from), Vec3(up_), float(reach))) return true;
    }
    return false;
  }

  const Snapshot& scene_;
  Vec3d point_, up_;
  double depth_, step_;
};

}  // namespace

std::vector<ups_segment> outlines(const Snapshot& scene, const Vec3d& point, const Vec3d& normal, double depth) {
  const Vec3d up = normalize(normal);
  const Vec3d own = point - scene.origin;
  Edges edges(up);
  scene.raytracer->each_triangle([&](const Vec3d (&p)[3]) {
    double highest = -INFINITY, lowest = INFINITY;
    for (const Vec3d& corner : p) {
      highest = std::max(highest, dot(corner - own, up));
      lowest = std::min(lowest, dot(corner - own, up));
    }
    if (lowest < 0 && highest > -depth) edges.add_triangle(p);
  });
  const View view(scene, point, up, depth);
  std::vector<ups_segment> out;
  edges.each([&](const Vec3d& a, const Vec3d& b) { view.add(a, b, out); });
  return out;
}

}  // namespace ups
