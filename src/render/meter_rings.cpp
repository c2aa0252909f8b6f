// See meter_rings.h. Of discs out to ring k: plain, the mean; fourth, the fit of E + a r^2 at the centre, whose bias is
// of fourth order. Their difference estimates the bias of the former. Both are linear in the rings' fluxes. Of half
// discs, which lean, E + a r: read r^(1/2) for r below.
#include "render/meter_rings.h"

#include <algorithm>
#include <cmath>

#include "render/spread.h"
#include "render/zero_bound.h"

namespace ups {

namespace {

constexpr uint32_t least_photons = 5;  // of a disc that may be chosen
constexpr uint32_t quarter = 4;        // rings, to a quarter of the radius
// Standard deviations. A disc that is left by chance costs a reading most of its photons, and the narrower one is just
// the one that chance has most to do with; and photons are not quite as random as Poisson's. A bound only widens.
constexpr double beyond_doubt = 6, likely = 4;
constexpr uint64_t few = 8;  // photons

uint32_t visits_of_half(size_t half, uint32_t visits) {
  uint32_t sum = 0;
  for (uint32_t b = uint32_t(half); b < batch_count; b += 2) sum += visits_of_batch(visits, b);
  return sum;
}

// plain - fourth = sum (alpha + beta r_j^2) flux_j out to each ring: with the moments m_i = sum area_j r_j^(2 i),
// fourth = sum (m_2 - m_1 r_j^2) / (m_0 m_2 - m_1^2) flux_j.
struct BiasKernel {
  double alpha[max_rings] = {}, beta[max_rings] = {};
  explicit BiasKernel(const Rings& rings) {
    double m0 = 0, m1 = 0, m2 = 0;
    for (uint32_t k = 0; k < rings.count; ++k) {
      const double a = rings.area[k], u = rings.bias_scale[k];
      m0 += a, m1 += a * u, m2 += a * u * u;
      const double determinant = m0 * m2 - m1 * m1;
      if (!(determinant > 1e-9 * m0 * m2)) continue;  // one ring: no bias is seen
      alpha[k] = 1 / m0 - m2 / determinant;
      beta[k] = m1 / determinant;
    }
  }
  double at(const Rings& rings, uint32_t disc, uint32_t ring) const {
    return ring <= disc ? alpha[disc] + beta[disc] * rings.bias_scale[ring] : 0.0;
  }
};

// What the widest disc's batches vary beyond independent photons, where that is no chance (3 of its standard deviations).
double clump(double ratio) { return ratio > 1 + 3 * std::sqrt(2.0 / (batch_count - 1)) ? ratio : 1; }

}  // namespace

// Of discs out to each ring, for one visit.
struct MeterRings::Sums {
  double area[max_rings], flux[max_rings], square[max_rings], bias_scale[max_rings];
  double of_ring[max_rings], square_of_ring[max_rings];
  uint64_t count[max_rings];
  uint32_t max_ring;
  double clump = 1;  // photons that come together, as paths from the same ray of a file do: one of independent ones
  double mean(uint32_t k) const { return flux[k] / area[k]; }
  double variance(uint32_t k) const { return clump * square[k] / (area[k] * area[k]); }
  // Light is narrower than the disc that a mean is of: the disc to ring k holds another number of photons than that
  // mean predicts, by more than so many standard deviations of a normal number as likely.
  bool differs(uint32_t k, double mean, double sigmas) const {
    if (!(flux[max_ring] > 0)) return false;
    double photon = square[max_ring] / flux[max_ring];
    if (flux[k] > 0) photon = std::max(photon, square[k] / flux[k]);
    photon *= clump;
    return poisson_deviance(flux[k] / photon, mean * area[k] / photon) > sigmas * sigmas;
  }
  // What two discs differ in by bias, less so many times what noise contributes.
  double bias2_between(uint32_t k, uint32_t narrower, double times) const {
    const double share = area[narrower] / area[k], d = mean(k) - mean(narrower);
    const double noise2 = (1 - share) * (1 - share) * variance(narrower) +
                          clump * (square[k] - square[narrower]) / (area[k] * area[k]);
    return std::max(0.0, d * d - times * noise2);
  }
  // What discs narrower than one of these lx say.
  NarrowLight narrower(const Rings& rings, double lx, uint32_t disc, double sure) const {
    NarrowLight most;
    for (uint32_t k = rings.narrowest; k < disc; ++k)
      if (differs(k, lx, sure) && (mean(k) < lx || double(count[k]) >= clump * few))
        most = larger(most, {mean(k) - lx, chance_of(k)});
    return most;
  }
  // Of a disc's mean, 95 %: two standard deviations, and three photons of all where it has none.
  double chance_of(uint32_t k) const {
    return std::max(2 * std::sqrt(variance(k)), 3 * clump * square[max_ring] / (flux[max_ring] * area[k]));
  }
  static NarrowLight larger(const NarrowLight& a, const NarrowLight& b) { return a.size() < b.size() ? b : a; }
  // What few photons that lie close together may bring there, 95 %, beyond a disc's lx: closer than so many of all would
  // lie, spread over the widest disc, in 98 of 100 cases; else 0. A single one that happens to be right in the middle
  // counts no more than at a hundredth of that disc. events: of which they come, at most. Discs that hold half of them
  // and more are looked at: one that holds all is up to twice as large as what they fill, and strays lie beyond.
  NarrowLight crowded(const Rings& rings, double lx, uint32_t events) const {
    const uint64_t photons = count[max_ring];
    const double n = double(std::min<uint64_t>(photons, events));
    if (n < 1 || photons >= 2 * few) return {};
    constexpr uint32_t to_a_hundredth = 7;  // rings
    const uint32_t narrowest = max_ring - std::min(max_ring, to_a_hundredth);
    NarrowLight most;
    for (uint32_t k = first_with((photons + 1) / 2, rings); k <= max_ring; ++k) {
      const double here = double(count[k]) * n / double(photons),
                   ways = std::tgamma(n + 1) / (std::tgamma(here + 1) * std::tgamma(n - here + 1));
      if (here < 1 || (here < 2 && k < narrowest)) continue;
      if (ways * std::pow(area[k] / area[max_ring], here) <= 0.02)
        most = larger(larger(most, {0, lx}), {mean(k) - lx, mean(k) * std::max(1.0, poisson_excess(here) / here)});
    }
    return most;
  }
  // The last before one from which a narrower one differs.
  uint32_t widest(const Rings& rings) const {
    for (uint32_t k = first_with(least_photons, rings); k < max_ring; ++k)
      for (uint32_t narrower = rings.narrowest; narrower <= k; ++narrower)
        if (differs(narrower, mean(k + 1), beyond_doubt)) return k;
    return max_ring;
  }
  RingProfile profile(const Rings& rings, double lx) const {
    RingProfile p{lx, rings.radius2[max_ring], rings.narrowest, {}, {}};
    for (uint32_t k = 0; k <= max_ring && lx > 0; ++k)
      if (area[k] > 0) p.mean[k] = float(mean(k) / lx), p.variance[k] = float(variance(k) / (lx * lx));
    return p;
  }
  // The first that has so many photons, if any has; at least the narrowest that is resolved.
  uint32_t first_with(uint64_t photons, const Rings& rings) const {
    uint32_t k = rings.narrowest;
    while (k + 1 < rings.count && double(count[k]) < clump * double(photons)) ++k;
    return k;
  }
};

MeterRings::MeterRings(size_t meters, size_t columns, uint32_t rings, bool direct, bool caustics)
    : rings_(rings), flux_(meters * columns * batch_count * rings), direct_(direct ? flux_.size() : 0),
      square_(meters * columns * halves * rings), count_(square_.size()), lean_(meters * columns * rings * 2),
      largest_(meters * columns * rings), caustics_(caustics), sure_(deviations_among(meters, likely)) {}

void MeterRings::add(size_t row, uint32_t batch, const MeterLanding& l, uint32_t iteration) {
  const size_t of_half = (row * halves + batch % halves) * rings_ + l.ring;
  const size_t of_batch = (row * batch_count + batch) * rings_ + l.ring, of_row = row * rings_ + l.ring;
  flux_[of_batch] += l.lm;
  square_[of_half] += l.lm * l.lm;
  count_up(count_[of_half], 1);
  // The mean direction over an octant: between pi/8 and its neighbours' edges, sin(pi/8) / (pi/8) long.
  const double near = 0.9003163, off = 0.3729232;
  const double s = l.octant & 1 ? off : near, t = l.octant & 1 ? near : off;
  lean_[of_row * 2] += l.octant & 2 ? -s * l.lm : s * l.lm;
  lean_[of_row * 2 + 1] += l.octant & 4 ? -t * l.lm : t * l.lm;
  if (l.direct && !direct_.empty()) direct_[of_batch] += l.lm;
  if (float(l.lm) > largest_[of_row].photon.value)
    largest_[of_row] = {{float(l.lm), {iteration, PathNumber::light(l.path)}}, uint8_t(batch)};
}

MeterRings::Sums MeterRings::sums_of(size_t row, const Rings& rings, size_t begin, size_t end, uint32_t visits) const {
  Sums s;
  s.max_ring = rings.count - 1;
  double area = 0, flux = 0, square = 0, moment = 0;
  uint64_t count = 0;
  for (uint32_t k = 0; k < rings.count; ++k) {
    s.of_ring[k] = s.square_of_ring[k] = 0;
    for (size_t half = begin; half < end; ++half) {
      for (uint32_t b = uint32_t(half); b < batch_count; b += 2) s.of_ring[k] += this->flux(row, b, k) / visits;
      s.square_of_ring[k] += square_[(row * halves + half) * rings_ + k] / (double(visits) * visits);
      count += count_[(row * halves + half) * rings_ + k];
    }
    s.area[k] = area += rings.area[k];
    moment += rings.area[k] * rings.bias_scale[k];
    s.bias_scale[k] = area > 0 ? moment / area : 0;
    s.flux[k] = flux += s.of_ring[k];
    s.square[k] = square += s.square_of_ring[k];
    s.count[k] = count;
  }
  return s;
}

// Least noise^2 + bias^2, searched from narrow to wide up to the first disc whose bias is beyond doubt: wider ones that
// look harmless again have only diluted it.
// Bias: a disc's own hides in its noise long after it matters: that of each wider disc, b^2 - s_b^2, stands for half of
// its own too, in proportion to r^2 as light has it that curves evenly. Beside an edge the fit sees but a third of a
// wide disc's bias, a disc of a quarter of the radius all but its own: as that has much noise, three times of it are
// taken off. What is noise of all that, the neighbours' curvature replaces.
// Neighbours' steps know better than the meter's own what a quarter of the radius differs in: bias squared, less twice its
// noise, and what the meter may differ from them in. Of many meters chance shows some a bias of four deviations: beside
// neighbours that tell it takes six.
// Noise: that of the mean of two halves. Variances are from the photons' own squares: batches of a half are too few. So
// are its photons to tell light that is narrower than a disc: `widest` is told by all. A small disc that only dim
// photons have reached does not know its noise: as long as bright ones are due there by chance, the widest disc's tells;
// of caustics, whose brightest are few and far brighter, that of all photons: wherever one lies, it makes noise.
uint32_t MeterRings::best(const Sums& s, const Rings& rings, const Dependence& dependence, const Told& told, double lx,
                          uint32_t widest, const Sums& bright, double bright_variance) {
  const BiasKernel kernel(rings);
  const uint32_t first = s.first_with(least_photons, rings);
  double b1 = 0, q1 = 0, q2 = 0, noise2[max_rings], bias2[max_rings], between2[max_rings], bias_noise2[max_rings];
  const double sure = told.curvature.tell() ? beyond_doubt : likely;
  uint32_t last = std::max(first, widest);
  while (last > first && !(rings.area[last] > 0)) --last;
  for (uint32_t k = 0; k <= last; ++k) {
    const double u = rings.bias_scale[k], alpha = kernel.alpha[k], beta = kernel.beta[k];
    b1 += u * s.of_ring[k], q1 += u * s.square_of_ring[k], q2 += u * u * s.square_of_ring[k];
    if (k < first) continue;
    const double bias = alpha * s.flux[k] + beta * b1,
                 square = alpha * alpha * s.square[k] + 2 * alpha * beta * q1 + beta * beta * q2,
                 of_noise = bias_noise2[k] = dependence.of_bias[k] * std::max(0.0, square);
    const double photons =
                     bright.flux[last] > 0 ? bright.flux[last] * bright.flux[last] / bright.square[last] / s.clump : 0,
                 due = photons * s.area[k] / s.area[last],
                 noise = due < 16 ? bright.variance(last) / bright_variance * s.area[last] / s.area[k] : 0;
    noise2[k] = 0.5 * dependence.of_mean[k] / s.clump * std::max(noise, s.variance(k));
    bias2[k] = std::max(0.0, bias * bias - of_noise);
    between2[k] = k >= first + quarter ? s.bias2_between(k, k - quarter, 3) : 0;
    if (!told.steps) bias2[k] = std::max(bias2[k], between2[k]);
    if (k > first && bias * bias > sure * sure * of_noise && bias * bias > 4 * noise2[k]) last = k;
  }
  uint32_t chosen = last;
  double least = INFINITY, curved = 0;  // of wider discs: bias^2 / scale^2
  const RingProfile profile = s.profile(rings, lx);
  for (uint32_t k = last + 1; k-- > first;) {
    const double scale2 = rings.bias_scale[k] * rings.bias_scale[k];
    curved = std::max(curved, bias2[k] / scale2);
    const double scale = s.mean(last) * s.bias_scale[k], own = told.curvature.share_of_own(scale, bias_noise2[k]),
                 curvature = told.curvature.mean * scale;
    double bias = own * std::max(bias2[k], 0.5 * curved * scale2) + (1 - own) * curvature * curvature;
    if (told.steps && noise2[k] + bias < least) {
      const StepBias b = told.steps(profile, k);
      const double shown = lx * lx * (std::max(0.0, b.mean * b.mean - 2 * b.told_variance) + b.own_variance);
      bias = std::max(bias, b.variance() > 0 ? shown : between2[k]);
    }
    if (noise2[k] + bias < least) least = noise2[k] + bias, chosen = k;
  }
  return chosen;
}

// Photons of stratified passes and of one path are not independent: what the batches vary, over what squares say that
// independent photons would. Of 15 degrees of freedom, so that discs of similar size are taken together, and with few
// photons, whose dependence does not matter, the squares are believed.
MeterRings::Dependence MeterRings::dependence(size_t row, const Sums& s, const Rings& rings, uint32_t visits) const {
  if (visits < batch_count) return {};
  const BiasKernel kernel(rings);
  Dependence own, out;
  double mean[batch_count] = {}, first[batch_count] = {}, bias[batch_count] = {}, q1 = 0, q2 = 0;
  for (uint32_t k = 0; k < rings.count; ++k) {
    const double u = rings.bias_scale[k], alpha = kernel.alpha[k], beta = kernel.beta[k];
    q1 += u * s.square_of_ring[k], q2 += u * u * s.square_of_ring[k];
    for (uint32_t b = 0; b < batch_count; ++b) {
      mean[b] += flux(row, b, k), first[b] += u * flux(row, b, k);
      bias[b] = alpha * mean[b] + beta * first[b];
    }
    const double trust = double(s.count[k]) / double(s.count[k] + 256);
    const auto over = [&](const double* of_batch, double independent) {
      const double error = spread(of_batch, visits).standard_error;
      return independent > 0 ? 1 + trust * (error * error / independent - 1) : 1;
    };
    own.of_mean[k] = over(mean, s.square[k]);
    own.of_bias[k] = over(bias, alpha * alpha * s.square[k] + 2 * alpha * beta * q1 + beta * beta * q2);
  }
  for (uint32_t k = 0; k < rings.count; ++k) {
    const uint32_t from = k - (k > 0), to = k + (k + 1 < rings.count);
    double of_mean = 0, of_bias = 0;
    for (uint32_t j = from; j <= to; ++j) of_mean += own.of_mean[j], of_bias += own.of_bias[j];
    out.of_mean[k] = of_mean / (to - from + 1), out.of_bias[k] = of_bias / (to - from + 1);
  }
  out.clump = clump(out.of_mean[rings.count - 1]);
  // Those of narrow discs come in the same clumps, though they are too few to show it.
  if (out.clump > 1)
    for (uint32_t k = 0; k < rings.count; ++k)
      out.of_mean[k] = std::max(out.of_mean[k], out.clump), out.of_bias[k] = std::max(out.of_bias[k], out.clump);
  return out;
}

// Of all batches.
struct MeterRings::Whole {
  Sums sums;
  Dependence dependence;
};

MeterRings::Whole MeterRings::whole(size_t row, const Rings& rings, uint32_t visits) const {
  Whole w{sums_of(row, rings, 0, halves, visits), {}};
  w.dependence = dependence(row, w.sums, rings, visits);
  w.sums.clump = w.dependence.clump;
  return w;
}

MeterRings::Choice MeterRings::choose(size_t row, const Rings& rings, uint32_t visits, const Told& told) const {
  if (visits < min_batches || rings.count < 2) return {rings.count - 1, rings.count - 1};
  const auto [all, dependence] = whole(row, rings, visits);
  const uint32_t widest = all.widest(rings);
  Choice choice;
  for (size_t half = 0; half < halves; ++half) {
    Sums of_half = sums_of(row, rings, half, half + 1, visits_of_half(half, visits));
    of_half.clump = dependence.clump;
    const double lx = all.mean(rings.count - 1);
    choice[1 - half] = caustics_ ? best(of_half, rings, dependence, told, lx, widest, all, 0.5)
                                 : best(of_half, rings, dependence, told, lx, widest, of_half, 1);
  }
  return choice;
}

RingProfile MeterRings::profile(size_t row, const Rings& rings, uint32_t visits) const {
  const Sums sums = whole(row, rings, visits).sums;
  RingProfile p = sums.profile(rings, sums.mean(rings.count - 1));
  // Least squares by rings, weighted by area: m_i = sum area_j r_j^i, e = (m_2 sum f_j - m_1 sum r_j f_j) / (m_0 m_2 -
  // m_1^2).
  double m0 = 0, m1 = 0, m2 = 0, s0 = 0, s1 = 0, t0 = 0, t1 = 0;
  for (uint32_t k = 0; k < rings.count && p.lx > 0; ++k) {
    const double r = std::sqrt(rings.radius2[k]), *lean = &lean_[(row * rings_ + k) * 2];
    m0 += rings.area[k], m1 += rings.area[k] * r, m2 += rings.area[k] * r * r;
    s0 += lean[0], s1 += r * lean[0], t0 += lean[1], t1 += r * lean[1];
    // Of n directions at random the mean's square exceeds 2 / n in 14 of 100 cases (Rayleigh 1919). Half discs lean
    // whatever falls on them.
    const double toward2 = (s0 * s0 + t0 * t0) / (double(visits) * visits);
    if (caustics_ && rings.bias_scale[k] == rings.radius2[k] &&
        toward2 > 2 * sums.variance(k) * sums.area[k] * sums.area[k])
      p.one_sided[k] = float(std::sqrt(toward2) / sums.flux[k]);
    const double determinant = (m0 * m2 - m1 * m1) * visits * p.lx;
    if (!(m0 * m2 - m1 * m1 > 1e-9 * m0 * m2)) continue;
    p.lean_s[k] = float((m2 * s0 - m1 * s1) / determinant), p.lean_t[k] = float((m2 * t0 - m1 * t1) / determinant);
  }
  return p;
}

void MeterRings::Photons::add(const Photons& o) {
  for (uint32_t b = 0; b < batch_count; ++b) value[b] += o.value[b], direct[b] += o.direct[b], bias[b] += o.bias[b];
  if (o.paths.largest > paths.largest) largest_batch = o.largest_batch, largest = o.largest;
  lx += o.lx;
  widest = o.widest && (widest || paths.count == 0);
  paths.add(o.paths);
  count_up(caustics, o.caustics);
  choice_variance += o.choice_variance;
  bias_scale = std::max(bias_scale, o.bias_scale);
  widest_scale = std::max(widest_scale, o.widest_scale);
  caustic.shift += o.caustic.shift, caustic.chance += o.caustic.chance;
  halves_differ |= o.halves_differ;
  brings_direct |= o.brings_direct;
}

MeterRings::Photons MeterRings::read(size_t row, const Rings& rings, const Choice& choice, uint32_t visits,
                                     uint32_t others) const {
  Photons p;
  const Sums s = whole(row, rings, visits).sums;
  if (caustics_) p.caustics = uint32_t(std::min<uint64_t>(s.count[rings.count - 1], UINT32_MAX));
  if (s.count[rings.count - 1] == 0) return p;
  p.halves_differ = choice[0] != choice[1];
  p.widest = s.area[std::min(choice[0], choice[1])] == s.area[rings.count - 1];
  p.brings_direct = !direct_.empty();
  for (uint32_t b = 0; b < batch_count; ++b) {
    const uint32_t out_to = choice[b % 2];
    for (uint32_t k = 0; k <= out_to; ++k) {
      p.value[b] += flux(row, b, k);
      if (!direct_.empty()) p.direct[b] += direct_[(row * batch_count + b) * rings_ + k];
    }
    p.value[b] /= s.area[out_to];
    p.direct[b] /= s.area[out_to];
    p.lx += p.value[b] / visits;
  }
  for (uint32_t k = 0; k <= std::max(choice[0], choice[1]); ++k) {
    const Largest& of_ring = largest_[row * rings_ + k];
    const uint32_t out_to = choice[of_ring.batch % halves];
    const float largest = float(of_ring.photon.value / s.area[out_to]);
    if (k <= out_to && largest > p.paths.largest)
      p.paths.largest = largest, p.largest_batch = of_ring.batch, p.largest = of_ring.photon.from;
    for (size_t half = 0; half < halves; ++half)
      if (k <= choice[half]) count_up(p.paths.count, count_[(row * halves + half) * rings_ + k]);
  }

  const BiasKernel kernel(rings);
  const double share = double(visits_of_half(0, visits)) / visits;
  for (uint32_t k = 0; k < rings.count; ++k) {
    const double d = share * kernel.at(rings, choice[0], k) + (1 - share) * kernel.at(rings, choice[1], k);
    for (uint32_t b = 0; b < batch_count; ++b) p.bias[b] += d * flux(row, b, k);
  }
  // The discs are as random as the halves that choose them: on the average over renders, a quarter of what they differ
  // in is the variance of the halves' mean by that choice. Twice the noise is taken off: it had its part in the choice.
  if (p.halves_differ)
    p.choice_variance = 0.25 * s.bias2_between(std::max(choice[0], choice[1]), std::min(choice[0], choice[1]), 2);
  p.bias_scale = share * s.bias_scale[choice[0]] + (1 - share) * s.bias_scale[choice[1]];
  p.widest_scale = s.bias_scale[rings.count - 1];

  const double t = t_quantile(std::max(visits, min_batches));
  const uint32_t outermost = rings.count - 1;
  // Narrower than both: between them `choice_variance` tells, and the reading has more noise than a disc.
  const NarrowLight narrower = s.narrower(rings, p.lx, std::min(choice[0], choice[1]), sure_);
  const double all = (double(s.count[outermost]) + others) / s.clump;  // few of both: by how many light has been found
  if (caustics_) {
    uint32_t batches = 0;  // of a file of rays copies of one, which lie together, are in one batch
    for (uint32_t b = 0; b < batch_count; ++b) {
      double lm = 0;
      for (uint32_t k = 0; k < rings.count; ++k) lm += flux(row, b, k);
      batches += lm > 0;
    }
    p.caustic = Sums::larger(narrower, s.crowded(rings, p.lx, batches));
  } else {
    p.narrower = narrower.size();
    const double mean = s.mean(s.first_with(std::min(few, s.count[outermost]), rings));
    if (all < 2 * few) p.narrower = std::max(p.narrower, mean * (1 + 2 * t / std::sqrt(all)));
  }
  return p;
}

}  // namespace ups
