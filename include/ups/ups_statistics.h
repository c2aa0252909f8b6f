/* UPS: what standards ask of an area beside ups_result_get_meter_statistics: percentiles, shares, ratios. */
#ifndef UPS_STATISTICS_H
#define UPS_STATISTICS_H

#include "ups_render.h"

/* A value and where the true one lies with 95 %, noise and bias together; -1 where not known: low and high before
 * 6 visits of all meters. A plain array element: it never grows. An interval need not lie evenly about its value: the least
 * of noisy readings is biased low, the largest high. */
typedef struct ups_interval {
  double value, low, high;
} ups_interval;

/* lx: `share` (0 to 1) of the set's meters are below. 0: the least, 0.5: the median, 1: the largest. Here and in shares
 * each meter counts the same, one on a surface (a triangle, a texel) by its area. */
UPS_API ups_status ups_result_get_meter_percentile(const ups_result *result, ups_sensor_id sensor, double share,
                                                   ups_interval *out);
/* 0 to 1: the share of the set's meters with at least threshold_lx, a finite number. */
UPS_API ups_status ups_result_get_meter_share(const ups_result *result, ups_sensor_id sensor, double threshold_lx,
                                              ups_interval *out);
/* The mean of one set over that of another: of a task over its surround, of a wall over the work plane. value is -1
 * where the denominator is 0, low and high are -1 too where its own error is more than half of it. */
UPS_API ups_status ups_result_get_meter_ratio(const ups_result *result, ups_sensor_id numerator,
                                              ups_sensor_id denominator, ups_interval *out);
/* Meter by meter, of two sets of count meters: with cylindrical ones over horizontal ones at the same places the
 * modelling index of EN 12464-1. -1 where a meter does not measure; all -1 before each meter was visited. */
UPS_API ups_status ups_result_read_meter_ratios(const ups_result *result, ups_sensor_id numerator,
                                                ups_sensor_id denominator, ups_interval *out, size_t count);

#endif
