// How long do photons take? Building the index of photons that lie evenly on the surfaces of a room, and finding the
// ten or so within a radius.
#include <map>

#include "benchmarks.h"
#include "rooms.h"
#include "transport/photon_index.h"

namespace ups::benchmarks {

namespace {

constexpr size_t room_triangles = 100'000;
constexpr double photons_per_query = 8;
constexpr size_t query_count = 1u << 14;
constexpr size_t sizes[] = {10'000, 100'000, 1'000'000};
constexpr const char* size_names[] = {"1e4", "1e5", "1e6"};

const std::vector<StoredPhoton>& photons_of(size_t photon_count) {
  static std::map<size_t, std::vector<StoredPhoton>> photons;
  auto& these = photons[photon_count];
  for (size_t i = these.size(); i < photon_count; ++i)
    these.push_back({room_of(room_triangles).random_point(uint32_t(query_count + i)).p, uint32_t(i)});
  return these;
}

// On a plane; surfaces that meet add some.
float radius_of(size_t photon_count) {
  return float(std::sqrt(photons_per_query * room_of(room_triangles).area() / (pi * double(photon_count))));
}

void build(benchmark::State& state, size_t photon_count) {
  const std::vector<StoredPhoton>& photons = photons_of(photon_count);
  const float radius = radius_of(photon_count);
  for (auto _ : state) {
    const PhotonIndex index(LightPaths::of(photons), radius);
    benchmark::DoNotOptimize(index.empty());
  }
  count(state, "photons", double(photon_count));
}

void query(benchmark::State& state, size_t photon_count) {
  const float radius = radius_of(photon_count);
  const PhotonIndex index(LightPaths::of(photons_of(photon_count)), radius);
  std::vector<Vec3> places;
  for (uint32_t i = 0; i < query_count; ++i) places.push_back(room_of(room_triangles).random_point(i).p);
  size_t found = 0;
  for (auto _ : state)
    for (const Vec3& p : places) index.query(p, radius, [&](const PhotonIndex::Photon&, float) { ++found; });
  benchmark::DoNotOptimize(found);
  count(state, "queries", double(query_count));
  count(state, "found", double(found) / double(state.iterations()));
}

std::string name_of(const char* what, size_t size) { return std::string("photons/") + what + "/" + size_names[size]; }

}  // namespace

void register_photon_index() {
  for (size_t i = 0; i < std::size(sizes); ++i) {
    add(name_of("build", i), [=](benchmark::State& s) { build(s, sizes[i]); });
    add(name_of("query", i), [=](benchmark::State& s) { query(s, sizes[i]); });
    if (i > 0) compare(name_of("build", i), name_of("build", 0), "photons");
    if (i > 0) compare(name_of("query", i), name_of("query", 0), "queries");
  }
}

}  // namespace ups::benchmarks
