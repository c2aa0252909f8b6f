// Is a render told from another by its books where flux or importance is lost on the way, starts wrong or is taken by
// roulette? And do books without a fault pass?
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "../support/snapshot_room.h"
#include "emitter/point.h"
#include "render/dropped_text.h"
#include "render/flux_balance.h"
#include "render/job.h"

namespace ups {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::shared_ptr<const RenderResult> render(std::shared_ptr<Snapshot> scene, ups_method method = UPS_METHOD_UPS,
                                           int threads = 2, uint32_t paths = 1u << 16) {
  ups_render_desc d{};
  d.method = method;
  d.iteration_count = 4;
  d.seed = 1;
  d.flux_paths = paths;
  d.light_paths_per_iteration = paths / 4;
  d.merge_radius_m = 0.1f;
  RenderJob job(std::move(scene), d, std::make_shared<ThreadPool>(threads));
  job.start();
  std::string message;
  while (job.wait(UINT32_MAX, message) == UPS_TIMEOUT) {}
  EXPECT_EQ(message, "");
  return job.result();
}

bool warns(const RenderResult& r) {
  return r.warnings.find("the flux balance does not close") != std::string::npos;
}
bool warns_of_eye_paths(const RenderResult& r) {
  return r.warnings.find("the balance of eye paths does not close") != std::string::npos;
}

// Within 4.6 standard errors, which Gaussian noise passes in 4 of 10^6, of at most 0.15 % of what is emitted: of what
// roulette takes or gives 1 % is found in 97.7 of 100 cases, and 1e-6 of what is lost on the way, by the warning. In
// glass that absorbs nothing a few paths that it never lets out decide: there the error is not limited.
TEST(FluxBalance, ClosesInRoomsWithoutAFault) {
  struct Case {
    ups_material_model model;
    float absorption_per_m;
    uint32_t paths;
    double error;
  };
  for (const Case& c : {Case{UPS_MATERIAL_MATTE, 0, 1u << 17, 0.0015}, {UPS_MATERIAL_MIRROR, 0, 1u << 17, 0.0015},
                        {UPS_MATERIAL_GLASS, 0, 1u << 16, INFINITY}, {UPS_MATERIAL_GLASS, 0.1f, 1u << 15, 0.0015}})
    for (const ups_method method : {UPS_METHOD_UPS, UPS_METHOD_PATH_TRACING}) {
      const auto scene = test::room(c.model);
      if (c.absorption_per_m > 0)
        for (Material& m : scene->materials) m.absorption_per_m = Rgb(c.absorption_per_m);
      const auto r = render(scene, method, 2, c.paths);
      EXPECT_FALSE(warns(*r) || warns_of_eye_paths(*r)) << r->warnings;
      EXPECT_EQ(r->dropped, "");
      const ups_result_info& i = r->info;
      EXPECT_GE(i.flux_balance_standard_error_lm, 0);
      EXPECT_LE(i.flux_balance_standard_error_lm, c.error * i.emitted_flux_lm) << c.model << " " << method;
      EXPECT_LE(std::abs(i.emitted_flux_lm - i.absorbed_flux_lm - i.escaped_flux_lm),
                4.6 * i.flux_balance_standard_error_lm + 1e-5 * i.emitted_flux_lm);
    }
}

// Its paths start with more or less flux than it states.
class WrongEmitter : public PointEmitter {
 public:
  WrongEmitter(const Rgb& intensity, float factor) : PointEmitter(Vec3(), intensity, 0.0f), factor_(factor) {}
  bool sample_emission(const Vec2& u, const Vec2& v, EmissionSample& out) const override {
    const bool emits = PointEmitter::sample_emission(u, v, out);
    out.flux *= factor_;
    return emits;
  }

 private:
  float factor_;
};

std::shared_ptr<Snapshot> room_with(float factor) {
  auto scene = test::room(UPS_MATERIAL_MATTE);
  std::vector<std::shared_ptr<const Emitter>> emitters;
  emitters.push_back(std::make_unique<WrongEmitter>(Rgb(100.0f), factor));
  scene->emitters = EmitterSet(std::move(emitters), {});
  return scene;
}

// One lamp starts all paths alike: the least error that is found is that of rounding, 1e-5.
TEST(FluxBalance, TellsEmissionThatStartsWithTheWrongFlux) {
  for (const ups_method method : {UPS_METHOD_UPS, UPS_METHOD_PATH_TRACING}) {
    EXPECT_FALSE(warns(*render(room_with(1), method)));
    for (const float factor : {0.9999f, 1.0001f}) EXPECT_TRUE(warns(*render(room_with(factor), method))) << factor;
  }
  EXPECT_NE(render(room_with(0.5f))->warnings.find("of 1256.6371 lm emitted 628.3"), std::string::npos)
      << render(room_with(0.5f))->warnings;
}

TEST(FluxBalance, TellsPathsThatAreDroppedAndWhere) {
  const auto poisoned = [] {
    const auto scene = test::room(UPS_MATERIAL_GLASS);
    for (Material& m : scene->materials) m.absorption_per_m = Rgb(nan);
    return scene;
  };
  const auto one = render(poisoned(), UPS_METHOD_UPS, 1);
  EXPECT_TRUE(warns(*one)) << one->warnings;
  EXPECT_NE(one->dropped.find("light_walk: 65536 samples were not finite, the first in light path 0 of iteration 0"),
            std::string::npos) << one->dropped;
  EXPECT_NE(one->dropped.find("eye_walk: "), std::string::npos) << one->dropped;
  EXPECT_NE(one->dropped.find("the first in camera 1, pixel (0, 0) of iteration 0, near ("), std::string::npos)
      << one->dropped;
  for (const int threads : {2, 3}) EXPECT_EQ(render(poisoned(), UPS_METHOD_UPS, threads)->dropped, one->dropped);
}

// Of each method, of paths that are cut off and of those that leave an open room, with glass that absorbs and with
// mirrors: all importance that eye paths start with is accounted for, to the rounding of the sums.
TEST(FluxBalance, AccountsForTheImportanceOfEyePaths) {
  ThreadPool pool(2);
  const StopSignal stop;
  for (const ups_material_model model : {UPS_MATERIAL_MATTE, UPS_MATERIAL_MIRROR, UPS_MATERIAL_GLASS})
    for (const ups_method method : {UPS_METHOD_UPS, UPS_METHOD_PATH_TRACING, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PPM,
                                    UPS_METHOD_SPPM, UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING,
                                    UPS_METHOD_LIGHT_TRACING})
      for (const uint32_t longest : {0u, 3u}) {
        const auto scene = test::room(model, true);
        for (Material& m : scene->materials) m.absorption_per_m = Rgb(0.1f);
        TransportSettings settings{.method = *method_of(method)};
        settings.techniques = settings.method.techniques;
        settings.max_path_length = longest;
        settings.light_paths = 1024;
        Integrator integrator(scene, settings, pool, stop);
        FluxBooks books;
        for (uint32_t i = 0; i < 8; ++i) {
          IterationTally tally;
          EXPECT_TRUE(integrator.run(i, stop, tally));
          books.add(tally.work.importance);
        }
        const std::string what = std::to_string(model) + ", " + std::to_string(method) + ", " + std::to_string(longest);
        EXPECT_NEAR(books.absorbed + books.escaped + books.cut + books.roulette, books.started, 1e-9 * books.started)
            << what;
        EXPECT_TRUE(importance_balance(books).closes()) << what << importance_warning(importance_balance(books));
        if (method != UPS_METHOD_PATH_TRACING) continue;
        EXPECT_GT(books.escaped, 0.01 * books.started) << what;
        EXPECT_EQ(books.cut > 0.001 * books.started, longest > 0) << what;
      }
}

TEST(FluxBalance, OfEyePathsTellsThoseThatAreDropped) {
  for (const ups_method method : {UPS_METHOD_PATH_TRACING, UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL}) {
    const auto scene = test::room(UPS_MATERIAL_GLASS);
    EXPECT_FALSE(warns_of_eye_paths(*render(scene, method, 2, 0)));
    for (Material& m : scene->materials) m.absorption_per_m = Rgb(nan);
    const auto r = render(scene, method, 2, 0);
    EXPECT_TRUE(warns_of_eye_paths(*r)) << r->warnings;
    EXPECT_NE(r->warnings.find("is neither absorbed nor escapes"), std::string::npos) << r->warnings;
  }
}

// Each by its name, with the first of two alone.
TEST(FluxBalance, TellsEachKindOfDroppedSampleWithItsPlace) {
  ThreadPool pool(1);
  TransportSettings settings{.method = *method_of(UPS_METHOD_UPS)};
  const StopSignal stop;
  const Integrator integrator(test::room(UPS_MATERIAL_MATTE), settings, pool, stop);
  for (size_t k = 0; k < size_t(Drop::count); ++k) {
    WorkCounts w;
    w.drop(Drop(k), {Stream::light, 3, uint32_t(k)}, Vec3(0.5f, nan, 0));
    w.drop(Drop(k), {Stream::light, 4, 0}, Vec3());
    EXPECT_EQ(dropped_text(integrator, w),
              std::string(drop_names[k]) + ": 2 samples were not finite, the first in light path " + std::to_string(k) +
                  " of iteration 3, at no finite point\n");
    w = {};
    w.drop(Drop(k), {Stream::light, 3, 1}, Vec3(-integrator.scene().origin));
    EXPECT_NE(dropped_text(integrator, w).find(", near (0, 0, 0) m\n"), std::string::npos) << dropped_text(integrator, w);
  }
}

// ---- books alone ----

// A path of 10 games, its flux halved before each. cheat: added to the probability with which roulette spares it.
WorkCounts played(uint64_t seed, uint32_t paths, double cheat) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  WorkCounts w;
  w.light_paths = paths;
  w.brightest_lm = 1;
  for (uint32_t i = 0; i < paths; ++i) {
    double now = 1;
    w.flux.start(now);
    for (int k = 0; k < 10 && now > 0; ++k) {
      w.flux.absorbed += now / 2;
      now /= 2;
      const bool survives = uniform(random) < 0.5 + cheat;
      w.flux.play(now, 0.5, survives ? now / 0.5 : 0);
      now = survives ? now / 0.5 : 0;
    }
    w.flux.escaped += now;
  }
  return w;
}

// The spread of 400 balances has a relative standard error of 3.5 %: 15 % is a false alarm in 50,000.
TEST(FluxBalance, KnowsItsStandardErrorAndCloses) {
  constexpr int seeds = 400;
  double square = 0, stated = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const WorkCounts w = played(uint64_t(seed), 1000, 0);
    const FluxBalance b = flux_balance(w, 1);
    EXPECT_TRUE(b.closes()) << flux_warning(b, 1);
    EXPECT_EQ(flux_warning(b, 1), "");
    square += std::pow(1 - (w.flux.absorbed + w.flux.escaped) / 1000, 2) / seeds;
    stated += b.standard_error * b.standard_error / seeds;
  }
  EXPECT_NEAR(std::sqrt(square / stated), 1, 0.15);
}

// The same from batches, of 16 iterations and of 17, by which the first batch has twice the paths. The spread of 16 is
// itself uncertain by 18 %, the mean of 400 squares by 2 %.
TEST(FluxBalance, KnowsItsStandardErrorByBatches) {
  constexpr uint64_t seeds = 400, paths = 100;
  for (const uint32_t iterations : {16u, 17u}) {
    double square = 0, stated = 0;
    for (uint64_t seed = 1; seed <= seeds; ++seed) {
      WorkCounts all;
      for (uint32_t i = 0; i < iterations; ++i) {
        WorkCounts w = played(1000 * seed + i, paths, 0);
        w.flux.settle(i % 16, paths);
        all.add(w);
      }
      const double n = double(paths * iterations), s = flux_balance(all, 1).standard_error;
      EXPECT_NE(s, std::sqrt(all.flux.roulette_variance) / n) << "the games' own was told";
      square += std::pow(1 - (all.flux.absorbed + all.flux.escaped) / n, 2) / seeds;
      stated += s * s / seeds;
    }
    EXPECT_NEAR(std::sqrt(square / stated), 1, 0.15) << iterations;
  }
}

// One game that holds the variance is in no spread.
TEST(FluxBalance, TellsTheErrorOfAFewLargeGames) {
  WorkCounts all;
  for (uint32_t i = 0; i < 16; ++i) {
    WorkCounts w = played(i + 1, 100, 0);
    w.flux.settle(i, 100);
    all.add(w);
  }
  const double before = flux_balance(all, 1).standard_error;
  all.flux.play(1000, 0.5, 2000);
  EXPECT_GT(flux_balance(all, 1).standard_error, 0.9 * 1000 / 1600);
  EXPECT_LT(before, 0.1 * 1000 / 1600);
}

TEST(FluxBalance, TellsUnfairRoulette) {
  for (const double cheat : {-0.02, 0.02}) {
    const FluxBalance b = flux_balance(played(1, 100000, cheat), 1);
    EXPECT_FALSE(b.closes());
    const char* told = cheat > 0 ? "Russian roulette gives" : "Russian roulette takes";
    EXPECT_NE(flux_warning(b, 1).find(told), std::string::npos) << flux_warning(b, 1);
    const std::string of_eyes = importance_warning(importance_balance(played(1, 100000, cheat).flux));
    EXPECT_NE(of_eyes.find(told), std::string::npos) << of_eyes;
  }
}

// As from the sun and from a lamp: which paths there are is chance, what becomes of them is not.
TEST(FluxBalance, TellsWhatUnequalPathsLoseOnTheirWays) {
  for (const double loss : {0.0, 1e-5}) {
    WorkCounts w;
    w.light_paths = 1001;
    w.brightest_lm = 1.9f;
    for (uint64_t i = 0; i < w.light_paths; ++i) {
      const double lm = i % 2 ? 1.9 : 0.1;
      w.flux.start(lm);
      w.flux.absorbed += lm * (1 - loss);
    }
    const FluxBalance b = flux_balance(w, 1);
    EXPECT_EQ(b.closes(), loss == 0) << flux_warning(b, 1);
    EXPECT_EQ(flux_warning(b, 1).find("are neither absorbed nor escape") != std::string::npos, loss > 0);
    const std::string of_eyes = importance_warning(importance_balance(w.flux));
    EXPECT_EQ(of_eyes.find("0.001 % is neither absorbed nor escapes") != std::string::npos, loss > 0) << of_eyes;
  }
}

TEST(FluxBalance, OfAFewPathsIsNoAlarm) {
  for (uint64_t seed = 1; seed <= 2000; ++seed) {
    EXPECT_TRUE(flux_balance(played(seed, 1, 0), 1).closes()) << seed;
    EXPECT_TRUE(flux_balance(played(seed, 7, 0), 1).closes()) << seed;
    EXPECT_TRUE(importance_balance(played(seed, 7, 0).flux).closes()) << seed;
  }
}

}  // namespace
}  // namespace ups
