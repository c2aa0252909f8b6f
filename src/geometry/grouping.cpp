// See grouping.h. An octree about the origin, its side a power of two, so that cells stay where they are while things
// move. A cell with few enough triangles is a group. What is too large for the cells within one that has more is grouped
// in that cell, with those of its cells that hold little.
#include "geometry/grouping.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ups {
namespace {

constexpr size_t least_share = 8;       // a cell within another makes a group of its own from that part of a full group
constexpr int deepest = 24;             // things that lie in one place cannot be told apart
constexpr uint32_t number_block = 64;   // see cut()

using Members = std::vector<uint32_t>;

class Octree {
 public:
  Octree(const std::vector<Thing>& things, Grouping& out) : things_(things), out_(out) {}

  void part(const Members& members, const Vec3d& middle, double half, int depth) {
    if (triangles(members) <= group_triangles || depth == deepest) return cut(members);
    Members within[8], rest;
    for (const uint32_t i : members) {
      const Box& box = things_[i].box;
      if (box.empty()) {
        within[0].push_back(i);
        continue;
      }
      const Vec3d size = box.upper - box.lower, at = box.lower * 0.5 + box.upper * 0.5;
      if (std::max({size.x, size.y, size.z}) > half)
        rest.push_back(i);
      else
        within[(at.x > middle.x) | (at.y > middle.y) << 1 | (at.z > middle.z) << 2].push_back(i);
    }
    if (depth == 0 && triangles(rest) <= group_triangles) out_.ungrouped = std::exchange(rest, {});
    for (int c = 0; c < 8; ++c) {
      const double step = 0.5 * half;
      if (triangles(within[c]) * least_share <= group_triangles)
        rest.insert(rest.end(), within[c].begin(), within[c].end());
      else
        part(within[c], middle + Vec3d(c & 1 ? step : -step, c & 2 ? step : -step, c & 4 ? step : -step), step,
             depth + 1);
    }
    std::sort(rest.begin(), rest.end());
    cut(rest);
  }

 private:
  size_t triangles(const Members& members) const {
    size_t sum = 0;
    for (const uint32_t i : members) sum += things_[i].triangles;
    return sum;
  }

  // Into groups of triangles enough. They do not reach across blocks of numbers, so that who removes a thing touches few.
  void cut(const Members& members) {
    const bool is_one = triangles(members) <= group_triangles;
    Members group;
    size_t in_group = 0;
    const auto end_group = [&] {
      if (!group.empty()) out_.groups.push_back(std::exchange(group, {}));
      in_group = 0;
    };
    for (const uint32_t i : members) {
      const Thing& thing = things_[i];
      if (!is_one && !group.empty() &&
          (in_group + thing.triangles > group_triangles ||
           thing.number / number_block != things_[group.back()].number / number_block))
        end_group();
      group.push_back(i);
      in_group += thing.triangles;
    }
    end_group();
  }

  const std::vector<Thing>& things_;
  Grouping& out_;
};

}  // namespace

Grouping group_by_place(const std::vector<Thing>& things) {
  Grouping out;
  Members all;
  double reach = 0;
  for (const Thing& thing : things) {
    all.push_back(uint32_t(all.size()));
    if (!thing.box.empty()) reach = std::max({reach, max_abs(thing.box.lower), max_abs(thing.box.upper)});
  }
  const double half = reach > 0 ? std::exp2(std::ceil(std::log2(reach))) : 1;
  Octree(things, out).part(all, {0, 0, 0}, half, 0);
  return out;
}

}  // namespace ups
