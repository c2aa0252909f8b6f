// How well a beam or field angle is known that was measured by the goniophotometer. Asked by the API.
#pragma once
#include "render/goniometer_sums.h"

namespace ups {

// fraction: of the peak of the plane C / C + 180, as photometry::beam_of takes it.
ups_goniometer_beam beam_with_error(const Goniometer& goniometer, const GoniometerReading& reading, double c_deg,
                                    double fraction);

}  // namespace ups
