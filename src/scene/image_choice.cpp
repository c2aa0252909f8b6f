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
  const Vec3 to = plane.mirrored(image.center) - r.p;
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

// visit(index of an image, what it would bring): those that are seen in their mirrors and bring anything.
template <class Visit>
void weigh_images(const Snapshot& scene, const Receiver& r, const Visit& visit) {
  const FlatMirrors& mirrors = scene.flat_mirrors;
  const FlatMirrors::Plane* plane = nullptr;
  Vec3 behind;
  for (uint32_t i = 0; i < mirrors.images.size(); ++i) {
    if (plane != &mirrors.planes[mirrors.images[i].plane]) {
      plane = &mirrors.planes[mirrors.images[i].plane];
      behind = plane->mirrored(r.p);
    }
    const float size = size_of_image(scene, i, r, behind);
    if (size > 0 && std::isfinite(size)) visit(i, size);
  }
}

}  // namespace

// A point x of it is seen at p + t (x' - p), t = here / (here + its height): beside where the centre is by at most
// t |x - c| + |c' - p| times the difference of both t.
bool FlatMirrors::may_show(const Image& image, const Vec3& p) const {
  const Plane& plane = planes[image.plane];
  const float above = plane.height(image.center), here = plane.height(p);
  if (!(above * here > 0)) return false;
  const Vec3 way = plane.mirrored(image.center) - p;
  const float t = here / (above + here), reach = image.reach / std::abs(above + here),
              beside = image.radius > 0 ? t / (1 - reach) * (image.radius + length(way) * reach) : 0;
  return plane.holds(p + way * t, beside);
}

EmitterChoice choose_image(const Snapshot& scene, const Receiver& receiver, float u) {
  const float frequency = scene.flat_mirrors.frequency;
  if (!(u < frequency)) return {};
  u /= frequency;
  if (scene.flat_mirrors.images.size() > FlatMirrors::most_weighed) {
    EmitterChoice choice = scene.flat_mirrors.tree.choose(receiver, u);
    choice.probability *= frequency;
    return choice;
  }
  std::array<std::pair<uint32_t, float>, FlatMirrors::most_weighed> seen;
  size_t count = 0;
  float sum = 0;
  weigh_images(scene, receiver, [&](uint32_t image, float size) { seen[count++] = {image, size}, sum += size; });
  if (count == 0) return {};
  float below = 0;
  for (size_t i = 0; i < count; ++i) {
    const auto [image, size] = seen[i];
    if (i + 1 == count || u * sum < below + size) return {image, frequency * size / sum, 0};
    below += size;
  }
  return {};
}

float image_probability(const Snapshot& scene, const Receiver& receiver, uint32_t image) {
  if (scene.flat_mirrors.images.size() > FlatMirrors::most_weighed)
    return scene.flat_mirrors.frequency * scene.flat_mirrors.tree.probability(receiver, image);
  float own = 0, sum = 0;
  weigh_images(scene, receiver, [&](uint32_t i, float size) { sum += size, own = i == image ? size : own; });
  return sum > 0 ? scene.flat_mirrors.frequency * own / sum : 0;
}

}  // namespace ups
