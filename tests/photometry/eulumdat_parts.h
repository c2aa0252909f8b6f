// A valid EULUMDAT file of 1000 lm in parts that a test can replace. For the tests of its reader.
#pragma once
#include "photometry/files.h"

namespace photometry::test {

struct EulumdatParts {
  std::string type = "1", isym = "1", mc, ng, name = "name", size = "600\n300\n50", area = "600\n300",
              heights = "0\n0\n0\n0", dff = "100", lor = "0", conversion = "1", tilt = "0", sets, dc = "0", dg = "0";
  std::vector<std::string> lamps = {"1\nLED\n1000\n3000\n80\n10"};
  std::vector<double> c = {0}, gamma = {0, 45, 90}, intensity = {300, 200, 0};
  std::string end;

  std::string text() const {
    const auto or_size = [](const std::string& s, size_t n) { return s.empty() ? std::to_string(n) : s; };
    std::string out = "maker\n" + type + "\n" + isym + "\n" + or_size(mc, c.size()) + "\n" + dc +
                      "\n" + or_size(ng, gamma.size()) + "\n" + dg + "\nreport\n" + name + "\nnumber\nfile\ndate\n" + size +
                      "\n" +
                      area + "\n" + heights + "\n" + dff + "\n" + lor + "\n" + conversion + "\n" + tilt + "\n" +
                      or_size(sets, lamps.size()) + "\n";
    for (const std::string& set : lamps) out += set + "\n";
    for (int i = 0; i < 10; ++i) out += "0.5\n";
    for (const std::vector<double>* list : {&c, &gamma, &intensity})
      for (double v : *list) out += (v == int(v) ? std::to_string(int(v)) : std::to_string(v)) + "\n";
    return out + end;
  }
};

}  // namespace photometry::test
