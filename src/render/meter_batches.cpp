// See meter_statistics.h: one set's meters by batch, and what is made of them before their order counts.
#include <algorithm>
#include <cmath>

#include "render/meter_statistics.h"

namespace ups {

void MeterBatches::add(const Meter& meter, const double* batch, const double* bias_batch) {
  meters_.push_back(meter);
  widened_.push_back(0);
  stated_ = -1;
  if (meter.halves_differ) means_ = 2;
  weights_ += meter.weight;
  for (uint32_t b = 0; b < used_; ++b) {
    batches_.push_back(float(batch[b]));
    bias_sums_[b] += meter.weight * bias_batch[b];
  }
}

void MeterBatches::widen(double bound) {
  stated_ = bound;
  if (meters_.back().known && used_ >= min_batches)
    widened_.back() = float(std::max(0.0, bound - this->bound(meters_.size() - 1)));
}

double MeterBatches::standard_error(size_t m) const {
  return error_of_mean(used_, means_, [&](uint32_t b) { return double(batch(m, b)); });
}

double MeterBatches::bound(size_t m) const {
  return offset(m) + (meters_[m].known ? t_quantile(used_, means_) * std::hypot(standard_error(m), bias_error(m)) : 0);
}

double MeterBatches::mean() const {
  double sum = 0;
  for (const Meter& m : meters_) sum += m.weight * m.value;
  return sum / weights_;
}

double MeterBatches::unfound() const {
  double sum = 0;
  for (const Meter& m : meters_) sum += m.weight * (m.unfound_in_mean < 0 ? m.unfound : m.unfound_in_mean);
  return sum / weights_;
}

NarrowLight MeterBatches::caustic() const {
  NarrowLight sum;
  double square = 0;
  for (const Meter& m : meters_) {
    sum.shift += m.weight * m.caustic.shift, sum.chance += m.weight * m.caustic.chance;
    square += std::pow(m.weight * m.caustic.chance, 2);
  }
  return {sum.shift / weights_, std::min(sum.chance, std::sqrt(meet_ * square)) / weights_};
}

double MeterBatches::choice_variance() const {
  double sum = 0;
  for (const Meter& m : meters_) sum += m.weight * m.weight * m.choice_variance;
  return sum / (weights_ * weights_);
}

double MeterBatches::told_bias() const {
  double sum = 0;
  for (const Meter& m : meters_) sum += m.weight * m.bias.mean;
  return sum / weights_;
}

double MeterBatches::mean_of_batch(uint32_t b) const {
  double sum = 0;
  for (size_t m = 0; m < count(); ++m) sum += meters_[m].weight * double(batch(m, b));
  return sum / weights_;
}

// First order: (x_b - r mean_b) / mean about r = x / mean.
MeterBatches MeterBatches::over_mean() const {
  MeterBatches out(used_);
  const double mean = this->mean(), unfound = this->unfound() + caustic().size();
  double of_set[batch_count], own[batch_count];
  const double no_bias[batch_count] = {};
  for (uint32_t b = 0; b < used_; ++b) of_set[b] = mean_of_batch(b);
  const double bias = told_bias();
  for (size_t m = 0; m < count(); ++m) {
    const double ratio = value(m) / mean;
    for (uint32_t b = 0; b < used_; ++b) own[b] = ratio + (double(batch(m, b)) - ratio * of_set[b]) / mean;
    const Spread own_bias{(meters_[m].bias.mean - ratio * bias) / mean, bias_error(m) / mean};
    out.add({ratio, own_bias, (meters_[m].unfound + ratio * unfound) / mean, meters_[m].weight, meters_[m].known,
             meters_[m].halves_differ},
            own, no_bias);
    out.widened_.back() = widened_[m] / float(mean);
  }
  return out;
}

MeterBatches MeterBatches::negative() const {
  MeterBatches out = *this;
  for (Meter& m : out.meters_) m.value = -m.value, m.caustic.shift = -m.caustic.shift;
  for (float& v : out.batches_) v = -v;
  return out;
}

MeterBatches MeterBatches::moved(double sign) const {
  MeterBatches out = *this;
  for (size_t m = 0; m < count(); ++m) {
    Meter& meter = out.meters_[m];
    const double by = sign * offset(m);
    meter.value += by;
    for (uint32_t b = 0; b < used_; ++b) {
      float& own = out.batches_[m * used_ + b];
      own = meter.known ? float(double(own) + by) : float(meter.value);
    }
    meter.bias = {0, meter.known ? meter.bias.standard_error : 0};
    meter.unfound = 0, meter.caustic = {}, meter.unfound_in_mean = -1, meter.known = true;
    out.widened_[m] = 0;
  }
  return out;
}

}  // namespace ups
