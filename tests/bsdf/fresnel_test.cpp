// Fresnel reflectances against closed forms and published values.
#include "bsdf/fresnel.h"

#include <gtest/gtest.h>

namespace ups {
namespace {

TEST(Fresnel, NormalIncidenceIsClosedForm) {
  for (float n : {1.0f, 1.001f, 1.33f, 1.5f, 2.4f, 3.0f}) {
    EXPECT_NEAR(fresnel_dielectric(1, n), normal_reflectance(n), 1e-6f) << n;
    EXPECT_NEAR(fresnel_dielectric(1, 1 / n), normal_reflectance(n), 1e-6f) << n;
  }
}

TEST(Fresnel, BothPolarisationsAgainstTheSineAndTangentForms) {
  for (double n : {1.1, 1.5, 2.0})
    for (double degrees : {10.0, 30.0, 45.0, 60.0, 80.0, 89.0}) {
      const double i = degrees * M_PI / 180, t = std::asin(std::sin(i) / n);
      const double s = std::sin(i - t) / std::sin(i + t), p = std::tan(i - t) / std::tan(i + t);
      const PolarisedReflectance r = fresnel_polarised(float(std::cos(i)), float(n));
      EXPECT_NEAR(r.s, s * s, 2e-6);
      EXPECT_NEAR(r.p, p * p, 2e-6);
    }
}

TEST(Fresnel, BrewsterAngleReflectsNoP) { EXPECT_NEAR(fresnel_polarised(std::cos(std::atan(1.5f)), 1.5f).p, 0, 1e-10); }

TEST(Fresnel, TotalReflectionBeyondTheCriticalAngle) {
  const float critical = std::sqrt(1 - 1 / (1.5f * 1.5f));
  EXPECT_EQ(fresnel_dielectric(critical - 1e-4f, 1 / 1.5f), 1);
  EXPECT_LT(fresnel_dielectric(critical + 1e-4f, 1 / 1.5f), 0.95f);
}

TEST(Fresnel, SameFromBothSidesOfARefraction) {
  for (float c : {0.01f, 0.1f, 0.5f, 0.9f})
    for (float n : {1.01f, 1.5f, 3.0f})
      EXPECT_NEAR(fresnel_dielectric(c, n), fresnel_dielectric(refracted_cosine(c, n), 1 / n), 1e-4f) << c << " " << n;
}

TEST(Fresnel, EqualIndicesDoNothingAtAnyAngle) {
  for (float c : {1e-6f, 1e-4f, 0.3f, 1.0f}) {
    EXPECT_EQ(fresnel_dielectric(c, 1), 0);
    EXPECT_EQ(refracted_cosine(c, 1), c);
  }
}

// Double-precision midpoint rule of the integral of 2 c F(c).
double diffuse_reflectance(double n) {
  double sum = 0;
  constexpr int count = 200000;
  for (int i = 0; i < count; ++i) {
    const double c = (i + 0.5) / count, t2 = 1 - (1 - c * c) / (n * n);
    double f = 1;
    if (t2 > 0) {
      const double t = std::sqrt(t2), s = (c - n * t) / (c + n * t), p = (n * c - t) / (n * c + t);
      f = 0.5 * (s * s + p * p);
    }
    sum += 2 * c * f / count;
  }
  return sum;
}

TEST(Fresnel, DiffuseReflectanceOfGlass) {
  const float external = diffuse_fresnel_reflectance(1.5f);
  EXPECT_NEAR(external, 0.0918f, 5e-5f);                            // textbooks: 9.18 %
  EXPECT_NEAR(1 - (1 - external) / (1.5f * 1.5f), 0.5963f, 5e-5f);  // 59.63 % from inside
  EXPECT_NEAR(1 - (1 - external) / (1.5f * 1.5f), diffuse_reflectance(1 / 1.5), 1e-5);
  for (double n : {1.0005, 1.0011, 1.01, 1.2, 1.33, 2.0, 3.0})
    EXPECT_NEAR(diffuse_fresnel_reflectance(float(n)), diffuse_reflectance(n), 5e-5) << n;
  EXPECT_EQ(diffuse_fresnel_reflectance(1), 0);
}

TEST(Fresnel, ConductorNormalIncidenceAndDielectricLimit) {
  const float n = 0.18f, k = 3.42f;
  EXPECT_NEAR(fresnel_conductor(1, n, k), ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k), 1e-5f);
  for (float c : {0.05f, 0.3f, 0.8f}) EXPECT_NEAR(fresnel_conductor(c, 1.5f, 0), fresnel_dielectric(c, 1.5f), 1e-5f);
  EXPECT_NEAR(fresnel_conductor(1e-6f, n, k), 1, 1e-4f);
}

TEST(Fresnel, AveragesOfConductorsAndSchlick) {
  const float n = 1.37f, k = 1.77f;
  double conductor = 0, schlick = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const float c = (float(i) + 0.5f) / count;
    conductor += 2.0 * c * fresnel_conductor(c, n, k) / count;
    schlick += 2.0 * c * fresnel_schlick(c, Rgb(0.3f)).r / count;
  }
  EXPECT_NEAR(fresnel_conductor_average(Rgb(n), Rgb(k)).r, conductor, 2e-3);
  EXPECT_NEAR(fresnel_schlick_average(Rgb(0.3f)).r, schlick, 1e-4);
}

}  // namespace
}  // namespace ups
