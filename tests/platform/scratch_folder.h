// A folder of a test's own, gone with it.
#pragma once
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "platform/native_path.h"
#include "platform/paths.h"

namespace ups::platform {

class ScratchFolder {
 public:
  ScratchFolder() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    path_ = joined(testing::TempDir(), "ups-platform-" + std::to_string(now));
    EXPECT_FALSE(make_folder(path_));
  }
  ~ScratchFolder() {
    std::error_code error;
    std::filesystem::remove_all(native_path(path_), error);
    EXPECT_FALSE(error) << "something in it is held open";
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string path(const std::string& name) const { return joined(path_, name); }

 private:
  std::string path_;
};

}  // namespace ups::platform
