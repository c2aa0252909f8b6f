// ups_base.h: version, status, last error, context and log.
#include "api/desc.h"
#include "api/handles.h"
#include "base/last_error.h"
#include "base/thread.h"

namespace ups {

// Nobody may be reading: the newest messages are kept.
void ContextCore::log(ups_log_level level, std::string text) {
  constexpr size_t max_messages = 1000;
  const std::lock_guard lock(mutex_);
  if (log_.size() == max_messages) log_.pop_front();
  log_.push_back({level, std::move(text)});
}

namespace api {
namespace {

LastError last_error;

}  // namespace

ups_status fail(ups_status status, const char* function, const char* message) noexcept {
  last_error.set(function, message);
  return status;
}

}  // namespace api
}  // namespace ups

using namespace ups;
using namespace ups::api;

uint32_t ups_version(void) { return UPS_VERSION_MAJOR * 10000 + UPS_VERSION_MINOR * 100 + UPS_VERSION_PATCH; }

const char* ups_status_name(ups_status status) {
  switch (status) {
    case UPS_OK:
      return "UPS_OK";
    case UPS_ERROR_INTERNAL:
      return "UPS_ERROR_INTERNAL";
    case UPS_ERROR_INVALID_ARGUMENT:
      return "UPS_ERROR_INVALID_ARGUMENT";
    case UPS_ERROR_INVALID_STATE:
      return "UPS_ERROR_INVALID_STATE";
    case UPS_ERROR_OUT_OF_MEMORY:
      return "UPS_ERROR_OUT_OF_MEMORY";
    case UPS_ERROR_PARSE:
      return "UPS_ERROR_PARSE";
    case UPS_ERROR_UNSUPPORTED:
      return "UPS_ERROR_UNSUPPORTED";
    case UPS_ERROR_BUFFER_TOO_SMALL:
      return "UPS_ERROR_BUFFER_TOO_SMALL";
    case UPS_ERROR_IO:
      return "UPS_ERROR_IO";
    case UPS_TIMEOUT:
      return "UPS_TIMEOUT";
    case UPS_CANCELLED:
      return "UPS_CANCELLED";
    default:
      return "UPS_STATUS_UNKNOWN";
  }
}

const char* ups_last_error(void) { return last_error.get(); }

void ups_context_desc_init(ups_context_desc* desc, uint32_t struct_size) {
  write_defaults(desc, struct_size, ups_context_desc{});
}

ups_status ups_context_create(const ups_context_desc* desc, ups_context** out) {
  return guard(__func__, [&] {
    require(out, "out");
    ups_context_desc d{};
    if (desc) d = read_desc(desc, &ups_context_desc_init);
    constexpr int32_t max_threads = 1024;
    if (d.thread_count < 0 || d.thread_count > max_threads)
      fail_argument("thread_count is " + std::to_string(d.thread_count) +
                    "; it must be 0 (all hardware threads) to 1024");
    const int processors = platform::processor_count();
    std::unique_ptr<ups_context> context(
        new ups_context{.core = std::make_shared<ContextCore>(std::min<int>(d.thread_count, processors))});
    if (d.thread_count > processors)
      context->core->log(UPS_LOG_INFO, "thread_count is " + std::to_string(d.thread_count) + ": there are " +
                                           std::to_string(processors) +
                                           " processors for this process, and as many threads run");
    *out = context.release();
  });
}

void ups_context_destroy(ups_context* context) { destroy(context); }

ups_status ups_context_get_thread_count(const ups_context* context, int32_t* out) {
  return guard(__func__, [&] {
    require(out, "out");
    *out = require(context, "context").core->pool->thread_count();
  });
}

ups_status ups_context_pop_log(ups_context* context, char* text, size_t capacity, size_t* needed,
                               ups_log_level* level) {
  return guard(__func__, [&] {
    if (!text && capacity > 0) fail_argument("text is NULL, but capacity is " + std::to_string(capacity));
    require(context, "context").core->pop([&](const ContextCore::Message* message) {
      if (!message) {
        if (needed) *needed = 0;
        if (text && capacity > 0) *text = '\0';
        return false;
      }
      const bool copied = copy_text(message->text, text, capacity, needed);
      if (level) *level = message->level;
      return copied;
    });
  });
}
