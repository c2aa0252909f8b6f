// What light keeps on its way through parallel thin panes, in double and without the engine: the Fresnel equations by
// polarisation, the ways within a pane summed one by one, reflections between panes as images of the emitter. As in the
// engine, polarisation is kept within a pane and not from one to the next.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "../support/shapes.h"

namespace ups::test {

using Colour = std::array<double, 3>;
constexpr double luminance(const Colour& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }  // Rec.709

struct Split {
  double reflected = 0, passed = 0;
};

// Of unpolarised light; `passage` is what one way straight through the glass keeps.
inline Split split(double ior, double passage, double cos_outside) {
  const double cos_inside = std::sqrt(1 - (1 - cos_outside * cos_outside) / (ior * ior));
  const double s = (cos_outside - ior * cos_inside) / (cos_outside + ior * cos_inside);
  const double p = (ior * cos_outside - cos_inside) / (ior * cos_outside + cos_inside);
  const double way = std::pow(passage, 1 / cos_inside);
  Split sum;
  for (const double face : {s * s, p * p}) {
    sum.reflected += 0.5 * face;
    double inside = 0.5 * (1 - face) * way;
    for (bool far = true; inside > 1e-12; far = !far, inside *= face * way)
      (far ? sum.passed : sum.reflected) += inside * (1 - face);
  }
  return sum;
}

struct Pane {
  double ior = 1.52;
  Colour transmittance = {-1, -1, -1};  // at normal incidence; < 0: clear

  Split at(int channel, double cosine) const { return split(ior, passage_[channel], cosine); }
  Pane(double index, const Colour& at_normal) : ior(index), transmittance(at_normal) {
    for (int c = 0; c < 3; ++c) {
      double low = 0, high = 1;
      for (int i = 0; i < 50 && at_normal[c] >= 0; ++i) {
        const double middle = 0.5 * (low + high);
        (split(ior, middle, 1).passed < at_normal[c] ? low : high) = middle;
      }
      passage_[c] = high;
    }
  }

 private:
  Colour passage_;
};

// Parallel panes at the same distance from one to the next, all of them between emitter and receiver.
struct Stack {
  std::vector<Pane> panes;  // the one next to the emitter first
  P3 normal = {0, 0, 1};    // towards the emitter
  double gap = 0.1;
  int echoes = 6;  // how often light goes back between two panes; 0: straight light alone

  // What arrives after i ways back, by i.
  std::vector<double> transmittances(int channel, double cosine) const {
    const size_t count = panes.size();
    std::vector<double> out(echoes + 1), down(count + 1), up(count + 1);  // light that comes to each pane
    std::vector<Split> pane;
    for (const Pane& p : panes) pane.push_back(p.at(channel, cosine));
    down[0] = 1;
    for (int i = 0; i <= echoes; ++i) {
      std::vector<double> back(count + 1);
      for (size_t p = 0; p < count; ++p) {
        down[p + 1] += up[p] * pane[p].reflected;
        if (p > 0) back[p - 1] += up[p] * pane[p].passed;
      }
      for (size_t p = 0; p < count; ++p) {
        down[p + 1] += down[p] * pane[p].passed;
        if (p > 0) back[p - 1] += down[p] * pane[p].reflected;
      }
      out[i] = down[count];
      std::fill(down.begin(), down.end(), 0.0);
      up = back;
    }
    return out;
  }

  // Sum over the images of a small emitter: of what value(direction, distance^2) gives, what comes through.
  template <class Value>
  Colour through(const P3& from, const P3& to, const Value& value) const {
    Colour total{};
    for (int i = 0; i <= echoes; ++i) {
      const P3 way = to - (from + normal * (2 * gap * i)), d = normalize(way);
      for (int c = 0; c < 3; ++c) total[c] += transmittances(c, std::abs(dot(d, normal)))[i] * value(d, dot(way, way));
    }
    return total;
  }
};

}  // namespace ups::test
