// See flat_mirrors.h: the choice among images.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/flat_mirrors.h"
#include "scene/snapshot.h"

namespace ups {
namespace {

// A share of what a lamp with extent may bring goes by its flux alone, so that no part of it is forgotten.
constexpr float by_flux = 0.02f;
// A share of the images that are seen, by number: what is strong may be hidden.
constexpr float by_number = 0.1f;

// Of all that the receiver may catch of an image by its cosine; 0: it lies behind it. to: its centre.
float facing(const Receiver& r, const Vec3& to, float radius) {
  if (max_abs(r.n) == 0) return 1;
  const float along = dot(to, r.n), height = r.both_sides ? std::abs(along) : along;
  return std::max({0.0f, height, 0.25f * (height + radius)}) / length(to);
}

// What an image would bring, unoccluded, where its mirror shows some of it. behind: the receiver's own image.
float size_of_image(const Snapshot& scene, uint32_t index, const Receiver& r, const Vec3& behind) {
  const FlatMirrors& mirrors = scene.flat_mirrors;
  const FlatMirrors::Image& image = mirrors.images[index];
  const FlatMirrors::Plane& plane = mirrors.planes[image.plane];
  const Emitter& emitter = scene.emitters[image.emitter];
  if (!mirrors.may_show(image, r.p)) return 0;
  const Vec3 to = mirrors.way(image, r.p);
  const float cosine = facing(r, to, image.radius);
  if (!(cosine > 0)) return 0;
  const MirrorLobe lobe = mirror_lobe(scene.materials[plane.material], std::abs(dot(to, plane.n)) / length(to));
  const float reflectance = luminance(lobe.reflectance);
  if (emitter.is_delta()) {
    DirectSample s;
    return emitter.sample_direct(behind, {0.5f, 0.5f}, s) ? luminance(s.weight) * reflectance * cosine : 0;
  }
  const float even = float(emitter.flux_lm()) * (0.25f * inv_pi) / (length2(to) + image.radius * image.radius);
  return (mirrors.tree.brings(r, index) + by_flux * even * cosine) * reflectance;
}

// Those that are seen in their mirrors and bring anything, each with its probability. far: of directional emitters.
struct Seen {
  std::array<std::pair<uint32_t, float>, FlatMirrors::most_weighed> images;
  size_t count = 0;
};
void weigh_images(const Snapshot& scene, const Receiver& r, bool far, Seen& seen) {
  const FlatMirrors& mirrors = scene.flat_mirrors;
  const FlatMirrors::Plane* plane = nullptr;
  Vec3 behind;
  float sum = 0;
  for (uint32_t i = 0; i < mirrors.images.size(); ++i) {
    if (mirrors.images[i].far != far) continue;
    if (plane != &mirrors.planes[mirrors.images[i].plane]) {
      plane = &mirrors.planes[mirrors.images[i].plane];
      behind = plane->mirrored(r.p);
    }
    const float size = size_of_image(scene, i, r, behind);
    if (!(size > 0 && std::isfinite(size))) continue;
    seen.images[seen.count++] = {i, size};
    sum += size;
  }
  for (size_t k = 0; k < seen.count; ++k) {
    float& size = seen.images[k].second;
    size = mirrors.frequency * ((1 - by_number) * (size / sum) + by_number / float(seen.count));
  }
}

}  // namespace

// A point x of it is seen at p + t (x' - p), t = here / (here + its height): beside where the centre is by at most
// t |x - c| + |c' - p| times the difference of both t.
bool FlatMirrors::may_show(const Image& image, const Vec3& p) const {
  const Plane& plane = planes[image.plane];
  if (Vec3 at; image.far) return plane.shows(image.center, true, p, at);
  const float above = plane.height(image.center), here = plane.height(p);
  if (!(above * here > 0)) return false;
  const Vec3 to = way(image, p);
  const float t = here / (above + here), reach = image.reach / std::abs(above + here),
              beside = image.radius > 0 ? t / (1 - reach) * (image.radius + length(to) * reach) : 0;
  return plane.holds(p + to * t, beside);
}

EmitterChoice choose_image(const Snapshot& scene, const Receiver& receiver, double u, bool far) {
  const float frequency = scene.flat_mirrors.frequency;
  if (!(u < frequency)) return {};
  if (scene.flat_mirrors.images.size() > FlatMirrors::most_weighed) {
    EmitterChoice choice = scene.flat_mirrors.tree.choose(receiver, u / frequency);
    choice.probability *= frequency;
    return choice;
  }
  Seen seen;
  weigh_images(scene, receiver, far, seen);
  float below = 0;
  for (size_t k = 0; k < seen.count; ++k) {
    const auto [image, probability] = seen.images[k];
    if (k + 1 == seen.count || u < below + probability) return {image, probability, 0};
    below += probability;
  }
  return {};
}

float image_probability(const Snapshot& scene, const Receiver& receiver, uint32_t image) {
  if (scene.flat_mirrors.images.size() > FlatMirrors::most_weighed)
    return scene.flat_mirrors.frequency * scene.flat_mirrors.tree.probability(receiver, image);
  Seen seen;
  weigh_images(scene, receiver, scene.flat_mirrors.images[image].far, seen);
  for (size_t k = 0; k < seen.count; ++k)
    if (seen.images[k].first == image) return seen.images[k].second;
  return 0;
}

}  // namespace ups
