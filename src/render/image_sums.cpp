// See image_sums.h. An iteration adds what it found: but for the end of a pass that takes no longer for a larger image.
#include "render/image_sums.h"

#include "render/fill_gaps.h"

namespace ups {

ImageSums::ImageSums(const Camera& camera, const Plan& plan)
    : plan_(plan), width_(camera.width()), height_(camera.height()),
      illuminance_(camera.illuminance() ? camera.pixel_count() : 0), eye_(size_t(camera.pixel_count()) * 3),
      pending_(eye_.size()) {}

double ImageSums::bytes_per_pixel(const Camera& camera, uint32_t technique_edges) {
  constexpr double sums = 3 * (8 + 8 + 4 + 4 * batch_count) + 4, reading = 3 * (4 + 4) + 4,
                   gaps = 1 + 3 * 4 * (1.0 / 3);          // of fill_gaps()
  const double illuminance = camera.illuminance() ? 8 + 4 : 0;
  constexpr double technique = 2 * 3 * (4 + 8 + 4);  // with weight and without: tally, sum, reading
  return sums + reading + gaps + illuminance +
         (technique_edges ? technique * (technique_count(technique_edges) + 1) : 0);
}

void ImageSums::add(uint32_t iteration, const IterationTally& tally, size_t c) {
  if (!tally.techniques.empty()) add_techniques(tally.techniques[c]);
  plan_.for_visited_pixels(iteration, width_, height_, [&](uint32_t i, uint32_t pixel) {
    if (!illuminance_.empty()) illuminance_[pixel] += tally.illuminance[c][i];
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
  ImageReading r{width_, height_, std::vector<float>(pixels * 3), std::vector<float>(pixels * 3, -1.0f),
                 std::vector<float>(illuminance_.size()), {}, {}};
  const uint32_t passes = iterations / plan_.camera_subsets, used = std::min(passes, batch_count);
  const std::vector<uint32_t> all = all_visits(iterations);
  for (size_t p = 0; p < pixels; ++p) {
    const double per_visit = all[p] ? 1.0 / all[p] : 0.0;
    if (!illuminance_.empty()) r.illuminance[p] = float(illuminance_[p] * per_visit);
    for (size_t i = p * 3; i < p * 3 + 3; ++i) r.luminance_rgb[i] = float(eye_[i] * per_visit);
  }
  if (passes == 0) fill_unvisited(all, r);
  for (size_t i = 0; i < splat_.size(); ++i) r.luminance_rgb[i] += float(splat_[i] / iterations);
  for (size_t i = 0; passes >= min_batches && i < pixels * 3; ++i) {
    float sums[batch_count];
    for (uint32_t b = 0; b < used; ++b) sums[b] = batches_[b][i];
    r.standard_error_rgb[i] = float(spread(sums, passes).standard_error);
  }
  return r;
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
  const auto y = [](const float* p) { return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]; };
  double mean = 0;
  for (size_t p = 0; p < pixels; ++p) mean += y(&image.luminance_rgb[p * 3]) / double(pixels);
  if (!(mean > 0)) return Errors::dark;
  for (size_t p = 0; p < pixels; ++p)
    out.push_back(t_quantile(passes) * y(&image.standard_error_rgb[p * 3]) /
                  std::max(y(&image.luminance_rgb[p * 3]), share_of_mean * mean));
  return Errors::known;
}

}  // namespace ups
