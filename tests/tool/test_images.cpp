// Images that the program writes: OpenEXR files keep every bit, pictures show what they should.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "ups/ups_exr.h"
#include "ups/ups_ocio.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wshadow"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace {

class Images : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::path(testing::TempDir()) / ("ups-images-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::string path(const char* name) const { return (folder / name).string(); }

  struct Png {
    int width = 0, height = 0;
    std::vector<unsigned char> rgb;
    std::vector<int> at(int x, int y) const {
      const size_t i = 3 * (size_t(y) * size_t(width) + size_t(x));
      return {rgb[i], rgb[i + 1], rgb[i + 2]};
    }
  };
  Png read_png(const std::string& file) const {
    Png png;
    int channels = 0;
    unsigned char* data = stbi_load(file.c_str(), &png.width, &png.height, &channels, 3);
    EXPECT_NE(data, nullptr);
    if (data) png.rgb.assign(data, data + size_t(png.width) * size_t(png.height) * 3);
    stbi_image_free(data);
    return png;
  }
  std::filesystem::path folder;
};

TEST_F(Images, ExrKeepsEveryBit) {
  const std::vector<float> rgb = {1e-30f, 2, 3, 4, 5e30f, 6, -7, 8, INFINITY, 10, 11, 12, 13, 14, 15, 16, 17, 18};
  const std::vector<float> y = {1, 2, 3, 4, 5, 6};
  const ups_exr_channel channels[] = {
      {"R", &rgb[0], 12, 0}, {"G", &rgb[1], 12, 0}, {"B", &rgb[2], 12, 0}, {"illuminance.Y", y.data(), 0, 0}};
  const ups_exr_attribute attributes[] = {{"unit.R", "cd/m^2"}, {"note", ""}};
  ASSERT_EQ(ups_exr_write(path("a.exr").c_str(), 3, 2, channels, 4, attributes, 2), UPS_OK) << ups_exr_last_error();
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);  // no temporary file is left

  ups_exr_image* image = nullptr;
  ASSERT_EQ(ups_exr_read(path("a.exr").c_str(), &image), UPS_OK) << ups_exr_last_error();
  uint32_t width = 0, height = 0, count = 0;
  EXPECT_EQ(ups_exr_get_size(image, &width, &height), UPS_OK);
  EXPECT_EQ(ups_exr_get_channel_count(image, &count), UPS_OK);
  EXPECT_EQ(width, 3u);
  EXPECT_EQ(height, 2u);
  EXPECT_EQ(count, 4u);
  std::vector<float> read(6);
  ASSERT_EQ(ups_exr_read_channel(image, "G", read.data(), 6), UPS_OK);
  for (size_t i = 0; i < 6; ++i) EXPECT_EQ(read[i], rgb[3 * i + 1]);
  ASSERT_EQ(ups_exr_read_channel(image, "illuminance.Y", read.data(), 6), UPS_OK);
  EXPECT_EQ(read, y);
  EXPECT_EQ(ups_exr_read_channel(image, "Y", read.data(), 6), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(std::string(ups_exr_last_error()).find("illuminance.Y"), std::string::npos);
  EXPECT_EQ(ups_exr_read_channel(image, "R", read.data(), 5), UPS_ERROR_INVALID_ARGUMENT);
  char text[16] = "";
  size_t needed = 0;
  EXPECT_EQ(ups_exr_get_attribute(image, "unit.R", text, sizeof text, &needed), UPS_OK);
  EXPECT_STREQ(text, "cd/m^2");
  EXPECT_EQ(ups_exr_get_attribute(image, "unit.Z", text, sizeof text, &needed), UPS_ERROR_INVALID_ARGUMENT);
  ups_exr_image_destroy(image);
}

// As many as the images of techniques of up to 16 edges have.
TEST_F(Images, ExrOfManyChannels) {
  constexpr size_t count = 1638;
  std::vector<float> values;
  std::vector<std::string> names;
  for (size_t i = 0; i <= 4096; ++i) {
    values.push_back(float(i));
    names.push_back("connect_s" + std::to_string(i) + ".R");
  }
  std::vector<ups_exr_channel> channels;
  for (size_t i = 0; i < values.size(); ++i) channels.push_back({names[i].c_str(), &values[i], 0, 0});
  ASSERT_EQ(ups_exr_write(path("a.exr").c_str(), 1, 1, channels.data(), uint32_t(count), nullptr, 0), UPS_OK)
      << ups_exr_last_error();
  ups_exr_image* image = nullptr;
  ASSERT_EQ(ups_exr_read(path("a.exr").c_str(), &image), UPS_OK) << ups_exr_last_error();
  uint32_t found = 0;
  EXPECT_EQ(ups_exr_get_channel_count(image, &found), UPS_OK);
  EXPECT_EQ(found, count);
  float value = -1;
  for (const size_t i : {size_t(0), size_t(1000), count - 1}) {
    EXPECT_EQ(ups_exr_read_channel(image, names[i].c_str(), &value, 1), UPS_OK) << ups_exr_last_error();
    EXPECT_EQ(value, values[i]);
  }
  ups_exr_image_destroy(image);
  EXPECT_EQ(ups_exr_write(path("b.exr").c_str(), 1, 1, channels.data(), 4097, nullptr, 0), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(std::string(ups_exr_last_error()).find("at most 4096"), std::string::npos);
}

TEST_F(Images, ExrRefusesWhatCannotBeWritten) {
  const float value = 1;
  const ups_exr_channel twice[] = {{"Y", &value, 0, 0}, {"Y", &value, 0, 0}};
  EXPECT_EQ(ups_exr_write(path("a.exr").c_str(), 1, 1, twice, 2, nullptr, 0), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_exr_write(path("a.exr").c_str(), 1, 1, nullptr, 0, nullptr, 0), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_exr_write(path("a.exr").c_str(), 0, 1, twice, 1, nullptr, 0), UPS_ERROR_INVALID_ARGUMENT);
  for (const char* name : {"channels", "type", "version", "tiles", "chunkCount", "preview", "chromaticities"}) {
    const ups_exr_attribute reserved[] = {{name, "scanlineimage"}};
    EXPECT_EQ(ups_exr_write(path("a.exr").c_str(), 1, 1, twice, 1, reserved, 1), UPS_ERROR_INVALID_ARGUMENT) << name;
    EXPECT_NE(std::string(ups_exr_last_error()).find(std::string(name) + "' is OpenEXR's own"), std::string::npos);
  }
  const std::string longest(255, 'a'), longer = longest + "b";  // OpenEXR would cut it
  const ups_exr_channel named[] = {{longest.c_str(), &value, 0, 0}, {longer.c_str(), &value, 0, 0}};
  EXPECT_EQ(ups_exr_write(path("a.exr").c_str(), 1, 1, named, 2, nullptr, 0), UPS_ERROR_INVALID_ARGUMENT);
  const ups_exr_attribute attribute[] = {{longer.c_str(), "x"}};
  EXPECT_EQ(ups_exr_write(path("a.exr").c_str(), 1, 1, named, 1, attribute, 1), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_exr_write(path("no/folder/a.exr").c_str(), 1, 1, named, 1, nullptr, 0), UPS_ERROR_IO);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

// A cut file is an error, or at least an end, whatever its length; sanitizers see stray reads.
TEST_F(Images, ExrCutAtEveryLength) {
  std::vector<float> y(64 * 4);
  for (size_t i = 0; i < y.size(); ++i) y[i] = float(i * i % 97);
  const ups_exr_channel channel = {"Y", y.data(), 0, 0};
  ASSERT_EQ(ups_exr_write(path("a.exr").c_str(), 64, 4, &channel, 1, nullptr, 0), UPS_OK);
  std::ifstream in(path("a.exr"), std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(in)), {});
  for (size_t length = 0; length < whole.size(); length += 3) {
    std::ofstream(path("cut.exr"), std::ios::binary) << whole.substr(0, length);
    ups_exr_image* image = nullptr;
    EXPECT_NE(ups_exr_read(path("cut.exr").c_str(), &image), UPS_OK) << length;
    EXPECT_EQ(image, nullptr);
  }
  ups_exr_image* image = nullptr;
  EXPECT_EQ(ups_exr_read(path("none.exr").c_str(), &image), UPS_ERROR_IO);
}

TEST_F(Images, ExposureIsTheGreyOfTheGeometricMean) {
  double exposure = 0;
  std::vector<float> rgb(300, 50.f);  // 100 pixels
  ASSERT_EQ(ups_ocio_choose_exposure(rgb.data(), 10, 10, &exposure), UPS_OK);
  EXPECT_NEAR(exposure, 0.26 / 50, 1e-8);
  for (int i = 0; i < 12; ++i) rgb[size_t(i)] = 1e6f;  // four of 100 pixels are lamps
  for (int i = 12; i < 150; ++i) rgb[size_t(i)] = 0;   // and many are black
  ASSERT_EQ(ups_ocio_choose_exposure(rgb.data(), 10, 10, &exposure), UPS_OK);
  EXPECT_NEAR(exposure / (0.26 / 50), 1, 0.5);
  std::fill(rgb.begin(), rgb.end(), 0.f);
  ASSERT_EQ(ups_ocio_choose_exposure(rgb.data(), 10, 10, &exposure), UPS_OK);
  EXPECT_EQ(exposure, 1);
}

TEST_F(Images, LuminanceThatIsNotFiniteIsRefused) {
  for (const float bad : {NAN, INFINITY, -INFINITY}) {
    std::vector<float> rgb(12, 1.f);
    rgb[7] = bad;
    double exposure = 5;
    EXPECT_EQ(ups_ocio_choose_exposure(rgb.data(), 2, 2, &exposure), UPS_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(exposure, 5);
    for (const double chosen : {0.0, 1.0})
      EXPECT_EQ(ups_ocio_write_png(path("a.png").c_str(), rgb.data(), 2, 2, chosen), UPS_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(ups_ocio_last_error()).find("luminance_rgb: element 7 is "), std::string::npos);
    EXPECT_NE(std::string(ups_ocio_last_error()).find("must be finite"), std::string::npos);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(Images, FieldsOfALaterVersionMustBeZero) {
  struct {
    ups_ocio_false_color_desc desc;
    char future[16];
  } longer;
  std::memset(&longer, 0xff, sizeof longer);
  ups_ocio_false_color_desc_init(&longer.desc, uint32_t(sizeof longer));  // leaves 0 in what it does not know
  const float values[] = {1, 2, 3, 4};
  longer.desc.columns = longer.desc.rows = 2, longer.desc.values = values;
  EXPECT_EQ(ups_ocio_write_false_color_png(path("a.png").c_str(), &longer.desc), UPS_OK) << ups_ocio_last_error();
  longer.future[5] = 1;
  EXPECT_EQ(ups_ocio_write_false_color_png(path("b.png").c_str(), &longer.desc), UPS_ERROR_UNSUPPORTED);
  EXPECT_NE(std::string(ups_ocio_last_error()).find("struct_size is " + std::to_string(sizeof longer)),
            std::string::npos);
}

TEST_F(Images, ChosenExposureShowsTheMeanAsGrey) {
  const std::vector<float> rgb(300, 50.f);
  ASSERT_EQ(ups_ocio_write_png(path("v.png").c_str(), rgb.data(), 10, 10, 0), UPS_OK) << ups_ocio_last_error();
  EXPECT_NEAR(read_png(path("v.png")).at(3, 3)[1], 118, 3);  // sRGB of 18 %
}

TEST_F(Images, APictureSaysItsExposureAndThatItWasSmoothed) {
  const std::vector<float> rgb(3 * 200 * 100, 50.f);
  ups_ocio_picture_desc desc;
  ups_ocio_picture_desc_init(&desc, sizeof desc);
  desc.width = 200, desc.height = 80;
  desc.luminance_rgb = rgb.data();
  const auto bytes = [&] {
    EXPECT_EQ(ups_ocio_write_picture_png(path("p.png").c_str(), &desc), UPS_OK) << ups_ocio_last_error();
    std::ifstream in(path("p.png"), std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(in)), {});
  };
  const auto has = [](const std::string& file, const std::string& words) {
    return file.find(words) != std::string::npos;
  };
  const std::string chosen = bytes();
  EXPECT_TRUE(has(chosen, std::string("tEXtExposure\0EV100 8.64: 50 cd/m2 is shown", 42)));  // log2(8 * 50)
  EXPECT_TRUE(has(chosen, "5th and 95th percentile"));
  EXPECT_FALSE(has(chosen, "smoothed"));
  EXPECT_NEAR(read_png(path("p.png")).at(100, 55)[1], 118, 3);
  ASSERT_EQ(ups_ocio_get_exposure(10, &desc.exposure), UPS_OK);
  const std::string given = bytes();
  EXPECT_TRUE(has(given, "EV100 10.00: 128 cd/m2 is shown as an 18 % grey"));
  EXPECT_FALSE(has(given, "percentile"));
  EXPECT_LT(read_png(path("p.png")).at(100, 30)[1], 90);  // 1.4 stops darker
  desc.smoothed = 1;
  EXPECT_TRUE(has(bytes(), std::string("tEXtComment\0smoothed for display", 32)));
  const Png said = read_png(path("p.png"));
  int white = 0;
  for (int y = 65; y < 80; ++y)
    for (int x = 0; x < 200; ++x) white += said.at(x, y)[1] > 128;
  EXPECT_GT(white, 100);  // letters' strokes
  desc.smoothed = 2;
  EXPECT_EQ(ups_ocio_write_picture_png(path("q.png").c_str(), &desc), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_FALSE(std::filesystem::exists(path("q.png")));
}

TEST_F(Images, ASmallPictureIsNotCoveredByWhatItSays) {
  const std::vector<float> rgb(3 * 200 * 100, 50.f);
  ups_ocio_picture_desc desc;
  ups_ocio_picture_desc_init(&desc, sizeof desc);
  desc.luminance_rgb = rgb.data();
  const auto pixels = [&](int32_t smoothed) {
    desc.smoothed = smoothed;
    EXPECT_EQ(ups_ocio_write_picture_png(path("p.png").c_str(), &desc), UPS_OK) << ups_ocio_last_error();
    return read_png(path("p.png")).rgb;
  };
  for (const auto& [width, height] : {std::pair{24u, 16u}, {1u, 1u}, {200u, 67u}, {100u, 200u}}) {
    desc.width = width, desc.height = height;
    EXPECT_EQ(pixels(1), pixels(0)) << width << " x " << height;
  }
  desc.width = 200, desc.height = 68;
  EXPECT_NE(pixels(1), pixels(0));
  desc.width = 24, desc.height = 16;
  pixels(1);
  std::ifstream in(path("p.png"), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  EXPECT_NE(bytes.find("smoothed for display"), std::string::npos);
}

TEST_F(Images, ViewIsGreyForGreyAndRisesWithLuminance) {
  std::vector<float> rgb;
  for (int i = 0; i < 16; ++i) rgb.insert(rgb.end(), 3, std::exp2(float(i - 8)));
  rgb[3 * 15] = 0.5f;  // the last one is red, and not so bright that the view bleaches it
  rgb[3 * 15 + 1] = rgb[3 * 15 + 2] = 0;
  ASSERT_EQ(ups_ocio_write_png(path("v.png").c_str(), rgb.data(), 16, 1, 1.0), UPS_OK) << ups_ocio_last_error();
  const Png png = read_png(path("v.png"));
  ASSERT_EQ(png.width, 16);
  ASSERT_EQ(png.height, 1);
  int before = -1;
  for (int x = 0; x < 15; ++x) {
    const auto color = png.at(x, 0);
    EXPECT_NEAR(color[0], color[1], 2) << x;  // the view's own white is D65
    EXPECT_NEAR(color[1], color[2], 2) << x;
    EXPECT_GE(color[1], before);
    before = color[1];
  }
  EXPECT_GT(before, 250);
  EXPECT_LT(png.at(0, 0)[1], 20);
  EXPECT_GT(png.at(15, 0)[0], png.at(15, 0)[2] + 100);
}

TEST_F(Images, FalseColorShowsRowZeroAtTheBottom) {
  const std::vector<float> values = {0, 100, -1, 50};  // row 0: 0, 100; row 1: unknown, 50
  ups_ocio_false_color_desc desc;
  ups_ocio_false_color_desc_init(&desc, sizeof desc);
  desc.columns = desc.rows = 2;
  desc.values = values.data();
  desc.title = "grid";
  const auto corners = [&](int32_t at_bottom) {
    desc.first_row_at_bottom = at_bottom;
    EXPECT_EQ(ups_ocio_write_false_color_png(path("f.png").c_str(), &desc), UPS_OK) << ups_ocio_last_error();
    const Png png = read_png(path("f.png"));
    // The cells fill 480 x 480 pixels; their block starts where the first colour that is not grey appears.
    int left = 0, top = 0;
    const auto colored = [&](int x, int y) {
      const auto c = png.at(x, y);
      return c[0] != c[1] || c == std::vector<int>{150, 150, 150};
    };
    for (top = 0; top < png.height && !colored(60, top); ++top) {
    }
    for (left = 0; left < png.width && !colored(left, top + 40); ++left) {
    }
    EXPECT_TRUE(colored(left + 479, top + 479));
    EXPECT_FALSE(colored(left + 479, top + 480));
    return std::vector<std::vector<int>>{png.at(left + 120, top + 120), png.at(left + 360, top + 120),
                                         png.at(left + 120, top + 360), png.at(left + 360, top + 360)};
  };
  const std::vector<int> none = {150, 150, 150}, low = {68, 1, 84}, middle = {33, 144, 140}, high = {253, 231, 37};
  EXPECT_EQ(corners(1), (std::vector<std::vector<int>>{none, middle, low, high}));
  EXPECT_EQ(corners(0), (std::vector<std::vector<int>>{low, high, none, middle}));
}

// Where values lie beyond the scale's end, its top label says so: a sign before the number.
TEST_F(Images, FalseColorSaysThatValuesExceedItsScale) {
  std::vector<float> values(400, 10.f);
  ups_ocio_false_color_desc desc;
  ups_ocio_false_color_desc_init(&desc, sizeof desc);
  desc.columns = desc.rows = 20;
  desc.values = values.data();
  const auto ink_of_top_label = [&] {
    EXPECT_EQ(ups_ocio_write_false_color_png(path("f.png").c_str(), &desc), UPS_OK) << ups_ocio_last_error();
    const Png png = read_png(path("f.png"));
    double ink = 0;  // pixels: letters have soft edges
    for (int y = 61; y < 77; ++y) {  // at the top of the 480 pixels of values, right of the colour bar
      for (int x = 578; x < png.width; ++x) ink += (255 - png.at(x, y)[1]) / 225.0;
    }
    return ink;
  };
  const double within = ink_of_top_label();
  EXPECT_GT(within, 0);
  values[5] = 1000;  // one of 400: above the 99th percentile, so the scale still ends at 10
  EXPECT_GT(ink_of_top_label(), within + 20);
  desc.scale_max = 1000;
  const double wide = ink_of_top_label();
  values[5] = 10;
  EXPECT_EQ(ink_of_top_label(), wide);
}

TEST_F(Images, FalseColorOfNothing) {
  const float zero = 0, unknown = -1;
  ups_ocio_false_color_desc desc;
  ups_ocio_false_color_desc_init(&desc, sizeof desc);
  desc.columns = desc.rows = 1;
  for (const float* values : {&zero, &unknown}) {
    desc.values = values;
    EXPECT_EQ(ups_ocio_write_false_color_png(path("f.png").c_str(), &desc), UPS_OK);
  }
  desc.scale_min = 5;
  desc.scale_max = 5;
  EXPECT_EQ(ups_ocio_write_false_color_png(path("f.png").c_str(), &desc), UPS_ERROR_INVALID_ARGUMENT);
  desc.values = nullptr;
  EXPECT_EQ(ups_ocio_write_false_color_png(path("f.png").c_str(), &desc), UPS_ERROR_INVALID_ARGUMENT);
}

TEST_F(Images, FalseColorOfScalesWithoutSteps) {
  const float values[] = {1, 2, 3, 4};
  ups_ocio_false_color_desc desc;
  ups_ocio_false_color_desc_init(&desc, sizeof desc);
  desc.columns = desc.rows = 2;
  desc.values = values;
  for (const auto& [least, most] :
       {std::pair{0.0, 5e-324}, {-5e-324, 0.0}, {-1e308, 1e308}, {0.0, 1.7e308}, {1.0, 1 + 1e-15}}) {
    desc.scale_min = least, desc.scale_max = most;
    EXPECT_EQ(ups_ocio_write_false_color_png(path("f.png").c_str(), &desc), UPS_ERROR_INVALID_ARGUMENT) << most;
  }
  for (const auto& [least, most] : {std::pair{0.0, 1e-30}, {-1e30, 1e30}, {1.0, 1 + 1e-8}}) {
    desc.scale_min = least, desc.scale_max = most;
    EXPECT_EQ(ups_ocio_write_false_color_png(path("f.png").c_str(), &desc), UPS_OK) << ups_ocio_last_error();
  }
}

TEST_F(Images, FalseColorOfATitleThatIsTooWide) {
  const float values[] = {1};
  ups_ocio_false_color_desc desc;
  ups_ocio_false_color_desc_init(&desc, sizeof desc);
  desc.columns = desc.rows = 1;
  desc.values = values;
  const std::string title(10000, 'W');
  desc.title = title.c_str();
  EXPECT_EQ(ups_ocio_write_false_color_png(path("f.png").c_str(), &desc), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(std::string(ups_ocio_last_error()).find("title or unit"), std::string::npos) << ups_ocio_last_error();
}

TEST_F(Images, ExposuresBeyondWhatCanBeGivenBack) {
  double ev100 = 0;
  for (const double exposure : {1e-320, 1e-300, 1e300})
    EXPECT_EQ(ups_ocio_get_ev100(exposure, &ev100), UPS_ERROR_INVALID_ARGUMENT) << exposure;
  EXPECT_EQ(ups_ocio_get_ev100(1, &ev100), UPS_OK);
}

TEST_F(Images, HandlesOfAnotherKindAreRefused) {
  const void* zeros[32] = {};
  auto* wrong = reinterpret_cast<ups_exr_image*>(zeros);
  uint32_t width = 0, height = 0;
  EXPECT_EQ(ups_exr_get_size(wrong, &width, &height), UPS_ERROR_INVALID_ARGUMENT);
  ups_exr_image_destroy(wrong);
}

TEST_F(Images, PixelsStayAsTheyAre) {
  std::vector<uint8_t> rgb(3 * 5 * 2);
  for (size_t i = 0; i < rgb.size(); ++i) rgb[i] = uint8_t(7 * i);
  ASSERT_EQ(ups_ocio_write_pixels_png(path("p.png").c_str(), rgb.data(), 5, 2), UPS_OK) << ups_ocio_last_error();
  const Png png = read_png(path("p.png"));
  EXPECT_EQ(png.width, 5);
  EXPECT_EQ(png.height, 2);
  EXPECT_EQ(png.rgb, rgb);
  EXPECT_EQ(ups_ocio_write_pixels_png(path("q.png").c_str(), nullptr, 5, 2), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_ocio_write_pixels_png(path("q.png").c_str(), rgb.data(), 0, 2), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_ocio_write_pixels_png(path("no/q.png").c_str(), rgb.data(), 5, 2), UPS_ERROR_IO);
  EXPECT_FALSE(std::filesystem::exists(path("q.png")));
}

}  // namespace
