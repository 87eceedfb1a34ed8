/* Manufactured and exact solutions for codes of any language.
 *
 * A solution is a motion u(X, t) of a body together with the body force that makes it exact:
 *   Div P + rho0 b = rho0 a,   X a point of the body at rest, t the time. SI units.
 * P is the first Piola-Kirchhoff stress, P_iJ, with (Div P)_i = sum_J dP_iJ/dX_J; F_iJ = delta_iJ + du_i/dX_J.
 *
 *   mpmvv_solution *ring;
 *   const char *names[] = {"amplitude", "poissons_ratio"};
 *   const double values[] = {0.05, 0.3};
 *   if (mpmvv_create("ring", 2, names, values, &ring) != MPMVV_OK) puts(mpmvv_message());
 *   mpmvv_body_force(ring, n, X, t, b);
 *   mpmvv_destroy(ring);
 *
 * Arrays hold one point after the other. With D the solution's dimension, n points are n*D numbers, vectors alike;
 * matrices are n*D*D numbers, row by row: F_iJ of point p is F[p*D*D + i*D + J]. In Fortran these are X(D, n), u(D, n)
 * and F(D, D, n) with F_iJ in F(J, i, p).
 *
 * No function throws or ends the program. Those that can fail return a status; mpmvv_message() says in one line what
 * was wrong in the last one that failed on this thread, and what would be right. Several threads may use one solution
 * at once, each with arrays of its own; only mpmvv_destroy has to come last. Functions keep their names, arguments and
 * meaning as long as MPMVV_MMS_VERSION does; later versions may add some.
 */
#ifndef MPMVV_MMS_H
#define MPMVV_MMS_H

#include <stddef.h>

#if defined(__GNUC__)
#define MPMVV_API __attribute__((visibility("default")))
#else
#define MPMVV_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define MPMVV_MMS_VERSION 1

typedef struct mpmvv_solution mpmvv_solution;

typedef enum mpmvv_status {
  MPMVV_OK = 0,
  MPMVV_UNKNOWN_NAME = 1, /* of a solution or of a parameter */
  MPMVV_BAD_VALUE = 2,    /* a parameter out of its range, or parameters that do not go together */
  MPMVV_BAD_ARGUMENT = 3, /* a null pointer, a negative count, a time, coordinate or normal that is not finite */
  MPMVV_NOT_FINITE =
      4, /* a field is not finite at a point: the point is outside of the body, or the time is too large */
  MPMVV_NO_MEMORY = 5,
  MPMVV_FAILED = 6 /* what should not happen */
} mpmvv_status;

/* The version of the library that runs: MPMVV_MMS_VERSION of its own header. */
MPMVV_API int mpmvv_version(void);

/* What was wrong in the last call that failed on this thread; "" before the first. Valid until the next that fails. */
MPMVV_API const char* mpmvv_message(void);

/* --- What there is. A null pointer or -1 for an index beyond the last. --- */

MPMVV_API int mpmvv_solution_count(void);
MPMVV_API const char* mpmvv_solution_name(int k);          /* "ring" */
MPMVV_API const char* mpmvv_solution_what(int k);          /* one line for people */
MPMVV_API int mpmvv_solution_dimension(int k);             /* 1, 2 or 3 */
MPMVV_API int mpmvv_parameter_count(int k);                /* of solution k */
MPMVV_API const char* mpmvv_parameter_name(int k, int p);  /* "amplitude" */
MPMVV_API const char* mpmvv_parameter_unit(int k, int p);  /* "m"; "" for a number without one */
MPMVV_API const char* mpmvv_parameter_range(int k, int p); /* for people: "> 0" */
MPMVV_API double mpmvv_parameter_default(int k, int p);    /* NaN for an index beyond the last */

/* --- One solution. --- */

/* Makes a solution. `count` parameters are given by name, the others keep their defaults; with count 0 both arrays may
 * be null. On success *solution is to be destroyed; otherwise it is null. */
MPMVV_API mpmvv_status mpmvv_create(const char* name, int count, const char* const* parameter_names,
                                    const double* parameter_values, mpmvv_solution** solution);
MPMVV_API void mpmvv_destroy(mpmvv_solution* solution); /* a null pointer is left alone */

MPMVV_API int mpmvv_dimension(const mpmvv_solution* solution); /* D; 0 for a null pointer */

/* The value of a parameter of this solution; NaN where it has none of that name. */
MPMVV_API double mpmvv_parameter(const mpmvv_solution* solution, const char* name);

/* The largest displacement over body and time, up to a factor of order one, m: what errors are measured by. */
MPMVV_API double mpmvv_displacement_scale(const mpmvv_solution* solution);

/* --- Its fields at n points of the body at rest, X, and one time t, s. --- */

MPMVV_API mpmvv_status mpmvv_displacement(const mpmvv_solution* solution, size_t n, const double* X, double t,
                                          double* u);
MPMVV_API mpmvv_status mpmvv_velocity(const mpmvv_solution* solution, size_t n, const double* X, double t, double* v);
MPMVV_API mpmvv_status mpmvv_acceleration(const mpmvv_solution* solution, size_t n, const double* X, double t,
                                          double* a);
MPMVV_API mpmvv_status mpmvv_body_force(const mpmvv_solution* solution, size_t n, const double* X, double t, double* b);
MPMVV_API mpmvv_status mpmvv_deformation_gradient(const mpmvv_solution* solution, size_t n, const double* X, double t,
                                                  double* F);
MPMVV_API mpmvv_status mpmvv_stress(const mpmvv_solution* solution, size_t n, const double* X, double t, double* P);

/* P N, force per area at rest, on surfaces with unit normals N (n vectors) at rest. */
MPMVV_API mpmvv_status mpmvv_traction(const mpmvv_solution* solution, size_t n, const double* X, const double* N,
                                      double t, double* traction);

/* X of the particles that are at x at time t: for codes that know current positions alone. */
MPMVV_API mpmvv_status mpmvv_reference_point(const mpmvv_solution* solution, size_t n, const double* x, double t,
                                             double* X);

#ifdef __cplusplus
}
#endif

#endif
