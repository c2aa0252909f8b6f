// Threads of the library as a guest's should be: they bear names, take no signals of the host, compute in the default
// floating-point environment; one that cannot start is an error with a message of its own.
#pragma once
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/floating_point.h"
#include "platform/threads.h"

namespace ups {

// body() on a thread named "ups/<role>".
template <class Body>
std::thread start_thread(const std::string& role, Body body) {
  try {
    return platform::start_thread("ups/" + role, [body = std::move(body)] {
      const DefaultFloatingPoint environment;
      body();
    });
  } catch (const std::system_error& e) {
    throw Error(UPS_ERROR_OUT_OF_MEMORY, std::string("a thread cannot be started: ") + e.code().message() +
                                             " (too little memory for its stack, or a limit of threads)");
  }
}

}  // namespace ups
