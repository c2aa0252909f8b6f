// Tables of `ups render --out` beside a meter set's own: what each source contributes, and goniometers. Called by
// output.cpp and, of goniometers, by `ups goniometer`.
#pragma once
#include <string>
#include <vector>

#include "tool/handles.h"

namespace ups::tool {

// "luminaire_3", "instance_7", "group_1"; empty without --separate.
std::vector<std::string> source_names(const ups_result* result);

// positions_m: 3 a meter. A row a meter; of each source illuminance and standard error, lx.
void write_sources_csv(const std::string& path, const std::vector<double>& positions_m, const SensorEntry& meters,
                       const ups_result* result);

// The nodes of a goniometer; gamma runs fastest.
struct GoniometerNodes {
  std::vector<float> c_deg, gamma_deg;
  std::vector<ups_intensity_reading> readings;
  float c_deg_of(size_t i) const { return c_deg[i / gamma_deg.size()]; }
  float gamma_deg_of(size_t i) const { return gamma_deg[i % gamma_deg.size()]; }
};
GoniometerNodes read_goniometer(const SensorEntry& goniometer, const ups_result* result);

// A row a node: c_deg, gamma_deg, intensity and its errors, cd.
void write_goniometer_csv(const std::string& path, const SensorEntry& goniometer, const ups_result* result);

}  // namespace ups::tool
