// See meter_sums.h.
#include "render/meter_sums.h"

namespace ups {

Spread spread_of_halves(const double* sums, uint32_t visits) {
  Spread s = spread(sums, visits);
  if (s.standard_error < 0) return s;
  double variance = 0;
  for (uint32_t half = 0; half < 2; ++half) {
    double of_half[batch_count / 2];
    uint32_t n = 0, used = 0;
    double mean = 0, square = 0;
    const auto count = [&](uint32_t b) { return visits / batch_count + (b < visits % batch_count); };
    for (uint32_t b = half; b < std::min(visits, batch_count); b += 2) n += count(b), mean += of_half[used++] = sums[b];
    mean /= n;
    for (uint32_t i = 0; i < used; ++i) {
      const double of_batch = count(half + 2 * i), d = of_half[i] / of_batch - mean;
      square += of_batch * d * d;
    }
    variance += double(n) / visits * n / visits * square / (double(n) * (used - 1));
  }
  s.standard_error = std::sqrt(variance);
  return s;
}

void MeterSums::add(uint32_t batch, const MeterTally& t) {
  value[batch] += t.value;
  direct += t.direct;
  bias[batch] += t.bias;
}

void MeterSums::add(const MeterRings::Photons& photons) {
  for (uint32_t b = 0; b < batch_count; ++b) value[b] += photons.value[b];
  direct += photons.direct;
}

ups_meter_reading reading_of(const MeterSums& sums, const MeterRings::Photons& photons, uint32_t visits) {
  if (visits == 0) return {-1, -1, -1, -1, -1, -1};
  const Spread e = photons.halves_differ ? spread_of_halves(sums.value, visits) : spread(sums.value, visits),
               b = spread(sums.bias, visits);
  ups_meter_reading out;
  out.illuminance_lx = float(e.mean);
  out.direct_lx = float(sums.direct / visits);
  out.indirect_lx = float(std::max(0.0, e.mean - double(out.direct_lx)));
  out.bias_lx = float(b.mean + photons.bias);
  out.standard_error_lx = float(e.standard_error);
  out.error_bound_lx = error_bound(e, b, visits);
  if (e.standard_error < 0) return out;
  // The photons' bias: where it is noise, its estimate counts once, as a disc is chosen that has less of it than noise.
  const double t = t_quantile(visits);
  const bool seen = std::abs(photons.bias) > 2 * photons.bias_error;
  const double noise = std::hypot(e.standard_error, b.standard_error, seen ? photons.bias_error : 0);
  const double bias = seen ? std::abs(b.mean + photons.bias) : std::abs(b.mean) + std::abs(photons.bias);
  out.error_bound_lx = float(std::max(bias + t * noise, photons.narrower));
  return out;
}

}  // namespace ups
