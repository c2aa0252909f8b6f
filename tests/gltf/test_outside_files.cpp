// Files that a scene names lie in its folder or below it, unless the caller lets them lie anywhere: a scene that
// someone else sent reads nothing else.
#include <functional>

#include "good_file.h"

namespace {

class OutsideFile : public GoodFile {
 protected:
  void SetUp() override {
    GoodFile::SetUp();
    home = folder / "home";
    std::filesystem::create_directories(home / "scene" / "lamps");
    folder = home / "scene";
  }
  void TearDown() override {
    folder = home.parent_path();
    GoodFile::TearDown();
  }
  static SceneBuilder with_lamp(const std::string& file) {
    SceneBuilder builder;
    builder.add_node({{"name", "desk"}, {"extras", {{"ups", {{"luminaire", {{"file", file}}}}}}}});
    return builder;
  }
  // Refused with words that help; read where it is allowed.
  void expect_outside(const SceneBuilder& scene_file, const char* file) {
    SceneBuilder builder = scene_file;
    expect_failure(builder, UPS_ERROR_IO, {file, "lies outside the scene's folder", "--allow-outside"});
    ups_gltf_import_desc allowing;
    ups_gltf_import_desc_init(&allowing, sizeof allowing);
    EXPECT_EQ(allowing.allow_outside, 0);
    allowing.allow_outside = 1;
    desc = &allowing;
    import(builder);
    desc = nullptr;
  }

  std::filesystem::path home;
};

TEST_F(OutsideFile, LuminairesFromOtherFolders) {
  write("../out.ies", "good");
  write("lamps/in.ies", "good");
  std::filesystem::create_symlink(home / "out.ies", folder / "link.ies");
  std::filesystem::create_directory_symlink(home, folder / "up");
  std::filesystem::create_symlink("lamps/in.ies", folder / "inner.ies");
  for (const std::string file : {"lamps/in.ies", "inner.ies", "lamps/../inner.ies", "../scene/lamps/in.ies"}) {
    SceneBuilder builder = with_lamp(file);
    import(builder);
  }
  SceneBuilder absolute = with_lamp((folder / "lamps" / "in.ies").string());
  import(absolute);
  for (const std::string file : {"../out.ies", "lamps/../../out.ies", "link.ies", "up/out.ies"})
    expect_outside(with_lamp(file), file.c_str());
  expect_outside(with_lamp((home / "out.ies").string()), "out.ies");
  // Whether it is there is not told.
  SceneBuilder gone = with_lamp("../gone.ies");
  expect_failure(gone, UPS_ERROR_IO, {"node 0 \"desk\"", "gone.ies", "lies outside"});
}

TEST_F(OutsideFile, AFolderWhoseNameBeginsAlikeIsAnother) {
  std::filesystem::create_directories(home / "scene2");
  write("../scene2/a.ies", "good");
  expect_outside(with_lamp("../scene2/a.ies"), "a.ies");
}

TEST_F(OutsideFile, BuffersAndProfilesOfExtensions) {
  SceneBuilder square;
  square.add_square();
  square.add_node({{"mesh", 0}});
  square.gltf();
  write("../scene.bin", square.bytes);
  square.doc["buffers"][0]["uri"] = "../scene.bin";
  EXPECT_EQ(import_text(square.doc.dump()), UPS_ERROR_IO);
  expect_words({"buffer 0", "lies outside the scene's folder"});

  write("../a.ies", "good");
  SceneBuilder light;
  light.doc["extensions"]["EXT_lights_ies"]["lights"] = json::array({{{"uri", "%2e%2e/a.ies"}}});
  light.add_node({{"extensions", {{"EXT_lights_ies", {{"light", 0}}}}}});
  expect_outside(light, "a.ies");

  SceneBuilder image;
  image.doc["images"] = json::array({{{"uri", "../wood.png"}}});
  image.doc["textures"] = json::array({{{"source", 0}}});
  image.doc["materials"] = json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}});
  expect_failure(image, UPS_ERROR_IO, {"image 0", "wood.png", "lies outside"});
}

TEST_F(OutsideFile, TheFlagIsZeroOrOne) {
  ups_gltf_import_desc wrong;
  ups_gltf_import_desc_init(&wrong, sizeof wrong);
  wrong.allow_outside = 2;
  EXPECT_EQ(ups_gltf_import_file(&context, "a.gltf", &wrong, &scene, &imported), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(std::string(ups_gltf_last_error()).find("allow_outside"), std::string::npos);
}

}  // namespace
