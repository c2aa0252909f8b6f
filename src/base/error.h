// The one exception type of the engine. Stops at the API, where it becomes a ups_status and a message.
#pragma once
#include <stdexcept>
#include <string>

#include "ups/ups_base.h"

namespace ups {

class Error : public std::runtime_error {
 public:
  Error(ups_status status, const std::string& message) : std::runtime_error(message), status_(status) {}
  ups_status status() const { return status_; }

 private:
  ups_status status_;
};

[[noreturn]] inline void fail_argument(const std::string& message) { throw Error(UPS_ERROR_INVALID_ARGUMENT, message); }

}  // namespace ups
