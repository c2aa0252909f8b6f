// Numbers from what files say of lamps in words: "4000 K", "LED 830 CRI>80". Called by the API.
#pragma once
#include "photometry/photometry.h"

namespace photometry {

// Correlated, K; of a text that states several, or none, < 0. A code of three digits, as 830, has it in its last two.
double colour_temperature_k(const LampSet& lamps);
// Ra; < 0 where there is none, or only a group of DIN 5035 such as 1B.
double colour_rendering_index(const LampSet& lamps);

}  // namespace photometry
