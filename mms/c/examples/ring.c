/* Displacement and body force of a ring at three points: for each a line with X, u and b. */
#include <stdio.h>

#include "mpmvv_mms.h"

int main(void) {
  const char *names[] = {"amplitude", "poissons_ratio"};
  const double values[] = {0.05, 0.3};
  const double X[] = {0.6, 0.0, 0.3, 0.7, -0.5, -0.5}, t = 0.004;
  double u[6], b[6];
  mpmvv_solution *ring;

  if (mpmvv_create("ring", 2, names, values, &ring) != MPMVV_OK || mpmvv_displacement(ring, 3, X, t, u) != MPMVV_OK ||
      mpmvv_body_force(ring, 3, X, t, b) != MPMVV_OK) {
    fprintf(stderr, "%s\n", mpmvv_message());
    return 1;
  }
  for (int p = 0; p < 3; ++p)
    printf("%.17g %.17g  %.17g %.17g  %.17g %.17g\n", X[2 * p], X[2 * p + 1], u[2 * p], u[2 * p + 1], b[2 * p],
           b[2 * p + 1]);
  mpmvv_destroy(ring);
  return 0;
}
