// UPS for C++17: luminaires of parts, ups_fixture.h. See ups.hpp.
#ifndef UPS_HPP_FIXTURE_HPP
#define UPS_HPP_FIXTURE_HPP

#include "descs.hpp"

namespace ups {
inline namespace v0_1 {

struct FixtureEmitterDesc : ups_fixture_emitter_desc {
  FixtureEmitterDesc() noexcept { ups_fixture_emitter_desc_init(this, sizeof(ups_fixture_emitter_desc)); }
};

struct ReflectorDesc : ups_reflector_desc {
  ReflectorDesc() noexcept { ups_reflector_desc_init(this, sizeof(ups_reflector_desc)); }
  // POLYLINE through points of 2 values each: radius and z, m.
  explicit ReflectorDesc(Span<const double> points_rz_m) : ReflectorDesc() {
    profile = UPS_REFLECTOR_POLYLINE;
    profile_point_count = detail::count(points_rz_m.size(), 2, "points_rz_m");
    profile_rz_m = points_rz_m.data();
  }
};

struct LensDesc : ups_lens_desc {
  LensDesc() noexcept { ups_lens_desc_init(this, sizeof(ups_lens_desc)); }
};

struct CollimatorDesc : ups_collimator_desc {
  CollimatorDesc() noexcept { ups_collimator_desc_init(this, sizeof(ups_collimator_desc)); }
  // The outer wall as a polyline, from z = 0 down, of points of 2 values each: radius and z, m.
  explicit CollimatorDesc(Span<const double> points_rz_m) : CollimatorDesc() {
    wall = UPS_COLLIMATOR_POLYLINE;
    wall_point_count = detail::count(points_rz_m.size(), 2, "points_rz_m");
    wall_rz_m = points_rz_m.data();
  }
};

struct FixturePartDesc : ups_fixture_part_desc {
  FixturePartDesc() noexcept { ups_fixture_part_desc_init(this, sizeof(ups_fixture_part_desc)); }
  // The mesh's desc must be there until this one was used.
  explicit FixturePartDesc(const ups_mesh_desc &of) noexcept : FixturePartDesc() { mesh = &of; }
};

struct FixtureInstanceDesc : ups_fixture_instance_desc {
  FixtureInstanceDesc() noexcept { ups_fixture_instance_desc_init(this, sizeof(ups_fixture_instance_desc)); }
  explicit FixtureInstanceDesc(const Transform &at) noexcept : FixtureInstanceDesc() { at.copy_to(to_world); }
};

class Fixture : public Handle<ups_fixture> {
 public:
  using Handle::Handle;
  explicit Fixture(const Context &context) : Handle(detail::value<ups_fixture *>(ups_fixture_create, context.get())) {}

  ups_fixture_part_id add_emitter(const FixtureEmitterDesc &desc) {
    return detail::value<ups_fixture_part_id>(ups_fixture_add_emitter, get(), &desc);
  }
  ups_fixture_part_id add_reflector(const ReflectorDesc &desc) {
    return detail::value<ups_fixture_part_id>(ups_fixture_add_reflector, get(), &desc);
  }
  ups_fixture_part_id add_lens(const LensDesc &desc) {
    return detail::value<ups_fixture_part_id>(ups_fixture_add_lens, get(), &desc);
  }
  ups_fixture_part_id add_collimator(const CollimatorDesc &desc) {
    return detail::value<ups_fixture_part_id>(ups_fixture_add_collimator, get(), &desc);
  }
  ups_fixture_part_id add_part(const FixturePartDesc &desc) {
    return detail::value<ups_fixture_part_id>(ups_fixture_add_part, get(), &desc);
  }
  ups_fixture_info get_info() const { return detail::sized<ups_fixture_info>(ups_fixture_get_info, get()); }
};

}  // namespace v0_1
}  // namespace ups

#endif
