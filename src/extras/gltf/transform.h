// 3x4 transforms of nodes, and glTF's +Y up turned to +Z up. Called by the importer.
#pragma once
#include <array>
#include <string>

#include "gltf/document.h"

namespace ups::gltf {

using Vector = std::array<double, 3>;

struct Affine {  // row-major, as in the C API
  double m[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  Vector column(int j) const { return {m[j], m[4 + j], m[8 + j]}; }
  void set_column(int j, const Vector& v);
  Vector point(const Vector& p) const;
  Vector direction(const Vector& d) const;
};

Affine operator*(const Affine& a, const Affine& b);
// (x, y, z) becomes (x, -z, y).
Affine turn_to_z_up();
double determinant(const Affine& a);
double length(const Vector& v);

// A node's own matrix, and the same without its scale. Throws on wrong lengths, numbers that are not finite and null
// rotations.
struct NodeTransform {
  Affine full, unscaled;
};
NodeTransform local_transform(const tinygltf::Node& node, const std::string& where);

// Columns of length 1, right-angled and right-handed: local +Z keeps its direction, +Y as far as it can.
// was_scaled: whether more than rounding was taken away, but for what mirrors. Throws where a column vanishes.
Affine without_scale(const Affine& a, bool& was_scaled, const std::string& where);
// The same left-handed where `a` mirrors: of +X the opposite, for what mirrors light.
Affine with_mirror_of(const Affine& a, Affine frame);

}  // namespace ups::gltf
