// How long does a surface take to scatter? For each material model: a path's vertex (build the Bsdf, sample it), and
// one evaluation of a Bsdf that is there, as connections and merges need; and texture lookups, alone and within a
// vertex.
#include <map>

#include "benchmarks.h"
#include "bsdf/cases.h"
#include "rooms.h"

namespace ups::benchmarks {

namespace {

constexpr size_t pair_count = 1u << 12;  // directions, numbers and coordinates that are prepared
constexpr uint32_t small_side = 64, large_side = 2048;
constexpr TransportMode mode = TransportMode::radiance;
enum Stream : uint32_t { outgoing = 4, incoming = 5, coordinate = 6 };

struct Event {
  Vec3 wo, wi;
  float lobe;
  Vec2 u, uv;
};

// wo in front; wi in front too, or on both sides where the material transmits.
std::vector<Event> make_events(bool transmits) {
  std::vector<Event> events;
  for (uint32_t i = 0; i < pair_count; ++i) {
    const Numbers a = random_numbers(i, outgoing), b = random_numbers(i, incoming), c = random_numbers(i, coordinate);
    Event e{square_to_cosine_hemisphere({a.a, a.b}), square_to_sphere({b.a, b.b}), a.c, {b.c, b.d}, {c.a, c.b}};
    if (!transmits) e.wi.z = std::abs(e.wi.z);
    events.push_back(e);
  }
  return events;
}

void sample(benchmark::State& state, const Material& material) {
  const std::vector<Event> events = make_events(false);
  BsdfSample out;
  for (auto _ : state)
    for (const Event& e : events) {
      const Bsdf bsdf(material, e.uv);
      benchmark::DoNotOptimize(bsdf.sample(e.wo, e.lobe, e.u, mode, out));
      benchmark::DoNotOptimize(out);
    }
  count(state, "vertices", double(events.size()));
}

void evaluate(benchmark::State& state, const Material& material) {
  const Bsdf bsdf(material, {0.5f, 0.5f});
  const std::vector<Event> events = make_events(bsdf.transmits());
  for (auto _ : state)
    for (const Event& e : events) benchmark::DoNotOptimize(bsdf.evaluate(e.wo, e.wi, mode));
  count(state, "evaluations", double(events.size()));
}

std::vector<test::Case> materials() {
  using enum MaterialModel;
  Material diffuser_material = test::make(diffuser), pane = test::make(glazing, 0, Rgb(0.5f), 1.52f);
  diffuser_material.transmittance = Rgb(0.3f);
  pane.transmittance = Rgb(0.8f);
  return {{"matte", test::make(matte)},
          {"plastic_smooth", test::make(plastic)},
          {"plastic_rough", test::make(plastic, 0.4f)},
          {"metal_smooth", test::make(metal)},
          {"metal_rough", test::make(metal, 0.4f)},
          {"mirror", test::make(mirror)},
          {"glass_smooth", test::make(glass)},
          {"glass_rough", test::make(glass, 0.4f)},
          {"glazing", pane},
          {"diffuser", diffuser_material}};
}

// Square, three channels, of random texels.
const Texture& texture_of(uint32_t side) {
  static std::map<uint32_t, Texture> textures;
  const auto found = textures.find(side);
  if (found != textures.end()) return found->second;
  std::vector<float> texels(size_t(side) * side * 3);
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = 0.2f + 0.6f * to_unit_float(uint32_t(mix64(i)));
  return textures.try_emplace(side, side, side, 3, std::move(texels)).first->second;
}

// At random places: the large texture is not in the cache.
void look_up(benchmark::State& state, uint32_t side) {
  const Texture& texture = texture_of(side);
  std::vector<Vec2> places;
  for (uint32_t i = 0; i < 64 * pair_count; ++i) {
    const Numbers u = random_numbers(i, coordinate);
    places.push_back({u.a, u.b});
  }
  for (auto _ : state)
    for (const Vec2& uv : places) benchmark::DoNotOptimize(texture.rgb(uv));
  count(state, "lookups", double(places.size()));
}

void sample_textured(benchmark::State& state) {
  Material material = test::make(MaterialModel::matte);
  material.reflectance_texture = &texture_of(small_side);
  sample(state, material);
}

void register_material(const test::Case& c) {
  const std::string vertex = "bsdf/sample/" + c.name, evaluation = "bsdf/evaluate/" + c.name;
  add(vertex, [material = c.material](benchmark::State& s) { sample(s, material); });
  if (c.name != "matte") compare(vertex, "bsdf/sample/matte", "vertices");
  if (!Bsdf(c.material, {0, 0}).has_continuous()) return;  // nothing to evaluate
  add(evaluation, [material = c.material](benchmark::State& s) { evaluate(s, material); });
  if (c.name != "matte") compare(evaluation, "bsdf/evaluate/matte", "evaluations");
}

}  // namespace

void register_bsdf() {
  for (const test::Case& c : materials()) register_material(c);
  add("bsdf/sample/matte_textured", sample_textured);
  compare("bsdf/sample/matte_textured", "bsdf/sample/matte", "vertices");
  add("texture/lookup/64x64", [](benchmark::State& s) { look_up(s, small_side); });
  add("texture/lookup/2048x2048", [](benchmark::State& s) { look_up(s, large_side); });
  compare("texture/lookup/2048x2048", "texture/lookup/64x64", "lookups");
}

}  // namespace ups::benchmarks
