// See progress.h: a line that is written over on a terminal, lines below one another elsewhere.
#include "tool/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "platform/process.h"
#include "tool/text_format.h"

namespace ups::tool {

namespace {

constexpr double line_interval_s = 5;
constexpr int bar_width = 30;

std::string percent(double fraction, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f %%", digits, 100 * fraction);
  return text;
}

}  // namespace

std::string progress_text(const ups_progress& progress, const std::string& foretold) {
  std::string text = percent(progress.fraction, 0) + ", " + std::to_string(progress.iterations_done) + " iterations";
  if (progress.worst_relative_error >= 0) text += ", worst error " + percent(progress.worst_relative_error, 1);
  if (progress.median_relative_error >= 0) text += ", median " + percent(progress.median_relative_error, 1);
  if (progress.remaining_s >= 0) text += ", " + duration_text(progress.remaining_s) + " left";
  return foretold.empty() ? text : text + ", " + foretold;
}

Progress::Progress() : terminal_(platform::standard_error_is_terminal()), next_line_s_(line_interval_s) {}

void Progress::update(const ups_progress& progress, const std::string& foretold) {
  if (!terminal_) {
    if (progress.elapsed_s < next_line_s_) return;
    next_line_s_ = progress.elapsed_s + line_interval_s;
    std::fprintf(stderr, "%s\n", progress_text(progress, foretold).c_str());
    return;
  }
  const int full = std::clamp(int(std::lround(progress.fraction * bar_width)), 0, bar_width);
  std::string line = "[";
  line.append(size_t(full), '#').append(size_t(bar_width - full), ' ');
  line += "] ";
  line += progress_text(progress, foretold);
  // One that wraps could not be written over. The last column is left free: some terminals wrap after it.
  line.resize(std::min(line.size(), size_t(std::max(1, platform::terminal_columns() - 1))));
  const size_t length = line.size();
  if (length < last_length_) line += std::string(last_length_ - length, ' ');  // over the longer line before
  last_length_ = length;
  std::fprintf(stderr, "\r%s", line.c_str());
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::finish() {
  if (drawn_) std::fprintf(stderr, "\n");
  drawn_ = false;
}

}  // namespace ups::tool
