/* The calls that ReadSpeed.cs measures, as a C program makes them: seconds that `calls` of them take. */
#include <time.h>
#include <ups/ups.h>

static double now_s(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double read_meters_s(const ups_result *result, ups_sensor_id sensor, ups_meter_reading *out, size_t count, int calls) {
  const double start = now_s();
  for (int i = 0; i < calls; ++i)
    if (ups_result_read_meters(result, sensor, out, count) != UPS_OK) return -1;
  return now_s() - start;
}

double read_image_s(const ups_result *result, ups_sensor_id camera, float *out, size_t bytes, int calls) {
  const double start = now_s();
  for (int i = 0; i < calls; ++i)
    if (ups_result_read_image(result, camera, UPS_CHANNEL_LUMINANCE_RGB, out, 0, bytes) != UPS_OK) return -1;
  return now_s() - start;
}
