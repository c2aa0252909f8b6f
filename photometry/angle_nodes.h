// Where the rows and planes of a table should lie so that they follow a set of rays: dense where the light is, with a
// step where it ends. Called by far_field.cpp.
#pragma once
#include <cstddef>
#include <vector>

namespace photometry {

struct WeightedAngle {
  double deg, weight;
};

struct NodeRange {
  double first_deg, last_deg;  // both become nodes
  bool polar;                  // gamma, whose solid angle goes with the sine; else C
  size_t bands;                // wanted; between them the weights are about equal
  double widest_deg;           // of the steps
  double always_deg;           // its multiples are nodes too
};

// Ascending nodes: quantiles of the angles by weight, and both sides of every gap whose emptiness is no chance, so that
// the light beyond an edge is 0 within about a fiftieth of a step. Rounded to as many decimals as the steps need.
// Steps of 0.05 degrees at least, but at edges. `angles` ascend, lie in the range and are not empty.
std::vector<double> angle_nodes(const std::vector<WeightedAngle>& angles, const NodeRange& range);

}  // namespace photometry
