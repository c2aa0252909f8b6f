// Commits build what changed, to the same bits as a commit of the whole; they run as jobs; renders say what they are of.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <thread>

#include "../support/processors.h"
#include "edited_room.h"

using namespace ups_test;

namespace {

class Commit : public testing::Test {
 protected:
  Commit() {
    auto d = make(&ups_context_desc_init);
    d.thread_count = 2;
    EXPECT_OK(ups_context_create(&d, &context));
  }
  ~Commit() override { ups_context_destroy(context); }
  ups_context* context = nullptr;
};

// Of this process.
struct Threads {
  int all, of_nice_19;
};
Threads threads() {
  Threads out{0, 0};
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream stat(task.path() / "stat");
    std::string text;
    if (!std::getline(stat, text)) continue;  // it has just ended
    std::istringstream fields(text.substr(text.rfind(')') + 2));
    std::string field;
    for (int i = 3; i <= 19; ++i) fields >> field;  // the 19th is the nice value
    ++out.all, out.of_nice_19 += field == "19";
  }
  return out;
}
// Those that last: one that has ended stays listed for a moment after it was joined, on a busy machine for longer.
int lasting_threads() {
  int least = threads().all;
  for (int i = 0; i < 20; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    least = std::min(least, threads().all);
  }
  return least;
}

struct Edit {
  const char* name;
  std::function<void(EditedRoom&)> make;
};

void set_transform(EditedRoom& r, ups_instance_id id, double x, double y, double z, double angle) {
  ups_instance_desc d{};
  place(d, x, y, z, angle);
  EXPECT_OK(ups_scene_set_transform(r.scene, id, d.to_world));
}
template <class Change>
void change_material(EditedRoom& r, ups_material_id id, const Change& change) {
  auto d = sized<ups_material_desc>();
  EXPECT_OK(ups_scene_get_material(r.scene, id, &d));
  change(d);
  EXPECT_OK(ups_scene_set_material(r.scene, id, &d));
}
template <class Change>
void change_luminaire(EditedRoom& r, const Change& change) {
  auto d = sized<ups_luminaire_desc>();
  EXPECT_OK(ups_scene_get_luminaire(r.scene, r.opening, &d));
  change(d);
  EXPECT_OK(ups_scene_set_luminaire(r.scene, r.opening, &d));
}

// Every kind of edit that light or sensors feel. None needs another to have been made.
const std::vector<Edit>& edits() {
  static const std::vector<Edit> all = {
      {"dimmed", [](EditedRoom& r) { EXPECT_OK(ups_scene_set_dimming(r.scene, r.opening, 0.37f)); }},
      {"out", [](EditedRoom& r) { EXPECT_OK(ups_scene_set_dimming(r.scene, r.point, 0)); }},
      {"on again", [](EditedRoom& r) { EXPECT_OK(ups_scene_set_dimming(r.scene, r.point, 1.1f)); }},
      {"flux and colour", [](EditedRoom& r) {
         change_luminaire(r, [](auto& d) { d.flux_lm = 1234, d.color_rgb[0] = 2; });
       }},
      {"a luminaire from a point", [](EditedRoom& r) { change_luminaire(r, [](auto& d) { d.use_opening = 0; }); }},
      {"a luminaire aimed", [](EditedRoom& r) {
         ups_luminaire_desc d{};
         place(d, 2.2, 1.9, 3.4, 0.4);
         EXPECT_OK(ups_scene_set_luminaire_transform(r.scene, r.opening, d.to_world));
       }},
      {"a light", [](EditedRoom& r) {
         auto d = sized<ups_light_desc>();
         EXPECT_OK(ups_scene_get_light(r.scene, r.spot, &d));
         d.intensity_rgb[2] = 90, d.outer_cone_rad = 0.6f;
         EXPECT_OK(ups_scene_set_light(r.scene, r.spot, &d));
       }},
      {"maintenance", [](EditedRoom& r) { EXPECT_OK(ups_scene_set_maintenance_factor(r.scene, 0.8)); }},
      {"an instance moved", [](EditedRoom& r) { set_transform(r, r.first, 1.4, 1.2, 0.33, 0.3); }},
      {"the mirror moved", [](EditedRoom& r) { set_transform(r, r.glossy, 1.9, 2.8, 0.7, -0.2); }},
      {"an emitting surface moved", [](EditedRoom& r) { set_transform(r, r.panel, 0.6, 0.7, 2.2, 0); }},
      {"an instance far off", [](EditedRoom& r) { set_transform(r, r.second, 60, 1, 0.31, 0); }},
      {"and back", [](EditedRoom& r) { set_transform(r, r.second, 3, 1.1, 0.31, 0); }},
      {"another mesh of an instance", [](EditedRoom& r) {
         auto d = sized<ups_instance_desc>();
         EXPECT_OK(ups_scene_get_instance(r.scene, r.second, &d));
         d.mesh = r.plate;
         EXPECT_OK(ups_scene_set_instance(r.scene, r.second, &d));
       }},
      {"vertices", [](EditedRoom& r) {
         const float p[12] = {0, 0, 0, 0.9f, 0, 0.1f, 0, 0.7f, 0.05f, 0.9f, 0.8f, 0};
         EXPECT_OK(ups_scene_set_mesh_vertices(r.scene, r.plate, p, nullptr, 4));
       }},
      {"a mesh of a shared instance", [](EditedRoom& r) {
         auto d = sized<ups_mesh_desc>();
         EXPECT_OK(ups_scene_get_mesh(r.scene, r.box, &d));
         std::vector<float> p(d.positions_m, d.positions_m + 24);
         p[2] -= 0.005f;
         d.positions_m = p.data();
         EXPECT_OK(ups_scene_set_mesh(r.scene, r.box, &d));
       }},
      {"a reflectance", [](EditedRoom& r) { change_material(r, r.wall, [](auto& d) { d.reflectance_rgb[2] = 0.7f; }); }},
      {"a luminance", [](EditedRoom& r) { change_material(r, r.lamp, [](auto& d) { d.luminance_cd_m2[0] = 111; }); }},
      {"a surface begins to emit", [](EditedRoom& r) {
         change_material(r, r.mirror, [](auto& d) { d.luminance_cd_m2[1] = 50; });
       }},
      {"and ends", [](EditedRoom& r) { change_material(r, r.mirror, [](auto& d) { d.luminance_cd_m2[1] = 0; }); }},
      {"holes", [](EditedRoom& r) {
         change_material(r, r.mirror, [&](auto& d) { d.alpha_mode = UPS_ALPHA_MASK, d.alpha_texture = r.texture; });
       }},
      {"other holes", [](EditedRoom& r) {
         const float texels[4] = {1, 0, 0.25f, 1};
         auto d = sized<ups_texture_desc>();
         EXPECT_OK(ups_scene_get_texture(r.scene, r.texture, &d));
         d.texels = texels;
         EXPECT_OK(ups_scene_set_texture(r.scene, r.texture, &d));
       }},
      {"glass", [](EditedRoom& r) { change_material(r, r.red, [](auto& d) { d.model = UPS_MATERIAL_GLASS; }); }},
      {"matte", [](EditedRoom& r) { change_material(r, r.red, [](auto& d) { d.model = UPS_MATERIAL_MATTE; }); }},
      {"a pane", [](EditedRoom& r) { change_material(r, r.mirror, [](auto& d) { d.model = UPS_MATERIAL_GLAZING; }); }},
      {"the camera", [](EditedRoom& r) {
         auto d = sized<ups_camera_desc>();
         EXPECT_OK(ups_scene_get_camera(r.scene, r.camera, &d));
         d.to_world[3] = 1.7, d.vertical_fov_rad = 1.2f;
         EXPECT_OK(ups_scene_set_camera(r.scene, r.camera, &d));
       }},
      {"meters", [](EditedRoom& r) {
         auto d = sized<ups_meter_desc>();
         EXPECT_OK(ups_scene_get_meters(r.scene, r.meters, &d));
         std::vector<double> p(d.positions_m, d.positions_m + 6);
         p[0] = 1.3;
         d.positions_m = p.data();
         EXPECT_OK(ups_scene_set_meters(r.scene, r.meters, &d));
       }},
      {"surface meters", [](EditedRoom& r) {
         auto d = sized<ups_surface_meters_desc>();
         EXPECT_OK(ups_scene_get_surface_meters(r.scene, r.surface, &d));
         d.back = 1;
         EXPECT_OK(ups_scene_set_surface_meters(r.scene, r.surface, &d));
       }},
      {"an instance more", [](EditedRoom& r) { r.add_instance(r.plate, 1, 2, 1); }},
      {"a light less", [](EditedRoom& r) {
         if (r.sun.v) EXPECT_OK(ups_scene_remove_luminaire(r.scene, r.sun));
         r.sun = {};
       }},
      {"an instance less", [](EditedRoom& r) {
         if (r.glossy.v) EXPECT_OK(ups_scene_remove_instance(r.scene, r.glossy));
         r.glossy = {};
       }},
  };
  return all;
}

std::string texts(const EditedRoom& r) {
  std::string all;
  for (const ups_scene_text topic : {UPS_SCENE_TEXT_WARNINGS, UPS_SCENE_TEXT_EFFECTS, UPS_SCENE_TEXT_TECHNIQUES}) {
    size_t needed = 0;
    EXPECT_OK(ups_scene_get_text(r.scene, topic, nullptr, 0, &needed));
    std::string text(needed, '\0');
    EXPECT_OK(ups_scene_get_text(r.scene, topic, text.data(), text.size(), nullptr));
    all += text;
  }
  return all;
}

}  // namespace

TEST_F(Commit, EachEditGivesTheBitsOfAFullBuild) {
  EditedRoom edited(context);
  EXPECT_OK(ups_scene_commit(edited.scene));
  Readings before = edited.render();
  for (size_t i = 0; i < edits().size(); ++i) {
    SCOPED_TRACE(edits()[i].name);
    edits()[i].make(edited);
    EXPECT_OK(ups_scene_commit(edited.scene));
    EditedRoom whole(context);
    for (size_t k = 0; k <= i; ++k) edits()[k].make(whole);
    EXPECT_OK(ups_scene_commit(whole.scene));
    const Readings now = edited.render();
    EXPECT_TRUE(now == whole.render());
    EXPECT_FALSE(now == before) << "the edit is not felt";
    EXPECT_EQ(texts(edited), texts(whole));
    before = now;
  }
}

// Above 98,304 triangles large meshes have an index each, and small ones are indexed in groups.
TEST_F(Commit, EditsOfALargeSceneGiveTheBitsOfAFullBuild) {
  const auto furnish = [](EditedRoom& r, uint32_t side, int sheets) {  // what is moved, the large one first
    std::vector<ups_instance_id> moved{r.add_instance(r.add_sheet(r.wall, side, 3.9f), 0.05, 0.05, 0.005)};
    for (int i = 0; i < 70; ++i) r.add_instance(r.add_box(r.red, 0, 0.05f), 0.1 + 0.05 * i, 3.5, 0.1 + 0.02 * i);
    for (int i = 0; i < sheets; ++i)
      moved.push_back(r.add_instance(r.add_sheet(r.wall, 60, 0.5f), 0.3 * (i % 9), 0.3 * (i / 9), 0.4 + 0.02 * i));
    return moved;
  };
  uint32_t state = 5;
  const auto random = [&](double below) { return below * double((state = state * 1664525u + 1013904223u) >> 8) / 0x1p24; };
  const std::pair<uint32_t, int> sizes[] = {{380, 0}, {100, 20}, {100, 30}};  // 20 sheets: 144,000 triangles
  for (const auto& [side, sheets] : sizes) {
    SCOPED_TRACE(side + uint32_t(sheets));
    EditedRoom edited(context), whole(context);
    const auto moved = furnish(edited, side, sheets), moved_in_whole = furnish(whole, side, sheets);
    EXPECT_OK(ups_scene_commit(edited.scene));
    for (const Edit& edit : edits()) {
      edit.make(edited), edit.make(whole);
      const size_t k = size_t(random(double(moved.size())));
      const double x = random(2), y = random(2), z = 0.1 + random(2), angle = random(1);
      set_transform(edited, moved[k], x, y, z, angle), set_transform(whole, moved_in_whole[k], x, y, z, angle);
      EXPECT_OK(ups_scene_commit(edited.scene));
    }
    EXPECT_OK(ups_scene_commit(whole.scene));
    EXPECT_TRUE(edited.render() == whole.render());
    for (const int32_t count : {1, 3}) {
      auto d = make(&ups_context_desc_init);
      d.thread_count = count;
      ups_context* other = nullptr;
      EXPECT_OK(ups_context_create(&d, &other));
      {
        EditedRoom copy(edited, EditedRoom::Copied{}, other);
        EXPECT_OK(ups_scene_commit(copy.scene));
        EXPECT_TRUE(edited.render() == copy.render()) << count;
      }
      ups_context_destroy(other);
    }
  }
}

TEST_F(Commit, RandomEditsGiveTheSceneThatIsBuiltAnew) {
  uint32_t state = 17;
  const auto random = [&](size_t below) { return size_t((state = state * 1664525u + 1013904223u) >> 8) % below; };
  EditedRoom edited(context), whole(context);
  for (int i = 0; i < 150; ++i) {
    const Edit& edit = edits()[random(edits().size())];
    const bool needs_mirror = std::string(edit.name) == "the mirror moved";
    if (needs_mirror && !edited.glossy.v) continue;
    edit.make(edited), edit.make(whole);
    if (random(3) == 0) EXPECT_OK(ups_scene_commit(edited.scene));
  }
  EXPECT_OK(ups_scene_commit(edited.scene));
  EXPECT_OK(ups_scene_commit(whole.scene));
  EXPECT_TRUE(edited.render() == whole.render());
  EXPECT_EQ(texts(edited), texts(whole));
  EditedRoom copy(edited, EditedRoom::Copied{});
  EXPECT_OK(ups_scene_commit(copy.scene));
  EXPECT_TRUE(edited.render() == copy.render());
}

TEST_F(Commit, IsDirtyUntilCommitted) {
  EditedRoom r(context);
  int32_t dirty = -1;
  EXPECT_OK(ups_scene_is_dirty(r.scene, &dirty));
  EXPECT_EQ(dirty, 1);
  EXPECT_OK(ups_scene_commit(r.scene));
  EXPECT_OK(ups_scene_is_dirty(r.scene, &dirty));
  EXPECT_EQ(dirty, 0);
  for (const Edit& edit : edits()) {
    edit.make(r);
    EXPECT_OK(ups_scene_is_dirty(r.scene, &dirty));
    EXPECT_EQ(dirty, 1) << edit.name;
    EXPECT_OK(ups_scene_commit(r.scene));
  }
  EXPECT_EQ(ups_scene_set_dimming(r.scene, r.opening, -1), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_OK(ups_scene_is_dirty(r.scene, &dirty));
  EXPECT_EQ(dirty, 0) << "what failed is no edit";
  expect_error(ups_scene_is_dirty(r.scene, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"out"});
}

TEST_F(Commit, ARenderSaysThatEditsAreMissing) {
  EditedRoom r(context);
  EXPECT_OK(ups_scene_commit(r.scene));
  const Readings committed = r.render();
  EXPECT_OK(ups_scene_set_dimming(r.scene, r.opening, 0.1f));
  auto d = make(&ups_render_desc_init);
  d.iteration_count = 1;
  for (const bool dirty : {true, false}) {
    ups_result* result = nullptr;
    EXPECT_OK(ups_render(r.scene, &d, &result));
    char text[4000] = "";
    EXPECT_OK(ups_result_get_text(result, UPS_TEXT_WARNINGS, text, sizeof text, nullptr));
    EXPECT_EQ(std::string(text).find("not committed") != std::string::npos, dirty);
    ups_result_destroy(result);
    if (dirty) EXPECT_TRUE(r.render() == committed);
    EXPECT_OK(ups_scene_commit(r.scene));
  }
}

TEST_F(Commit, AFailedCommitLeavesTheOneBefore) {
  EditedRoom r(context);
  EXPECT_OK(ups_scene_commit(r.scene));
  const Readings before = r.render();
  EXPECT_OK(ups_scene_remove_instance(r.scene, r.first));  // which is measured
  expect_error(ups_scene_commit(r.scene), UPS_ERROR_INVALID_ARGUMENT, {"instance 2", "removed"});
  EXPECT_TRUE(r.render() == before);
  int32_t dirty = 0;
  EXPECT_OK(ups_scene_is_dirty(r.scene, &dirty));
  EXPECT_EQ(dirty, 1);
  EXPECT_OK(ups_scene_remove_sensor(r.scene, r.surface));
  EXPECT_OK(ups_scene_commit(r.scene));
}

TEST_F(Commit, RunsAsAJob) {
  EditedRoom r(context), whole(context);
  ups_job* job = nullptr;
  EXPECT_OK(ups_scene_start_commit(r.scene, &job));
  while (ups_job_wait(job, 1000) == UPS_TIMEOUT) {}
  EXPECT_OK(ups_job_wait(job, 0));
  auto progress = sized<ups_progress>();
  EXPECT_OK(ups_job_poll(job, &progress));
  EXPECT_EQ(progress.state, UPS_JOB_FINISHED);
  EXPECT_EQ(progress.fraction, 1);
  EXPECT_EQ(progress.iterations_done, 0u);
  ups_result* result = nullptr;
  expect_error(ups_job_result(job, &result), UPS_ERROR_INVALID_STATE, {"commit"});
  uint32_t count;
  expect_error(ups_job_get_curve_count(job, &count), UPS_ERROR_INVALID_STATE, {"commit"});
  ups_job_destroy(job);
  EXPECT_OK(ups_scene_commit(whole.scene));
  EXPECT_TRUE(r.render() == whole.render());
}

TEST_F(Commit, AJobCommitsWhatWasThereAtItsStart) {
  EditedRoom r(context), whole(context);
  EXPECT_OK(ups_scene_commit(whole.scene));
  ups_job* job = nullptr;
  EXPECT_OK(ups_scene_start_commit(r.scene, &job));
  for (const Edit& edit : edits()) edit.make(r);
  while (ups_job_wait(job, 1000) == UPS_TIMEOUT) {}
  EXPECT_OK(ups_job_wait(job, 0));
  ups_job_destroy(job);
  int32_t dirty = 0;
  EXPECT_OK(ups_scene_is_dirty(r.scene, &dirty));
  EXPECT_EQ(dirty, 1);
  EXPECT_TRUE(r.render() == whole.render());
}

TEST_F(Commit, AJobIsCancelledAndTheSceneStays) {
  EditedRoom r(context);
  EXPECT_OK(ups_scene_commit(r.scene));
  const Readings before = r.render();
  const ups_mesh_id mesh = r.add_sheet(r.wall, 700, 3.9f);  // about a second's work
  r.add_instance(mesh, 0.05, 0.05, 0.02);
  ups_job* job = nullptr;
  EXPECT_OK(ups_scene_start_commit(r.scene, &job));
  ups_job* second = nullptr;
  expect_error(ups_scene_start_commit(r.scene, &second), UPS_ERROR_INVALID_STATE, {"another commit"});
  expect_error(ups_scene_commit(r.scene), UPS_ERROR_INVALID_STATE, {"another commit"});
  ups_job_cancel(job);
  while (ups_job_wait(job, 1000) == UPS_TIMEOUT) {}
  EXPECT_EQ(ups_job_wait(job, 0), UPS_CANCELLED);
  ups_job_destroy(job);
  EXPECT_TRUE(r.render() == before);
  EXPECT_OK(ups_scene_commit(r.scene));
  EXPECT_FALSE(r.render() == before);
}

// At twenty moments, most of them within Embree's build of a large mesh.
TEST_F(Commit, CancelledCommitsLeaveNothingBehind) {
  constexpr uint32_t side = 380, vertices = (side + 1) * (side + 1);
  EditedRoom edited(context), whole(context);
  const ups_mesh_id sheet = edited.add_sheet(edited.wall, side, 3.9f), in_whole = whole.add_sheet(whole.wall, side, 3.9f);
  edited.add_instance(sheet, 0.05, 0.05, 0.02), whole.add_instance(in_whole, 0.05, 0.05, 0.02);
  EXPECT_OK(ups_scene_commit(edited.scene));
  auto d = sized<ups_mesh_desc>();
  EXPECT_OK(ups_scene_get_mesh(edited.scene, sheet, &d));
  std::vector<float> p(d.positions_m, d.positions_m + 3 * vertices);
  int cancelled = 0;
  for (uint32_t round = 0; round < 20; ++round) {
    for (uint32_t i = 0; i < vertices; ++i) p[3 * i + 2] = 0.001f * float(i * (round + 3) % 17);
    EXPECT_OK(ups_scene_set_mesh_vertices(edited.scene, sheet, p.data(), nullptr, vertices));
    ups_job* job = nullptr;
    EXPECT_OK(ups_scene_start_commit(edited.scene, &job));
    ups_job_wait(job, 3 * round);
    ups_job_cancel(job);
    ups_status status;
    while ((status = ups_job_wait(job, 1000)) == UPS_TIMEOUT) {}
    EXPECT_TRUE(status == UPS_CANCELLED || status == UPS_OK) << status;
    cancelled += status == UPS_CANCELLED;
    ups_job_destroy(job);
  }
  EXPECT_GT(cancelled, 0);
  EXPECT_OK(ups_scene_set_mesh_vertices(whole.scene, in_whole, p.data(), nullptr, vertices));
  EXPECT_OK(ups_scene_commit(whole.scene));
  EXPECT_OK(ups_scene_commit(edited.scene));
  EXPECT_TRUE(edited.render() == whole.render());
}

TEST_F(Commit, AJobHasFewerThreadsAndALowPriority) {
  EditedRoom r(context);
  EXPECT_OK(ups_scene_commit(r.scene));
  auto d = make(&ups_render_desc_init);
  d.method = UPS_METHOD_UPS, d.iteration_count = 2, d.seed = 7, d.light_paths_per_iteration = 256;
  const auto run = [&](int32_t threads) {
    ups_result* result = nullptr;
    EXPECT_OK(ups_render(r.scene, &d, &result));
    auto info = sized<ups_result_info>();
    EXPECT_OK(ups_result_get_info(result, &info));
    EXPECT_EQ(info.threads, threads);
    std::vector<ups_meter_reading> readings(2);
    EXPECT_OK(ups_result_read_meters(result, r.meters, readings.data(), 2));
    ups_result_destroy(result);
    return readings;
  };
  const int both = std::min(2, ups::test::processors());  // the context wants 2
  const auto all = run(both);
  d.thread_limit = 1;
  const auto one = run(1);
  d.thread_limit = 0, d.priority = UPS_PRIORITY_LOW;
  const auto low = run(both);
  for (const auto& other : {one, low}) EXPECT_EQ(std::memcmp(all.data(), other.data(), 2 * sizeof all[0]), 0);
  d.priority = 2;
  ups_result* result = nullptr;
  expect_error(ups_render(r.scene, &d, &result), UPS_ERROR_INVALID_ARGUMENT, {"priority"});
}

// By what Linux says of the job's threads.
TEST_F(Commit, ALowPriorityIsTheOperatingSystems) {
  EditedRoom r(context);
  EXPECT_OK(ups_scene_commit(r.scene));
  auto d = make(&ups_render_desc_init);
  d.method = UPS_METHOD_UPS, d.time_limit_s = 1000, d.priority = UPS_PRIORITY_LOW;
  ups_job* job = nullptr;
  EXPECT_OK(ups_job_start(r.scene, &d, &job));
  auto progress = sized<ups_progress>();
  while (progress.iterations_done == 0 && ups_job_wait(job, 5) == UPS_TIMEOUT) EXPECT_OK(ups_job_poll(job, &progress));
  EXPECT_EQ(threads().of_nice_19, std::min(2, ups::test::processors())) << "the job's thread and its one worker";
  ups_job_cancel(job);
  ups_job_destroy(job);
}

// A limit of one thread: the job's own, and none beside it that the context has not.
TEST_F(Commit, ACommitsJobHasFewerThreadsAndALowPriority) {
  EditedRoom whole(context);
  whole.add_instance(whole.add_sheet(whole.wall, 500, 3.9f), 0.05, 0.05, 0.02);
  EXPECT_OK(ups_scene_commit(whole.scene));
  const int before = lasting_threads();
  for (const uint32_t limit : {0u, 1u, 7u})
    for (const ups_priority priority : {UPS_PRIORITY_NORMAL, UPS_PRIORITY_LOW}) {
      EditedRoom r(context);
      r.add_instance(r.add_sheet(r.wall, 500, 3.9f), 0.05, 0.05, 0.02);  // half a second's work
      auto d = make(&ups_commit_desc_init);
      d.thread_limit = limit, d.priority = priority;
      ups_job* job = nullptr;
      for (int tries = 0; threads().all > before && tries < 5000; ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      EXPECT_OK(ups_scene_start_commit_with(r.scene, &d, &job));
      Threads most{0, 0};
      while (ups_job_wait(job, 5) == UPS_TIMEOUT) {
        const Threads now = threads();
        most = {std::max(most.all, now.all), std::max(most.of_nice_19, now.of_nice_19)};
      }
      EXPECT_OK(ups_job_wait(job, 0));
      ups_job_destroy(job);
      const int own = limit == 1 ? 1 : std::min(2, ups::test::processors());  // of the context's 2 at most
      const bool apart = priority == UPS_PRIORITY_LOW || limit == 1;
      EXPECT_EQ(most.all - before, apart ? own : 1) << limit << " " << priority;
      EXPECT_EQ(most.of_nice_19, priority == UPS_PRIORITY_LOW ? own : 0) << limit << " " << priority;
      EXPECT_TRUE(r.render() == whole.render());
    }
  auto d = make(&ups_commit_desc_init);
  d.priority = 2;
  ups_job* job = nullptr;
  expect_error(ups_scene_start_commit_with(whole.scene, &d, &job), UPS_ERROR_INVALID_ARGUMENT, {"priority"});
  expect_error(ups_scene_start_commit_with(whole.scene, nullptr, &job), UPS_ERROR_INVALID_ARGUMENT, {"desc"});
  EXPECT_EQ(job, nullptr);
}

// A limit is a status: the scene is what it was, and the next commit without it makes what it makes of a new scene.
TEST_F(Commit, WantsNoMoreMemoryThanItIsAllowed) {
  EditedRoom whole(context), r(context);
  EXPECT_OK(ups_scene_commit(r.scene));
  const Readings before = r.render();
  for (EditedRoom* room : {&whole, &r}) room->add_instance(room->add_sheet(room->wall, 500, 3.9f), 0.05, 0.05, 0.02);
  EXPECT_OK(ups_scene_commit(whole.scene));
  auto d = make(&ups_commit_desc_init);
  EXPECT_EQ(d.memory_limit_bytes, 0u);
  for (const uint64_t megabytes : {1, 8, 1000}) {
    d.memory_limit_bytes = megabytes << 20;
    ups_job* job = nullptr;
    EXPECT_OK(ups_scene_start_commit_with(r.scene, &d, &job));
    while (ups_job_wait(job, 1000) == UPS_TIMEOUT) {}
    const ups_status status = ups_job_wait(job, 0);
    if (megabytes < 1000)
      expect_error(status, UPS_ERROR_OUT_OF_MEMORY, {"memory_limit_bytes", "triangles"});
    else
      EXPECT_OK(status);
    ups_job_destroy(job);
    EXPECT_TRUE(r.render() == (megabytes < 1000 ? before : whole.render())) << megabytes;
  }
  // What is refused now is a part that two builds would share; a smaller one than that has room.
  const ups_instance_id more = r.add_instance(r.add_sheet(r.wall, 500, 3.9f), 0.05, 0.05, 0.03);
  d.memory_limit_bytes = 8 << 20;
  ups_job* job = nullptr;
  EXPECT_OK(ups_scene_start_commit_with(r.scene, &d, &job));
  while (ups_job_wait(job, 1000) == UPS_TIMEOUT) {}
  expect_error(ups_job_wait(job, 0), UPS_ERROR_OUT_OF_MEMORY, {"memory_limit_bytes (8389 kB)"});
  ups_job_destroy(job);
  EXPECT_TRUE(r.render() == whole.render());
  EXPECT_OK(ups_scene_remove_instance(r.scene, more));
  r.add_instance(r.add_sheet(r.wall, 4, 0.2f), 0.05, 0.05, 0.03);
  EXPECT_OK(ups_scene_start_commit_with(r.scene, &d, &job));
  while (ups_job_wait(job, 1000) == UPS_TIMEOUT) {}
  EXPECT_OK(ups_job_wait(job, 0));
  ups_job_destroy(job);

  d.reserved = 1;
  expect_error(ups_scene_start_commit_with(r.scene, &d, &job), UPS_ERROR_INVALID_ARGUMENT, {"reserved is 1"});
}

TEST_F(Commit, GoesOnBesideRendersOfTheSameScene) {
  EditedRoom r(context);
  EXPECT_OK(ups_scene_commit(r.scene));
  const Readings before = r.render();
  auto d = make(&ups_render_desc_init);
  d.method = UPS_METHOD_UPS, d.iteration_count = 2, d.seed = 7, d.light_paths_per_iteration = 256;
  for (const Edit& edit : edits()) {
    ups_job* job = nullptr;
    EXPECT_OK(ups_job_start(r.scene, &d, &job));
    edit.make(r);
    EXPECT_OK(ups_scene_commit(r.scene));
    ups_job_cancel(job);
    ups_job_destroy(job);
  }
  // Two renders at once find what each finds alone.
  const Readings alone = r.render();
  Readings together[2];
  std::thread other([&] { together[0] = r.render(); });
  together[1] = r.render();
  other.join();
  EXPECT_TRUE(together[0] == alone && together[1] == alone);
  EXPECT_FALSE(alone == before);
}
