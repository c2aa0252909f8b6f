// How a scene of the torture set is judged. Each is rendered by Unified Path Sampling, bidirectional path tracing, path
// tracing, SPPM and the automatic choice, with random numbers of their own. Result (support/result.h) throws where a
// reading, an error, a pixel or the books of flux are not finite, where a sample was dropped or where the balance of
// flux or of eye paths does not close; what it does not read by itself is read here, and by another short render
// (all_outputs.h).
//
// Means of sets of meters are compared, with the truth where it is known, else with what the first three methods but
// the judged one read, weighted by 1 / s^2; and the mean of all methods with the truth. Each comparison has a standard
// error s, which is at most 0.16 %, and allows 4 s, or 0.5 % where that is more, as expect_lx.h does: 6 s, an error of
// 1 %, is found in 97.7 cases of 100; false alarms where noise decides 0.12 % of comparisons, P(|t_15| > 4) (seeds are
// fixed: one that passes once passes always). A render whose s comes out larger is repeated with as many iterations as
// it asks for, in either form: the fast one's scenes are smaller, its figures as exact. s of the mean of all methods is
// at most half of that, 0.08 %: 0.7 % is found in 99 of 100. What a method cannot reach in such a time is data:
// Judged::noise and looser. What they state is judged, too: twice the 95 % bounds cover the difference.
//
// Where a method keeps books of flux, emitted - absorbed - escaped is within 3 of its standard errors and 1e-6 of what
// is emitted, in that render or, where chance (P(|t_15| > 3) = 0.9 %) has it that it is not, in another one, but within
// 5.3 in the first: a false alarm in 5,000 renders. That standard error is at most TortureOptions::balance_error of
// what is emitted, and 5.3 of it is found in 97.7 %: 2.7 % that roulette takes or gives. What paths lack as they start,
// or lose on their ways, is told by the library's warning, by which Result throws: where all start alike from 1e-6 on.
#pragma once
#include <initializer_list>
#include <string>
#include <vector>

#include "../support/full.h"
#include "../support/expect_lx.h"

namespace ups::test {

inline constexpr ups_method torture_methods[] = {UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING,
                                                 UPS_METHOD_SPPM, UPS_METHOD_AUTO};

// What a method cannot find as well as the others in such a time, and why.
struct Looser {
  ups_method method;
  double noise;  // as Judged::noise; INFINITY: its mean is not judged
  const char* reason;
};

inline constexpr double largest_s = 0.0016;  // of a comparison, relative: 6 of it are 1 %

struct Judged {
  Sensor meters;
  double truth_lx = -1;       // of the mean; < 0: not known
  double truth_error = 1e-4;  // relative: of the formula, and of coordinates in floats
  double noise = largest_s;   // the largest s of a method, relative to the mean
  std::vector<Looser> looser{};
};

struct TortureOptions {
  uint32_t iterations = 16;  // at first; in the end as many as the noise asks for
  uint32_t light_paths = 1u << 11;
  ups_separation separation = UPS_SEPARATE_NOTHING;
  uint32_t sppm_factor = 8;      // light paths of SPPM, which has nothing but them, in proportion
  uint32_t sppm_iterations = 0;  // SPPM's at first, where they are to be more: that spares a repeat
  double merge_radius_m = 0;     // 0: chosen by the library
  double sppm_radius_m = 0;      // 0: chosen by the library
  double balance_error = 0.005;  // the largest standard error of the books of flux, relative to what is emitted
  std::vector<ups_method> methods{std::begin(torture_methods), std::end(torture_methods)};
};

// SPPM's that is small enough for 0.5 % in a room of 4 m.
inline constexpr double radius_in_rooms = 0.2;

struct MeanOfSet {
  double lx = 0, standard_error = 0, bound = 0;
};
MeanOfSet mean_of_set(const Result& result, const Sensor& meters);
// Of independent means, weighted by 1 / s^2.
MeanOfSet together(const std::vector<MeanOfSet>& all);

// Renders, checks, and gives back what each method found.
std::vector<Result> survive(const std::string& name, Scene& scene, const std::vector<Judged>& judged,
                            const TortureOptions& options = {});

// A camera of 8 x 8 pixels with illuminances, at p, that looks along `direction`.
Sensor add_small_camera(Scene& scene, const P3& p, const P3& direction);
// n x n cells that cover the rectangle u, v and face u x v.
Sensor add_cells(Scene& scene, const P3& corner, const P3& u, const P3& v, int n);
// n x n points from a corner along u and v, the outermost half a step inside.
std::vector<P3> grid_points(const P3& corner, const P3& u, const P3& v, int n);
// 144 in a room of 4 m: SPPM's discs cover 3 m by 3 m of it, so that most photons count.
std::vector<P3> many_points(double height);

}  // namespace ups::test
