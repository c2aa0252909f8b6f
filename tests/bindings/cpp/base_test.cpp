// Errors, spans, handles and the context of ups.hpp.
#include <array>
#include <memory>
#include <type_traits>

#include "room.h"

namespace {

TEST(Errors, HaveStatusNameAndMessage) {
  Room room;
  try {
    room.scene.set_dimming(room.lamp, -1);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error &error) {  // as other libraries' errors are caught
    EXPECT_EQ(error.what(), std::string("UPS_ERROR_INVALID_ARGUMENT: ") + ups_last_error());
    EXPECT_EQ(dynamic_cast<const ups::Error &>(error).status(), UPS_ERROR_INVALID_ARGUMENT);
  }
  expect_error(UPS_ERROR_INVALID_STATE, {"commit"}, [&] { room.scene.render(Room::few()); });
  expect_error(UPS_ERROR_PARSE, {}, [&] { ups::Profile::parse(room.context, std::string("IESNA:LM-63-2002\n")); });
}

TEST(Errors, AnswersAreNotThrown) {
  EXPECT_EQ(ups::check(UPS_OK), UPS_OK);
  EXPECT_EQ(ups::check(UPS_TIMEOUT), UPS_TIMEOUT);
  EXPECT_EQ(ups::check(UPS_CANCELLED), UPS_CANCELLED);
  EXPECT_THROW(ups::check(UPS_ERROR_IO), ups::Error);
}

TEST(Spans, AreOfWhatHasDataAndASize) {
  std::vector<float> vector = {1, 2};
  const std::array<float, 3> array = {1, 2, 3};
  float plain[] = {1, 2, 3, 4};
  const auto size = [](ups::Span<const float> span) { return span.size(); };
  EXPECT_EQ(size(vector), 2u);
  EXPECT_EQ(size(array), 3u);
  EXPECT_EQ(size(plain), 4u);
  EXPECT_EQ(size({plain, 1}), 1u);
  EXPECT_EQ(size(std::vector<float>(5)), 5u) << "to read from, while the call lasts";
  ups::Span<float> to_write(vector);
  to_write[1] = 7;
  EXPECT_EQ(vector[1], 7);
  float sum = 0;
  for (const float value : ups::Span<const float>(to_write)) sum += value;
  EXPECT_EQ(sum, 8);
  vector.clear();
  EXPECT_EQ(ups::Span<const float>(vector).data(), nullptr);
  EXPECT_TRUE(ups::Span<const float>().empty());
}

TEST(Spans, KeepTypeConstAndLifetime) {
  using ups::Span;
  static_assert(!std::is_convertible_v<const std::vector<float> &, Span<float>>, "const is kept");
  static_assert(!std::is_convertible_v<std::vector<double> &, Span<const float>>, "so is the type");
  static_assert(!std::is_convertible_v<std::vector<float>, Span<float>>, "nothing is written to temporaries");
  static_assert(std::is_convertible_v<std::vector<float> &, Span<float>>);
  static_assert(std::is_convertible_v<Span<float>, Span<const float>>);
  static_assert(!std::is_convertible_v<Span<const float>, Span<float>>);
}

template <class T>
constexpr bool moves_alone = !std::is_copy_constructible_v<T> && !std::is_copy_assignable_v<T> &&
                             std::is_nothrow_move_constructible_v<T> && std::is_nothrow_move_assignable_v<T>;

TEST(Handles, AreMovedAndNeverCopied) {
  static_assert(moves_alone<ups::Context> && moves_alone<ups::Profile> && moves_alone<ups::Fixture> &&
                moves_alone<ups::Scene> && moves_alone<ups::Job> && moves_alone<ups::Result> && moves_alone<ups::Path>);
  Room room;
  ups_scene *const raw = room.scene.get();
  ups::Scene moved = std::move(room.scene);
  EXPECT_EQ(moved.get(), raw);
  EXPECT_FALSE(room.scene);
  EXPECT_TRUE(moved);
  moved.commit();
  room.scene = std::move(moved);
  EXPECT_EQ(room.scene.get(), raw);
  EXPECT_GT(room.scene.render(Room::few()).read_meters(room.meters)[0].illuminance_lx, 1);
  std::vector<ups::Scene> scenes;
  for (int i = 0; i < 20; ++i) scenes.emplace_back(room.context);
  room.scene = std::move(scenes[3]);
  EXPECT_TRUE(room.scene.is_dirty()) << "the first scene was freed, this one is new";
}

TEST(Handles, MovedFromRefuse) {
  Room room;
  ups::Scene moved = std::move(room.scene);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"NULL"}, [&] { room.scene.commit(); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"NULL"}, [&] { room.scene.add_material(ups::MaterialDesc()); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"NULL"}, [&] { room.scene.render(Room::few()); });
  const ups::Context context = std::move(room.context);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"NULL"}, [&] { ups::Scene scene(room.context); });
  ups::Profile profile = downlight(context);
  const ups::Profile taken = std::move(profile);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"profile", "NULL"},
               [&] { moved.add_luminaire({profile, ups::Transform()}); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"profile", "NULL"},
               [&] { moved.set_luminaire(room.lamp, {profile, ups::Transform()}); });
  ups::Job none(nullptr);
  none.cancel();
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"NULL"}, [&] { none.wait(); });
}

TEST(Handles, AreLentAndGivenUp) {
  Room room;
  EXPECT_EQ(ups_scene_set_dimming(room.scene.get(), room.lamp, 0.5f), UPS_OK);
  EXPECT_EQ(room.scene.get_dimming(room.lamp), 0.5f);
  ups_scene *const raw = room.scene.release();
  EXPECT_FALSE(room.scene);
  const ups::Scene taken(raw);
  EXPECT_EQ(taken.get_dimming(room.lamp), 0.5f);
}

TEST(Handles, EndInAnyOrder) {
  auto room = std::make_unique<Room>();
  room->scene.commit();
  const ups_sensor_id meters = room->meters;
  auto result = std::make_unique<ups::Result>(room->scene.render(Room::few()));
  const ups::Job job = room->scene.start(Room::few(4));
  const ups::Profile profile = room->scene.get_luminaire_profile(room->lamp);
  room.reset();
  EXPECT_GT(result->read_meters(meters)[0].illuminance_lx, 1);
  result.reset();
  EXPECT_EQ(job.wait(), UPS_OK);
  EXPECT_GT(job.result().read_meters(meters)[0].illuminance_lx, 1);
  EXPECT_EQ(profile.get_info().peak_cd, 1000);
}

TEST(Contexts, TellTheirThreadsAndTheirLog) {
  Room room;
  EXPECT_GE(room.context.get_thread_count(), 1);
  EXPECT_EQ(ups::version(), UPS_VERSION_MAJOR * 10000u + UPS_VERSION_MINOR * 100u + UPS_VERSION_PATCH);
  room.scene.set_maintenance_factor(0.8);
  ups::LightDesc light(UPS_LIGHT_POINT, ups::Transform::translation(1, 1, 2));
  for (float &i : light.intensity_rgb) i = 10;
  room.scene.add_light(light);  // does not keep a maintenance factor: a warning
  room.scene.commit();
  std::size_t warnings = 0;
  while (const auto message = room.context.pop_log()) {
    EXPECT_FALSE(message->text.empty());
    EXPECT_EQ(message->text.find('\0'), std::string::npos);
    warnings += message->level == UPS_LOG_WARNING && message->text.find("aintenance") != std::string::npos;
  }
  EXPECT_EQ(warnings, 1u);
  EXPECT_FALSE(room.context.pop_log());
}

}  // namespace
