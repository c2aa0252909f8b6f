// Which numbers are found in what files say of their lamps?
#include "photometry/lamps.h"

#include "photometry/files.h"

namespace photometry {
namespace {

using namespace test;

TEST(Lamps, ColourTemperature) {
  const auto kelvin = [](const std::string& colour, const std::string& type = "LED") {
    LampSet lamps;
    lamps.colour = colour, lamps.type = type;
    return colour_temperature_k(lamps);
  };
  for (const char* text : {"3000", "3000K", "3000 K", "warm white, 3000 K", "tw 3000 K / 3000K", "830", " 930 "})
    EXPECT_EQ(kelvin(text), 3000) << text;
  for (const char* text : {"", "warm white", "2700-6500 K", "80", "1.5", "9999999"}) EXPECT_EQ(kelvin(text), -1) << text;
  EXPECT_EQ(kelvin("", "LED 4000K CRI80"), 4000);
  EXPECT_EQ(kelvin("", "module 1200 lm"), -1) << "no kelvin";
  EXPECT_EQ(kelvin("warm", "LED 4000K"), -1) << "the colour has its own field";
}

TEST(Lamps, ColourRendering) {
  const auto index = [](const std::string& rendering, const std::string& type = "LED") {
    LampSet lamps;
    lamps.colour_rendering = rendering, lamps.type = type;
    return colour_rendering_index(lamps);
  };
  for (const char* text : {"80", "Ra 80", "CRI>80", ">80", "Ra = 80"}) EXPECT_EQ(index(text), 80) << text;
  for (const char* text : {"", "1B", "1", "80-89", "good"}) EXPECT_EQ(index(text), -1) << text;
  EXPECT_EQ(index("", "LED 4000K CRI 90"), 90);
  EXPECT_EQ(index("", "T16 54 W"), -1);
}

// Letter by letter this took time by the square of their number: minutes.
TEST(Lamps, AWordOfAMillionLettersIsRead) {
  LampSet lamps;
  lamps.type = std::string(1000000, 'A') + "1 Ra 80";
  EXPECT_EQ(colour_rendering_index(lamps), 80);
}

TEST(Lamps, OfIesFilesFromTheirKeywords) {
  const Photometry p = read_text(
      "IES:LM-63-2019\n[TEST] x\n[LAMP] LED\n[_CCT] 4000\n[_COLOR RENDERING] 83\nTILT=NONE\n"
      "2 500 1 2 1 1 2 0 0 0\n1 1.00001 25\n0 90\n0\n100 100\n");
  ASSERT_EQ(p.lamp_sets.size(), 1u);
  EXPECT_EQ(p.lamp_sets[0].count, 2);
  EXPECT_EQ(p.lamp_sets[0].flux_lm, 1000);
  EXPECT_EQ(p.lamp_sets[0].power_w, 25);
  EXPECT_EQ(p.lamp_sets[0].type, "LED");
  EXPECT_EQ(colour_temperature_k(p.lamp_sets[0]), 4000);
  EXPECT_EQ(colour_rendering_index(p.lamp_sets[0]), 83);
}

}  // namespace
}  // namespace photometry
