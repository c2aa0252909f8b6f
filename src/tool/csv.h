// A table of numbers as text, written whole or not at all. Used by the tables of `ups render --out`.
#pragma once
#include <cstdio>
#include <string>

#include "common/atomic_file.h"

namespace ups::tool {

class Csv {
 public:
  explicit Csv(std::string header) : text_(std::move(header) + "\n") {}
  void add(double value) { add(value, 9); }  // of a float
  void add_place(double metres) { add(metres, 12); }
  void end_row() {
    text_ += "\n";
    at_start_ = true;
  }
  void write(const std::string& path) const { extras::write_file(path, text_.data(), text_.size()); }

 private:
  void add(double value, int digits) {
    char number[40];
    std::snprintf(number, sizeof number, "%s%.*g", at_start_ ? "" : ",", digits, value == 0 ? 0.0 : value);  // no "-0"
    text_ += number;
    at_start_ = false;
  }

  std::string text_;
  bool at_start_ = true;
};

}  // namespace ups::tool
