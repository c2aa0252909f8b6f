// See eye_walk.h: what an eye path has found waits for a shadow ray, gets one by chance, and is added up.
#include "transport/eye_walk.h"

#include <algorithm>

#include "base/per_thread.h"
#include "transport/selection.h"

namespace ups {
namespace {

// Emptied: of a path that was broken off some may be left.
template <class T>
std::vector<T>& emptied(const PerThread<std::vector<T>>& kept) {
  std::vector<T>& out = kept.get();
  out.clear();
  return out;
}

}  // namespace

std::vector<EyeWalk::WaitingEdge>& EyeWalk::kept_edges() {
  static const PerThread<std::vector<WaitingEdge>> kept;
  return emptied(kept);
}
std::vector<EyeWalk::Column>& EyeWalk::kept_columns() {
  static const PerThread<std::vector<Column>> kept;
  return emptied(kept);
}

constexpr size_t most_waiting = 1024;  // edges, half a megabyte

void EyeWalk::offer(const Contribution& c, Drop drop, double share) {
  // Images of techniques show what has next to no weight, too.
  if (!c.media || sensor_.techniques || (in_.recorder && in_.recorder->wants_all_edges()))
    return test_edge(c, drop, share);
  const double size = luminance(c.value) * share * c.weight(in_, 1);
  if (!std::isfinite(size)) return work_.drop(drop, rng_.address(), place_of(c));
  const bool far = scene_.emitters.has_direct(true) && scene_.emitters.is_directional(c.emitter);
  if (size > 0) edges_.push_back({c, *c.media, drop, share, size, far});
  if (edges_.size() >= most_waiting) test_edges();  // of a path of many hundred vertices
}

namespace {

// Of an eye path. Timed against 1, 2, 4 and all of them at equal error: in the bathroom 0.90 of the time of all, in an
// office and in a box with two balls 0.97. Where an eye path has edges to other emitters, too, those to directional ones
// get so many beside the others' three.
constexpr int shadow_rays = 3, shadow_rays_beside = 2;

}  // namespace

// The size t for which probabilities min(1, size / t) of the edges to emitters of a kind have the sum `rays`.
double EyeWalk::size_of_certain_edges(bool far, int rays, double WaitingEdge::*size) const {
  double t = INFINITY;
  for (;;) {
    double rest = 0;
    int certain = 0;
    for (const WaitingEdge& e : edges_) {
      if (e.far != far) continue;
      if (e.*size >= t) ++certain;
      else rest += e.*size;
    }
    if (certain == rays) return t;
    const double next = rest / (rays - certain);
    if (!(next < t)) return t;
    t = next;
  }
}

void EyeWalk::part_by_emitter(bool far) {
  static const PerThread<std::vector<double>> kept;
  std::vector<double>& sums = kept.get();
  sums.resize(std::max(sums.size(), scene_.emitters.size()));
  for (const WaitingEdge& e : edges_) sums[e.found.emitter] = 0;
  for (const WaitingEdge& e : edges_)
    if (e.far == far) sums[e.found.emitter] += e.size;
  for (WaitingEdge& e : edges_)
    if (e.far == far) e.part = e.size / sums[e.found.emitter];
}

// Which edges get a shadow ray is drawn in proportion to what they would bring, with a fixed number in all: where all
// are free, nothing is lost by it (systematic sampling with probabilities in proportion to size, Madow 1949). Those to
// directional emitters are drawn by themselves: they would bring much, and may all be hidden.
// Where sources are told apart as many are drawn by their part of what the path would bring from their own emitter. A lamp
// that is weak here is chosen seldom, and each time hardly an edge to it would get a ray: its own reading would lack what
// few paths bring, and not know it. Not by their part of their source's: another lamp of its group may be strong and
// hidden. An edge gets its ray by the larger of both probabilities; so up to twice as many rays are cast.
void EyeWalk::test_edges() {
  size_t count[2] = {};
  for (const WaitingEdge& e : edges_) ++count[e.far];
  for (const bool far : {false, true}) {
    const int rays = far && count[0] > 0 ? shadow_rays_beside : shadow_rays;
    const bool all = count[far] <= size_t(rays);
    const bool by_emitter = !all && tells_sources_apart();
    if (by_emitter) part_by_emitter(far);
    const double certain = all ? 0 : size_of_certain_edges(far, rays, &WaitingEdge::size),
                 own = by_emitter ? size_of_certain_edges(far, rays, &WaitingEdge::part) : 1;
    double sum = all ? 0 : rng_.get_fine(tests_, tests_ ? Slot::later_edges : Slot::edges);
    const auto draw = [&](WaitingEdge& e, double probability) {
      const double before = sum;
      if (probability < 1 && std::floor(sum += probability) == std::floor(before)) return;
      e.found.media = &e.media;
      test_edge(e.found, e.drop, e.share / probability);
    };
    const auto by_size = [&](const WaitingEdge& e) { return all ? 1 : std::min(1.0, e.size / certain); };
    const auto by_part = [&](const WaitingEdge& e) { return std::min(1.0, e.part / own); };
    // Those that bring most by themselves, so that no weak one comes between and their number varies by one at most.
    for (WaitingEdge& e : edges_)
      if (e.far == far && !(by_emitter && by_part(e) > by_size(e))) draw(e, by_size(e));
    if (!by_emitter) continue;
    for (WaitingEdge& e : edges_)
      if (e.far == far && by_part(e) > by_size(e)) draw(e, by_part(e));
  }
  ++tests_;
  edges_.clear();
}

void EyeWalk::test_edge(const Contribution& c, Drop drop, double share) {
  Passage way;
  if (c.media && is_finite(c.value) && !edge_free(scene_, c, work_, way)) return;
  const Rgb unweighted = c.value * way.transmittance * float(share);
  const double weight = c.weight(in_, way.pass);
  if (in_.recorder) in_.recorder->found(c, {way.pass, unweighted, weight}, none);
  add(c, unweighted, way.pass, float(weight), drop);
}

void EyeWalk::add(const Contribution& c, const Rgb& unweighted, double pass, float weight, Drop where) {
  const Rgb value = unweighted * weight;
  if (!is_finite(value)) return drop(where, place_of(c));
  const bool is_direct = c.technique.edges == 1;
  const float lx = luminance(value);
  tally_.add(value);
  if (is_direct) tally_.direct += lx;
  if (sensor_.techniques) sensor_.techniques->add(c.technique, sensor_.pixel, value, unweighted);
  if (sensor_.excess) in_.moments->add(lx * sensor_.share, c.relative(pass), sensor_.camera, sensor_.excess);
  keep_separated(c.emitter, lx, is_direct ? lx : 0.0, 0.0);
}

MeterTally& EyeWalk::separated(uint32_t emitter) {
  const uint32_t column = in_.plan.separation.column_of_emitter[emitter];
  auto at = std::find_if(columns_.begin(), columns_.end(), [&](const Column& c) { return c.first == column; });
  if (at == columns_.end()) at = columns_.insert(at, {column, {}});
  return at->second;
}

void EyeWalk::keep_separated(uint32_t emitter, double lx, double direct, double bias) {
  if (!sensor_.separated) return;
  MeterTally& t = separated(emitter);
  t.value += lx, t.direct += direct, t.bias += bias;
}

void EyeWalk::add_separated() {
  if (!sensor_.separated) return;
  for (const auto& [column, kept] : columns_) {
    MeterTally t = MeterTally::of_path(kept.value, kept.direct, kept.bias);
    t.caustics = kept.caustics;
    sensor_.separated[column].add(t, sensor_.share);
  }
}

}  // namespace ups
