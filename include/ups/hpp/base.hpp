// UPS for C++17: what every class needs: errors, spans, handles, the context. See ups.hpp.
#ifndef UPS_HPP_BASE_HPP
#define UPS_HPP_BASE_HPP

#if defined(_MSVC_LANG) ? _MSVC_LANG < 201703L : __cplusplus < 201703L
#error "ups.hpp needs C++17 or later; for earlier ones there is the C API, ups.h"
#endif
#if !defined(__cpp_exceptions) && !defined(_CPPUNWIND)
#error "ups.hpp reports failures by exceptions; a program without them uses the C API, ups.h"
#endif

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../ups.h"

namespace ups {
// In all names that a linker sees: apart from those within a static library, and from those of other versions.
inline namespace v0_1 {

// A failure of the library, or an array that does not fit. what(): the status' name and the library's message.
class Error : public std::runtime_error {
 public:
  Error(ups_status status, const std::string &message)
      : std::runtime_error(std::string(ups_status_name(status)) + ": " + message), status_(status) {}
  ups_status status() const noexcept { return status_; }  // UPS_ERROR_*

 private:
  ups_status status_;
};

// Throws what this thread's last call failed with. UPS_TIMEOUT and UPS_CANCELLED are answers: returned, as UPS_OK is.
inline ups_status check(ups_status status) {
  if (status < 0) throw Error(status, ups_last_error());
  return status;
}

// Elements of somebody else's array: of a std::vector, std::array, std::span, C array or what else has data and a size.
// An array of nothing is null.
template <typename T>
class Span {
  template <typename C>
  using Elements = std::remove_pointer_t<decltype(std::data(std::declval<C &>()))>;

 public:
  constexpr Span() noexcept = default;
  constexpr Span(T *data, std::size_t size) noexcept : data_(size != 0 ? data : nullptr), size_(size) {}
  // An array that ends before the span does may be read from alone: a span of const elements takes temporaries too.
  template <typename C, typename = std::enable_if_t<
                            !std::is_same_v<std::remove_cv_t<std::remove_reference_t<C>>, Span> &&
                            (std::is_lvalue_reference_v<C> || std::is_const_v<T>) &&
                            std::is_convertible_v<Elements<std::remove_reference_t<C>> (*)[], T (*)[]>>>
  constexpr Span(C &&array) noexcept : Span(std::data(array), std::size(array)) {}

  constexpr T *data() const noexcept { return data_; }
  constexpr std::size_t size() const noexcept { return size_; }
  constexpr bool empty() const noexcept { return size_ == 0; }
  constexpr T *begin() const noexcept { return data_; }
  constexpr T *end() const noexcept { return data_ + size_; }
  constexpr T &operator[](std::size_t i) const noexcept { return data_[i]; }  // i < size()

 private:
  T *data_ = nullptr;
  std::size_t size_ = 0;
};

namespace detail {

struct Destroy {
  void operator()(ups_context *p) const noexcept { ups_context_destroy(p); }
  void operator()(ups_profile *p) const noexcept { ups_profile_destroy(p); }
  void operator()(ups_fixture *p) const noexcept { ups_fixture_destroy(p); }
  void operator()(ups_scene *p) const noexcept { ups_scene_destroy(p); }
  void operator()(ups_job *p) const noexcept { ups_job_destroy(p); }
  void operator()(ups_result *p) const noexcept { ups_result_destroy(p); }
  void operator()(ups_path *p) const noexcept { ups_path_destroy(p); }
};

// What a C function writes to its last argument. Here and below Check throws what it fails with; an extra has its own.
template <typename T, ups_status (*Check)(ups_status) = check, typename Function, typename... Arguments>
T value(Function function, Arguments... arguments) {
  T out{};
  Check(function(arguments..., &out));
  return out;
}

// The same, of a struct that says its size.
template <typename T, ups_status (*Check)(ups_status) = check, typename Function, typename... Arguments>
T sized(Function function, Arguments... arguments) {
  T out{};
  out.struct_size = sizeof out;
  Check(function(arguments..., &out));
  return out;
}

// The same of all indices below what `count` finds.
template <typename T, typename Count, typename Function, typename... Arguments>
std::vector<T> all(Count count, Function function, Arguments... arguments) {
  std::vector<T> out(value<std::uint32_t>(count, arguments...));
  for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = sized<T>(function, arguments..., i);
  return out;
}

// What is asked for by two calls: how much there is, then all of it. A commit that comes between may have more of it, or
// less.
template <typename T, ups_status (*Check)(ups_status) = check, typename Function, typename... Arguments>
std::vector<T> list(Function function, Arguments... arguments) {
  std::vector<T> out;
  for (;;) {
    std::size_t needed = 0;
    Check(function(arguments..., static_cast<T *>(nullptr), std::size_t{0}, &needed));
    out.resize(needed);
    if (needed == 0) return out;
    const ups_status status = function(arguments..., out.data(), out.size(), &needed);
    if (status == UPS_ERROR_BUFFER_TOO_SMALL) continue;
    Check(status);
    out.resize(needed);
    return out;
  }
}

template <ups_status (*Check)(ups_status) = check, typename Function, typename... Arguments>
std::string text(Function function, Arguments... arguments) {
  const std::vector<char> all = list<char, Check>(function, arguments...);  // the final zero is among them
  return all.empty() ? std::string() : std::string(all.data(), all.size() - 1);
}

// The number of elements of an array that has `per` values each.
inline std::uint32_t count(std::size_t values, std::size_t per, const char *what) {
  if (values % per != 0)
    throw Error(UPS_ERROR_INVALID_ARGUMENT, std::string(what) + ": " + std::to_string(values) +
                                                " values; expected a multiple of " + std::to_string(per));
  if (values / per > UINT32_MAX)
    throw Error(UPS_ERROR_INVALID_ARGUMENT, std::string(what) + ": more than 2^32 - 1 elements");
  return static_cast<std::uint32_t>(values / per);
}

inline void expect(std::size_t values, std::size_t wanted, const char *what) {
  if (values != wanted)
    throw Error(UPS_ERROR_INVALID_ARGUMENT, std::string(what) + ": " + std::to_string(values) + " values; expected " +
                                                std::to_string(wanted));
}

// A NUL would cut it short, and another file be meant.
inline const char *c_path(const std::string &path) {
  if (path.find('\0') != std::string::npos)
    throw Error(UPS_ERROR_INVALID_ARGUMENT, "the path '" + std::string(path.c_str()) + "' goes on after a NUL");
  return path.c_str();
}

// Of an array that may be left out.
template <typename T>
const T *optional_array(Span<const T> array, std::size_t wanted, const char *what) {
  if (!array.empty()) expect(array.size(), wanted, what);
  return array.data();
}

}  // namespace detail

// A C handle and its destruction.
template <typename T, typename Destroy = detail::Destroy>
class Handle {
 public:
  explicit Handle(T *owned) noexcept : owned_(owned) {}
  T *get() const noexcept { return owned_.get(); }     // lent: stays this object's
  T *release() noexcept { return owned_.release(); }   // the caller owns it; this is empty afterwards
  explicit operator bool() const noexcept { return owned_ != nullptr; }

 private:
  std::unique_ptr<T, Destroy> owned_;
};

// Of the library that is loaded: major * 10000 + minor * 100 + patch.
inline std::uint32_t version() noexcept { return ups_version(); }

struct ContextDesc : ups_context_desc {
  ContextDesc() noexcept { ups_context_desc_init(this, sizeof(ups_context_desc)); }
};

struct LogMessage {
  std::string text;
  ups_log_level level;
};

// Threads and log.
class Context : public Handle<ups_context> {
 public:
  using Handle::Handle;
  explicit Context(const ContextDesc &desc = ContextDesc())
      : Handle(detail::value<ups_context *>(ups_context_create, &desc)) {}
  std::int32_t get_thread_count() const { return detail::value<std::int32_t>(ups_context_get_thread_count, get()); }
  // The oldest message, which leaves the log; none where that is empty.
  std::optional<LogMessage> pop_log() {
    std::vector<char> text;
    for (;;) {
      std::size_t needed = 0;
      ups_log_level level = UPS_LOG_INFO;
      const ups_status status = ups_context_pop_log(get(), text.data(), text.size(), &needed, &level);
      if (status != UPS_ERROR_BUFFER_TOO_SMALL) check(status);
      if (needed == 0) return std::nullopt;
      if (status == UPS_OK && needed <= text.size()) return LogMessage{text.data(), level};
      text.resize(needed);  // meanwhile another thread may have taken the message
    }
  }
};

}  // namespace v0_1
}  // namespace ups

#endif
