// ups compare: how far an image is from a reference, over luminance (R, G, B) or the channel Y, and channel by channel
// beside the noise that the files themselves report.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "tool/commands.h"
#include "tool/exr_file.h"
#include "tool/handles.h"
#include "tool/report.h"
#include "tool/text_format.h"

namespace ups::tool {

namespace {

// Keeps dark pixels from deciding the relative error: a share of the reference's squared mean.
constexpr double dark_share = 1e-2;
constexpr double trimmed_share = 1e-3;  // fireflies: the pixels that trimmed errors leave out

struct Plane {
  uint32_t width = 0, height = 0;
  std::vector<double> y;
  std::vector<std::vector<float>> channels;  // R, G, B, or Y
  // Of each pixel, mean over its channels; < 0: not known at this pixel; empty: not at any.
  std::vector<double> variance;
};

// Left empty where a channel's standard error is missing, or known at no pixel.
std::vector<double> read_variance(const ExrFile& image, const std::vector<std::string>& names) {
  std::vector<double> variance(image.pixels(), 0);
  for (const std::string& name : names) {
    if (!image.has("standard_error." + name)) return {};
    const std::vector<float> error = image.channel("standard_error." + name);
    for (size_t i = 0; i < error.size(); ++i) {
      if (error[i] >= 0 && variance[i] >= 0)
        variance[i] += double(error[i]) * error[i] / double(names.size());
      else
        variance[i] = -1;
    }
  }
  if (std::none_of(variance.begin(), variance.end(), [](double v) { return v >= 0; })) return {};
  return variance;
}

Plane read_plane(const std::string& path) {
  const ExrFile image(path);
  Plane plane;
  plane.width = image.width(), plane.height = image.height();
  const size_t pixels = image.pixels();
  const bool rgb = image.has("R");
  const std::vector<std::string> names = rgb ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"};
  const std::vector<double> weights = rgb ? std::vector<double>{0.2126, 0.7152, 0.0722} : std::vector<double>{1};
  plane.y.assign(pixels, 0);
  for (size_t c = 0; c < names.size(); ++c) {
    if (!image.has(names[c]))
      throw Failure(path + ": has no channel '" + names[c] + "'; R, G and B are compared, or Y");
    plane.channels.push_back(image.channel(names[c]));
    for (size_t i = 0; i < pixels; ++i) plane.y[i] += weights[c] * plane.channels[c][i];
  }
  plane.variance = read_variance(image, names);
  for (size_t i = 0; i < pixels; ++i) {
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

// Over all but the last `left_out` of the pixels in `order`, each divided by its denominator where there are some, and
// over those where the value is known; -1: not known.
double mean_over(const std::vector<double>& values, const std::vector<uint32_t>& order, size_t left_out,
                 const std::vector<double>& denominators = {}) {
  if (values.empty() || left_out >= order.size()) return -1;
  double sum = 0, known = 0;
  for (size_t k = 0; k + left_out < order.size(); ++k) {
    const double value = values[order[k]];
    if (value >= 0) ++known;
    if (value > 0) sum += denominators.empty() ? value : value / denominators[order[k]];
  }
  return std::isfinite(sum) && known > 0 ? sum / known : -1;
}

ChannelErrors compare_channels(const Plane& a, const Plane& reference, const std::vector<double>& denominators) {
  const size_t pixels = a.y.size(), channels = reference.channels.size();
  if (a.channels.size() != channels) return {-1, -1, -1, -1, -1, -1, -1};  // colour against Y
  std::vector<double> squared(pixels, 0);
  for (size_t c = 0; c < channels; ++c) {
    for (size_t i = 0; i < pixels; ++i) {
      const double difference = double(a.channels[c][i]) - reference.channels[c][i];
      squared[i] += difference * difference / double(channels);
    }
  }
  std::vector<uint32_t> order(pixels);
  std::iota(order.begin(), order.end(), 0u);
  const size_t left_out = size_t(std::ceil(trimmed_share * double(pixels)));
  std::nth_element(order.begin(), order.end() - ptrdiff_t(left_out), order.end(), [&](uint32_t i, uint32_t k) {
    return squared[i] != squared[k] ? squared[i] < squared[k] : i < k;
  });
  ChannelErrors e{};
  e.mse = mean_over(squared, order, 0);
  e.relative_mse = mean_over(squared, order, 0, denominators);
  e.trimmed_mse = mean_over(squared, order, left_out);
  e.noise_a = mean_over(a.variance, order, 0);
  e.noise_b = mean_over(reference.variance, order, 0);
  e.relative_noise_b = mean_over(reference.variance, order, 0, denominators);
  e.trimmed_noise_b = mean_over(reference.variance, order, left_out);
  return e;
}

Comparison compare_planes(const Plane& a, const Plane& reference) {
  Comparison result{};
  result.mean_a = mean_of(a.y);
  result.mean_b = mean_of(reference.y);
  const double floor = dark_share * result.mean_b * result.mean_b;
  double sum = 0, relative_sum = 0, worst = -1;
  std::vector<double> denominators(a.y.size());
  for (size_t i = 0; i < a.y.size(); ++i) {
    const double difference = a.y[i] - reference.y[i], squared = difference * difference;
    const double denominator = denominators[i] = reference.y[i] * reference.y[i] + floor;
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
  result.channels = compare_channels(a, reference, denominators);
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
    put(stdout, to_json(c));
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
