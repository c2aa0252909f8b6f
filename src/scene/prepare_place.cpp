// See builder.h: where the scene's origin is, and what lies too far from all else to have a place near it.
#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "base/text.h"
#include "scene/builder.h"
#include "scene/check.h"
#include "scene/length_text.h"

namespace ups {
namespace {

constexpr double max_coordinate_m = 1e9, least_extent_m = 1e-9;
// Floats resolve 2^-24 of the extent. Where that is a millimetre and what matters takes this share of the extent or
// less, it is told; where it is a centimetre, light between surfaces so close together is not to be trusted.
constexpr double coarse_m = 0.001, coarse_share = 0x1p-12, lost_m = 0.01, lost_share = 0x1p-16;
constexpr double least_angle = 0x1p-12;     // rad; some arc minute, the least that an eye resolves
constexpr double most_solid_angle = 1e-4;   // of all that is left out

double diagonal(const Box& b) { return length(b.upper - b.lower); }
Vec3d middle(const Box& b) { return b.lower * 0.5 + b.upper * 0.5; }

double gap(const Box& a, const Box& b) {
  const auto apart = [&](double Vec3d::*axis) {
    return std::max({0.0, b.lower.*axis - a.upper.*axis, a.lower.*axis - b.upper.*axis});
  };
  return std::hypot(apart(&Vec3d::x), apart(&Vec3d::y), apart(&Vec3d::z));
}

double step(const Box& b) { return 0x1p-24 * diagonal(b); }

// By value: what is asked reorders them.
double lower_median(std::vector<double> values) {
  const auto at = values.begin() + std::ptrdiff_t(values.size() - 1) / 2;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

// What has a place, with what it takes up.
class Builder::Places {
 public:
  struct Item {
    Box box;
    const char* noun;
    uint32_t id;
    bool is_instance() const { return std::string_view(noun) == instance_noun; }
  };
  static constexpr const char* instance_noun = "instance";

  void add(const Box& box, const char* noun, uint32_t id) {
    const double farthest = std::max(max_abs(box.lower), max_abs(box.upper));
    if (!(farthest <= max_coordinate_m))
      fail_argument(std::string(noun) + " id " + std::to_string(id) + " reaches a coordinate of " +
                    check::text(farthest) + " m; the library works within " + check::text(max_coordinate_m) +
                    " m of the world's origin");
    items_.push_back({box, noun, id});
    grow(bounds_, box);
  }
  static void grow(Box& all, const Box& box) { all.grow(box.lower), all.grow(box.upper); }

  template <class Visit>
  void each(const Visit& visit) const {
    for (const Item& i : items_) visit(i);
  }
  template <class Test>
  void remove(const Test& test) {
    std::erase_if(items_, test);
    bounds_ = {};
    for (const Item& i : items_) grow(bounds_, i.box);
  }

  const Box& bounds() const { return bounds_; }

  // The extent of most of what there is, around its middle; both by medians, which single things far away do not move.
  double typical_extent() const {
    const Vec3d from = median();
    std::vector<double> distances;
    for (const Item& i : items_) distances.push_back(reach(i, from));
    return 2 * lower_median(std::move(distances));
  }
  const Item& farthest(const Vec3d& from) const {
    return *std::max_element(items_.begin(), items_.end(),
                             [&](const Item& a, const Item& b) { return reach(a, from) < reach(b, from); });
  }
  Vec3d median() const {
    std::vector<double> of_axis[3];
    for (const Item& i : items_) {
      const Vec3d m = middle(i.box);
      of_axis[0].push_back(m.x), of_axis[1].push_back(m.y), of_axis[2].push_back(m.z);
    }
    return {lower_median(std::move(of_axis[0])), lower_median(std::move(of_axis[1])),
            lower_median(std::move(of_axis[2]))};
  }


 private:
  static double reach(const Item& i, const Vec3d& from) { return length(middle(i.box) - from) + diagonal(i.box) / 2; }

  std::vector<Item> items_;
  Box bounds_;
};

// The origin is near the centre of all that has a place; distances from it are what floats have to hold. It stays
// while things move within these bounds, and a little beyond.
void Builder::place() {
  Places places;
  find_places(places);
  if (places.bounds().empty()) return;
  if (step(places.bounds()) >= coarse_m) check_extent(places);
  const Box& box = places.bounds();
  const Vec3d size = box.upper - box.lower;
  out_->extent = std::exp2(std::ceil(std::log2(std::max({size.x, size.y, size.z, least_extent_m}))));
  const double step = out_->extent / 4;
  out_->origin = {step * std::round(middle(box).x / step), step * std::round(middle(box).y / step),
                  step * std::round(middle(box).z / step)};
  out_->centre = Vec3(middle(box) - out_->origin);
  out_->radius = float(length(size) * 0.5 * (1 + 0x1p-20));
}

void Builder::find_places(Places& places) {
  const auto point = [](const Vec3d& p, double reach = 0) {
    const Vec3d r(reach, reach, reach);
    return Box{p - r, p + r};
  };
  for (const Raytracer::Instance& i : out_->instances)  // its origin is the world's yet
    places.add(out_->mesh_boxes[i.mesh].transformed(i.to_scene), Places::instance_noun, i.number);
  in_.sources().each([&](uint32_t id, const SourceDescription& s) {
    if (const auto* light = std::get_if<LightDescription>(&s.kind)) {
      if (light->kind != UPS_LIGHT_DIRECTIONAL) places.add(point(light->to_world.column(3)), "luminaire", id);
      return;
    }
    const auto& luminaire = std::get<LuminaireDescription>(s.kind);
    const Vec3d p = luminaire.to_world.column(3);
    if (const auto rays = rays_of(luminaire)) {
      const Axes axes(luminaire.to_world);
      const Box own{Vec3d(rays->lower()), Vec3d(rays->upper())};
      Box box;
      for (int k = 0; k < 8; ++k) {
        const Vec3d c = own.corner(k);
        box.grow(p + axes.x * c.x + axes.y * c.y + axes.z * c.z);
      }
      return places.add(box, "luminaire", id);
    }
    const float* size = luminaire.profile->opening.size_m;
    places.add(point(p, luminaire.use_opening
                            ? 0.5 * std::hypot(double(size[0]), double(size[1]), double(size[2])) : 0),
               "luminaire", id);
  });
  in_.sensors().each([&](uint32_t id, const Description::Sensor& s) {
    if (const auto* camera = std::get_if<CameraDescription>(&s))
      return places.add(point(camera->to_world.column(3)), "sensor", id);
    if (const auto* o = std::get_if<ObserverDescription>(&s))
      return places.add(point(o->to_world.column(3)), "sensor", id);
    const auto* meters = std::get_if<MetersDescription>(&s);
    if (!meters) return;  // a goniometer is at infinity, what measures a surface lies on it
    const double reach = 0.5 * std::max(std::hypot(double(meters->cell_width), double(meters->cell_height)),
                                        double(meters->footprint));
    const Vec3d r(reach, reach, reach);
    places.add({meters->bounds.lower - r, meters->bounds.upper + r}, "sensor", id);
  });
}

// One surface far away would cost all others their precision. What matters is what shines or measures, or, where that
// stands in one place, most of all there is.
void Builder::check_extent(Places& places) {
  const Places near = places_that_matter(places);
  leave_out_far_surfaces(near, places);
  const double resolved = step(places.bounds()), width = diagonal(places.bounds()), typical = places.typical_extent(),
               of_near = near.bounds().empty() ? 0 : diagonal(near.bounds());
  const bool is_near = of_near > 0 && of_near < typical;
  const double matters = is_near ? of_near : typical;
  if (resolved < coarse_m || matters > coarse_share * width) return;
  const Places::Item& far = places.farthest(is_near ? middle(near.bounds()) : places.median());
  const std::string text = "the scene is " + length_text(width) + " wide, and what matters in it " +
                           length_text(matters) + ": places are known to " + length_text(resolved) + ". " + far.noun +
                           " id " + std::to_string(far.id) + " reaches farthest: ";
  const bool lost = resolved >= lost_m && matters <= lost_share * width;
  warn(text + (lost ? "readings are wrong as long as it does, and bounds do not tell; move it, or leave it out"
                    : "without it readings would be more exact"));
}

// Sources, sensors, and surfaces that shine or are measured.
Builder::Places Builder::places_that_matter(const Places& places) const {
  std::set<uint32_t> instances;
  in_.sensors().each([&](uint32_t, const Description::Sensor& s) {
    if (const auto* measured = std::get_if<SurfaceMetersDescription>(&s))
      for (const ups_instance_id id : measured->instances) instances.insert(number_of(id.v));
  });
  for (const Raytracer::Instance& i : out_->instances) {
    const ups_material_desc& material = in_.materials().at(out_->material_numbers[i.material]);
    if (!is_black(to_rgb(material.luminance_cd_m2))) instances.insert(i.number);
  }
  Places near = places;
  near.remove([&](const Places::Item& i) { return i.is_instance() && instances.count(i.id) == 0; });
  return near;
}

// Surfaces that light and sensors hardly see, all of them together.
void Builder::leave_out_far_surfaces(const Places& near, Places& places) {
  if (near.bounds().empty() || sees_infinity()) return;
  std::set<uint32_t> far;
  double nearest = INFINITY, solid_angle = 0;
  places.each([&](const Places::Item& i) {
    const double distance = gap(near.bounds(), i.box), angle = diagonal(i.box) / distance;
    if (!i.is_instance() || !(0x1p-24 * distance >= coarse_m) || !(angle < least_angle)) return;
    far.insert(i.id);
    nearest = std::min(nearest, distance);
    solid_angle += angle * angle;
  });
  if (far.empty() || solid_angle > most_solid_angle) return;
  places.remove([&](const Places::Item& i) { return i.is_instance() && far.count(i.id) > 0; });
  warn(listed("instance", {far.begin(), far.end()}) + ": left out, " + length_text(nearest) +
       " and more away from all luminaires and sensors, smaller than an arc minute from there; with it, places would "
       "be known to " + length_text(0x1p-24 * nearest) + " at best");
  far_surfaces_ = std::move(far);
  list_surfaces();
}

// Parallel light throws shadows of any size at any distance, and a goniometer measures there.
bool Builder::sees_infinity() const {
  bool does = false;
  in_.sources().each([&](uint32_t, const SourceDescription& s) {
    const auto* light = std::get_if<LightDescription>(&s.kind);
    does |= light && light->kind == UPS_LIGHT_DIRECTIONAL;
  });
  in_.sensors().each([&](uint32_t, const Description::Sensor& s) {
    does |= std::holds_alternative<GoniometerDescription>(s);
  });
  return does;
}

}  // namespace ups
