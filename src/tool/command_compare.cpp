// ups compare: how far an image is from a reference, over luminance (R, G, B) or the channel Y.
#include <cmath>
#include <cstdio>

#include "tool/commands.h"
#include "tool/handles.h"
#include "tool/report.h"

namespace ups::tool {

namespace {

// Keeps dark pixels from deciding the relative error: a share of the reference's squared mean.
constexpr double dark_share = 1e-2;

struct Plane {
  uint32_t width = 0, height = 0;
  std::vector<double> y;
};

bool has_channel(const ups_exr_image* image, const std::string& name) {
  uint32_t count = 0;
  check(ups_exr_get_channel_count(image, &count), ups_exr_last_error);
  for (uint32_t i = 0; i < count; ++i) {
    const std::string found = read_text([&](char* to, size_t capacity, size_t* needed) {
      return ups_exr_get_channel_name(image, i, to, capacity, needed);
    });
    if (found == name) return true;
  }
  return false;
}

Plane read_plane(const std::string& path) {
  ups_exr_image* read = nullptr;
  check(ups_exr_read(path.c_str(), &read), ups_exr_last_error);
  const Image image(read);
  Plane plane;
  check(ups_exr_get_size(read, &plane.width, &plane.height), ups_exr_last_error);
  plane.y.assign(size_t(plane.width) * plane.height, 0);
  std::vector<float> values(plane.y.size());
  const auto add = [&](const char* channel, double weight) {
    if (ups_exr_read_channel(read, channel, values.data(), values.size()) != UPS_OK) {
      throw Failure(path + ": " + ups_exr_last_error() + "; R, G and B are compared, or Y");
    }
    for (size_t i = 0; i < values.size(); ++i) plane.y[i] += weight * values[i];
  };
  if (has_channel(read, "R")) {
    add("R", 0.2126);
    add("G", 0.7152);
    add("B", 0.0722);
  } else {
    add("Y", 1);
  }
  for (size_t i = 0; i < plane.y.size(); ++i) {
    if (!std::isfinite(plane.y[i])) {
      throw Failure(path + ": pixel (" + std::to_string(i % plane.width) + ", " + std::to_string(i / plane.width) +
                    ") is not a finite number");
    }
  }
  return plane;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (double value : values) sum += value;
  return sum / double(values.size());
}

Comparison compare_planes(const Plane& a, const Plane& reference) {
  Comparison result{};
  result.mean_a = mean_of(a.y);
  result.mean_b = mean_of(reference.y);
  const double floor = dark_share * result.mean_b * result.mean_b;
  double sum = 0, relative_sum = 0, worst = -1;
  for (size_t i = 0; i < a.y.size(); ++i) {
    const double difference = a.y[i] - reference.y[i], squared = difference * difference;
    const double denominator = reference.y[i] * reference.y[i] + floor;
    sum += squared;
    if (squared > 0) relative_sum += squared / denominator;  // infinite, hence unknown, against a black reference
    if (squared > worst) {
      worst = squared;
      result.worst_x = uint32_t(i % a.width);
      result.worst_y = uint32_t(i / a.width);
    }
  }
  result.rmse = std::sqrt(sum / double(a.y.size()));
  result.relative_mse = std::isfinite(relative_sum) ? relative_sum / double(a.y.size()) : -1;
  return result;
}

std::string size_text(const Plane& plane) { return std::to_string(plane.width) + " x " + std::to_string(plane.height); }

}  // namespace

int compare(const std::string& a_path, const std::string& b_path, bool json) {
  const Plane a = read_plane(a_path), b = read_plane(b_path);
  if (a.width != b.width || a.height != b.height) {
    throw Failure(a_path + " is " + size_text(a) + ", " + b_path + " is " + size_text(b) + "; sizes must be equal");
  }
  const Comparison c = compare_planes(a, b);
  if (json) {
    std::fputs(to_json(c).c_str(), stdout);
    return exit_done;
  }
  std::printf("RMSE: %.6g\n", c.rmse);
  if (c.relative_mse >= 0) {
    std::printf("relative RMSE: %.6g (relative MSE %.6g)\n", std::sqrt(c.relative_mse), c.relative_mse);
  } else {
    std::printf("relative RMSE: unknown, the reference is black\n");
  }
  std::printf("mean: %.6g, reference %.6g\n", c.mean_a, c.mean_b);
  std::printf("worst pixel: (%u, %u)\n", c.worst_x, c.worst_y);
  return exit_done;
}

}  // namespace ups::tool
