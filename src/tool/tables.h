// Tables of `ups render --out` beside a meter set's own: what each source contributes, and goniometers. Called by
// output.cpp and, of goniometers, by `ups goniometer`.
#pragma once
#include <string>
#include <vector>

#include "report/findings.h"
#include "tool/handles.h"

namespace ups::tool {

// positions_m: 3 a meter. A row for each meter listed; of each source illuminance and standard error, lx.
void write_sources_csv(const std::string& path, const std::vector<double>& positions_m,
                       const std::vector<size_t>& listed, const SensorEntry& meters,
                       const std::vector<SourceEntry>& sources, const ups_result* result);

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
