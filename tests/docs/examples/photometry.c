/* Photometric files and profiles. */
#include "example.h"

static const char file[] =
    "IESNA:LM-63-2002\n[TEST] 4711\n[MANUFAC] Example Lighting\nTILT=NONE\n1 1500 1 4 1 1 2 0.2 0.2 0\n1 1 18\n"
    "0 30 60 90\n0\n500 400 150 0\n";

static char *text_of(const ups_profile *profile, ups_profile_text topic) {
  /* [ups_profile_get_text] */
  size_t needed;
  check(ups_profile_get_text(profile, topic, NULL, 0, &needed)); /* how much */
  char *text = malloc(needed);
  check(ups_profile_get_text(profile, topic, text, needed, NULL));
  /* [end] */
  return text;
}

static void describe(const ups_profile *profile) {
  /* [ups_profile_get_info] */
  ups_profile_info info;
  info.struct_size = sizeof info;
  check(ups_profile_get_info(profile, &info));
  printf("%.0f lm of %.0f lm, %.0f W, peak %.0f cd, beam angle %.0f degrees\n", info.flux_lm, info.rated_flux_lm,
         info.input_power_w, info.peak_cd, info.beam_angle_deg[0]);
  /* [end] */
  expect(near(info.rated_flux_lm, 1500, 0) && near(info.input_power_w, 18, 0) && info.peak_cd == 500);
  expect(near(info.light_output_ratio, info.flux_lm / 1500, 1e-9) && info.lamp_set_count == 1);

  /* [ups_profile_get_lamp_set] */
  ups_profile_lamp_set lamps;
  lamps.struct_size = sizeof lamps;
  check(ups_profile_get_lamp_set(profile, 0, &lamps)); /* below lamp_set_count of ups_profile_info */
  printf("%d lamps of %.0f lm together\n", (int)lamps.count, lamps.flux_lm);
  /* [end] */
  expect(lamps.count == 1 && lamps.flux_lm == 1500);

  /* [ups_profile_eval ups_profile_get_luminance] */
  const float directions[6] = {0, 0, -1, 1, 0, -1}; /* straight down; 45 degrees towards C0 */
  float cd[2], cd_m2[2];
  check(ups_profile_eval(profile, directions, 2, cd));
  check(ups_profile_get_luminance(profile, directions, 2, cd_m2)); /* of its opening, 0.2 m x 0.2 m */
  /* [end] */
  expect(cd[0] == 500 && near(cd[1], 275, 1) && near(cd_m2[0], 500 / 0.04, 1));

  /* [ups_profile_get_zonal_flux] */
  const float angles[3] = {0, 60, 90};
  double lm[2];
  check(ups_profile_get_zonal_flux(profile, angles, 3, lm)); /* 0 to 60 degrees, 60 to 90 degrees */
  /* [end] */
  expect(near(lm[0] + lm[1], info.flux_lm, 1e-3 * info.flux_lm) && lm[0] > lm[1]);

  /* [ups_profile_get_beam] */
  ups_profile_beam beam;
  beam.struct_size = sizeof beam;
  check(ups_profile_get_beam(profile, 0, 0.5f, &beam)); /* plane C0-C180, half of the peak */
  /* [end] */
  expect(beam.angle_deg == info.beam_angle_deg[0] && near(beam.from_deg, -beam.to_deg, 1e-3));
}

static void write(const ups_profile *profile) {
  /* [ups_profile_with_keyword] */
  static const char name[] = "EX-18, a white downlight with a louvre of anodised aluminium and a driver for DALI-2";
  ups_profile *named;
  check(ups_profile_with_keyword(profile, "LUMCAT", name, &named));
  /* [end] */
  /* [ups_profile_get_keyword] */
  char value[256];
  check(ups_profile_get_keyword(named, "LUMCAT", value, sizeof value, NULL));
  /* [end] */
  expect(strcmp(value, name) == 0);

  /* [ups_profile_write] */
  size_t size;
  check(ups_profile_write(named, UPS_PROFILE_EULUMDAT, NULL, 0, &size)); /* how much */
  char *bytes = malloc(size);
  check(ups_profile_write(named, UPS_PROFILE_EULUMDAT, bytes, size, NULL));
  /* fwrite(bytes, 1, size - 1, ldt): the final zero is no part of the file */
  /* [end] */
  expect(strstr(bytes, "Example Lighting") == bytes);

  /* [ups_profile_get_write_warnings] */
  char lost[1024];
  check(ups_profile_get_write_warnings(named, UPS_PROFILE_EULUMDAT, lost, sizeof lost, NULL));
  if (lost[0]) printf("not as it was:\n%s", lost);
  /* [end] */
  expect(lost[0]); /* too long for that format */
  free(bytes);
  ups_profile_destroy(named);
}

int main(void) {
  ups_context *context;
  check(ups_context_create(NULL, &context));

  /* [ups_profile_desc_init ups_profile_create] */
  const float c_deg[1] = {0}, gamma_deg[3] = {0, 45, 90}, intensity_cd[3] = {500, 400, 0};
  ups_profile_desc desc;
  ups_profile *table;
  ups_profile_desc_init(&desc, sizeof desc);
  desc.c_count = 1; /* one plane: round */
  desc.gamma_count = 3;
  desc.c_deg = c_deg;
  desc.gamma_deg = gamma_deg;
  desc.intensity_cd = intensity_cd;
  check(ups_profile_create(context, &desc, &table));
  /* [end] */
  const float down[3] = {0, 0, -1};
  float cd;
  check(ups_profile_eval(table, down, 1, &cd));
  expect(cd == 500);
  ups_profile_destroy(table);

  /* [ups_profile_parse] */
  ups_profile *profile;
  const ups_status status = ups_profile_parse(context, file, strlen(file), UPS_PROFILE_AUTO, &profile);
  if (status < 0) fprintf(stderr, "%s\n", ups_last_error()); /* has the line */
  /* [end] */
  expect(status == UPS_OK);
  ups_profile *broken;
  expect(ups_profile_parse(context, file, 60, UPS_PROFILE_IES_LM63, &broken) == UPS_ERROR_PARSE);
  describe(profile);
  write(profile);
  char *format = text_of(profile, UPS_PROFILE_TEXT_FORMAT);
  expect(strcmp(format, "IES LM-63-2002") == 0);
  free(format);

  /* [ups_profile_parse_desc_init ups_profile_parse_with] */
  ups_profile_parse_desc parse;
  ups_profile *tilted;
  ups_profile_parse_desc_init(&parse, sizeof parse);
  parse.bytes = file;
  parse.size = strlen(file);
  parse.tilt_deg = 30; /* intensities times the file's factor there; this one has TILT=NONE */
  check(ups_profile_parse_with(context, &parse, &tilted));
  /* [end] */
  check(ups_profile_eval(tilted, down, 1, &cd));
  expect(cd == 500);
  ups_profile_destroy(tilted);

  /* [ups_profile_destroy] */
  ups_profile_destroy(profile); /* luminaires that were added with it keep it */
  /* [end] */
  ups_context_destroy(context);
  return 0;
}
