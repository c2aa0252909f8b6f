// Test data by name, and what tests look for in what was read. For the tests of readers and writers.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "photometry/photometry.h"

namespace photometry::test {

inline std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

inline std::string data(const std::string& name) { return contents(TEST_DATA "/" + name); }

inline Photometry read_text(const std::string& text, const ReadOptions& options = {}) {
  return read(text.data(), text.size(), options);
}

inline Photometry read_file(const std::string& name) { return read_text(data(name)); }

inline bool has_warning(const Photometry& p, const std::string& start) {
  for (const std::string& w : p.warnings)
    if (w.rfind(start, 0) == 0) return true;
  return false;
}

inline bool warned(const Photometry& p, const std::string& part) {
  for (const std::string& w : p.warnings)
    if (w.find(part) != w.npos) return true;
  return false;
}

inline std::string keyword(const Photometry& p, const std::string& name) {
  for (const Keyword& k : p.keywords)
    if (k.name == name) return k.value;
  return "(none)";
}

// What the error says, which must be of this kind.
template <class Error>
std::string refusal(const std::string& text, const ReadOptions& options = {}) {
  try {
    read_text(text, options);
  } catch (const Error& e) {
    return e.what();
  }
  return "read without an error";
}

// The file must be refused with an error of this kind that says `part`.
template <class Error>
void expect_refused(const std::string& text, const std::string& part) {
  try {
    read_text(text);
    ADD_FAILURE() << "was read, where \"" << part << "\" was expected";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}

// n + 1 numbers in equal steps.
inline std::vector<double> steps(double first, double last, int n) {
  std::vector<double> out;
  for (int i = 0; i <= n; ++i) out.push_back(first + (last - first) * i / n);
  return out;
}

inline double rad(double deg) { return deg * 3.14159265358979323846 / 180; }

// In C-gamma terms.
inline double eval_at(const Distribution& d, double c_deg, double gamma_deg) {
  const double c = rad(c_deg), g = rad(gamma_deg);
  return d.eval(std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g));
}

// Of the peak: what the six characters of an EULUMDAT intensity round, half a unit of the fifth digit.
constexpr double six_characters = 5.001e-5;

// Both are the same light: tables, to the rounding of a few operations, or of `part` of the peak.
inline void expect_same(const Distribution& a, const Distribution& b, double part = 1e-12) {
  ASSERT_EQ(a.type(), b.type());
  ASSERT_EQ(a.c_deg().size(), b.c_deg().size());
  ASSERT_EQ(a.gamma_deg(), b.gamma_deg());
  for (size_t i = 0; i < a.c_deg().size(); ++i) {
    ASSERT_NEAR(a.c_deg()[i], b.c_deg()[i], 1e-9);
    for (size_t j = 0; j < a.gamma_deg().size(); ++j) ASSERT_NEAR(a.at(i, j), b.at(i, j), part * b.peak_cd());
  }
}

}  // namespace photometry::test
