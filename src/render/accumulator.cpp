// See accumulator.h: meters, images and their techniques in the order in, readings out, then summaries of the errors.
#include "render/accumulator.h"

#include <algorithm>
#include <cmath>

namespace ups {

namespace {

ErrorSummary summary_of(std::vector<double> errors, double bias_share) {
  ErrorSummary s;
  if (errors.empty()) return s;
  double sum = 0, worst = 0;
  for (double e : errors) {
    sum += e;
    worst = std::max(worst, e);
  }
  s.mean = float(sum / double(errors.size()));
  s.worst = float(worst);
  s.p95 = float(quantile(errors, 0.95));
  s.median = float(quantile(errors, 0.5));
  s.bias_share = float(bias_share);
  return s;
}

}  // namespace

Accumulator::Accumulator(const Snapshot& scene, const Plan& plan)
    : plan_(plan), emitted_lm_(scene.emitters.flux_lm()), emits_(emitted_lm_ > 0) {
  for (const Goniometer& g : scene.goniometers) goniometers_.emplace_back(g);
  for (const MeterSet& set : scene.meter_sets) {
    meters_.emplace_back(set.meters.size());
    separated_.emplace_back(set.meters.size() * plan.separation.columns.size());
  }
  for (const Camera& c : scene.cameras) {
    const size_t n = size_t(c.pixel_count()) * 3;
    images_.push_back({c.width(), c.height(), std::vector<double>(c.illuminance() ? n / 3 : 0), std::vector<double>(n),
                       std::vector<double>(n), std::vector<float>(n), std::vector<float>(n * batch_count),
                       std::vector<uint32_t>(plan.camera_subsets), {}, {}, {}});
  }
}

void Accumulator::MeterSums::add(uint32_t batch, const MeterTally& t) {
  value[batch] += t.value;
  direct += t.direct;
  bias[batch] += t.bias;
}

void Accumulator::add(const IterationTally& tally) {
  const uint32_t batch = iterations_ % batch_count;
  for (size_t s = 0; s < meters_.size(); ++s) {
    for (size_t m = 0; m < meters_[s].size(); ++m) meters_[s][m].add(batch, tally.meters[s][m]);
    for (size_t i = 0; i < separated_[s].size(); ++i) separated_[s][i].add(batch, tally.separated[s][i]);
  }
  for (size_t c = 0; c < images_.size(); ++c) add_image(c, tally);
  for (size_t g = 0; g < goniometers_.size(); ++g) goniometers_[g].add(batch, tally.goniometers[g]);
  work_.add(tally.work);
  ++iterations_;
}

namespace {

void add_rgb(std::vector<double>& sums, const std::vector<Rgb>& values) {
  sums.resize(values.size() * 3);
  for (size_t i = 0; i < values.size(); ++i) {
    sums[i * 3] += values[i].r;
    sums[i * 3 + 1] += values[i].g;
    sums[i * 3 + 2] += values[i].b;
  }
}

}  // namespace

void Accumulator::add_techniques(Image& image, const TechniqueTally& tally) {
  add_rgb(image.weighted, tally.weighted);
  add_rgb(image.unweighted, tally.unweighted);
  for (size_t f = 0; f < 2; ++f) add_rgb(image.families[f], tally.families[f]);
}

void Accumulator::add_image(size_t c, const IterationTally& tally) {
  Image& image = images_[c];
  if (!tally.techniques.empty()) add_techniques(image, tally.techniques[c]);
  const uint32_t pixels = image.width * image.height, subsets = plan_.camera_subsets;
  ++image.visits[iterations_ % subsets];
  for (uint32_t p = 0; p < pixels; ++p) {
    if (!plan_.visits_pixel(iterations_, image.width, p)) continue;
    if (!image.illuminance.empty()) image.illuminance[p] += tally.illuminance[c][p];
    const Rgb& v = tally.pixels[c][p];
    const float rgb[3] = {v.r, v.g, v.b};
    for (int k = 0; k < 3; ++k) {
      image.eye[p * 3 + k] += rgb[k];
      image.pending[p * 3 + k] += rgb[k];
    }
  }
  const float per_pass = 1.0f / float(subsets);
  if (!tally.splats[c].empty())
    for (uint32_t p = 0; p < pixels; ++p) {
      const Rgb& v = tally.splats[c][p];
      const float rgb[3] = {v.r, v.g, v.b};
      for (int k = 0; k < 3; ++k) {
        image.splat[p * 3 + k] += rgb[k];
        image.pending[p * 3 + k] += rgb[k] * per_pass;
      }
    }
  if ((iterations_ + 1) % subsets != 0) return;
  float* batch = image.batches.data() + size_t(plan_.pass(iterations_) % batch_count) * pixels * 3;
  for (size_t i = 0; i < size_t(pixels) * 3; ++i) batch[i] += image.pending[i];
  std::fill(image.pending.begin(), image.pending.end(), 0.0f);
}

ups_meter_reading Accumulator::reading_of(const MeterSums& sums) const {
  const Spread e = spread(sums.value, iterations_), b = spread(sums.bias, iterations_);
  ups_meter_reading out;
  out.illuminance_lx = float(e.mean);
  out.direct_lx = float(iterations_ ? sums.direct / iterations_ : 0.0);
  out.indirect_lx = float(std::max(0.0, e.mean - double(out.direct_lx)));
  out.bias_lx = float(b.mean);
  out.standard_error_lx = float(e.standard_error);
  out.error_bound_lx = error_bound(e, b, iterations_);
  return out;
}

MeterSetReading Accumulator::read_meters_and_sources(size_t set) const {
  MeterSetReading r = read_meters(set);
  const size_t columns = plan_.separation.columns.size();
  for (size_t c = 0; c < columns; ++c) {
    std::vector<ups_meter_reading>& column = r.separated.emplace_back();
    for (size_t m = 0; m < r.meters.size(); ++m) column.push_back(reading_of(separated_[set][m * columns + c]));
  }
  return r;
}

MeterSetReading Accumulator::read_meters(size_t set) const {
  const std::vector<MeterSums>& meters = meters_[set];
  MeterSetReading r;
  r.meters.resize(meters.size());
  double batch_mean[batch_count] = {}, minimum = INFINITY, maximum = 0;
  for (size_t m = 0; m < meters.size(); ++m) {
    const MeterSums& sums = meters[m];
    r.meters[m] = reading_of(sums);
    const double mean = spread(sums.value, iterations_).mean;
    minimum = std::min(minimum, mean);
    maximum = std::max(maximum, mean);
    for (uint32_t k = 0; k < batch_count; ++k) batch_mean[k] += sums.value[k] / double(meters.size());
  }
  const Spread mean = spread(batch_mean, iterations_);
  ups_meter_statistics& s = r.statistics;
  s.struct_size = sizeof s;
  s.count = uint32_t(meters.size());
  s.mean_lx = mean.mean;
  s.min_lx = minimum;
  s.max_lx = maximum;
  s.uniformity = mean.mean > 0 ? minimum / mean.mean : 0;
  s.mean_standard_error_lx = mean.standard_error;
  std::vector<double> errors;
  for (const ups_meter_reading& m : r.meters)
    if (m.error_bound_lx >= 0 && mean.mean > 0)
      errors.push_back(m.error_bound_lx / std::max(double(m.illuminance_lx), share_of_mean * mean.mean));
  const bool known = mean.standard_error >= 0 && !emits_;  // a set that no light has reached has no known error
  const ErrorSummary e = summary_of(std::move(errors), 0);
  s.median_relative_error_bound = e.median >= 0 ? e.median : known ? 0 : -1;
  s.p95_relative_error_bound = e.p95 >= 0 ? e.p95 : known ? 0 : -1;
  s.worst_relative_error_bound = e.worst >= 0 ? e.worst : known ? 0 : -1;
  return r;
}

ImageReading Accumulator::read_image(size_t c) const {
  const Image& image = images_[c];
  const size_t pixels = size_t(image.width) * image.height;
  ImageReading r{image.width, image.height, std::vector<float>(pixels * 3), std::vector<float>(pixels * 3, -1.0f),
                 std::vector<float>(image.illuminance.size()), {}, {}};
  const uint32_t passes = iterations_ / plan_.camera_subsets;
  for (size_t p = 0; p < pixels; ++p) {
    const uint32_t n = visits(image, p);
    if (!image.illuminance.empty() && n) r.illuminance[p] = float(image.illuminance[p] / n);
    for (size_t i = p * 3; i < p * 3 + 3; ++i) {
      r.luminance_rgb[i] = float((n ? image.eye[i] / n : 0.0) + (iterations_ ? image.splat[i] / iterations_ : 0.0));
      if (passes >= min_batches)
        r.standard_error_rgb[i] = float(spread(image.batches.data() + i, passes, pixels * 3).standard_error);
    }
  }
  if (passes == 0) fill_from_neighbours(image, r);
  return r;
}

ImageReading Accumulator::read_image_and_techniques(size_t c) const {
  ImageReading r = read_image(c);
  read_techniques(images_[c], r);
  return r;
}

// Splats count for each iteration, eye paths for each visit of their pixel.
void Accumulator::read_techniques(const Image& image, ImageReading& r) const {
  if (image.weighted.empty()) return;
  const size_t pixels = size_t(image.width) * image.height, values = pixels * 3;
  std::vector<double> per_visit(pixels);
  for (size_t p = 0; p < pixels; ++p) per_visit[p] = visits(image, p) ? 1.0 / visits(image, p) : 0.0;
  for (size_t f = 0; f < 2; ++f) {
    r.families[f].resize(values);
    const bool splats = Family(f) == Family::path_integration;
    for (size_t i = 0; i < values; ++i)
      r.families[f][i] = float(image.families[f][i] * per_visit[i / 3] + (splats ? image.splat[i] / iterations_ : 0.0));
  }
  for (uint32_t t = 0; t < image.weighted.size() / values; ++t) {
    TechniqueReading out{technique_at(t), std::vector<float>(values), std::vector<float>(values)};
    for (size_t i = 0; i < values; ++i) {
      const double scale = out.technique.t() == 1 ? 1.0 / iterations_ : per_visit[i / 3];
      out.weighted[i] = float(image.weighted[t * values + i] * scale);
      out.unweighted[i] = float(image.unweighted[t * values + i] * scale);
    }
    r.techniques.push_back(std::move(out));
  }
}

uint32_t Accumulator::visits(const Image& image, size_t pixel) const {
  const uint32_t x = uint32_t(pixel % image.width), y = uint32_t(pixel / image.width);
  return image.visits[(x + y * plan_.subset_shift()) % plan_.camera_subsets];
}

size_t Accumulator::unvisited_pixels(size_t c) const {
  if (iterations_ >= plan_.camera_subsets) return 0;
  size_t count = 0;
  for (size_t p = 0; p < size_t(images_[c].width) * images_[c].height; ++p) count += visits(images_[c], p) == 0;
  return count;
}

// A render that ended within its first pass: what eye paths would have found at a pixel is what they found beside it.
void Accumulator::fill_from_neighbours(const Image& image, ImageReading& r) const {
  const int w = int(image.width), h = int(image.height), reach = int(plan_.camera_subsets);
  for (int p = 0; p < w * h; ++p) {
    if (visits(image, size_t(p))) continue;
    const int x = p % w, y = p / w;
    double sum[4] = {}, count = 0;
    for (int d = 1; d <= reach && count == 0; ++d)
      for (int v = std::max(0, y - d); v <= std::min(h - 1, y + d); ++v)
        for (int u = std::max(0, x - d); u <= std::min(w - 1, x + d); ++u) {
          const size_t q = size_t(v) * w + u;
          const uint32_t n = visits(image, q);
          if (n == 0) continue;
          for (int k = 0; k < 3; ++k) sum[k] += image.eye[q * 3 + k] / n;
          if (!image.illuminance.empty()) sum[3] += image.illuminance[q] / n;
          ++count;
        }
    if (count == 0) continue;
    for (int k = 0; k < 3; ++k) r.luminance_rgb[size_t(p) * 3 + k] += float(sum[k] / count);
    if (!image.illuminance.empty()) r.illuminance[size_t(p)] = float(sum[3] / count);
  }
}

ErrorSummary Accumulator::summarize() const {
  if (meters_.empty()) return images_.empty() ? summarize_goniometers() : summarize_images();
  std::vector<double> errors;
  double bias = 0, bound = 0;
  for (size_t s = 0; s < meters_.size(); ++s) {
    const MeterSetReading set = read_meters(s);
    if (set.statistics.mean_standard_error_lx < 0) return {};
    if (!(set.statistics.mean_lx > 0)) {
      if (!takes_dark_for_dark()) return {};
      errors.push_back(0);
      continue;
    }
    for (const ups_meter_reading& m : set.meters) {
      const double floor = share_of_mean * set.statistics.mean_lx;
      errors.push_back(m.error_bound_lx / std::max(double(m.illuminance_lx), floor));
      bias += std::abs(m.bias_lx);
      bound += m.error_bound_lx;
    }
  }
  return summary_of(std::move(errors), bound > 0 ? bias / bound : 0.0);
}

GoniometerReading Accumulator::read_goniometer(size_t goniometer) const {
  return goniometers_[goniometer].read(iterations_, emitted_lm_);
}

ErrorSummary Accumulator::summarize_goniometers() const {
  std::vector<double> errors;
  double noise = 0;
  for (const GoniometerSums& g : goniometers_) {
    const double own = g.mean_noise(iterations_);
    if (own < 0) return {};
    noise = std::max(noise, own);
    if (!g.relative_errors(iterations_, errors)) {
      if (!takes_dark_for_dark()) return {};
      errors.push_back(0);
    }
  }
  ErrorSummary s = summary_of(std::move(errors), 0.0);
  s.mean = float(noise);  // a target must be within reach
  return s;
}

ErrorSummary Accumulator::summarize_images() const {
  std::vector<double> errors;
  for (size_t c = 0; c < images_.size(); ++c) {
    const uint32_t passes = iterations_ / plan_.camera_subsets;
    if (passes < min_batches) return {};
    const ImageReading image = read_image(c);
    const size_t pixels = image.luminance_rgb.size() / 3;
    const auto y = [](const float* p) { return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]; };
    double mean = 0;
    for (size_t p = 0; p < pixels; ++p) mean += y(&image.luminance_rgb[p * 3]) / double(pixels);
    if (!(mean > 0)) {
      if (!takes_dark_for_dark()) return {};
      errors.push_back(0);
      continue;
    }
    for (size_t p = 0; p < pixels; ++p)
      errors.push_back(t_quantile(passes) * y(&image.standard_error_rgb[p * 3]) /
                       std::max(y(&image.luminance_rgb[p * 3]), share_of_mean * mean));
  }
  return summary_of(std::move(errors), 0.0);
}

}  // namespace ups
