// How far a render is, on standard error: a bar with the remaining time on a terminal, a line every few seconds
// elsewhere (log files). Called by the render command about ten times a second.
#pragma once
#include <string>

#include "ups/ups_render.h"

namespace ups::tool {

class Progress {
 public:
  Progress();
  // foretold: text, or none
  void update(const ups_progress& progress, const std::string& foretold);
  void finish();  // ends the bar's line

 private:
  bool terminal_;
  bool drawn_ = false;
  double next_line_s_ = 0;
  size_t last_length_ = 0;
};

std::string progress_text(const ups_progress& progress, const std::string& foretold);

}  // namespace ups::tool
