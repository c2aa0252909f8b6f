// Profiles to triangles, see optics.h: how many rings and columns a tolerance needs, the triangles, and measures of
// them.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "photometry/optics_face.h"

namespace optics {
namespace {

constexpr uint32_t min_columns = 12;
constexpr int max_depth = 40;         // of bisection
constexpr double column_share = 0.7;  // of the tolerances, for what the columns alone cost; the rings get the rest
constexpr int grid = 6;               // a triangle is tried at points between so many steps along its sides

ProfilePoint straight(const ProfilePoint& a, const ProfilePoint& b, double t) {
  const double dr = b.r - a.r, dz = b.z - a.z, length = std::hypot(dr, dz);
  if (!(length > 0)) throw std::invalid_argument("a profile has two points at one place");
  // The ends exactly: neighbours share them.
  if (t >= 1) return {b.r, b.z, dz / length, -dr / length};
  return {a.r + t * dr, a.z + t * dz, dz / length, -dr / length};
}

// Facets along the profile become straight sections.
std::vector<Section> without_facets(const Profile& profile) {
  std::vector<Section> out;
  for (const Section& section : profile.sections) {
    if (section.facets_along == 0) out.push_back(section);
    for (uint32_t i = 0; i < section.facets_along; ++i) {
      const ProfilePoint a = section.at(double(i) / section.facets_along);
      const ProfilePoint b = section.at(double(i + 1) / section.facets_along);
      out.push_back({[a, b](double t) { return straight(a, b, t); }});
    }
  }
  return out;
}

// The middle line of a flat strip whose edges follow the profile, `half` an angle to either side.
Section strip(const Section& edge, double half) {
  return {[at = edge.at, c = std::cos(half)](double t) {
    const ProfilePoint p = at(t);
    const double length = std::hypot(p.normal_r, p.normal_z * c);
    return ProfilePoint{p.r * c, p.z, p.normal_r / length, p.normal_z * c / length};
  }};
}

struct Vec {
  double x, y, z;
};
Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(const Vec& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(const Vec& a, const Vec& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double length(const Vec& a) { return std::sqrt(dot(a, a)); }

Vec turned(double r, double z, double angle) { return {r * std::cos(angle), r * std::sin(angle), z}; }

// The point of a section, between two parameters, nearest to (r, z): where the way to it is along the normal.
ProfilePoint nearest(const Section& section, double low, double high, double r, double z) {
  const auto beyond = [&](const ProfilePoint& p) {  // > 0: the point lies further along the profile
    return (r - p.r) * -p.normal_z + (z - p.z) * p.normal_r;
  };
  ProfilePoint a = section.at(low), b = section.at(high);
  double at_low = beyond(a), at_high = beyond(b);
  if (!(at_low > 0)) return a;
  if (!(at_high < 0)) return b;
  ProfilePoint p = a;
  for (int i = 0; i < 60 && high - low > 1e-12; ++i) {
    // Regula falsi; every third step halves, so that it cannot stall.
    const double t = i % 3 == 2 ? 0.5 * (low + high) : low + (high - low) * at_low / (at_low - at_high);
    p = section.at(t);
    const double value = beyond(p);
    if (std::abs(value) < 1e-14) return p;
    (value > 0 ? low : high) = t;
    (value > 0 ? at_low : at_high) = value;
  }
  return p;
}

struct Deviation {
  double distance = 0, angle = 0;
};

// Of one quad of a ring, `half` an angle to either side of the xz plane, from what it stands for. half 0: of the line.
Deviation deviation(const Section& section, double low, double high, double half) {
  const ProfilePoint a = section.at(low), b = section.at(high);
  struct Corner {
    Vec p, n;
  };
  const auto corner = [](const ProfilePoint& p, double angle) {
    // The one normal at a pole is the column's own.
    return Corner{turned(p.r, p.z, angle), turned(p.normal_r, p.normal_z, p.r > 0 ? angle : 0)};
  };
  const Corner corners[4] = {corner(a, -half), corner(a, half), corner(b, half), corner(b, -half)};
  Deviation worst;
  const auto try_triangle = [&](const Corner& u, const Corner& v, const Corner& w) {
    for (int i = 0; i <= grid; ++i)
      for (int j = 0; i + j <= grid; ++j) {
        const double s = double(i) / grid, t = double(j) / grid;
        const Vec p = u.p * (1 - s - t) + v.p * s + w.p * t, n = u.n * (1 - s - t) + v.n * s + w.n * t;
        const double r = std::hypot(p.x, p.y);
        const ProfilePoint q = nearest(section, low, high, r, p.z);
        worst.distance = std::max(worst.distance, std::hypot(q.r - r, q.z - p.z));
        const Vec true_n = turned(q.normal_r, q.normal_z, r > 0 ? std::atan2(p.y, p.x) : 0);
        worst.angle = std::max(worst.angle, std::atan2(length(cross(n, true_n)), dot(n, true_n)));
      }
  };
  try_triangle(corners[0], corners[1], corners[2]);
  try_triangle(corners[0], corners[2], corners[3]);
  return worst;
}

std::string tolerances(const Tolerance& t) {
  return "chord_tolerance_m " + text(t.chord_m) + " and normal_tolerance_rad " + text(t.normal_rad);
}

[[noreturn]] void too_fine(const Tolerance& t, const std::string& why) {
  throw std::invalid_argument(tolerances(t) + " " + why + "; raise the tolerance that is too small");
}

// Columns by what they cost alone: the sagitta of the widest circle, and half the square of the half-angle times the
// sine and cosine of the normal's inclination.
uint32_t column_count(const std::vector<Section>& sections, const Tolerance& tolerance) {
  double widest = 0, inclined = 0;
  for (const Section& section : sections)
    for (int i = 0; i <= 64; ++i) {
      const ProfilePoint p = section.at(i / 64.0);
      widest = std::max(widest, p.r);
      inclined = std::max(inclined, std::abs(p.normal_r * p.normal_z));
    }
  double half = pi / min_columns;
  if (column_share * tolerance.chord_m < widest)
    half = std::min(half, std::acos(1 - column_share * tolerance.chord_m / widest));
  if (inclined > 0) half = std::min(half, std::sqrt(2 * column_share * tolerance.normal_rad / inclined));
  const double columns = std::ceil(pi / half / 4) * 4;
  if (!(columns < max_triangles)) too_fine(tolerance, "would need more than 4000000 triangles");
  return uint32_t(columns);
}

// Parameters of a section's rings: bisected until the quads between two of them are within the tolerance and, of a
// round shape of some size, a quadric is the surface between them. Size 0: of a faceted one.
std::vector<double> rings(const Section& section, double half, double size, const Tolerance& tolerance,
                          size_t max_count) {
  std::vector<double> out{0};
  struct Piece {
    double low, high;
    int depth;
  };
  std::vector<Piece> stack{{0, 1, 0}};
  while (!stack.empty()) {
    const Piece piece = stack.back();
    stack.pop_back();
    const double ends[2] = {section.at(piece.low).r, section.at(piece.high).r};
    const bool tip = std::min(ends[0], ends[1]) == 0 && std::max(ends[0], ends[1]) <= tolerance.chord_m;
    const Deviation d = deviation(section, piece.low, piece.high, half);
    if (d.distance <= tolerance.chord_m && (tip || d.angle <= tolerance.normal_rad) &&
        (size == 0 || fit_band(section, piece.low, piece.high, size))) {
      out.push_back(piece.high);
      if (out.size() - 1 > max_count) too_fine(tolerance, "or the facets would need more than 4000000 triangles");
      continue;
    }
    if (piece.depth == max_depth) too_fine(tolerance, "cannot be kept");
    const double middle = 0.5 * (piece.low + piece.high);
    stack.push_back({middle, piece.high, piece.depth + 1});
    stack.push_back({piece.low, middle, piece.depth + 1});
  }
  return out;
}

// Writes the grids of quads of one section after another. The places of a ring are the same bits for all sections, as
// its r and z are and the columns' cosines: so creases have no gap.
class Writer {
 public:
  Writer(uint32_t columns, bool faceted) : columns_(columns), faceted_(faceted) {
    for (uint32_t j = 0; j < columns; ++j) {
      const double angle = 2 * pi * j / columns;
      around_.push_back({std::cos(angle), std::sin(angle), 0});
      const double middle = angle + pi / columns;
      between_.push_back({std::cos(middle), std::sin(middle), 0});
    }
  }

  void add(const std::vector<ProfilePoint>& line) {
    for (const ProfilePoint& p : line) {
      const auto count = mesh.positions.size() / 3;
      if (count > 0xf0000000u) throw std::invalid_argument("a mesh of more than 4026531840 vertices");
      first_.push_back(uint32_t(count));
      for (uint32_t j = 0; j < columns_; ++j) add_vertices(p, j);
    }
    for (size_t i = first_.size() - line.size(); i + 1 < first_.size(); ++i)
      for (uint32_t j = 0; j < columns_; ++j) add_quad(i, j, line);
    first_.clear();
  }

  Mesh mesh;

 private:
  // Smooth: one a column, the pole's normals those between the columns. Faceted: both ends of each facet.
  void add_vertices(const ProfilePoint& p, uint32_t j) {
    if (!faceted_) return add_vertex(p, around_[j], p.r > 0 ? around_[j] : between_[j]);
    add_vertex(p, around_[j], between_[j]);
    add_vertex(p, around_[(j + 1) % columns_], between_[j]);
  }
  void add_vertex(const ProfilePoint& p, const Vec& at, const Vec& facing) {
    const bool pole = p.r == 0;
    for (double v : {pole ? 0 : p.r * at.x, pole ? 0 : p.r * at.y, p.z}) mesh.positions.push_back(float(v));
    for (double v : {p.normal_r * facing.x, p.normal_r * facing.y, p.normal_z}) mesh.normals.push_back(float(v));
  }
  uint32_t index(size_t ring, uint32_t column, bool next) const {
    if (faceted_) return first_[ring] + 2 * column + (next ? 1 : 0);
    return first_[ring] + (next ? (column + 1) % columns_ : column);
  }
  void add_quad(size_t i, uint32_t j, const std::vector<ProfilePoint>& line) {
    const uint32_t a = index(i, j, false), b = index(i, j, true), c = index(i + 1, j, true), d = index(i + 1, j, false);
    if (line[i].r == 0)
      mesh.indices.insert(mesh.indices.end(), {a, c, d});
    else if (line[i + 1].r == 0)
      mesh.indices.insert(mesh.indices.end(), {a, b, d});
    else
      mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
  }

  uint32_t columns_;
  bool faceted_;
  std::vector<Vec> around_, between_;
  std::vector<uint32_t> first_;  // vertex of each ring
};

}  // namespace

double largest_radius(const Profile& profile) {
  double r = 0;
  for (const Section& section : profile.sections)
    for (int i = 0; i <= 64; ++i) r = std::max(r, section.at(i / 64.0).r);
  return r;
}

Mesh tessellate(const Profile& profile, const Tolerance& tolerance) {
  if (!(std::isfinite(tolerance.chord_m) && tolerance.chord_m > 0))
    fail("chord_tolerance_m", tolerance.chord_m, "above 0");
  if (!(std::isfinite(tolerance.normal_rad) && tolerance.normal_rad > 0))
    fail("normal_tolerance_rad", tolerance.normal_rad, "above 0");
  const std::vector<Section> sections = without_facets(profile);
  const bool faceted = profile.facets_around > 0;
  const uint32_t columns = faceted ? profile.facets_around : column_count(sections, tolerance);
  const double half = pi / columns, size = largest_radius(profile);
  Writer writer(columns, faceted);
  size_t band_count = 0;
  std::optional<ProfilePoint> last;
  for (const Section& section : sections) {
    const size_t left =
        max_triangles / (2 * size_t(columns)) - std::min(max_triangles / (2 * size_t(columns)), band_count);
    const std::vector<double> ts =
        faceted ? rings(strip(section, half), 0, 0, tolerance, left) : rings(section, half, size, tolerance, left);
    for (size_t i = 0; !faceted && i + 1 < ts.size(); ++i)
      writer.mesh.bands.push_back(*fit_band(section, ts[i], ts[i + 1], size));
    std::vector<ProfilePoint> line;
    for (double t : ts) {
      ProfilePoint p = section.at(t);
      if (faceted) {  // positions on the edges, normals of the strip
        const ProfilePoint middle = strip(section, half).at(t);
        p.normal_r = middle.normal_r, p.normal_z = middle.normal_z;
      }
      line.push_back(p);
    }
    if (last) line.front().r = last->r, line.front().z = last->z;  // the same bits
    last = line.back();
    band_count += line.size() - 1;
    writer.add(line);
  }
  if (!faceted) writer.mesh.columns = columns;
  return std::move(writer.mesh);
}

namespace {

Vec corner(const Mesh& mesh, size_t i) {
  const float* p = &mesh.positions[3 * size_t(mesh.indices[i])];
  return {double(p[0]), double(p[1]), double(p[2])};
}

}  // namespace

double area(const Mesh& mesh) {
  double sum = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec a = corner(mesh, i);
    sum += 0.5 * length(cross(corner(mesh, i + 1) - a, corner(mesh, i + 2) - a));
  }
  return sum;
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3)
    sum += dot(corner(mesh, i), cross(corner(mesh, i + 1), corner(mesh, i + 2))) / 6;
  return sum;
}

Topology topology(const Mesh& mesh) {
  std::map<std::array<float, 3>, uint32_t> places;
  std::vector<uint32_t> place;
  for (size_t v = 0; v < mesh.positions.size(); v += 3) {
    const std::array<float, 3> p{mesh.positions[v] + 0.0f, mesh.positions[v + 1] + 0.0f, mesh.positions[v + 2] + 0.0f};
    place.push_back(places.try_emplace(p, uint32_t(places.size())).first->second);
  }
  std::map<std::pair<uint32_t, uint32_t>, int> edges;  // by its lower end: once each way
  bool once = true;
  for (size_t i = 0; i < mesh.indices.size(); ++i) {
    const uint32_t from = place[mesh.indices[i]], to = place[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
    int& ways = edges[std::minmax(from, to)];
    const int way = from < to ? 1 : 2;
    once = once && from != to && !(ways & way);
    ways |= way;
  }
  for (const auto& [edge, ways] : edges) once = once && ways == 3;
  return {once, int64_t(places.size()) - int64_t(edges.size()) + int64_t(mesh.triangle_count())};
}

}  // namespace optics
