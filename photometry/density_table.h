// The density of a distribution's directions once more, as a renderer looks it up millions of times: in single
// precision and without the mathematical library. Made and owned by a Distribution.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace photometry {

class DensityTable {
 public:
  DensityTable() = default;
  // Ascending angles of the table's own, rad. Planes that wrap around have the first once more at the end; a single one
  // stands for all. density: rows fastest.
  DensityTable(const std::vector<double>& plane_rad, const std::vector<double>& row_rad, std::vector<float> density);

  // Of a unit direction in the frame of the table's polar axis: angles of rows count from -z. 0 outside the table.
  // Angles are right within 5e-7 rad.
  float at(float x, float y, float z) const;

 private:
  class Nodes {
   public:
    Nodes() = default;
    explicit Nodes(const std::vector<double>& rad);
    size_t size() const { return nodes_.size(); }
    float first() const { return nodes_.front().angle; }
    bool contain(float angle) const { return angle >= nodes_.front().angle && angle <= nodes_.back().angle; }
    // Of an angle between them: the last node at or below it, but the very last, and the place from there to the next.
    uint32_t find(float angle, float& place) const;

   private:
    struct Node {
      float angle, inverse_width;  // to the next node
    };
    uint32_t step(float angle) const { return uint32_t((angle - nodes_[0].angle) * steps_per_rad_); }
    std::vector<Node> nodes_;
    // Of equal steps from the first node to the last: the last node in the steps before.
    std::vector<uint32_t> before_;
    float steps_per_rad_ = 0;
  };

  Nodes planes_, rows_;
  std::vector<float> density_;
};

}  // namespace photometry
