// See layer_sums.h.
#include "render/layer_sums.h"

#include "ups/ups_sensor.h"

namespace ups {

namespace {

struct Wanted {
  bool albedo, normal, depth, id;
  explicit Wanted(uint32_t layers)
      : albedo(layers & UPS_LAYER_ALBEDO), normal(layers & UPS_LAYER_NORMAL), depth(layers & UPS_LAYER_DEPTH),
        id(layers & UPS_LAYER_ID) {}
  bool mean() const { return albedo || normal || depth; }
};

void add_three(std::vector<double>& to, uint32_t pixel, double x, double y, double z) {
  double* at = &to[size_t(pixel) * 3];
  at[0] += x, at[1] += y, at[2] += z;
}

// `none`: where nothing was met.
std::vector<float> means(const std::vector<double>& sums, const std::vector<uint32_t>& met, float none) {
  std::vector<float> out(sums.size());
  const size_t components = met.empty() ? 1 : sums.size() / met.size();
  for (size_t i = 0; i < out.size(); ++i) out[i] = met[i / components] ? float(sums[i] / met[i / components]) : none;
  return out;
}

}  // namespace

double LayerReading::bytes_per_pixel(const Camera& camera) {
  const Wanted w(camera.layers());
  return 4.0 * (3 * w.albedo + 3 * w.normal + w.depth + w.id);
}

double LayerSums::bytes_per_pixel(const Camera& camera) {
  const Wanted w(camera.layers());
  return 4.0 * (w.mean() + w.id) + 8.0 * (3 * w.albedo + 3 * w.normal + w.depth);
}

LayerSums::LayerSums(const Camera& camera)
    : width_(camera.width()), height_(camera.height()), layers_(camera.layers()) {
  const Wanted w(layers_);
  const size_t pixels = camera.pixel_count();
  met_.resize(w.mean() ? pixels : 0);
  albedo_.resize(w.albedo ? 3 * pixels : 0);
  normal_.resize(w.normal ? 3 * pixels : 0);
  depth_.resize(w.depth ? pixels : 0);
  id_.resize(w.id ? pixels : 0);
}

void LayerSums::add(const Plan& plan, uint32_t iteration, const IterationTally& tally, size_t c) {
  if (layers_ == 0) return;
  const std::vector<FirstHit>& hits = tally.first_hits[c];
  const std::vector<uint32_t>& ids = tally.first_ids[c];
  plan.for_visited_pixels(iteration, width_, height_, [&](uint32_t i, uint32_t pixel) {
    if (!ids.empty()) id_[pixel] = ids[i];
    if (hits.empty() || hits[i].depth < 0) return;
    const FirstHit& hit = hits[i];
    ++met_[pixel];
    if (!albedo_.empty()) add_three(albedo_, pixel, hit.albedo.r, hit.albedo.g, hit.albedo.b);
    if (!normal_.empty()) add_three(normal_, pixel, hit.normal.x, hit.normal.y, hit.normal.z);
    if (!depth_.empty()) depth_[pixel] += hit.depth;
  });
}

LayerReading LayerSums::read() const {
  return {means(albedo_, met_, 0), means(normal_, met_, 0), means(depth_, met_, -1), {id_.begin(), id_.end()}};
}

}  // namespace ups
