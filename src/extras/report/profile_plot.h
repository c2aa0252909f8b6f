// The polar diagram of a luminaire: curves of the planes C0-C180 and C90-C270, and of that of the peak where both miss
// it. Called by the page and by the program's data sheets; their colours are those of other drawings too.
#pragma once
#include "report/drawing.h"
#include "report/profile_data.h"

namespace ups::report {

struct Frame {
  double left, top, width, height;
};
// The last are of the plane of the peak. Told apart by colour-blind people too.
inline constexpr Ink plane_ink[3] = {{0, 92, 175}, {214, 84, 10}, {0, 128, 96}};
inline constexpr double plane_dash[3] = {0, 7, 2.5};
inline constexpr Ink black{25, 25, 25}, grey{105, 105, 105}, pale{205, 205, 205};

// What the polar diagram draws and its legend names: two planes or, with that of the peak, three.
std::vector<PlaneReport> drawn_planes(const ProfileReport& report);

// Of the unit in which numbers up to `largest` need no exponent.
struct Prefix {
  double factor;
  const char* sign;
};
Prefix prefix_of(double largest);

// 1, 2 or 5 times a power of ten, at least `smallest`.
double round_step(double smallest);

// Intensities per 1000 lm of the lamps where their flux is known, as luminaires with lamps are tabulated.
bool is_per_kilolumen(const ProfileReport& report);

bool shines_up(const ups_profile* profile, const ProfileReport& report);  // then the polar diagram is a full circle
void draw_polar(Drawing& drawing, const Frame& frame, const ups_profile* profile, const ProfileReport& report);

}  // namespace ups::report
