// IES LM-63-2002 files from functions of C and gamma, so that tests need no files.
#pragma once
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "../support/scene_builder.h"

namespace ups::test {

using Profile = std::unique_ptr<ups_profile, decltype(&ups_profile_destroy)>;

inline std::string ies_number(double v) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", v);
  return text;
}

// intensity_cd of C and gamma in radians, at the planes and angles given in degrees. `opening`: width, length and
// height as the file states them; lamp_lm: -1 for absolute photometry.
inline std::string ies_text(const std::function<double(double, double)>& intensity_cd, const std::vector<double>& c_deg,
                            const std::vector<double>& gamma_deg, const std::string& opening, double lamp_lm = -1) {
  std::string out =
      "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] none\n[MANUFAC] none\nTILT=NONE\n1 " +
      ies_number(lamp_lm) + " 1 " +
      std::to_string(gamma_deg.size()) + " " + std::to_string(c_deg.size()) + " 1 2 " + opening + "\n1 1 1\n";
  for (double g : gamma_deg) out += ies_number(g) + "\n";
  for (double c : c_deg) out += ies_number(c) + "\n";
  for (double c : c_deg)
    for (double g : gamma_deg) out += ies_number(std::max(0.0, intensity_cd(c * pi_d / 180, g * pi_d / 180))) + "\n";
  return out;
}

inline std::vector<double> steps(double step, double last) {
  std::vector<double> out;
  for (int i = 0; i * step <= last; ++i) out.push_back(i * step);
  return out;
}

// intensity_cd of gamma in radians, a value a degree from 0 to last_deg. A disc as opening; diameter 0: a point.
inline std::string ies_text(const std::function<double(double)>& intensity_cd, int last_deg, double diameter) {
  const std::string size = ies_number(0 - diameter);
  return ies_text([&](double, double gamma) { return intensity_cd(gamma); }, {0}, steps(1, last_deg),
                  size + " " + size + " 0");
}

inline Profile parse(ups_context* context, const std::string& ies) {
  ups_profile* profile = nullptr;
  check(ups_profile_parse(context, ies.data(), ies.size(), UPS_PROFILE_IES_LM63, &profile), "ups_profile_parse");
  return {profile, ups_profile_destroy};
}

}  // namespace ups::test
