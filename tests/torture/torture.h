// How a scene of the torture set is judged. Each is rendered by Unified Path Sampling, bidirectional path tracing, path
// tracing, SPPM and the automatic choice. Result (support/result.h) throws where a reading, an error, a pixel or the
// books of flux are not finite, where a sample was dropped or where the flux balance does not close; what it does not
// read by itself is read here. Then the methods must agree.
//
// Means of sets of meters are compared, with the truth where it is known, else with what Unified Path Sampling reads:
// within twice the 95 % bound that the methods state, which is 4.3 of Student's 15 degrees of freedom where noise
// decides: of right renders one comparison in 1400 fails (seeds are fixed: one that passes once passes always). The
// bound itself is limited: three times `worst_bound` is the smallest error that is found for certain in any set, five
// times as much of SPPM, whose photons alone are few here.
#pragma once
#include <initializer_list>
#include <string>
#include <vector>

#include "../stability/full.h"
#include "../support/expect_lx.h"

namespace ups::test {

inline constexpr ups_method torture_methods[] = {UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING,
                                                 UPS_METHOD_SPPM, UPS_METHOD_AUTO};

struct Judged {
  Sensor meters;
  double worst_bound = 0.05;  // 95 %, relative to the mean
  double truth_lx = -1;       // of the mean; < 0: not known
  double truth_error = 1e-4;  // relative: of the formula, and of coordinates in floats
};

struct TortureOptions {
  uint32_t iterations = fast_or_full(16u, 64u);
  uint32_t light_paths = 1u << 11;
  ups_separation separation = UPS_SEPARATE_NOTHING;
  uint32_t sppm_factor = 8;  // light paths of SPPM, which has nothing but them, in proportion
  std::vector<ups_method> blind{};  // do not find the light in such a time: they are rendered all the same
  std::vector<ups_method> methods{std::begin(torture_methods), std::end(torture_methods)};
};

// Those that next-event estimation cannot do without: a lamp without extent that chance alone finds.
inline const std::vector<ups_method> without_next_event{UPS_METHOD_SPPM};

// Renders, checks, and gives back what each method found.
std::vector<Result> survive(const std::string& name, Scene& scene, const std::vector<Judged>& judged,
                            const TortureOptions& options = {});

// A camera of 8 x 8 pixels with illuminances, at p, that looks along `direction`.
Sensor add_small_camera(Scene& scene, const P3& p, const P3& direction);
// n x n cells that cover the rectangle u, v and face u x v.
Sensor add_cells(Scene& scene, const P3& corner, const P3& u, const P3& v, int n);
// n x n points from a corner along u and v, the outermost half a step inside.
std::vector<P3> grid_points(const P3& corner, const P3& u, const P3& v, int n);

}  // namespace ups::test
