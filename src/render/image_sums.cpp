// See image_sums.h. An iteration adds what it found: but for the end of a pass that takes no longer for a larger image.
#include "render/image_sums.h"

#include "render/fill_gaps.h"
#include "render/robust_mean.h"

namespace ups {

namespace {

template <class Floats>
double luminance_at(const Floats& rgb, size_t pixel) {
  return luminance(Rgb(rgb[pixel * 3], rgb[pixel * 3 + 1], rgb[pixel * 3 + 2]));
}

}  // namespace

ImageSums::ImageSums(const Camera& camera, const Plan& plan, double emitted_cd_m2)
    : plan_(plan), width_(camera.width()), height_(camera.height()), tiles_(width_, height_),
      emitted_cd_m2_(emitted_cd_m2), layers_(camera), eye_(size_t(camera.pixel_count()) * 3), pending_(eye_.size()),
      largest_(camera.pixel_count()) {
  if (camera.illuminance()) illuminance_.emplace(camera, plan, emitted_cd_m2 * pi_d);
  bool any = false;
  for (uint32_t y = 0; y < height_; ++y)
    for (uint32_t x = 0; x < width_; ++x) {
      blank_.push_back(!camera.sees(x, y));
      any |= blank_.back();
    }
  if (!any) blank_ = {};
}

ImageSums::Bytes ImageSums::bytes_per_pixel(const Camera& camera, const TransportSettings& settings, double passes) {
  const double batches = std::min<double>(std::floor(passes), batch_count), begun = std::min(std::ceil(passes), 16.0);
  const bool splats = settings.has(UPS_TECHNIQUE_SENSOR_CONNECT), merges = settings.has(UPS_TECHNIQUE_MERGE);
  const double illuminance = camera.illuminance(), techniques = technique_count(settings.technique_edges),
               families = settings.technique_edges ? 2 : 0;
  Bytes b;
  b.sums = sizeof(Sample) + 3 * (8 + 4 + 8 * splats + 4 * batches) + merges * PixelMergeSums::bytes_per_pixel(batches) +
           illuminance * IlluminanceSums::bytes_per_pixel(merges, batches, begun) +
           3 * (8 + 4) * (2 * techniques + families) + LayerSums::bytes_per_pixel(camera);
  b.reading = 3 * (4 + 4 + 4) + 2 * 4 + IlluminanceReading::bytes_per_pixel * illuminance +
              3 * 4 * (2 * techniques + families) + LayerReading::bytes_per_pixel(camera);
  b.scratch = std::max(8 + 4 + 4.0, techniques > 0 ? 8 + 4.0 : 0);  // errors, visits, luminance; or techniques' scales
  return b;
}

void ImageSums::add(uint32_t iteration, const IterationTally& tally, size_t c) {
  if (!tally.techniques.empty()) add_techniques(tally.techniques[c]);
  if (illuminance_) illuminance_->add(iteration, tally.illuminance[c], !tally.pixel_merges.empty());
  layers_.add(plan_, iteration, tally, c);
  if (!merges_ && !tally.pixel_merges.empty()) merges_.emplace(width_, height_);
  const auto keep_largest = [&](uint32_t pixel, float value, PathNumber path) {
    if (value > largest_[pixel].value) largest_[pixel] = {value, {iteration, path}};
  };
  plan_.for_visited_pixels(iteration, width_, height_, [&](uint32_t i, uint32_t pixel) {
    if (!tally.pixel_merges.empty()) merges_->add(pixel, tally.pixel_merges[c][i]);
    const Rgb& v = tally.pixels[c][i];
    keep_largest(pixel, luminance(v), {});
    const float rgb[3] = {v.r, v.g, v.b};
    for (size_t k = 0, at = size_t(pixel) * 3; k < 3; ++k, ++at) {
      eye_[at] += rgb[k];
      pending_[at] += rgb[k];
    }
  });
  const float per_pass = 1.0f / float(plan_.camera_subsets);
  if (!tally.splats[c].empty()) splat_.resize(eye_.size());
  for (const Splat& s : tally.splats[c]) {
    keep_largest(s.pixel, luminance(s.value) * per_pass, PathNumber::light(s.path));
    const float rgb[3] = {s.value.r, s.value.g, s.value.b};
    for (size_t k = 0, at = size_t(s.pixel) * 3; k < 3; ++k, ++at) {
      splat_[at] += rgb[k];
      pending_[at] += rgb[k] * per_pass;
    }
  }
  if ((iteration + 1) % plan_.camera_subsets != 0) return;
  ZeroedVector<float>& batch = batches_[plan_.pass(iteration) % batch_count];
  batch.resize(pending_.size());
  for (size_t i = 0; i < batch.size(); ++i) batch[i] += pending_[i];
  std::fill(pending_.begin(), pending_.end(), 0.0f);
  if (merges_) merges_->bias.end_pass(plan_.pass(iteration));
}

namespace {

// Leaves out zeros: what no technique has brought light to yet takes no memory.
void add_rgb(ZeroedVector<double>& sums, const ZeroedVector<Rgb>& values) {
  sums.resize(values.size() * 3);
  for (size_t i = 0; i < values.size(); ++i) {
    if (is_black(values[i])) continue;
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

ImageReading ImageSums::read(uint32_t iterations, double caustic_lm) const {
  PixelMergeSums::Errors errors;
  return read(iterations, caustic_lm, errors);
}

ImageReading ImageSums::read(uint32_t iterations, double caustic_lm, PixelMergeSums::Errors& errors) const {
  const size_t pixels = size_t(width_) * height_;
  ImageReading r{width_, height_, std::vector<float>(pixels * 3), std::vector<float>(pixels * 3, -1.0f), {},
                 std::vector<float>(pixels), std::vector<float>(pixels, -1.0f), {}, layers_.read(), {}, {}};
  const uint32_t n = passes(iterations);
  const std::vector<uint32_t> all = all_visits(iterations);
  for (size_t p = 0; p < pixels; ++p) {
    const double per_visit = all[p] ? 1.0 / all[p] : 0.0;
    for (size_t i = p * 3; i < p * 3 + 3; ++i) r.luminance_rgb[i] = float(eye_[i] * per_visit);
  }
  if (illuminance_) r.illuminance = illuminance_->read(all, n, caustic_lm);
  if (n == 0) fill_unvisited(all, r);
  for (size_t i = 0; i < splat_.size(); ++i) r.luminance_rgb[i] += float(splat_[i] / iterations);
  r.robust_rgb = r.luminance_rgb;
  if (n >= min_batches) read_errors(n, r);
  read_bounds(n, all, caustic_lm, r, errors);
  clear_blank(r);
  return r;
}

void ImageSums::clear_blank(ImageReading& r) const {
  for (size_t p = 0; p < blank_.size(); ++p) {
    if (!blank_[p]) continue;
    for (std::vector<float>* rgb : {&r.luminance_rgb, &r.standard_error_rgb, &r.robust_rgb})
      std::fill_n(rgb->begin() + std::ptrdiff_t(3 * p), 3, 0.0f);
    r.bias[p] = r.error_bound[p] = 0;
    if (!r.illuminance) continue;
    IlluminanceReading& i = *r.illuminance;
    i.lx[p] = i.standard_error[p] = i.bias[p] = i.error_bound[p] = 0;
  }
}

void ImageSums::read_errors(uint32_t passes, ImageReading& r) const {
  const uint32_t used = std::min(passes, batch_count);
  for (size_t p = 0; p < r.bias.size(); ++p) {
    Batches rgb[3], y{};
    for (uint32_t b = 0; b < used; ++b) {
      for (size_t k = 0; k < 3; ++k) rgb[k][b] = batches_[b][p * 3 + k];
      y[b] = luminance(Rgb(rgb[0][b], rgb[1][b], rgb[2][b])) / float(visits_of_batch(passes, b));
    }
    const bool known = !(emitted_cd_m2_ > 0) || chance_light(y.data(), passes).is_enough(passes);
    const KeptBatches kept = least_dominated(y, used);
    for (size_t k = 0; k < 3; ++k) {
      if (known) r.standard_error_rgb[p * 3 + k] = float(spread(rgb[k].data(), passes).standard_error);
      if (kept.count < used) r.robust_rgb[p * 3 + k] = kept.mean(rgb[k], passes);
    }
  }
}

void ImageSums::read_bounds(uint32_t passes, const std::vector<uint32_t>& visits, double caustic_lm, ImageReading& r,
                            PixelMergeSums::Errors& errors) const {
  std::vector<float> light(r.bias.size());
  double mean = 0;
  for (size_t p = 0; p < light.size(); ++p) {
    light[p] = float(luminance_at(r.luminance_rgb, p));
    mean += light[p] / double(light.size());
    if (merges_) r.bias[p] = merges_->bias.mean(uint32_t(p), visits[p]);
  }
  if (passes < min_batches) return;
  const std::vector<float> largest = tiles_.largest_around(largest_of_tiles(), mean > 0 ? mean : emitted_cd_m2_);
  errors.unfound.resize(tiles_.count());
  if (merges_)
    errors = {merges_->bias.of_squares(passes, light), merges_->caustics.unfound(caustic_lm, plan_.light_paths)};
  for (uint32_t p = 0; p < light.size(); ++p) {
    const double noise = luminance_at(r.standard_error_rgb, p);
    const Spread bias = merges_ ? merges_->bias.of_pixel(p, visits[p], light[p], errors.squares) : Spread{0, 0};
    const double few = errors.unfound[tiles_.of(p)].noise(visits[p]);
    r.error_bound[p] = noise >= 0 ? ups::error_bound({light[p], std::hypot(noise, few)}, bias, passes)
                                  : float(std::abs(bias.mean) + chance(p, passes).bound(largest[tiles_.of(p)], passes));
    r.error_bound[p] += float(errors.unfound[tiles_.of(p)].lx / pi_d);  // of a white surface
  }
}

// A render that ended within its first pass: what eye paths would have found at a pixel is what they found beside it.
void ImageSums::fill_unvisited(const std::vector<uint32_t>& all, ImageReading& r) const {
  std::vector<uint8_t> known(all.begin(), all.end());  // 0 or 1
  for (size_t p = 0; p < blank_.size(); ++p)
    if (blank_[p]) known[p] = 0;
  fill_gaps(width_, height_, 3, known, r.luminance_rgb);
  if (r.illuminance) fill_gaps(width_, height_, 1, known, r.illuminance->lx);
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

ChanceLight ImageSums::chance(size_t pixel, uint32_t passes) const {
  double sums[batch_count];
  for (uint32_t b = 0; b < std::min(passes, batch_count); ++b) sums[b] = luminance_at(batches_[b], pixel);
  return chance_light(sums, passes);
}

std::vector<float> ImageSums::largest_of_tiles() const {
  std::vector<float> out(tiles_.count());
  for (uint32_t p = 0; p < largest_.size(); ++p) out[tiles_.of(p)] = std::max(out[tiles_.of(p)], largest_[p].value);
  return out;
}

void ImageSums::find_largest(uint32_t iterations, const ImageReading& r, LargestSamples& out) const {
  double mean = 0;
  for (size_t p = 0; p < largest_.size(); ++p) mean += luminance_at(r.luminance_rgb, p) / double(largest_.size());
  for (uint32_t p = 0; p < largest_.size(); ++p)
    out.add(p, largest_[p], visits(iterations, p % width_, p / width_), luminance_at(r.luminance_rgb, p), mean);
}

// As of a meter: bias that may be noise counts as noise, and merging has a quarter of the variance of its bias. Discs
// shrink, so that what is unfound falls a little more slowly than a meter's; it is little.
MeterError ImageSums::apart(uint32_t p, uint32_t passes, uint32_t visits, const ImageReading& r,
                            const PixelMergeSums::Errors& errors) const {
  const PixelCaustics::Unfound& caustics = errors.unfound[tiles_.of(p)];
  const double noise = luminance_at(r.standard_error_rgb, p), bound = double(r.error_bound[p]),
               unfound = caustics.lx / pi_d;
  if (noise < 0) return {.unfound = float(bound), .paths = float(chance(p, passes).paths)};
  if (!merges_) return {.noise = float(bound), .visits = passes};
  const Spread bias = merges_->bias.of_pixel(p, visits, float(luminance_at(r.luminance_rgb, p)), errors.squares);
  const double b = std::abs(bias.mean), s_b = std::max(0.0, bias.standard_error),
               own = merges_->bias.own(p, visits).standard_error, few = caustics.noise(visits),
               all = noise * noise + few * few + s_b * s_b,
               merged = s_b * s_b + few * few + std::min(noise * noise, own * own / 4);
  MeterError m{.noise = float(std::max(0.0, bound - unfound - b)),
               .bias = float(b),
               .merged = all > 0 ? float(merged / all) : 0,
               .deviations = s_b > 0 ? float(b / s_b) : 1e9f,
               .unfound = float(unfound),
               .paths = float(caustics.photons),
               .visits = passes};
  demote_bias(m);
  return m;
}

bool ImageSums::relative_errors(uint32_t iterations, double caustic_lm, std::vector<double>& out,
                                MeanError& together) const {
  const uint32_t n = passes(iterations);
  if (n < min_batches) return false;
  PixelMergeSums::Errors errors;
  const ImageReading image = read(iterations, caustic_lm, errors);
  const size_t pixels = image.luminance_rgb.size() / 3;
  out.reserve(out.size() + pixels);
  double mean = 0, of_dark = 0;
  const auto seen = double(pixels - size_t(std::count(blank_.begin(), blank_.end(), true)));
  for (size_t p = 0; p < pixels; ++p) mean += luminance_at(image.luminance_rgb, p) / seen;
  const bool lit = mean > 0;
  if (!lit) mean = emitted_cd_m2_;
  const std::vector<uint32_t> all = all_visits(iterations);
  MeterError darkest;
  for (uint32_t p = 0; p < pixels; ++p) {
    if (is_blank(p)) continue;
    const double own = luminance_at(image.luminance_rgb, p),
                 scale = mean > 0 ? 1 / std::max(own, share_of_mean * mean) : 0;
    out.push_back(mean > 0 ? image.error_bound[p] / std::max(own, share_of_mean * mean) : 0);
    const bool counts = own > 0 || !lit;
    if (!counts && out.back() <= of_dark) continue;
    const MeterError part = apart(p, n, all[p], image, errors).scaled(scale);
    if (counts)
      together.add(part);
    else
      of_dark = out.back(), darkest = part;
  }
  if (of_dark > 0) together.add(darkest);
  return true;
}

}  // namespace ups
