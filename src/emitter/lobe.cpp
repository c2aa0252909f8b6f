// See lobe.h.
#include "emitter/lobe.h"

#include "photometry/photometry.h"

namespace ups {

// Wider than the cone by what rounding of a direction may do.
Lobe cone_lobe(const Frame& frame, double inner_versine, double outer_versine) {
  Lobe lobe;
  lobe.shape = Lobe::Shape::cone;
  lobe.frame = frame;
  const double outer = outer_versine + 1e-3 * outer_versine + 1e-6;
  lobe.outer_cosine = float(1 - outer);
  lobe.inverse_width = float(1 / std::max(outer - inner_versine, 1e-7));
  return lobe;
}

FineTable fine_table(const photometry::Distribution& distribution) {
  FineTable table{};
  const auto grow = [](float& texel, double value) { texel = std::max(texel, float(value)); };
  for (int i = 0; i < Lobe::Fine::size; ++i)
    for (int k = 0; k < 9; ++k) {
      const Vec3 w = Lobe::Fine::direction(i, 0.5f * float(k % 3), 0.5f * float(k / 3));
      grow(table[size_t(i)], distribution.eval(w.x, w.y, w.z));
    }
  // The table's own nodes, where its peaks are; a single plane stands for all.
  const size_t planes = distribution.c_deg().size(), rows = distribution.gamma_deg().size();
  const size_t turns = planes == 1 ? 64 : 1;
  for (size_t c = 0; c < planes; ++c)
    for (size_t g = 0; g < rows; ++g) {
      double c_deg, gamma_deg;
      distribution.node_direction(c, g, c_deg, gamma_deg);
      const double gamma = gamma_deg / 180 * double(pi), sine = std::sin(gamma);
      for (size_t turn = 0; turn < turns; ++turn) {
        const double phi = c_deg / 180 * double(pi) + 2 * double(pi) * double(turn) / double(turns);
        const Vec3 w(float(sine * std::cos(phi)), float(sine * std::sin(phi)), float(-std::cos(gamma)));
        grow(table[size_t(Lobe::Fine::texel(w))], distribution.at(c, g));
      }
    }
  return table;
}

void add_to(CoarseTable& table, const Lobe& lobe, float intensity) {
  for (int i = 0; i < Lobe::Coarse::size; ++i) {
    float sum = 0;
    if (lobe.shape == Lobe::Shape::coarse)
      sum = 4 * lobe.table[i];
    else
      for (int k = 0; k < 4; ++k)
        sum += lobe.towards(Lobe::Coarse::direction(i, 0.25f + 0.5f * float(k % 2), 0.25f + 0.5f * float(k / 2)), 1);
    table[size_t(i)] += 0.25f * intensity * sum;
  }
  if (lobe.shape == Lobe::Shape::cone)  // which may be narrower than a texel
    table[size_t(Lobe::Coarse::texel(lobe.frame.n))] += 0.25f * intensity;
}

}  // namespace ups
