// The library's threads as guests of a program: how many run, what they are named, which signals they take, what is
// printed; and the host's floating-point environment, which must not reach the results.
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include <cfenv>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "../support/processors.h"
#include "../support/scene_builder.h"

using namespace ups::test;

namespace {

// A rough metal needs tables that are made at first use; a mirror makes photons worth merging.
void furnish(Scene& scene) {
  scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0.5));
  scene.add(box({1, 1, 0}, {2, 2, 0.5}), mirror(0.9));
  scene.add(box({2.5, 2.5, 0}, {3, 3, 1}), rough(UPS_MATERIAL_METAL, 0.8, 0.3));
  scene.add_luminaire(table_profile(scene.context(), 0).get(), {2, 2, 2.9}, {0, 0.1, -1}, false);
}

struct Job {
  ups_job* job = nullptr;
  Job(Scene& scene, uint32_t iterations) {
    EXPECT_EQ(ups_scene_commit(scene.get()), UPS_OK) << ups_last_error();
    auto d = make_desc<ups_render_desc>(ups_render_desc_init);
    d.method = UPS_METHOD_UPS;
    d.iteration_count = iterations;
    d.light_paths_per_iteration = 4096;
    EXPECT_EQ(ups_job_start(scene.get(), &d, &job), UPS_OK) << ups_last_error();
  }
  ~Job() { ups_job_destroy(job); }
};

using Threads = std::set<std::string>;
Threads threads_of_process() {
  Threads out;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) out.insert(entry.path());
  return out;
}

std::string line_of(const std::string& path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
    if (line.rfind(key, 0) == 0) return line.substr(key.size());
  return {};
}

// All that can be blocked, but what a thread raises by its own fault.
uint64_t expected_mask() {
  uint64_t mask = 0;
  for (int s = 1; s < SIGRTMIN; ++s) mask |= uint64_t(1) << (s - 1);
  for (const int s : {SIGKILL, SIGSTOP, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS, 32, 33})
    mask &= ~(uint64_t(1) << (s - 1));
  return mask;
}

TEST(Threads, BearNamesAndTakeNoSignals) {
  std::thread([] {}).join();  // the thread sanitizer starts one of its own beside the first
  const Threads before = threads_of_process();
  Scene scene(2);
  furnish(scene);
  scene.add_meters({{0.5, 0.5, 0.75}}, {0, 0, 1});
  const Job job(scene, 1u << 20);
  std::multiset<std::string> names, expected{"ups/job"};
  if (processors() > 1) expected.insert("ups/worker 1");
  for (int tries = 0; names != expected && tries < 200; ++tries) {  // each names itself, on a busy machine late
    ups_job_wait(job.job, 50);
    names.clear();
    for (const std::string& thread : threads_of_process()) {
      if (before.count(thread)) continue;
      std::string name;
      std::getline(std::ifstream(thread + "/comm") >> std::ws, name);
      names.insert(name);
      const uint64_t blocked = std::stoull(line_of(thread + "/status", "SigBlk:"), nullptr, 16);
      EXPECT_EQ(blocked & expected_mask(), expected_mask()) << name;
    }
  }
  EXPECT_EQ(names, expected) << "these alone are the library's";
  sigset_t mine;
  pthread_sigmask(SIG_BLOCK, nullptr, &mine);
  EXPECT_EQ(sigismember(&mine, SIGUSR1), 0) << "the host's thread keeps its mask";
}

TEST(Threads, NoMoreThanProcessorsAndSilently) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  {
    Scene scene(1024);
    int32_t count = 0;
    EXPECT_EQ(ups_context_get_thread_count(scene.context(), &count), UPS_OK);
    EXPECT_EQ(count, processors());
    char text[200] = "";
    ups_log_level level = -1;
    EXPECT_EQ(ups_context_pop_log(scene.context(), text, sizeof text, nullptr, &level), UPS_OK);
    EXPECT_EQ(level, UPS_LOG_INFO);
    EXPECT_NE(std::strstr(text, "1024"), nullptr) << text;
    EXPECT_NE(std::strstr(text, std::to_string(processors()).c_str()), nullptr) << text;
    furnish(scene);
    scene.add_meters({{0.5, 0.5, 0.75}}, {0, 0, 1});
    const Result result = scene.render({.iterations = 2});
    EXPECT_EQ(result.info().threads, processors());
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// A child of fork() has none of its parent's threads: what it has from there goes with it, and is not waited for.
TEST(Threads, AChildMayDestroyWhatItHasFromItsParent) {
  Scene scene(2);
  furnish(scene);
  scene.add_meters({{0.5, 0.5, 0.75}}, {0, 0, 1});
  Job job(scene, 1u << 20);
  ups_job_wait(job.job, 100);
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);  // or it would wait for ever
    ups_job_destroy(std::exchange(job.job, nullptr));
    ups_scene_destroy(scene.get());
    ups_context_destroy(scene.context());
#ifdef __SANITIZE_THREAD__  // it ends a child of a process with threads that starts some of its own
    _exit(0);
#endif
    Scene own(2);
    furnish(own);
    const Sensor meter = own.add_meters({{0.5, 0.5, 0.75}}, {0, 0, 1});
    _exit(own.render({.iterations = 1}).readings(meter)[0].illuminance_lx > 0 ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(ups_job_wait(job.job, 0), UPS_TIMEOUT) << "the parent's goes on";
}

// ---- the host's floating-point environment ----

// Bits of all readings, and whether the host's environment was left as it was. Made in a process of its own, so that
// tables of the library are made anew.
struct Outcome {
  uint64_t bits = 0;
  int untouched = 0;
};

uint64_t hash(uint64_t h, float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return (h ^ bits) * 0x100000001b3u;
}

Outcome render_under(int threads, const std::function<void()>& set, const std::function<bool()>& is_set) {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    set();
    Scene scene(threads);
    furnish(scene);
    const Sensor places = scene.add_meters({{0.5, 0.5, 0.75}, {3.1, 0.7, 0.75}, {1.7, 3.3, 0.1}}, {0, 0, 1});
    const Sensor camera = scene.add_camera({0.3, 0.3, 2}, {1, 1, -0.7}, 16, 12, 1, true);
    Outcome outcome{0xcbf29ce484222325u, 0};
    {
      const Job job(scene, 4);
      ups_job_wait(job.job, 60000);
      ups_result* result = nullptr;
      if (ups_job_result(job.job, &result) != UPS_OK) _exit(1);
      ups_meter_reading meters[3];
      if (ups_result_read_meters(result, places.id, meters, 3) != UPS_OK) _exit(1);
      for (const ups_meter_reading& m : meters)
        outcome.bits = hash(hash(outcome.bits, m.illuminance_lx), m.error_bound_lx);
      float image[16 * 12 * 3];
      if (ups_result_read_image(result, camera.id, UPS_CHANNEL_LUMINANCE_RGB, image, 0, sizeof image) != UPS_OK)
        _exit(1);
      for (const float v : image) outcome.bits = hash(outcome.bits, v);
      ups_result_destroy(result);
    }
    outcome.untouched = is_set();
    _exit(write(ends[1], &outcome, sizeof outcome) == ssize_t(sizeof outcome) ? 0 : 1);
  }
  close(ends[1]);
  Outcome outcome;
  EXPECT_EQ(read(ends[0], &outcome, sizeof outcome), ssize_t(sizeof outcome)) << "the child failed";
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  return outcome;
}

TEST(FloatingPoint, TheHostsModeChangesNoBit) {
  const Outcome right = render_under(1, [] {}, [] { return std::fegetround() == FE_TONEAREST; });
  EXPECT_TRUE(right.untouched);
  for (const int threads : {1, 2}) {
    for (const int mode : {FE_UPWARD, FE_TOWARDZERO}) {
      const Outcome found =
          render_under(threads, [&] { std::fesetround(mode); }, [&] { return std::fegetround() == mode; });
      EXPECT_EQ(found.bits, right.bits) << "rounding " << mode << ", threads " << threads;
      EXPECT_TRUE(found.untouched);
    }
#if defined(__SSE__)
    constexpr unsigned flush_and_zero = 0x8040;
    const Outcome found = render_under(threads, [&] { _mm_setcsr(_mm_getcsr() | flush_and_zero); },
                                       [&] { return (_mm_getcsr() & flush_and_zero) == flush_and_zero; });
    EXPECT_EQ(found.bits, right.bits) << "flush to zero, threads " << threads;
    EXPECT_TRUE(found.untouched);
#endif
  }
}

}  // namespace
