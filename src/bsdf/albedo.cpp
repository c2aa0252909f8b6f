// The tables of albedo.h: quadrature over visible normals, on grids that follow the functions' own scales.
//
// Sharp lobes are alike up to scale: near grazing everything depends on mu / alpha alone. So the grid's first
// coordinate mixes mu / alpha with mu, and what is missing from a smooth interface's albedo is stored over its
// envelope; what is left varies slowly, also as alpha goes to 0.
#include "bsdf/albedo.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>

#include "bsdf/fresnel.h"
#include "bsdf/material.h"
#include "bsdf/microfacet.h"

namespace ups {
namespace {

constexpr int mu_count = 32, alpha_count = 13, ior_count = 10;
constexpr float min_table_alpha = 4e-4f;        // below, the scaled functions no longer change
constexpr float min_ior = 1.001f, max_ior = max_rough_ior;  // beyond: as for max_ior

float mu_coordinate(float mu, float alpha) { return 0.5f * (std::sqrt(mu * (1 + alpha) / (mu + alpha)) + mu); }
// Its inverse, by bisection: it is monotonic.
float mu_at(float coordinate, float alpha) {
  float low = 0, high = 1;
  for (int i = 0; i < 40; ++i) {
    const float middle = 0.5f * (low + high);
    (mu_coordinate(middle, alpha) < coordinate ? low : high) = middle;
  }
  return std::max(low, 1e-6f);
}
float alpha_coordinate(float alpha) { return std::cbrt(alpha); }
float alpha_at(int i) {
  const float a = alpha_coordinate(min_table_alpha), c = a + (1 - a) * float(i) / (alpha_count - 1);
  return c * c * c;
}
// Fresnel reflectances move fastest close to ior 1.
float ior_coordinate(float ior) { return std::cbrt((ior - 1) / (ior + 1)); }
float ior_at(int i) {
  const float a = ior_coordinate(min_ior), c = a + (ior_coordinate(max_ior) - a) * float(i) / (ior_count - 1),
              s = c * c * c;
  return (1 + s) / (1 - s);
}

float envelope(float mu, float alpha) { return alpha * alpha / (alpha * alpha + mu * mu); }
// The integral of 2 mu envelope(mu) over mu in [0, 1].
float envelope_average(float alpha) { return alpha * alpha * std::log1p(1 / (alpha * alpha)); }

struct Position {
  int index;
  float fraction;
};
Position position(float coordinate, int count) {  // coordinate in [0, 1]
  const float x = std::clamp(coordinate, 0.0f, 1.0f) * float(count - 1);
  const int i = std::min(int(x), count - 2);
  return {i, x - float(i)};
}
Position alpha_position(float alpha) {
  const float a = alpha_coordinate(min_table_alpha);
  return position((alpha_coordinate(alpha) - a) / (1 - a), alpha_count);
}
Position mu_position(float mu, float alpha) { return position(mu_coordinate(mu, alpha), mu_count); }
Position ior_position(float ior) {
  static const float a = ior_coordinate(min_ior), b = ior_coordinate(max_ior);
  // Of the kind that needs no memory at a thread's first use, which would end the process where there is none.
  [[gnu::tls_model("initial-exec")]] thread_local float last = 0;
  [[gnu::tls_model("initial-exec")]] thread_local Position found{};
  if (ior != last) {
    found = position((ior_coordinate(std::max(ior, min_ior)) - a) / (b - a), ior_count);
    last = ior;
  }
  return found;
}
float mix(float a, float b, float t) { return a + (b - a) * t; }

// The averages have a grid of their own: they hold for the function as interpolated, down to min_alpha.
constexpr int average_count = 32;
float average_coordinate(float alpha) { return std::sqrt(std::sqrt(alpha)); }
float average_alpha_at(int i) {
  const float a = average_coordinate(min_alpha), c = a + (1 - a) * float(i) / (average_count - 1);
  return c * c * c * c;
}
Position average_position(float alpha) {
  const float a = average_coordinate(min_alpha);
  return position((average_coordinate(alpha) - a) / (1 - a), average_count);
}

// The integral of 2 mu over mu in [0, 1], cut evenly in the coordinate of mu.
struct DiffuseIncidence {
  static constexpr int parts = 4 * (mu_count - 1);
  float mu[average_count][parts], weight[average_count][parts];
  DiffuseIncidence() {
    for (int row = 0; row < average_count; ++row) {
      const float alpha = average_alpha_at(row);
      float low = 0;
      for (int i = 0; i < parts; ++i) {
        const float high = i + 1 == parts ? 1 : mu_at(float(i + 1) / parts, alpha);
        mu[row][i] = mu_at((float(i) + 0.5f) / parts, alpha);
        weight[row][i] = (high - low) * (high + low);
        low = high;
      }
    }
  }
};

// A function of mu and alpha, and its average over diffuse incidence as a function of alpha.
struct Table {
  float value[alpha_count][mu_count] = {};
  float average[average_count] = {};

  float at(const Position& r, const Position& m) const {
    const float a = mix(value[r.index][m.index], value[r.index][m.index + 1], m.fraction);
    const float b = mix(value[r.index + 1][m.index], value[r.index + 1][m.index + 1], m.fraction);
    return mix(a, b, r.fraction);
  }
  float average_at(const Position& r) const {
    return mix(average[r.index], average[r.index + 1], r.fraction);
  }
  // Averages of value * scale(mu, alpha), over envelope_average(alpha).
  template <class Scale>
  void integrate(const DiffuseIncidence& incidence, const Scale& scale) {
    for (int row = 0; row < average_count; ++row) {
      const float alpha = average_alpha_at(row);
      const Position r = alpha_position(alpha);
      double sum = 0;
      for (int i = 0; i < DiffuseIncidence::parts; ++i) {
        const float mu = incidence.mu[row][i];
        sum += incidence.weight[row][i] * at(r, mu_position(mu, alpha)) * scale(mu, alpha);
      }
      average[row] = float(sum / envelope_average(alpha));
    }
  }
};

// Points across the cap of visible normals, each ring of them turned around it (half way: it is symmetric). Points of
// neighbouring directions are shifted, so that edges such as that of total reflection fall between different points.
constexpr int cap_points = 16, around_points = 12;
struct Quadrature {
  float drop[cap_points][around_points], weight[cap_points][around_points];
  float cosine[around_points], sine[around_points];
  Quadrature() {
    constexpr int shift[around_points] = {0, 6, 3, 9, 1, 7, 4, 10, 2, 8, 5, 11};
    for (int j = 0; j < around_points; ++j) {
      const double phi = pi_d * (j + 0.5) / around_points;
      cosine[j] = float(std::cos(phi));
      sine[j] = float(std::sin(phi));
      for (int i = 0; i < cap_points; ++i) {
        const double rest = (i + (shift[j] + 0.5) / around_points) / cap_points;
        drop[i][j] = float(1 - rest * rest);  // crowds points where facets are seen edge-on
        weight[i][j] = float(2 * rest / (cap_points * around_points));
      }
    }
    double total = 0;
    for (const auto& ring : weight)
      for (float w : ring) total += w;
    for (auto& ring : weight)
      for (float& w : ring) w = float(w / total);
  }
};

float sum_of(const float (&terms)[around_points]) {
  double sum = 0;
  for (float term : terms) sum += term;
  return float(sum);
}

// Facets visible from one direction: the cosine to them, and reflection at them, for a ring of the quadrature.
struct Ring {
  float cos_h[around_points], h_z[around_points];
  float reflected[around_points];  // G2 / G1, 0 below the horizon
  float weight[around_points];
};

// The inner loops have no branch, so that compilers can make them vectors.
Ring visible_ring(const Quadrature& quadrature, int i, const Vec3& wo, float alpha) {
  const Vec3 v = normalize(Vec3{alpha * wo.x, 0, wo.z});
  const float a2 = alpha * alpha, root_o = smith_root(wo, alpha);
  Ring ring;
  for (int j = 0; j < around_points; ++j) {
    const float drop = quadrature.drop[i][j] * (1 + v.z), sine = std::sqrt(std::max(0.0f, drop * (2 - drop)));
    const float x = alpha * (v.x + sine * quadrature.cosine[j]), y = alpha * sine * quadrature.sine[j];
    const float z = std::max(v.z + (1 - drop), 1e-12f), scale = 1 / std::sqrt(x * x + y * y + z * z);
    const float cos_h = std::max(0.0f, (wo.x * x + wo.z * z) * scale);
    const float wi_x = 2 * cos_h * x * scale - wo.x, wi_y = 2 * cos_h * y * scale;
    const float wi_z = std::max(0.0f, 2 * cos_h * z * scale - wo.z);
    const float root_i = std::sqrt(a2 * (wi_x * wi_x + wi_y * wi_y) + wi_z * wi_z);
    ring.weight[j] = quadrature.weight[i][j];
    ring.cos_h[j] = cos_h;
    ring.h_z[j] = z * scale;
    ring.reflected[j] = wi_z * (wo.z + root_o) / (wo.z * root_i + wi_z * root_o + 1e-30f);
  }
  return ring;
}

// Weighted with the ring: what the coat reflects less than a smooth one would, and what single scattering loses.
struct RingLoss {
  float coat, missing;
};
RingLoss dielectric_ring(const Ring& ring, float wo_z, float alpha, float eta) {
  const float smooth = fresnel_dielectric(wo_z, eta);
  const float a2 = alpha * alpha, inverse_eta = 1 / eta, eta2_minus_1 = (eta - 1) * (eta + 1);
  float coat[around_points], missing[around_points];
  for (int j = 0; j < around_points; ++j) {
    const float c = ring.cos_h[j], square = std::max(0.0f, eta2_minus_1 + c * c);
    const float t = std::sqrt(square);  // eta * cos of refraction
    const float eta2_c = eta * eta * c, rs = (c - t) / (c + t + 1e-30f), rp = (eta2_c - t) / (eta2_c + t + 1e-30f);
    const float fresnel = square > 0 ? 0.5f * (rs * rs + rp * rp) : 1.0f;
    const float wt_z = std::max(0.0f, (wo_z - ring.h_z[j] * c + ring.h_z[j] * t) * inverse_eta);
    const float wt_z2 = wt_z * wt_z;
    const float transmitted = 2 * wt_z / (wt_z + std::sqrt(a2 * std::max(0.0f, 1 - wt_z2) + wt_z2) + 1e-30f);  // G1
    coat[j] = ring.weight[j] * (smooth - fresnel * ring.reflected[j]);
    missing[j] = ring.weight[j] * (fresnel * (1 - ring.reflected[j]) + (1 - fresnel) * (1 - transmitted));
  }
  return {sum_of(coat), sum_of(missing)};
}

struct Tables {
  Table conductor;
  std::array<Table, ior_count> coat, outside, inside;

  Tables() {
    for (int r = 0; r < alpha_count; ++r)
      for (int m = 0; m < mu_count; ++m) fill(r, m);
    const DiffuseIncidence incidence;
    conductor.integrate(incidence, envelope);
    for (int n = 0; n < ior_count; ++n) {
      const float ior = ior_at(n);
      coat[n].integrate(incidence,
                        [ior](float mu, float alpha) { return envelope(mu, alpha) * fresnel_dielectric(mu, ior); });
      outside[n].integrate(incidence, envelope);
      inside[n].integrate(incidence, envelope);
    }
  }

  void fill(int r, int m) {
    static const Quadrature quadrature;
    const float alpha = alpha_at(r), mu = mu_at(float(m) / (mu_count - 1), alpha), e = envelope(mu, alpha);
    const Vec3 wo{std::sqrt(std::max(0.0f, (1 - mu) * (1 + mu))), 0, mu};
    for (int i = 0; i < cap_points; ++i) {
      const Ring ring = visible_ring(quadrature, i, wo, alpha);
      float missing[around_points];
      for (int j = 0; j < around_points; ++j) missing[j] = ring.weight[j] * (1 - ring.reflected[j]);
      conductor.value[r][m] += sum_of(missing) / e;
      for (int n = 0; n < ior_count; ++n) {
        const float ior = ior_at(n);
        const RingLoss from_outside = dielectric_ring(ring, mu, alpha, ior);
        coat[n].value[r][m] += from_outside.coat / (e * fresnel_dielectric(mu, ior));
        outside[n].value[r][m] += from_outside.missing / e;
        inside[n].value[r][m] += dielectric_ring(ring, mu, alpha, 1 / ior).missing / e;
      }
    }
    // Where next to nothing is missing, rounding must not leave less than nothing.
    conductor.value[r][m] = std::max(0.0f, conductor.value[r][m]);
    for (int n = 0; n < ior_count; ++n) {
      outside[n].value[r][m] = std::max(0.0f, outside[n].value[r][m]);
      inside[n].value[r][m] = std::max(0.0f, inside[n].value[r][m]);
    }
  }
};

// Made once and never freed. Without a lock, which a child of fork() might find held for ever.
const Tables& tables() {
  static std::atomic<const Tables*> kept{};
  if (const Tables* made = kept.load(std::memory_order_acquire)) return *made;
  auto mine = std::make_unique<const Tables>();
  const Tables* first = nullptr;
  return kept.compare_exchange_strong(first, mine.get(), std::memory_order_acq_rel) ? *mine.release() : *first;
}

float missing_lobe(float mu, float alpha, float envelopes) { return mu * envelope(mu, alpha) / (pi * envelopes); }

// Between the tables of two indices.
float between(const std::array<Table, ior_count>& by_ior, float mu, float alpha, float ior) {
  const Position n = ior_position(ior), r = alpha_position(alpha), m = mu_position(mu, alpha);
  return mix(by_ior[n.index].at(r, m), by_ior[n.index + 1].at(r, m), n.fraction);
}
float average_between(const std::array<Table, ior_count>& by_ior, const Position& alpha, const Position& ior) {
  return mix(by_ior[ior.index].average_at(alpha), by_ior[ior.index + 1].average_at(alpha), ior.fraction);
}

}  // namespace

InterfaceAlbedo::InterfaceAlbedo(float ior) : ior_(ior), coat_average_(diffuse_fresnel_reflectance(ior)) {
  const Position n = ior_position(ior);
  table_ = int16_t(n.index), table_fraction_ = n.fraction;
}
void InterfaceAlbedo::set_alpha(float alpha) {
  alpha_ = alpha;
  if (!(alpha > 0)) return;
  const Position r = alpha_position(alpha), average = average_position(alpha);
  row_ = int16_t(r.index), row_fraction_ = r.fraction;
  envelopes_ = envelope_average(alpha);
  coat_average_ -= average_between(tables().coat, average, {table_, table_fraction_}) * envelopes_;
  missing_average_ = tables().conductor.average_at(average) * envelopes_;
}
float InterfaceAlbedo::coat(float mu) const {
  const float fresnel = fresnel_dielectric(mu, ior_);
  if (!(alpha_ > 0)) return fresnel;
  const Position r{row_, row_fraction_}, m = mu_position(mu, alpha_);
  const Table* table = &tables().coat[size_t(table_)];
  const float missing = mix(table[0].at(r, m), table[1].at(r, m), table_fraction_);
  return std::clamp(fresnel * (1 - missing * envelope(mu, alpha_)), 0.0f, 1.0f);
}
float InterfaceAlbedo::missing(float mu) const {
  if (!(alpha_ > 0)) return 0;
  return std::min(1.0f, tables().conductor.at({row_, row_fraction_}, mu_position(mu, alpha_)) * envelope(mu, alpha_));
}

float dielectric_missing(float mu, float alpha, float ior, bool inside) {
  const auto& by_ior = inside ? tables().inside : tables().outside;
  return std::min(1.0f, between(by_ior, mu, alpha, ior) * envelope(mu, alpha));
}
float dielectric_missing_average(float alpha, float ior, bool inside) {
  return average_between(inside ? tables().inside : tables().outside, average_position(alpha), ior_position(ior)) *
         envelope_average(alpha);
}

float missing_lobe_pdf(float mu, float alpha) { return missing_lobe(mu, alpha, envelope_average(alpha)); }
float InterfaceAlbedo::missing_lobe_pdf(float mu) const { return missing_lobe(mu, alpha_, envelopes_); }

Vec3 sample_missing_lobe(float alpha, const Vec2& u) {
  // CDF of mu: log(1 + mu^2 / alpha^2) over its value at mu = 1
  const float a2 = alpha * alpha;
  const float mu = std::min(1.0f, alpha * std::sqrt(std::expm1(u.x * std::log1p(1 / a2))));
  const float sine = std::sqrt(std::max(0.0f, (1 - mu) * (1 + mu))), phi = 2 * pi * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), mu};
}

}  // namespace ups
