/* UPS: illuminance and luminance by Unified Path Sampling. The whole core API; the extras have headers of their own. */
#ifndef UPS_H
#define UPS_H

#include "ups_base.h"
#include "ups_photometry.h"
#include "ups_scene.h"
#include "ups_fixture.h"
#include "ups_sensor.h"
#include "ups_render.h"
#include "ups_replay.h"
#include "ups_statistics.h"
#include "ups_glare.h"

#endif
