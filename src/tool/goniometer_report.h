// What `ups goniometer` measured, as numbers to print and as words for the file. Filled by that command, printed by it
// and by json.cpp.
#pragma once
#include "report/findings.h"
#include "tool/profile_file.h"

namespace ups::tool {

struct NodeError {
  float c_deg, gamma_deg;
  double relative_error_bound, relative_blur;  // of max(I, 5 % of the peak); blur: the bias of the node's surroundings
};

struct Measurement {
  Report render;          // of one goniometer
  ProfileReport profile;  // of the distribution, as its file would be
  NodeError worst;        // relative_error_bound < 0: not known, as in too short a render
  ups_intensity_reading peak;
  ups_interval peak_interval;  // of the largest true intensity of a node: the largest of noisy ones is too large
  ups_goniometer_beam beam[2], field[2];  // of 50 % and 10 %, in the planes C0-C180 and C90-C270

  const ups_goniometer_info& info() const { return render.goniometers[0].info; }
  double residual_lm() const { return info().emitted_flux_lm - info().absorbed_flux_lm - info().flux_lm; }
};

// The distribution with keywords that say where it comes from; `luminaire`: its name.
Profile make_profile(const ups_result* result, const SensorEntry& goniometer, const Report& render,
                     const std::string& luminaire);
// file: what the distribution is called in plots.
Measurement measure(const std::string& file, const SensorEntry& goniometer, const ups_result* result,
                    const ups_profile* profile, Report render);

// A copy of the profile with this keyword.
Profile with_keyword(const Profile& profile, const std::string& name, const std::string& value);

std::string to_text(const Measurement& measurement);
std::string to_json(const Measurement& measurement);

}  // namespace ups::tool
