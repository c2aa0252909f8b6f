// What a job ends with, whatever its thread throws: a status and a text, as a call of the API that throws it.
#include <gtest/gtest.h>

#include "render/job_threads.h"

namespace {

using namespace ups;

template <class Thrown>
void expect_told(const Thrown& thrown, ups_status status, const std::string& message) {
  JobError error;
  try {
    throw thrown;
  } catch (...) {
    error.keep();
  }
  EXPECT_EQ(error.status, status);
  EXPECT_EQ(error.message, message);
}

TEST(JobError, TellsWhateverIsThrown) {
  expect_told(Error(UPS_ERROR_UNSUPPORTED, "no such thing"), UPS_ERROR_UNSUPPORTED, "no such thing");
  expect_told(std::bad_alloc(), UPS_ERROR_OUT_OF_MEMORY, "out of memory");
  expect_told(std::length_error("vector::reserve"), UPS_ERROR_OUT_OF_MEMORY, "vector::reserve");
  expect_told(std::invalid_argument("stoi"), UPS_ERROR_INVALID_ARGUMENT, "stoi");
  expect_told(std::runtime_error("other"), UPS_ERROR_INTERNAL, "other");
  expect_told(7, UPS_ERROR_INTERNAL, "an exception of an unknown kind");
}

}  // namespace
