#include "photometry/room.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace photometry {
namespace {

constexpr double pi = 3.14159265358979323846, degree = pi / 180;

// Between two equal rectangles x by y, parallel and opposite at distance 1.
double form_factor(double x, double y) {
  const double x2 = 1 + x * x, y2 = 1 + y * y, sx = std::sqrt(x2), sy = std::sqrt(y2);
  return 2 / (pi * x * y) *
         (0.5 * std::log(x2 * y2 / (x2 + y2 - 1)) + x * sy * std::atan(x / sy) + y * sx * std::atan(y / sx) -
          x * std::atan(x) - y * std::atan(y));
}

// How many of n luminaires in a row of length `extent` have theirs `shift` beside them inside; n 0: which share.
double share_inside(double extent, int n, double shift) {
  const double inside = std::max(0.0, 1 - std::abs(shift) / extent);
  if (n == 0) return inside;
  // Of the places (i + 1/2) extent / n those with 0 < place + |shift| < extent.
  const double last = n * inside - 0.5;
  return last < 0 ? 0 : std::min(double(n), std::floor(last) + 1) / n;
}

}  // namespace

RoomFlux exchange(const RoomShape& room, const Reflectances& rho, const RoomFlux& direct) {
  const double across = form_factor(room.x, room.y), to_walls = 1 - across;
  const double from_walls = to_walls * room.floor_area() / room.wall_area();  // to either plane
  const double among_walls = 1 - 2 * from_walls;
  // Received: f = d_f + rho_c across c + rho_w from_walls w, and so on. f and c by w, then w.
  const double d = 1 - rho.floor * rho.ceiling * across * across;
  const auto plane = [&](double own, double other, double rho_other, double& constant, double& of_walls) {
    constant = (own + rho_other * across * other) / d;
    of_walls = rho.walls * from_walls * (1 + rho_other * across) / d;
  };
  double f0, f1, c0, c1;
  plane(direct[0], direct[2], rho.ceiling, f0, f1);
  plane(direct[2], direct[0], rho.floor, c0, c1);
  const double gain = rho.walls * among_walls + to_walls * (rho.floor * f1 + rho.ceiling * c1);
  const double w = (direct[1] + to_walls * (rho.floor * f0 + rho.ceiling * c0)) / (1 - gain);
  return {f0 + f1 * w, w, c0 + c1 * w};
}

RoomRays::RoomRays(const Distribution& distribution, double flux_lm) {
  constexpr int rows = 360, columns = 180;
  double sum = 0;
  for (int j = 0; j < rows; ++j) {
    const double g = (j + 0.5) * 180 / rows * degree, sine = std::sin(g), cosine = std::cos(g);
    for (int i = 0; i < columns; ++i) {
      const double c = (i + 0.5) * 360 / columns * degree;
      const double flux = distribution.eval(sine * std::cos(c), sine * std::sin(c), -cosine) * sine;
      if (!(flux > 0)) continue;
      sum += flux;
      if (j < rows / 2)
        down_.push_back({sine / cosine * std::cos(c), sine / cosine * std::sin(c), flux});
      else
        up_ += flux;
    }
  }
  if (!(sum > 0 && flux_lm > 0)) throw std::invalid_argument("the distribution has no flux");
  for (Ray& ray : down_) ray.share /= sum;
  up_ /= sum;
}

RoomFlux RoomRays::direct_shares(const RoomShape& room, int columns, int rows) const {
  double floor = 0, down = 0;
  for (const Ray& ray : down_) {
    floor += ray.share * share_inside(room.x, columns, ray.dx) * share_inside(room.y, rows, ray.dy);
    down += ray.share;
  }
  return {floor, down - floor, up_};
}

}  // namespace photometry
