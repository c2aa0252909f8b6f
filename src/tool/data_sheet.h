// The tables of a luminaire's data sheet, as `ups info` prints them: for people, as CSV, and in json.cpp.
#pragma once
#include <string>

#include "report/data_sheet.h"
#include "tool/library.h"

namespace ups::tool {

std::string to_text(const DataSheet& sheet);
std::string csv_header();
std::string csv_rows(const std::string& file, const DataSheet& sheet);  // a value a row

}  // namespace ups::tool
