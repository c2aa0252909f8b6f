// Values for pixels that have none yet, from those around them. Used by images that are read within their first pass.
#pragma once
#include <cstdint>
#include <vector>

namespace ups {

// Pull-push (Gortler et al. 1996, The Lumigraph, section 3.4): means of ever larger squares, then for each gap the
// interpolated mean of the smallest ones that know something. Takes time in proportion to the pixels, wherever the gaps
// are. `known`: by pixel, 0 is a gap; `values`: `channels` a pixel.
void fill_gaps(uint32_t width, uint32_t height, uint32_t channels, const std::vector<uint8_t>& known,
               std::vector<float>& values);

}  // namespace ups
