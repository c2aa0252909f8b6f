// UTF-8 text in the characters of the 5x7 font, for the diagrams that are written as pixels: letters lose their accents
// rather than become question marks. Called by drawing_pixels.cpp.
#pragma once
#include <string>

namespace ups::tool {

// Latin letters without accents (a-umlaut: a, sharp s: ss, ligatures: two letters), common signs in ASCII, combining
// accents left out, the degree sign as extras::degree_sign; '?' once for anything else beyond ASCII.
std::string folded(const std::string& utf8);

}  // namespace ups::tool
