// Which discs does a segment cross? Asked by light walks for meters, and by both walks for luminous openings.
//
// Embree only finds candidates (user geometry: its own disc shapes skip crossings near a ray's start); whether a disc
// is crossed is decided here, in double, so that few discs and many give the same answer.
#include <algorithm>
#include <cstring>

#include "geometry/embree.h"
#include "geometry/raytracer.h"

namespace ups {
namespace {

using Disc = DiscIndex::Disc;
using Crossing = DiscIndex::Crossing;

constexpr size_t brute_force_count = 4;

bool is_ball(const Disc& disc) { return disc.normal.x == 0 && disc.normal.y == 0 && disc.normal.z == 0; }

// A ball is reported from where it is entered, or from the start inside.
bool cross_ball(const Disc& ball, const Vec3d& o, const Vec3d& d, float tmax, float& t_out) {
  const Vec3d to_center = Vec3d(ball.center) - o;
  const double middle = dot(to_center, d), radius = ball.radius;
  const double half2 = radius * radius - length2(to_center - d * middle);
  if (!(half2 >= 0)) return false;
  const double half = std::sqrt(half2);
  if (!(middle + half >= 0 && middle - half <= tmax)) return false;
  t_out = float(std::max(0.0, middle - half));
  return true;
}

bool cross(const Disc& disc, const Vec3d& o, const Vec3d& d, float tmax, float& t_out) {
  const Vec3d n(disc.normal), c(disc.center);
  const double divisor = dot(d, n);
  if (divisor == 0) return is_ball(disc) && cross_ball(disc, o, d, tmax, t_out);
  const double t = dot(c - o, n) / divisor;
  if (!(t >= 0 && t <= tmax)) return false;
  if (length2(o + d * t - c) > double(disc.radius) * disc.radius) return false;
  t_out = float(t);
  return true;
}

struct Query {
  embree::QueryContext context;  // first: Embree hands back a pointer to it
  Vec3d o, d;
  float tmax;
  std::vector<Crossing>* out;
  bool out_of_memory = false;
};

void bounds(const RTCBoundsFunctionArguments* args) {
  const Disc& disc = static_cast<const Disc*>(args->geometryUserPtr)[args->primID];
  const float pad = 0x1p-21f * (max_abs(disc.center) + disc.radius);
  const auto half = [&](float n) { return disc.radius * std::sqrt(std::max(0.0f, 1 - n * n)) + pad; };
  const Vec3 h = disc.reach.x < 0 ? Vec3(half(disc.normal.x), half(disc.normal.y), half(disc.normal.z))
                                  : disc.reach + Vec3(pad, pad, pad);
  const Vec3 lower = disc.center - h, upper = disc.center + h;
  RTCBounds& b = *args->bounds_o;
  b.lower_x = lower.x, b.lower_y = lower.y, b.lower_z = lower.z;
  b.upper_x = upper.x, b.upper_y = upper.y, b.upper_z = upper.z;
}

// Leaves the ray as it is, so that Embree goes on to the next disc.
void collect(const RTCOccludedFunctionNArguments* args) {
  const Disc& disc = static_cast<const Disc*>(args->geometryUserPtr)[args->primID];
  Query& query = *reinterpret_cast<Query*>(args->context);
  float t;
  if (!cross(disc, query.o, query.d, query.tmax, t)) return;
  try {
    query.out->push_back({args->primID, t});
  } catch (...) {  // must not pass through Embree, which would keep it to itself
    query.out_of_memory = true;
  }
}

}  // namespace

struct DiscIndex::Impl {
  std::vector<Disc> discs;
  std::unique_ptr<embree::Device> device;  // both null for few discs
  std::unique_ptr<embree::Scene> scene;
};

DiscIndex::DiscIndex(std::vector<Disc> discs, ThreadPool& pool) : impl_(std::make_unique<Impl>()) {
  impl_->discs = std::move(discs);
  if (impl_->discs.size() <= brute_force_count) return;
  impl_->device = std::make_unique<embree::Device>();
  impl_->scene = std::make_unique<embree::Scene>(*impl_->device);
  RTCGeometry geometry = rtcNewGeometry(*impl_->device, RTC_GEOMETRY_TYPE_USER);
  impl_->device->check();
  rtcSetGeometryUserPrimitiveCount(geometry, unsigned(impl_->discs.size()));
  rtcSetGeometryUserData(geometry, impl_->discs.data());
  rtcSetGeometryBoundsFunction(geometry, &bounds, nullptr);
  rtcSetGeometryOccludedFunction(geometry, &collect);
  impl_->scene->attach(geometry, 0);
  impl_->scene->commit(pool);
}

DiscIndex::~DiscIndex() = default;

size_t DiscIndex::bytes() const {
  return impl_->discs.capacity() * sizeof(Disc) + (impl_->device ? impl_->device->bytes() : 0);
}

bool DiscIndex::empty() const { return impl_->discs.empty(); }

bool DiscIndex::holds(const std::vector<Disc>& discs) const {
  static_assert(sizeof(Disc) == 10 * sizeof(float));  // no padding to compare
  return discs.size() == impl_->discs.size() &&
         std::memcmp(discs.data(), impl_->discs.data(), discs.size() * sizeof(Disc)) == 0;
}

const DiscIndex::Disc& DiscIndex::disc(uint32_t i) const { return impl_->discs[i]; }

void DiscIndex::intersect_all(const Vec3& o, const Vec3& d, float tmax, std::vector<Crossing>& out) const {
  if (!impl_->scene) {
    float t;
    for (size_t i = 0; i < impl_->discs.size(); ++i)
      if (cross(impl_->discs[i], Vec3d(o), Vec3d(d), tmax, t)) out.push_back({uint32_t(i), t});
    return;
  }
  const size_t first = out.size();
  Query query;
  query.o = Vec3d(o), query.d = Vec3d(d), query.tmax = tmax, query.out = &out;
  RTCRay ray = embree::make_ray(o, d, tmax);
  embree::occluded(*impl_->scene, query.context, ray);
  if (query.out_of_memory) throw std::bad_alloc();
  // A disc may be offered twice where the index split its box; its crossing is the same both times.
  const auto begin = out.begin() + ptrdiff_t(first);
  std::sort(begin, out.end(), [](const Crossing& a, const Crossing& b) { return a.disc < b.disc; });
  out.erase(std::unique(begin, out.end(), [](const Crossing& a, const Crossing& b) { return a.disc == b.disc; }),
            out.end());
}

}  // namespace ups
