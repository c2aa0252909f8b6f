// 95 % intervals that the library does not give itself: of a mean from its standard error, of the extremes of many
// noisy values. Called by the report's parts and the program.
#pragma once
#include <cstdint>
#include <vector>

#include "ups/ups_statistics.h"

namespace ups::report {

// Of a mean of so many iterations. They are gathered in 16 batches, or in as many as there are: the errors
// have Student's distribution. -1: not known.
double noise_bound(double standard_error, uint32_t iterations);

// The least and greatest of values with 95 % intervals each, of a render of so many iterations. The least of many noisy
// values is too small, and its own interval is that of another question. -1: some interval is not known, or there is
// none.
ups_interval least_of(const std::vector<ups_interval>& values, uint32_t iterations);
ups_interval greatest_of(const std::vector<ups_interval>& values, uint32_t iterations);

}  // namespace ups::report
