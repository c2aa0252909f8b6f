// See prediction.h: errors of meters apart, the model's criterion, its fit to the looks, and the answers.
#include "render/prediction.h"

#include <algorithm>
#include <cmath>

#include "render/zero_bound.h"

namespace ups {

namespace {

constexpr double least_error = 1e-9;  // 0 has no logarithm
// 16 batches know a standard error to 1 / sqrt(2 15); counts for so many looks beside those that there are.
constexpr double look_deviation = 0.18, looks_of_knowledge = 1;
// Of the exponent about the model's: stratification makes noise fall a little faster; estimated bias is that of a
// smooth illuminance, real bias may fall more slowly.
constexpr double rays_exponent_deviation = 0.03, merging_exponent_deviation = 0.06, bias_exponent_deviation = 0.13;
// Batches of one visit each state an error that is off by more than chance: of a look's variance, which is small where
// so many meters know together what 16 batches do not of one.
constexpr double misfit = 3, meters_known_together = 100;
constexpr double interval = 2.1;  // standard deviations of a 95 % interval; Student's t for some 20 degrees of freedom
constexpr double step = 0.1;      // of the curve, in the logarithm of iterations
constexpr size_t steps = 185;     // to 10^8 times the last look's
constexpr size_t most_parts = 512;
// Variance of the logarithm of a deviation by 16 Gaussian batches, and by 8: a quarter of trigamma(7.5) and (3.5).
constexpr double chance_of_16 = 0.0357, chance_of_8 = 0.0826;
constexpr double meters_of_knowledge = 20;  // what few meters tell of it counts beside so many of Gaussian batches

double log_of(double error) { return std::log(std::max(error, least_error)); }

// By what the errors are made of.
double exponent_deviation(const std::vector<MeterError>& meters) {
  double merged = 0, bias = 0, sum = least_error;
  for (const MeterError& m : meters)
    merged += m.widest ? 0 : m.noise * m.merged, bias += m.bias + m.noise * m.of_bias, sum += m.error();
  return (rays_exponent_deviation * (sum - merged - bias) + merging_exponent_deviation * merged +
          bias_exponent_deviation * bias) / sum;
}

void keep_largest(std::vector<MeterError>& all, std::vector<MeterError>& kept, float (*size)(const MeterError&)) {
  const size_t count = std::min(all.size(), most_parts / 2);
  std::partial_sort(all.begin(), all.begin() + ptrdiff_t(count), all.end(),
                    [&](const MeterError& a, const MeterError& b) { return size(a) > size(b); });
  kept.insert(kept.end(), all.begin(), all.begin() + ptrdiff_t(count));
}

}  // namespace

MeterError MeterError::scaled(double scale) const {
  MeterError m = *this;
  for (float* part : {&m.noise, &m.bias, &m.unfound}) *part = float(*part * scale);
  return m;
}

double MeterError::quantile_ratio(double factor) const {
  if (visits < min_batches) return 1;
  const double then = std::clamp(factor * visits, double(min_batches), double(batch_count));
  return t_quantile(uint32_t(then)) / t_quantile(visits);
}

// A point meter's disc knows no schedule of radii: chosen by least error, noise^2 ~ 1 / (n r^2) against bias^2 ~ r^4, it
// has r^2 ~ n^(-1/3). What the meter's own eye path merges farther on does know the schedule, and is foretold as the disc.
constexpr double disc_alpha = 2.0 / 3;

// The widest disc stays as long as a wider one would have less error, of noise^2 ~ 1 / r^2 and bias ~ r^2: while
// noise^2 is more than twice bias^2. Noise of a bound is some two standard errors.
MeterError::Left MeterError::left_of_merging(double factor, double alpha, double stays) const {
  const double noise2 = 0.25 * double(merged) * noise * noise, bias2 = double(bias) * bias,
               until = bias2 > 0 ? std::clamp(noise2 / (2 * bias2), 1.0, stays) : stays,
               wide = widest ? std::min(factor, until) : 1, shrinks = factor / wide;
  return {std::pow(shrinks, -alpha) / wide, std::pow(shrinks, alpha - 1)};
}

// With its estimate goes what is not known of it.
void MeterError::keep_of_bias(double share) {
  const double lost = of_bias * (1 - share * share);
  noise += float((1 - share) * bias), bias *= float(share);
  of_bias -= float(lost), merged += float(lost);
}

void demote_bias(MeterError& m, double threshold) {
  const double z2 = double(m.deviations) * m.deviations;
  m.keep_of_bias(z2 > threshold ? 1 - threshold / z2 : 0.0);
}

namespace {

// P(|t| > z) of Student's t for 16 batches, by its nearly Gaussian transform (Wallace 1959).
double chance_beyond(double z) {
  constexpr double nu = batch_count - 1;
  return std::erfc((8 * nu + 1) / (8 * nu + 3) * std::sqrt(0.5 * nu * std::log1p(z * z / nu)));
}

// Of many meters chance makes some look biased: what it would make, over how many there are with so many deviations or
// more, is the share that counts as noise (false discovery rate; Benjamini, Hochberg 1995).
void demote_biases_of_chance(std::vector<MeterError>& meters, double threshold) {
  std::vector<MeterError*> order;
  for (MeterError& m : meters)
    if (m.bias > 0) order.push_back(&m);
  std::stable_sort(order.begin(), order.end(),
                   [](const MeterError* a, const MeterError* b) { return a->deviations > b->deviations; });
  double by_chance = 1;
  for (size_t k = order.size(); k-- > 0;) {
    MeterError& m = *order[k];
    by_chance = std::min(by_chance, double(order.size()) * chance_beyond(double(m.deviations)) / double(k + 1));
    demote_bias(m, threshold);
    m.keep_of_bias(1 - by_chance);
  }
}

}  // namespace

void MeanError::add(const MeterError& m) {
  noise_ += m.noise, bias_ += m.bias, unfound_ += m.unfound;
  merged_ += double(m.noise) * m.merged, of_bias_ += double(m.noise) * m.of_bias;
  if (m.widest) widest_ += double(m.noise) * m.merged;
  if (m.narrower) narrower_ += double(m.noise) * m.merged;
  paths_ += double(m.unfound) * m.paths;
  if (m.noise > 0 && m.visits > 0) visits_ = visits_ > 0 ? std::min(visits_, m.visits) : m.visits;
  ++count_;
}

MeterError MeanError::mean() const {
  const double count = std::max(count_, 1.0);
  return {.noise = float(noise_ / count),
          .bias = float(bias_ / count),
          .merged = noise_ > 0 ? float(merged_ / noise_) : 0,
          .deviations = 1e9f,
          .unfound = float(unfound_ / count),
          .paths = unfound_ > 0 ? float(paths_ / unfound_) : 0,
          .of_bias = noise_ > 0 ? float(of_bias_ / noise_) : 0,
          .widest = widest_ > 0.5 * merged_,
          .narrower = widest_ <= 0.5 * merged_ && widest_ + narrower_ > 0.5 * merged_,
          .visits = visits_};
}

void Prediction::add_look(const Look& look, std::vector<MeterError> meters) {
  looks_.push_back(look);
  if (meters.empty()) meters.push_back({.noise = float(look.error)});
  if (meters.size() == 1 && meters[0].error() > 0) meters[0] = meters[0].scaled(look.error / double(meters[0].error()));
  reduce(std::move(meters));
  fit();
}

// A curve of the criterion is found many times over: of many meters some stand for all.
void Prediction::reduce(std::vector<MeterError>&& meters) {
  meters_ = double(meters.size());
  find_stay(meters);
  find_chance(meters);
  exponent_deviation_ = exponent_deviation(meters);
  // The worst one's is the largest of all that chance makes.
  const double threshold = criterion_ == UPS_CRITERION_WORST ? 2 * std::max(1.0, std::log(meters_)) : 2;
  demote_biases_of_chance(meters, threshold);
  parts_.clear();
  if (criterion_ == UPS_CRITERION_MEAN) {
    MeanError mean;
    for (const MeterError& m : meters) mean.add(m);
    parts_.push_back(mean.mean());
  } else if (meters.size() <= most_parts) {
    parts_ = std::move(meters);
  } else if (criterion_ == UPS_CRITERION_WORST) {
    keep_largest(meters, parts_, [](const MeterError& m) { return m.error(); });
    keep_largest(meters, parts_, [](const MeterError& m) { return m.bias; });
  } else {
    const auto less = [](const MeterError& a, const MeterError& b) { return a.error() < b.error(); };
    std::sort(meters.begin(), meters.end(), less);
    for (size_t i = 0; i < most_parts; ++i)
      parts_.push_back(meters[size_t((double(i) + 0.5) / most_parts * double(meters.size()))]);
  }
}

// Were discs to leave the widest as odds of those that did grow with n, half of those that have not would by so many
// times the visits.
void Prediction::find_stay(const std::vector<MeterError>& meters) {
  double widest = 0, narrower = 0;
  for (const MeterError& m : meters) widest += m.widest, narrower += m.narrower;
  stays_ = 2 + widest / std::max(narrower, 1e-3);
}

// Of many stated errors a quantile or the worst is partly chance: 16 batches know a deviation the less surely the more
// seldom what makes it. As batches grow they turn Gaussian, and stated errors come closer together. How far chance
// moves them is seen from two halves of the batches.
void Prediction::find_chance(const std::vector<MeterError>& meters) {
  double halves = 0, sum = 0, squares = 0, count = 0;
  for (const MeterError& m : meters) {
    if (!(m.noise > least_error) || m.halves == 0) continue;
    const double log_noise = std::log(double(m.noise));
    halves += double(m.halves) * m.halves / 2, sum += log_noise, squares += log_noise * log_noise, ++count;
  }
  excess_ = std::max(0.0, (halves - count * chance_of_8) / (count + meters_of_knowledge) / 2);
  log_mean_ = count > 0 ? sum / count : 0;
  log_variance_ = count > 1 ? (squares - sum * log_mean_) / (count - 1) : 0;
}

Prediction::Model Prediction::model(double factor) const {
  const double now = chance_of_16 + excess_, then = chance_of_16 + excess_ / factor,
               all_variance = std::max(log_variance_, now);
  const double nearer = std::sqrt((all_variance - now + then) / all_variance), rise = now - then;
  const auto noise = [&](const MeterError& m) {
    return m.noise > least_error ? m.noise * std::exp(rise + (nearer - 1) * (std::log(double(m.noise)) - log_mean_))
                                 : double(m.noise);
  };
  const double of_rest = 1 / factor;
  std::vector<std::pair<double, double>> all;  // error, bias
  for (const MeterError& m : parts_) {
    const MeterError::Left left = m.left_of_merging(factor, m.is_disc() ? disc_alpha : alpha_, stays_);
    const double of_rays = std::max(0.0, 1 - double(m.merged) - double(m.of_bias)), bias = m.bias * left.bias,
                 square = of_rays * of_rest + m.merged * left.noise2, now_noise = noise(m) * m.quantile_ratio(factor),
                 all_noise = now_noise * std::sqrt(square + m.of_bias * left.bias * left.bias), paths = double(m.paths),
                 unfound = m.unfound * of_rest * poisson_excess(paths * factor) / poisson_excess(paths);
    all.emplace_back(all_noise + bias + unfound, bias + all_noise - now_noise * std::sqrt(square));
  }
  const double q = criterion_ == UPS_CRITERION_P95 ? 0.95 : criterion_ == UPS_CRITERION_MEDIAN ? 0.5 : 1;
  const auto at = all.begin() + ptrdiff_t(std::min(all.size() - 1, size_t(q * double(all.size()))));
  std::nth_element(all.begin(), at, all.end());
  return {at->first, at->first > 0 ? at->second / at->first : 0};
}

namespace {

// level + exponent u, their covariances, and the variance of one point about them.
struct Line {
  double level = 0, exponent = 0, var_level = 0, covariance = 0, var_exponent = 0, variance = 0;
};

// Through points (u, r) whose deviations have the correlation exp(-|u - u'|): those of looks at n < n' have n / n', as
// the later one's batches hold the earlier one's. Generalized least squares, whitened as in a first-order
// autoregression; the exponent is 0 but for the deviation given.
// variance: of each look, beside the others'.
Line fit_line(const std::vector<double>& u, const std::vector<double>& r, const std::vector<double>& variance,
              double exponent_deviation) {
  std::vector<double> scale;
  for (const double v : variance) scale.push_back(1 / std::sqrt(v));
  const auto for_rows = [&](const auto& row) {
    row(scale[0], scale[0] * u[0], scale[0] * r[0], 1.0);
    for (size_t i = 1; i < u.size(); ++i) {
      const double phi = std::exp(u[i - 1] - u[i]), now = scale[i], before = phi * scale[i - 1];
      row(now - before, now * u[i] - before * u[i - 1], now * r[i] - before * r[i - 1], 1 / (1 - phi * phi));
    }
  };
  Line l;
  l.variance = look_deviation * look_deviation;
  for (int round = 0; round < 3; ++round) {
    double aa = 0, ab = 0, bb = 1 / (exponent_deviation * exponent_deviation), ay = 0, by = 0, squares = 0;
    for_rows([&](double a, double b, double y, double weight) {
      const double w = weight / l.variance;
      aa += w * a * a, ab += w * a * b, bb += w * b * b, ay += w * a * y, by += w * b * y;
    });
    const double determinant = aa * bb - ab * ab;
    l.var_level = bb / determinant, l.covariance = -ab / determinant, l.var_exponent = aa / determinant;
    l.level = l.var_level * ay + l.covariance * by, l.exponent = l.covariance * ay + l.var_exponent * by;
    for_rows([&](double a, double b, double y, double weight) {
      squares += weight * (y - a * l.level - b * l.exponent) * (y - a * l.level - b * l.exponent);
    });
    l.variance = (looks_of_knowledge * look_deviation * look_deviation + squares) /
                 (looks_of_knowledge + double(u.size()));
  }
  return l;
}

}  // namespace

// What looks differ from the model by is fitted, and later looks get their best linear prediction (Goldberger 1962):
// part of the last look's own deviation remains.
void Prediction::fit() {
  std::vector<double> u, r, variance;
  const double first = misfit * meters_ / (meters_ + meters_known_together);  // the first look's batches are short
  const auto variance_at = [&](double iterations) {
    return 1 + first * std::pow(looks_[0].iterations / iterations, 2);
  };
  for (const Look& look : looks_) {
    variance.push_back(variance_at(look.iterations));
    const double factor = look.iterations / looks_.back().iterations;
    u.push_back(std::log(factor));
    r.push_back(log_of(look.error) - log_of(model(factor).error));
  }
  const Line l = fit_line(u, r, variance, exponent_deviation_);
  curve_.clear(), bias_share_.clear();
  for (size_t i = 0; i < steps; ++i) {
    const double later = double(i) * step, phi = std::exp(-later), then = variance_at(looks_.back().iterations / phi),
                 remains = phi * std::sqrt(then / variance.back()), a = 1 - remains;
    const Model m = model(1 / phi);
    const double unknown = a * a * l.var_level + 2 * a * later * l.covariance + later * later * l.var_exponent;
    curve_.push_back({log_of(m.error) + l.level + l.exponent * later + remains * (r.back() - l.level),
                      std::sqrt(l.variance * then * (1 - phi * phi) + unknown)});
    bias_share_.push_back(float(m.bias_share));
  }
}

Prediction::LogError Prediction::log_error(double iterations) const {
  const double at = std::clamp(std::log(iterations / looks_.back().iterations) / step, 0.0, double(steps - 1));
  const size_t i = std::min(size_t(at), steps - 2);
  const double f = at - double(i);
  const LogError &a = curve_[i], &b = curve_[i + 1];
  return {a.mean + f * (b.mean - a.mean), a.deviation + f * (b.deviation - a.deviation)};
}

Prediction::Expected Prediction::expect(double target) const {
  Expected e;
  if (looks_.back().error <= target) {
    size_t i = looks_.size() - 1;
    while (i > 0 && looks_[i - 1].error <= target) --i;
    e.reached = &looks_[i];
    e.iterations = e.low = e.high = e.reached->iterations;
    e.by_bias = bias_share_[0] > 0.5;
    return e;
  }
  // Where the curve, so many deviations off, first meets the target.
  const auto meets = [&](double deviations) {
    const auto above = [&](size_t i) { return curve_[i].mean + deviations * curve_[i].deviation - log_of(target); };
    for (size_t i = 1; i < steps; ++i)
      if (above(i) <= 0) return (double(i) - above(i) / (above(i) - above(i - 1))) * step;
    return -1.0;
  };
  const auto iterations = [&](double later) { return later < 0 ? -1 : looks_.back().iterations * std::exp(later); };
  const double later = meets(0);
  e.iterations = iterations(later);
  e.low = iterations(meets(-interval));
  e.high = iterations(meets(interval));
  e.by_bias = bias_share_[later < 0 ? steps - 1 : size_t(later / step)] > 0.5;
  return e;
}

}  // namespace ups
