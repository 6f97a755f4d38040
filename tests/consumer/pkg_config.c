/* SPDX-License-Identifier: Apache-2.0
 * A C11 program built with the flags of pkg-config alone. It prints the hour of the first key of a baked sky. */
#include <stdio.h>
#include <welkin/welkin.h>

int main(int argc, char** argv) {
  WelkinSky* sky = NULL;
  double time_h = -1.0;
  if (argc < 2 || welkin_sky_open_file(argv[1], &sky, NULL) != WELKIN_OK) return 1;
  if (welkin_sky_key_time(sky, 0, &time_h) == WELKIN_OK) printf("first key: %g h\n", time_h);
  welkin_sky_close(sky);
  return time_h == 0.0 ? 0 : 1;
}
