// Flat mirrors and panes, in which emitters have images: light that such a surface reflects comes as if from behind it,
// so that next-event estimation finds what else light paths alone would, or eye paths by a rare chance. Made at commit;
// sampled by transport/techniques.h.
#pragma once
#include <vector>

#include "emitter/emitter_set.h"
#include "emitter/receiver.h"
#include "geometry/raytracer.h"
#include "scene/media.h"

namespace ups {

struct Snapshot;

struct FlatMirrors {
  // All of one material that lies in it. Both sides reflect.
  struct Plane {
    Vec3 n;        // unit
    float offset;  // dot(n, p) of its points
    Vec3 center, s, t;  // of the rectangle that holds it
    float half_s, half_t;
    float error;  // surface points lie within this distance of it
    uint32_t material;

    float height(const Vec3& p) const { return dot(n, p) - offset; }
    Vec3 mirrored(const Vec3& p) const { return p - n * (2 * height(p)); }
    Vec3 mirrored_direction(const Vec3& d) const { return d - n * (2 * dot(n, d)); }
    bool holds(const Vec3& p, float beside = 0) const {  // of a point of the plane, or one so far beside
      return std::abs(dot(p - center, s)) <= half_s + beside && std::abs(dot(p - center, t)) <= half_t + beside;
    }
    // Where it shows a lamp to p; false where it does not. far: `lamp` is the direction to one.
    bool shows(const Vec3& lamp, bool far, const Vec3& p, Vec3& at) const {
      const float above = far ? dot(n, lamp) : height(lamp), here = height(p);
      if (!(above * here > 0)) return false;
      at = far ? p + mirrored_direction(lamp) * (here / above) : p + (mirrored(lamp) - p) * (here / (above + here));
      return holds(at);
    }
  };
  struct Image {
    uint32_t emitter, plane;
    Vec3 center;          // of the emitter; of a directional one the unit direction to it
    float radius, reach;  // of it, about that, and along the mirror's normal; without extent: 0
    bool far;             // directional
  };
  static constexpr size_t most_weighed = 64;  // one by one, where they are seen; more by a tree, wherever they are
  static constexpr size_t most_images = size_t(1) << 16;

  // From p to where it seems to be; far: unit.
  Vec3 way(const Image& image, const Vec3& p) const {
    const Plane& plane = planes[image.plane];
    return image.far ? plane.mirrored_direction(image.center) : plane.mirrored(image.center) - p;
  }
  // False where the mirror shows no part of the emitter to p.
  bool may_show(const Image& image, const Vec3& p) const;

  std::vector<Plane> planes;
  std::vector<Image> images;  // those of a plane together
  std::vector<uint32_t> image_numbers;  // by plane and column, columns fastest; none
  std::vector<uint32_t> column_of_emitter;  // none: has no images
  size_t column_count = 0;
  LightTree tree;  // of images, where they are more than are weighed or some have extent
  // Of each instance: planes by triangle; one for all; empty: it is no flat mirror.
  std::vector<std::vector<uint32_t>> planes_of_instance;
  // Share of the receivers that look at an image at all: what reflects little is not asked for as often as what lights
  // straight.
  float frequency = 1;
  bool all_flat = false;  // every surface with a delta lobe is one, in which every emitter without extent has an image
  bool complete = false;  // and no such light is reflected by two of them in turn
  bool of_all = false;    // every emitter has an image in every plane
  bool of_extended = false;  // some emitter with extent has an image
  bool has[2] = {};          // images of near emitters, of far ones

  bool empty() const { return images.empty(); }
  uint32_t plane_of(uint32_t instance, uint32_t primitive) const {  // none
    if (planes_of_instance.empty() || planes_of_instance[instance].empty()) return none;
    const std::vector<uint32_t>& of = planes_of_instance[instance];
    return of[of.size() > 1 ? primitive : 0];
  }
  uint32_t image_of(uint32_t emitter, uint32_t plane) const {
    const uint32_t column = column_of_emitter[emitter];
    return column == none ? none : image_numbers[plane * column_count + column];
  }
  size_t bytes() const;
};

FlatMirrors find_flat_mirrors(const Snapshot& scene);

// Which image of a kind a receiver looks at, if at any: in proportion to what each would bring there, unoccluded. Its
// index in `images`. See image_choice.cpp.
EmitterChoice choose_image(const Snapshot& scene, const Receiver& receiver, double u, bool far);
float image_probability(const Snapshot& scene, const Receiver& receiver, uint32_t image);

}  // namespace ups
