// See image_sums.h. An iteration adds what it found: but for the end of a pass that takes no longer for a larger image.
#include "render/image_sums.h"

#include "render/fill_gaps.h"

namespace ups {

ImageSums::ImageSums(const Camera& camera, const Plan& plan)
    : plan_(plan), width_(camera.width()), height_(camera.height()),
      illuminance_(camera.illuminance() ? camera.pixel_count() : 0), eye_(size_t(camera.pixel_count()) * 3),
      pending_(eye_.size()) {}

double ImageSums::bytes_per_pixel(const Camera& camera, uint32_t technique_edges) {
  constexpr double sums = 3 * (8 + 8 + 4 + 4 * batch_count) + 4 + PixelBias::bytes_per_pixel,
                   reading = 3 * (4 + 4 + 4) + 4 + 2 * 4,
                   gaps = 1 + 3 * 4 * (1.0 / 3);          // of fill_gaps()
  const double illuminance = camera.illuminance() ? 8 + 4 : 0;
  constexpr double technique = 2 * 3 * (4 + 8 + 4);  // with weight and without: tally, sum, reading
  return sums + reading + gaps + illuminance +
         (technique_edges ? technique * (technique_count(technique_edges) + 1) : 0);
}

void ImageSums::add(uint32_t iteration, const IterationTally& tally, size_t c) {
  if (!tally.techniques.empty()) add_techniques(tally.techniques[c]);
  if (!bias_ && !tally.pixel_bias.empty()) bias_.emplace(width_, height_);
  plan_.for_visited_pixels(iteration, width_, height_, [&](uint32_t i, uint32_t pixel) {
    if (!illuminance_.empty()) illuminance_[pixel] += tally.illuminance[c][i];
    if (!tally.pixel_bias.empty()) bias_->add(pixel, tally.pixel_bias[c][i]);
    const Rgb& v = tally.pixels[c][i];
    const float rgb[3] = {v.r, v.g, v.b};
    for (size_t k = 0, at = size_t(pixel) * 3; k < 3; ++k, ++at) {
      eye_[at] += rgb[k];
      pending_[at] += rgb[k];
    }
  });
  const float per_pass = 1.0f / float(plan_.camera_subsets);
  if (!tally.splats[c].empty()) splat_.resize(eye_.size());
  for (const Splat& s : tally.splats[c]) {
    const float rgb[3] = {s.value.r, s.value.g, s.value.b};
    for (size_t k = 0, at = size_t(s.pixel) * 3; k < 3; ++k, ++at) {
      splat_[at] += rgb[k];
      pending_[at] += rgb[k] * per_pass;
    }
  }
  if ((iteration + 1) % plan_.camera_subsets != 0) return;
  std::vector<float>& batch = batches_[plan_.pass(iteration) % batch_count];
  batch.resize(pending_.size());
  for (size_t i = 0; i < batch.size(); ++i) batch[i] += pending_[i];
  std::fill(pending_.begin(), pending_.end(), 0.0f);
  if (bias_) bias_->end_pass(plan_.pass(iteration));
}

namespace {

double luminance_at(const std::vector<float>& rgb, size_t pixel) {
  const float* p = &rgb[pixel * 3];
  return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
}

uint32_t samples_of(uint32_t batch, uint32_t passes) { return passes / batch_count + (batch < passes % batch_count); }

using Batches = std::array<float, batch_count>;

// Batches that no single sample dominates.
struct Kept {
  std::array<uint8_t, batch_count> batches;
  uint32_t count;
  float mean(const Batches& sums, uint32_t passes) const {
    float sum = 0;
    for (uint32_t i = 0; i < count; ++i) sum += sums[batches[i]] / float(samples_of(batches[i], passes));
    return sum / float(count);
  }
};

// Of the batches in the order of their means, the more at both ends are left out the more unequal they are: all of them
// stay where the Gini coefficient is small, their median where it is 1 (Buisine, Delepoulle, Renaud 2021, Firefly
// removal in Monte Carlo rendering with adaptive median of means, section 4).
Kept least_dominated(const Batches& means, uint32_t used) {
  std::array<uint8_t, batch_count> order{};
  for (uint32_t b = 0; b < used; ++b) {
    uint32_t at = b;
    for (; at > 0 && means[b] < means[order[at - 1]]; --at) order[at] = order[at - 1];
    order[at] = uint8_t(b);
  }
  double sum = 0, ranked = 0;
  for (uint32_t i = 0; i < used; ++i) {
    sum += means[order[i]];
    ranked += (i + 1.0) * means[order[i]];
  }
  const double gini = sum > 0 ? (2 * ranked / sum - (used + 1)) / used : 0;
  const uint32_t left_out = std::min(uint32_t(gini * used / 2), (used - 1) / 2);
  Kept kept{{}, used - 2 * left_out};
  std::copy_n(order.begin() + left_out, kept.count, kept.batches.begin());
  return kept;
}

void add_rgb(std::vector<double>& sums, const std::vector<Rgb>& values) {
  sums.resize(values.size() * 3);
  for (size_t i = 0; i < values.size(); ++i) {
    sums[i * 3] += values[i].r;
    sums[i * 3 + 1] += values[i].g;
    sums[i * 3 + 2] += values[i].b;
  }
}

}  // namespace

void ImageSums::add_techniques(const TechniqueTally& tally) {
  add_rgb(weighted_, tally.weighted);
  add_rgb(unweighted_, tally.unweighted);
  for (size_t f = 0; f < 2; ++f) add_rgb(families_[f], tally.families[f]);
}

std::vector<uint32_t> ImageSums::all_visits(uint32_t iterations) const {
  std::vector<uint32_t> all;
  all.reserve(size_t(width_) * height_);
  for (uint32_t y = 0; y < height_; ++y)
    for (uint32_t x = 0; x < width_; ++x) all.push_back(visits(iterations, x, y));
  return all;
}

ImageReading ImageSums::read(uint32_t iterations) const {
  const size_t pixels = size_t(width_) * height_;
  ImageReading r{width_, height_, std::vector<float>(pixels * 3), std::vector<float>(pixels * 3, -1.0f), {},
                 std::vector<float>(pixels), std::vector<float>(pixels, -1.0f),
                 std::vector<float>(illuminance_.size()), {}, {}};
  const uint32_t passes = iterations / plan_.camera_subsets;
  const std::vector<uint32_t> all = all_visits(iterations);
  for (size_t p = 0; p < pixels; ++p) {
    const double per_visit = all[p] ? 1.0 / all[p] : 0.0;
    if (!illuminance_.empty()) r.illuminance[p] = float(illuminance_[p] * per_visit);
    for (size_t i = p * 3; i < p * 3 + 3; ++i) r.luminance_rgb[i] = float(eye_[i] * per_visit);
  }
  if (passes == 0) fill_unvisited(all, r);
  for (size_t i = 0; i < splat_.size(); ++i) r.luminance_rgb[i] += float(splat_[i] / iterations);
  r.robust_rgb = r.luminance_rgb;
  if (passes >= min_batches) read_errors(passes, r);
  read_bounds(passes, all, r);
  return r;
}

void ImageSums::read_errors(uint32_t passes, ImageReading& r) const {
  const uint32_t used = std::min(passes, batch_count);
  for (size_t p = 0; p < r.bias.size(); ++p) {
    Batches rgb[3], y{};
    for (uint32_t b = 0; b < used; ++b) {
      for (size_t k = 0; k < 3; ++k) rgb[k][b] = batches_[b][p * 3 + k];
      y[b] = (0.2126f * rgb[0][b] + 0.7152f * rgb[1][b] + 0.0722f * rgb[2][b]) / float(samples_of(b, passes));
    }
    const Kept kept = least_dominated(y, used);
    for (size_t k = 0; k < 3; ++k) {
      r.standard_error_rgb[p * 3 + k] = float(spread(rgb[k].data(), passes).standard_error);
      if (kept.count < used) r.robust_rgb[p * 3 + k] = kept.mean(rgb[k], passes);
    }
  }
}

void ImageSums::read_bounds(uint32_t passes, const std::vector<uint32_t>& visits, ImageReading& r) const {
  std::vector<float> light(r.bias.size());
  for (size_t p = 0; p < light.size(); ++p) light[p] = luminance_at(r.luminance_rgb, p);
  std::vector<Spread> squares;
  if (bias_ && passes >= min_batches) squares = bias_->of_squares(passes, light);
  for (uint32_t p = 0; p < light.size(); ++p) {
    if (bias_) r.bias[p] = bias_->mean(p, visits[p]);
    if (passes < min_batches) continue;
    const Spread bias = bias_ ? bias_->of_pixel(p, visits[p], light[p], squares) : Spread{0, 0};
    r.error_bound[p] = ups::error_bound({light[p], luminance_at(r.standard_error_rgb, p)}, bias, passes);
  }
}

// A render that ended within its first pass: what eye paths would have found at a pixel is what they found beside it.
void ImageSums::fill_unvisited(const std::vector<uint32_t>& all, ImageReading& r) const {
  const std::vector<uint8_t> known(all.begin(), all.end());  // 0 or 1
  fill_gaps(width_, height_, 3, known, r.luminance_rgb);
  if (!r.illuminance.empty()) fill_gaps(width_, height_, 1, known, r.illuminance);
}

// Splats count for each iteration, eye paths for each visit of their pixel.
void ImageSums::read_techniques(uint32_t iterations, ImageReading& r) const {
  if (weighted_.empty()) return;
  const size_t pixels = size_t(width_) * height_, values = pixels * 3;
  std::vector<double> per_visit;
  for (const uint32_t n : all_visits(iterations)) per_visit.push_back(n ? 1.0 / n : 0.0);
  for (size_t f = 0; f < 2; ++f) {
    r.families[f].resize(values);
    const bool splats = Family(f) == Family::path_integration && !splat_.empty();
    for (size_t i = 0; i < values; ++i)
      r.families[f][i] = float(families_[f][i] * per_visit[i / 3] + (splats ? splat_[i] / iterations : 0.0));
  }
  for (uint32_t t = 0; t < weighted_.size() / values; ++t) {
    TechniqueReading out{technique_at(t), std::vector<float>(values), std::vector<float>(values)};
    for (size_t i = 0; i < values; ++i) {
      const double scale = out.technique.t() == 1 ? 1.0 / iterations : per_visit[i / 3];
      out.weighted[i] = float(weighted_[t * values + i] * scale);
      out.unweighted[i] = float(unweighted_[t * values + i] * scale);
    }
    r.techniques.push_back(std::move(out));
  }
}

size_t ImageSums::unvisited_pixels(uint32_t iterations) const {
  if (iterations >= plan_.camera_subsets) return 0;
  const std::vector<uint32_t> all = all_visits(iterations);
  return size_t(std::count(all.begin(), all.end(), 0u));
}

ImageSums::Errors ImageSums::relative_errors(uint32_t iterations, std::vector<double>& out) const {
  const uint32_t passes = iterations / plan_.camera_subsets;
  if (passes < min_batches) return Errors::unknown;
  const ImageReading image = read(iterations);
  const size_t pixels = image.luminance_rgb.size() / 3;
  double mean = 0;
  for (size_t p = 0; p < pixels; ++p) mean += luminance_at(image.luminance_rgb, p) / double(pixels);
  if (!(mean > 0)) return Errors::dark;
  for (size_t p = 0; p < pixels; ++p)
    out.push_back(image.error_bound[p] / std::max(luminance_at(image.luminance_rgb, p), share_of_mean * mean));
  return Errors::known;
}

}  // namespace ups
