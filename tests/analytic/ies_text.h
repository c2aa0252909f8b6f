// An axially symmetric IES LM-63-2002 file from a function of gamma, so that tests need no files.
#pragma once
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "../support/scene_builder.h"

namespace ups::test {

using Profile = std::unique_ptr<ups_profile, decltype(&ups_profile_destroy)>;

// intensity_cd of gamma in radians, a value a degree from 0 to last_deg. A disc as opening; diameter 0: a point.
inline std::string ies_text(const std::function<double(double)>& intensity_cd, int last_deg, double diameter) {
  const auto number = [](double v) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", v);
    return std::string(text);
  };
  std::string out =
      "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] none\n[MANUFAC] none\nTILT=NONE\n1 -1 1 " +
      std::to_string(last_deg + 1) + " 1 1 2 " + number(0 - diameter) + " " + number(0 - diameter) + " 0\n1 1 1\n";
  for (int g = 0; g <= last_deg; ++g) out += std::to_string(g) + "\n";
  out += "0\n";
  for (int g = 0; g <= last_deg; ++g) out += number(std::max(0.0, intensity_cd(g * pi_d / 180))) + "\n";
  return out;
}

inline Profile parse(ups_context* context, const std::string& ies) {
  ups_profile* profile = nullptr;
  check(ups_profile_parse(context, ies.data(), ies.size(), UPS_PROFILE_IES_LM63, &profile), "ups_profile_parse");
  return {profile, ups_profile_destroy};
}

}  // namespace ups::test
