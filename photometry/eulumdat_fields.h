// Lines of an EULUMDAT file in the lengths that the format's description gives its fields (A. W. Stockmar, 1990). Used
// by eulumdat_writer.cpp.
#pragma once
#include "photometry/writer_text.h"

namespace photometry {

// The number in at most so many characters, with as many decimals as fit; "" where those before the point do not.
std::string number_field(double value, size_t length);

class EulumdatFields {
 public:
  // Added to: what does not fit.
  explicit EulumdatFields(std::vector<std::string>& warnings) : warnings_(warnings) {}

  // `name` says what it is, for the warnings. A text is cut, a number becomes the largest that fits.
  void text(const std::string& value, size_t length, const char* name);
  void number(double value, size_t length, const char* name);
  std::string all() && { return std::move(text_); }

 private:
  void line(std::string_view value) { text_.append(value).append("\r\n"); }

  std::vector<std::string>& warnings_;
  std::string text_;
};

}  // namespace photometry
