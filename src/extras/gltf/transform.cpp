// See transform.h: a node's matrix or its translation, rotation and scale, checked, and frames with their scale taken
// out.
#include "gltf/transform.h"

#include <cmath>

#include "common/boundary.h"

namespace ups::gltf {

namespace {

// Matrices in files are written with 6 to 8 digits.
constexpr double scale_tolerance = 1e-5;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector scaled(const Vector& v, double factor) { return {v[0] * factor, v[1] * factor, v[2] * factor}; }

[[noreturn]] void fail(const std::string& where, const std::string& problem) {
  throw extras::Error(UPS_ERROR_PARSE, where + ": " + problem);
}

void check(const std::vector<double>& values, size_t size, const char* name, const std::string& where) {
  if (!values.empty() && values.size() != size) {
    fail(where, std::string("\"") + name + "\" must hold " + std::to_string(size) + " numbers");
  }
  for (double value : values) {
    if (!std::isfinite(value)) fail(where, std::string("\"") + name + "\" holds a number that is not finite");
  }
}

// glTF 2.0, section 3.5.3: unit quaternion (x, y, z, w).
Affine rotation(const std::vector<double>& q, const std::string& where) {
  Affine result;
  if (q.empty()) return result;
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(norm > 0)) fail(where, "\"rotation\" is the null quaternion");
  const double x = q[0] / norm, y = q[1] / norm, z = q[2] / norm, w = q[3] / norm;
  result.set_column(0, {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)});
  result.set_column(1, {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)});
  result.set_column(2, {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)});
  return result;
}

}  // namespace

void Affine::set_column(int j, const Vector& v) {
  for (int i = 0; i < 3; ++i) m[4 * i + j] = v[i];
}

Vector Affine::direction(const Vector& d) const {
  Vector result;
  for (int i = 0; i < 3; ++i) result[i] = m[4 * i] * d[0] + m[4 * i + 1] * d[1] + m[4 * i + 2] * d[2];
  return result;
}

Vector Affine::point(const Vector& p) const {
  const Vector d = direction(p);
  return {d[0] + m[3], d[1] + m[7], d[2] + m[11]};
}

Affine operator*(const Affine& a, const Affine& b) {
  Affine result;
  for (int j = 0; j < 3; ++j) result.set_column(j, a.direction(b.column(j)));
  result.set_column(3, a.point(b.column(3)));
  return result;
}

Affine turn_to_z_up() {
  Affine turn;
  turn.set_column(1, {0, 0, 1});
  turn.set_column(2, {0, -1, 0});
  return turn;
}

double determinant(const Affine& a) { return dot(a.column(0), cross(a.column(1), a.column(2))); }

double length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

NodeTransform local_transform(const tinygltf::Node& node, const std::string& where) {
  check(node.matrix, 16, "matrix", where);
  check(node.translation, 3, "translation", where);
  check(node.rotation, 4, "rotation", where);
  check(node.scale, 3, "scale", where);
  NodeTransform result;
  if (!node.matrix.empty()) {
    const auto& m = node.matrix;  // column-major
    const double w = m[15];
    for (const double off : {m[3], m[7], m[11], w - 1}) {
      if (!(std::abs(off) <= scale_tolerance)) fail(where, "\"matrix\" must end in the row 0, 0, 0, 1");
    }
    for (int j = 0; j < 4; ++j) result.full.set_column(j, {m[4 * j] / w, m[4 * j + 1] / w, m[4 * j + 2] / w});
    result.unscaled = result.full;
    return result;
  }
  result.unscaled = rotation(node.rotation, where);
  if (!node.translation.empty()) {
    result.unscaled.set_column(3, {node.translation[0], node.translation[1], node.translation[2]});
  }
  result.full = result.unscaled;
  if (!node.scale.empty()) {
    for (int j = 0; j < 3; ++j) result.full.set_column(j, scaled(result.full.column(j), node.scale[j]));
  }
  return result;
}

Affine without_scale(const Affine& a, bool& was_scaled, const std::string& where) {
  const double lengths[3] = {length(a.column(0)), length(a.column(1)), length(a.column(2))};
  Affine result = a;
  was_scaled = false;
  const Vector z = a.column(2);
  const Vector x = cross(a.column(1), z);
  if (!(lengths[2] > 0) || !(length(x) > 0)) fail(where, "its matrix has no direction: a scale of 0 or parallel axes");
  result.set_column(2, scaled(z, 1 / lengths[2]));
  result.set_column(0, scaled(x, 1 / length(x)));
  result.set_column(1, cross(result.column(2), result.column(0)));
  for (int j = 0; j < 3; ++j) {
    was_scaled = was_scaled || std::abs(lengths[j] - 1) > scale_tolerance ||
                 std::abs(std::abs(dot(a.column(j), result.column(j))) - 1) > scale_tolerance;
  }
  return result;
}

Affine with_mirror_of(const Affine& a, Affine frame) {
  if (determinant(a) < 0) frame.set_column(0, scaled(frame.column(0), -1));
  return frame;
}

}  // namespace ups::gltf
