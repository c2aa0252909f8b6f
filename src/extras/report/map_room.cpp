// See map_data.h: the plan of a scene as a map draws it.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "report/map_data.h"
#include "report/map_field.h"

namespace ups::report {
namespace {

constexpr double above = 0.01;  // m: of the plane that is cut, so that a grid on a floor or a wall shows its room

using Key = std::pair<int64_t, int64_t>;

// Lines joined end to end, each pair of ends once.
class Joined {
 public:
  explicit Joined(double grain) : grain_(grain) {}

  void add(const Place& a, const Place& b) {
    const size_t from = end_at(a), to = end_at(b);
    if (from == to) return;
    if (!seen_.emplace(std::minmax(from, to), true).second) return;
    ends_[from].next.push_back(to);
    ends_[to].next.push_back(from);
  }

  // From branches and loose ends on, then what is left: rings. Those shorter than `least` in both directions are left
  // out.
  void lines(bool cut, double least, std::vector<MapLine>& out) {
    for (const bool rings : {false, true}) {
      for (size_t start = 0; start < ends_.size(); ++start) {
        if (!rings && ends_[start].next.size() == 2) continue;
        while (!ends_[start].next.empty()) {
          MapLine line{{ends_[start].place}, cut};
          MapBox box;
          box.grow(ends_[start].place);
          for (size_t at = start; !ends_[at].next.empty();) {
            const size_t next = ends_[at].next.back();
            const bool passes = ends_[next].next.size() == 2;
            ends_[at].next.pop_back();
            std::erase(ends_[next].next, at);
            add_point(line.points, ends_[next].place);
            box.grow(ends_[next].place);
            at = next;
            if (!passes) break;
          }
          if (std::max(box.width(), box.height()) >= least) out.push_back(std::move(line));
        }
      }
    }
  }

 private:
  struct End {
    Place place;
    std::vector<size_t> next;
  };

  size_t end_at(const Place& p) {
    const Key key{std::llround(p.x / grain_), std::llround(p.y / grain_)};
    const auto [place, is_new] = by_place_.try_emplace(key, ends_.size());
    if (is_new) ends_.push_back({p, {}});
    return place->second;
  }

  // Without the ones between on a straight line.
  void add_point(std::vector<Place>& points, const Place& p) const {
    if (points.size() >= 2) {
      const Place a = points[points.size() - 2], b = points.back();
      const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
      const double ahead = (b.x - a.x) * (p.x - b.x) + (b.y - a.y) * (p.y - b.y);
      if (ahead >= 0 && std::abs(side) <= 0.5 * grain_ * std::hypot(p.x - a.x, p.y - a.y)) points.pop_back();
    }
    points.push_back(p);
  }

  double grain_;
  std::vector<End> ends_;
  std::map<Key, size_t> by_place_;
  std::map<std::pair<size_t, size_t>, bool> seen_;
};

bool is_near(const MapBox& box, const Place& a, const Place& b) {
  return std::max(a.x, b.x) >= box.left && std::min(a.x, b.x) <= box.right && std::max(a.y, b.y) >= box.low &&
         std::min(a.y, b.y) <= box.high;
}

// The convex hull (Andrew's monotone chain).
std::vector<Place> hull_of(std::vector<Place> points) {
  std::sort(points.begin(), points.end(),
            [](const Place& a, const Place& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  const auto turns_left = [](const Place& a, const Place& b, const Place& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 1e-12;
  };
  std::vector<Place> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const size_t start = hull.size();
    for (const Place& p : points) {
      while (hull.size() >= start + 2 && !turns_left(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// Of the opening in its luminaire's frame: points whose hull is what is seen of it.
std::vector<std::array<double, 3>> points_of(const ups_profile_info& info) {
  std::vector<std::array<double, 3>> points;
  const double half[3] = {0.5 * info.opening_m[0], 0.5 * info.opening_m[1], 0.5 * info.opening_m[2]};
  if (info.opening_shape == UPS_OPENING_POINT) return points;
  if (info.opening_shape == UPS_OPENING_RECTANGLE || info.opening_shape == UPS_OPENING_BOX) {
    for (int corner = 0; corner < 8; ++corner)
      points.push_back({corner & 1 ? half[0] : -half[0], corner & 2 ? half[1] : -half[1],
                        corner & 4 ? half[2] : -half[2]});
    return points;
  }
  constexpr int around = 32;
  const int axis = info.opening_shape == UPS_OPENING_CYLINDER ? info.opening_axis : 2;
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  for (int k = 0; k < around; ++k) {
    const double angle = 4 * std::acos(0.0) * k / around;
    for (const double end : {-1.0, 1.0}) {
      std::array<double, 3> p{};
      p[size_t(a)] = half[a] * std::cos(angle);
      p[size_t(b)] = half[b] * std::sin(angle);
      p[size_t(axis)] = info.opening_shape == UPS_OPENING_SPHERE ? 0 : end * half[axis];
      points.push_back(p);
    }
  }
  return points;
}

void add_luminaires(MapData& data, const MapPlane& plane, const ups_scene* scene) {
  uint32_t count = 0;
  check(ups_scene_get_source_count(scene, &count));
  for (uint32_t i = 0; i < count; ++i) {
    auto source = sized<ups_scene_source>();
    check(ups_scene_get_source(scene, i, &source));
    if (source.light_kind == UPS_LIGHT_DIRECTIONAL || !(source.flux_lm > 0)) continue;
    std::vector<Place> points;
    double centre[3] = {source.to_world[3], source.to_world[7], source.to_world[11]};
    if (source.kind == UPS_SOURCE_INSTANCE) {
      for (int k = 0; k < 3; ++k) centre[k] = 0.5 * (source.bounds_min_m[k] + source.bounds_max_m[k]);
      for (int corner = 0; corner < 8; ++corner) {
        double p[3];
        for (int k = 0; k < 3; ++k) p[k] = corner >> k & 1 ? source.bounds_max_m[k] : source.bounds_min_m[k];
        points.push_back(plane.flat(p));
      }
    } else if (source.light_kind < 0) {
      ups_profile* raw = nullptr;
      check(ups_scene_get_source_profile(scene, i, &raw));
      const Profile profile(raw);
      auto info = sized<ups_profile_info>();
      check(ups_profile_get_info(raw, &info));
      for (const auto& local : points_of(info)) {
        double p[3];
        for (int k = 0; k < 3; ++k) {
          p[k] = source.to_world[4 * k + 3];
          for (int c = 0; c < 3; ++c) {  // its scale is ignored
            const double *m = source.to_world + c, size = std::hypot(m[0], m[4], m[8]);
            p[k] += m[4 * k] / size * local[size_t(c)];
          }
        }
        points.push_back(plane.flat(p));
      }
    }
    data.luminaires.push_back({plane.flat(centre), points.empty() ? points : hull_of(points)});
  }
}

void add_observers(MapData& data, const MapPlane& plane, const LitScene& scene) {
  for (const SensorEntry& sensor : scene.sensors) {
    if (sensor.info.kind != SensorKind::observer) continue;
    const Eye eye = eye_of(scene, sensor);
    data.observers.push_back({plane.flat(eye.at_m), plane.direction(eye.along), sensor.name});
  }
}

}  // namespace

void add_room(MapData& data, const MapPlane& plane, const LitScene& lit) {
  const ups_scene* scene = lit.scene;
  MapBox near = MapField(data).box();
  const double side = std::max(near.width(), near.height()), reach = 0.3 * side + 0.4;
  near = {near.left - reach, near.low - reach, near.right + reach, near.high + reach};
  double point[3];
  for (int k = 0; k < 3; ++k) point[k] = plane.origin[k] + above * plane.normal[k];
  for (const bool cut : {false, true}) {
    const auto segments = read_array<ups_segment>([&](ups_segment* to, size_t capacity, size_t* needed) {
      return cut ? ups_scene_read_section(scene, point, plane.normal, to, capacity, needed)
                 : ups_scene_read_outlines(scene, point, plane.normal, INFINITY, to, capacity, needed);
    });
    Joined joined(2e-4 * side);
    for (const ups_segment& s : segments) {
      const Place a = plane.flat(s.from_m), b = plane.flat(s.to_m);
      if (is_near(near, a, b)) joined.add(a, b);
    }
    joined.lines(cut, cut ? 0 : 0.006 * side, data.room);
  }
  add_luminaires(data, plane, scene);
  if (std::abs(plane.normal[2]) > 0.7) add_observers(data, plane, lit);  // who looks past a wall is none of it
}

}  // namespace ups::report
