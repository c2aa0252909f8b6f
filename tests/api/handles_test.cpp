// Handles of a second copy of the library in the same process, as a host and its plug-in may each bring one: this copy
// refuses them in every call, and leaves them as they are.
#include <dlfcn.h>
#include <unistd.h>

#include <filesystem>

#include "fixture.h"

namespace ups_test {
namespace {

// The functions of a copy of the library, loaded from a file of its own.
class SecondCopy {
 public:
  SecondCopy() {
    std::string folder = testing::TempDir() + "ups_second_copy_XXXXXX";
    if (!mkdtemp(folder.data())) return;
    folder_ = folder;
    const std::string file = folder_ + "/copy.so";
    std::filesystem::copy_file(UPS_LIBRARY_FILE, file);
    library_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  ~SecondCopy() {  // not before: reports of sanitizers look up names in the file
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }
  SecondCopy(const SecondCopy&) = delete;
  SecondCopy& operator=(const SecondCopy&) = delete;
  bool is_loaded() const { return library_ != nullptr; }
  template <class Function>
  Function* operator()(Function*, const char* name) const {
    return reinterpret_cast<Function*>(dlsym(library_, name));
  }

 private:
  std::string folder_;
  void* library_ = nullptr;
};
#define OTHER(function) other(&function, #function)

struct Handles : Api {
  Handles() {
    if (!other.is_loaded()) return;
    EXPECT_EQ(OTHER(ups_context_create)(nullptr, &their_context), UPS_OK);
    EXPECT_EQ(OTHER(ups_scene_create)(their_context, &their_scene), UPS_OK);
    EXPECT_EQ(OTHER(ups_fixture_create)(their_context, &their_fixture), UPS_OK);
    const auto d = uniform_profile();
    EXPECT_EQ(OTHER(ups_profile_create)(their_context, &d, &their_profile), UPS_OK);
    const auto meter_desc = meters();
    ups_sensor_id sensor{};
    EXPECT_EQ(OTHER(ups_scene_add_meters)(their_scene, &meter_desc, &sensor), UPS_OK);
    EXPECT_EQ(OTHER(ups_scene_commit)(their_scene), UPS_OK);
    auto r = make(&ups_render_desc_init);
    r.iteration_count = 1;
    EXPECT_EQ(OTHER(ups_job_start)(their_scene, &r, &their_job), UPS_OK);
    EXPECT_EQ(OTHER(ups_job_wait)(their_job, UINT32_MAX), UPS_OK);
    EXPECT_EQ(OTHER(ups_job_result)(their_job, &their_result), UPS_OK);
  }
  ~Handles() override {
    if (!other.is_loaded()) return;
    OTHER(ups_result_destroy)(their_result);
    OTHER(ups_job_destroy)(their_job);
    OTHER(ups_profile_destroy)(their_profile);
    OTHER(ups_fixture_destroy)(their_fixture);
    OTHER(ups_scene_destroy)(their_scene);
    OTHER(ups_context_destroy)(their_context);
  }
  static void expect_refused(ups_status status, const char* argument) {
    expect_error(status, UPS_ERROR_INVALID_ARGUMENT, {argument, "another loaded copy"});
  }

  SecondCopy other;
  ups_context* their_context = nullptr;
  ups_scene* their_scene = nullptr;
  ups_fixture* their_fixture = nullptr;
  ups_profile* their_profile = nullptr;
  ups_job* their_job = nullptr;
  ups_result* their_result = nullptr;
};

TEST_F(Handles, OfAnotherCopyAreRefused) {
  ASSERT_TRUE(other.is_loaded()) << dlerror();
  ASSERT_NE(OTHER(ups_scene_create), &ups_scene_create) << "the loader took both for one library";
  ups_scene* s = nullptr;
  ups_fixture* f = nullptr;
  ups_profile* p = nullptr;
  ups_job* j = nullptr;
  ups_result* r = nullptr;
  int32_t threads = 0;
  size_t needed = 0;
  expect_refused(ups_scene_create(their_context, &s), "context");
  expect_refused(ups_fixture_create(their_context, &f), "context");
  const auto table = uniform_profile();
  expect_refused(ups_profile_create(their_context, &table, &p), "context");
  expect_refused(ups_profile_parse(their_context, "a", 1, UPS_PROFILE_AUTO, &p), "context");
  expect_refused(ups_context_get_thread_count(their_context, &threads), "context");
  expect_refused(ups_context_pop_log(their_context, nullptr, 0, &needed, nullptr), "context");

  const auto m = make(&ups_material_desc_init);
  ups_material_id id{};
  const auto meter_desc = meters();
  ups_sensor_id sensor_id{};
  const auto render = make(&ups_render_desc_init);
  expect_refused(ups_scene_add_material(their_scene, &m, &id), "scene");
  expect_refused(ups_scene_add_meters(their_scene, &meter_desc, &sensor_id), "scene");
  expect_refused(ups_scene_set_dimming(their_scene, {1}, 1), "scene");
  expect_refused(ups_scene_set_fixture_dimming(their_scene, {1}, 1), "scene");
  expect_refused(ups_scene_commit(their_scene), "scene");
  expect_refused(ups_scene_get_text(their_scene, UPS_SCENE_TEXT_WARNINGS, nullptr, 0, &needed), "scene");
  expect_refused(ups_job_start(their_scene, &render, &j), "scene");
  expect_refused(ups_render(their_scene, &render, &r), "scene");

  auto l = make(&ups_luminaire_desc_init);
  l.profile = their_profile;
  ups_luminaire_id luminaire_id{};
  const auto placement = make(&ups_fixture_instance_desc_init);
  ups_fixture_id fixture_id{};
  auto emitter = make(&ups_fixture_emitter_desc_init);
  emitter.radius_m = 0.01;
  expect_refused(ups_scene_add_luminaire(scene, &l, &luminaire_id), "profile");
  expect_refused(ups_scene_add_fixture(scene, their_fixture, &placement, &fixture_id), "fixture");
  expect_refused(ups_fixture_add_emitter(their_fixture, &emitter, nullptr), "fixture");
  expect_refused(ups_profile_write(their_profile, UPS_PROFILE_IES_LM63, nullptr, 0, &needed), "profile");

  ups_progress progress{};
  progress.struct_size = sizeof progress;
  ups_result_info info{};
  info.struct_size = sizeof info;
  expect_refused(ups_job_poll(their_job, &progress), "job");
  expect_refused(ups_job_wait(their_job, 0), "job");
  expect_refused(ups_job_result(their_job, &r), "job");
  expect_refused(ups_result_get_info(their_result, &info), "result");
  expect_refused(ups_result_get_text(their_result, UPS_TEXT_WARNINGS, nullptr, 0, &needed), "result");
  EXPECT_EQ(OTHER(ups_scene_commit)(scene), UPS_ERROR_INVALID_ARGUMENT) << "the other way round";
}

// Functions that return nothing: were the handles destroyed, the destructor of the test would do it again.
TEST_F(Handles, OfAnotherCopyAreLeftAlone) {
  ASSERT_TRUE(other.is_loaded()) << dlerror();
  ups_job_cancel(their_job);
  ups_result_destroy(their_result);
  ups_job_destroy(their_job);
  ups_profile_destroy(their_profile);
  ups_fixture_destroy(their_fixture);
  ups_scene_destroy(their_scene);
  ups_context_destroy(their_context);
  ups_result_info info{};
  info.struct_size = sizeof info;
  EXPECT_EQ(OTHER(ups_result_get_info)(their_result, &info), UPS_OK);
  EXPECT_EQ(info.iterations, 1u);
  EXPECT_EQ(OTHER(ups_scene_commit)(their_scene), UPS_OK);
}

TEST_F(Handles, OfAnotherKindAreRefused) {
  expect_error(ups_scene_commit(reinterpret_cast<ups_scene*>(context)), UPS_ERROR_INVALID_ARGUMENT, {"scene"});
  ups_scene* s = nullptr;
  expect_error(ups_scene_create(reinterpret_cast<ups_context*>(profile), &s), UPS_ERROR_INVALID_ARGUMENT, {"context"});
  EXPECT_EQ(s, nullptr);
}

}  // namespace
}  // namespace ups_test
