// The body that a luminous opening is: where its surface lies, how large it looks, points of it. Used by the emitters
// with a profile; knows nothing of light.
//
// The body's own frame, metres: centred on the origin, a flat opening in the xy-plane, a cylinder along z. turned()
// makes it from the luminaire's frame. Doubles, so that small bodies far away keep their shape.
#pragma once
#include <array>

#include "base/frame.h"
#include "photometry/photometry.h"

namespace ups {

class LuminousBody {
 public:
  // Whether there is an area to emit from: at least two extents.
  static bool has_area(const photometry::Opening& opening);
  // Throws Error where there is none, or one outside the range of a float.
  explicit LuminousBody(const photometry::Opening& opening);

  Frame turned(const Frame& luminaire) const;
  bool is_flat() const { return kind_ == Kind::rectangle || kind_ == Kind::ellipse; }
  const Vec3d& half() const { return half_; }  // extents; z is 0 for a flat opening
  double circumscribed_radius() const;
  // m^2: all sides of a body, one side of a flat opening. Of ellipses' mantles and ellipsoids to about 1 %: a constant
  // to state densities by.
  double area() const { return area_; }
  // m^2, as seen from afar in the direction w (unit, away from the body). 0 for a flat opening edge on.
  // margin: that of enter().
  double projected_area(const Vec3d& w, double margin = 0) const;

  struct Point {
    Vec3d p, n;        // n: unit, outwards; of a flat opening, of the side that is seen
    double pdf_a = 0;  // m^-2
  };
  // A point uniform in the area that is seen from afar in the direction w; pdf_a is n . w / projected area.
  bool sample_seen_along(const Vec3d& w, Vec2 u, Point& out) const;
  // A point that a reference outside sees. False where that lies inside the body: it sees nothing of it.
  bool sample_seen_from(const Vec3d& reference, Vec2 u, Point& out) const;
  // The density with which sample_seen_from takes a point of the surface with this normal.
  double pdf_seen_from(const Vec3d& reference, const Vec3d& p, const Vec3d& n) const;
  // The normal at a point of the surface, of the side that faces w. False where none does.
  bool normal_at(const Vec3d& p, const Vec3d& w, Vec3d& n) const;
  // Where a ray first enters the body, grown by `margin` on all sides; a flat opening lies at z = margin instead. d is
  // unit. False where the ray misses or starts inside.
  bool enter(const Vec3d& o, const Vec3d& d, double margin, double& t, Vec3d& n) const;

 private:
  enum class Kind { rectangle, ellipse, box, cylinder, ellipsoid };
  static Kind kind_of(const photometry::Opening& opening);
  Vec3d to_unit(const Vec3d& p) const { return {p.x / half_.x, p.y / half_.y, p.z / half_.z}; }

  // The parts that an opening is put together from: faces across an axis, the mantle of a cylinder, the ball.
  double face_area(int axis) const;
  void sample_face(int axis, double sign, const Vec2& u, Point& out) const;
  std::array<double, 3> face_weights(const Vec3d& reference) const;
  // pdf_seen_from() by these weights, and of a cylinder by its mantle's share.
  double box_pdf(const Vec3d& reference, const std::array<double, 3>& weights, const Vec3d& n) const;
  double cylinder_pdf(const Vec3d& reference, double share, const Vec3d& p, const Vec3d& n) const;
  static double mantle_seen(const Vec3d& half, const Vec3d& w);  // its projected area
  double mantle_share(const Vec3d& reference) const;
  double mantle_stretch(double c, double s) const;
  void place_on_mantle(const Vec3d& towards, double sine, double v, Point& out) const;
  double mantle_pdf(const Vec3d& reference, const Vec3d& p) const;
  bool sample_cap(const Vec3d& reference, const Vec2& u, Point& out) const;
  double cap_pdf(const Vec3d& reference, const Vec3d& p) const;
  void place_on_ball(const Vec3d& q, Point& out) const;

  Kind kind_;
  int axis_ = 2;  // of the luminaire, along this body's z
  Vec3d half_;
  double area_ = 0;
};

}  // namespace ups
