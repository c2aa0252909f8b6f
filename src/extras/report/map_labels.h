// Where texts on a map stand without touching one another. Called by map_plot.cpp.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "report/drawing.h"

namespace ups::report {

// Places that are taken, as discs along the middle line of each text.
class TakenPlaces {
 public:
  // Centred there, turned as a label is. False: something is there, and nothing is taken.
  bool take(const Point& centre, double width, double height, double turn_rad = 0) {
    const double radius = 0.5 * height, half = std::max(0.5 * width - radius, 0.0);
    const int discs = 1 + int(std::ceil(2 * half / radius));
    std::vector<Disc> wanted;
    for (int i = 0; i < discs; ++i) {
      const double along = discs > 1 ? -half + 2 * half * i / (discs - 1) : 0;
      wanted.push_back({{centre.x + along * std::cos(turn_rad), centre.y + along * std::sin(turn_rad)}, radius});
    }
    for (const Disc& a : wanted)
      for (const Disc& b : taken_)
        if (std::hypot(a.centre.x - b.centre.x, a.centre.y - b.centre.y) < a.radius + b.radius) return false;
    taken_.insert(taken_.end(), wanted.begin(), wanted.end());
    return true;
  }

  // What of a line lies in a rectangle; it may cross other things, but not what is set later.
  void occupy(const std::vector<Point>& line, const Point& least, const Point& most) {
    constexpr double step = 4, radius = 0.5;
    double next = 0;  // along a segment
    for (size_t i = 1; i < line.size(); ++i) {
      const Point a = line[i - 1], to{line[i].x - a.x, line[i].y - a.y};
      const double length = std::hypot(to.x, to.y);
      if (!(length > 0)) continue;
      double from = next, end = length;  // within the rectangle (Liang and Barsky 1984)
      const auto clip = [&](double start, double change, double low, double high) {
        if (change == 0) {
          if (!(start >= low && start <= high)) end = -1;
          return;
        }
        const double t0 = (low - start) / change * length, t1 = (high - start) / change * length;
        from = std::max(from, std::min(t0, t1)), end = std::min(end, std::max(t0, t1));
      };
      clip(a.x, to.x, least.x, most.x), clip(a.y, to.y, least.y, most.y);
      for (double at = next + step * std::ceil((from - next) / step); at <= end; at += step)
        taken_.push_back({{a.x + to.x * at / length, a.y + to.y * at / length}, radius});
      next = next > length ? next - length : step - std::fmod(length - next, step);
    }
  }

 private:
  struct Disc {
    Point centre;
    double radius;
  };
  std::vector<Disc> taken_;
};

// Along a line of points, `along` being how far each is from the first.
Point point_at(const std::vector<Point>& points, const std::vector<double>& along, double at);
// Of a text of half that width there, upright.
double turn_at(const std::vector<Point>& points, const std::vector<double>& along, double at, double half);
// Where the line is straightest, and nearly level if it can be; < 0: nowhere is it straight enough.
double best_place(const std::vector<Point>& points, const std::vector<double>& along, double from, double to,
                  double half);

}  // namespace ups::report
