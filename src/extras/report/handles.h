// The core's C API as the library and the program ups use it: handles with owners, two-call texts as strings, failures
// as exceptions.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "common/boundary.h"
#include "ups/ups.h"

namespace ups::report {

// The core's messages name the C function that failed, where one did: "ups_result_read_meters: ...". That helps those
// who called it; for others it is taken out.
std::string without_functions(const std::string& message);

// What cannot be done as asked; its text says what, where, and what would be right.
class Failure : public extras::Error {
 public:
  explicit Failure(const std::string& message, ups_status status = UPS_ERROR_INVALID_ARGUMENT)
      : Error(status, message) {}
};

template <auto destroy>
struct Destroy {
  template <class T>
  void operator()(T* handle) const {
    destroy(handle);
  }
};
using Profile = std::unique_ptr<ups_profile, Destroy<ups_profile_destroy>>;

inline void check(ups_status status, const char* (*last_error)() = ups_last_error) {
  if (status != UPS_OK) throw Failure(without_functions(last_error()), status);
}

// read(elements, capacity, needed) is one of the API's two-call functions, of an array of plain elements.
template <class Element, class Read>
std::vector<Element> read_array(Read&& read, const char* (*last_error)() = ups_last_error) {
  std::vector<Element> all;
  for (;;) {
    size_t needed = 0;
    check(read(nullptr, 0, &needed), last_error);
    all.resize(needed);
    if (needed == 0) return all;
    const ups_status status = read(all.data(), all.size(), &needed);
    if (status == UPS_ERROR_BUFFER_TOO_SMALL) continue;  // a commit that came between may have more to tell, or less
    check(status, last_error);
    all.resize(needed);
    return all;
  }
}

// The same of a text.
template <class Read>
std::string read_text(Read&& read, const char* (*last_error)() = ups_last_error) {
  const std::vector<char> all = read_array<char>(read, last_error);  // the final zero is among them
  return all.empty() ? std::string() : std::string(all.data(), all.size() - 1);
}

// An info struct that a getter fills.
template <class Info>
Info sized() {
  Info info{};
  info.struct_size = sizeof info;
  return info;
}

std::vector<std::string> lines_of(const std::string& text);  // without empty ones

// Of a line of the core, as it is: what is wrong with a photometric file the import tells of the file, "a.ies: ...", and
// the commit of whoever has it, "luminaire 2: ...", "luminaires 1 and 2: ...".
bool is_told(const std::vector<std::string>& lines, const std::string& line);
void append_once(std::vector<std::string>& to, const std::vector<std::string>& lines);

}  // namespace ups::report
