// The one exception type of the engine. Stops at the API, or with its job, where it becomes a ups_status and a message.
#pragma once
#include <new>
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

// Within a catch block: tell(status, message) of whatever was thrown; returns what that does.
template <class Tell>
auto tell_exception(const Tell& tell) {
  try {
    throw;
  } catch (const Error& e) {
    return tell(e.status(), e.what());
  } catch (const std::bad_alloc&) {
    return tell(UPS_ERROR_OUT_OF_MEMORY, "out of memory");
  } catch (const std::length_error& e) {
    return tell(UPS_ERROR_OUT_OF_MEMORY, e.what());
  } catch (const std::invalid_argument& e) {
    return tell(UPS_ERROR_INVALID_ARGUMENT, e.what());
  } catch (const std::exception& e) {
    return tell(UPS_ERROR_INTERNAL, e.what());
  } catch (...) {
    return tell(UPS_ERROR_INTERNAL, "an exception of an unknown kind");
  }
}

}  // namespace ups
