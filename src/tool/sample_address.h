// Samples by an address in words: what `ups render` lists and `ups replay --sample` takes.
#pragma once
#include <string>
#include <vector>

#include "tool/handles.h"

namespace ups::tool {

struct SampleReport {
  std::string sensor, address;
  ups_sample sample;
};

// NAME/INDEX/ITERATION/eye/PATH/SEED or .../light/...; of a camera INDEX is COLUMN,ROW.
std::string address_of(const SensorEntry& sensor, const ups_sample& sample);
// What is wrong with the address whatever the scene; nothing: it may be one.
std::string malformed_address(const std::string& address);
// Throws Failure that says what is wrong, and which sensors there are.
ups_sample sample_at(const LoadedScene& scene, const std::string& address);

// Those that weigh most in any sensor's reading, the largest share first.
std::vector<SampleReport> read_largest_samples(const LoadedScene& scene, const ups_result* result);

}  // namespace ups::tool
