// What the program shares with the library ups_report: drawings, maps and the page, from the same objects.
#pragma once

namespace ups::report {}
namespace ups::tool {
using namespace report;
}
