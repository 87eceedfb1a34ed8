#include "mms/c/mpmvv_mms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>

#include "mms/catalogue.hpp"

/// The C interface to the catalogue. No exception leaves a function.

struct mpmvv_solution {
  template <int D>
  using Of = std::shared_ptr<mpmvv::mms::ManufacturedSolution<D>>;

  mpmvv::mms::Values values;
  std::variant<Of<1>, Of<2>, Of<3>> fields;
};

namespace {

using namespace mpmvv::mms;

thread_local std::string message;

/// Keeps the message, or a short one that needs no allocation where there is no memory for it.
mpmvv_status failed(mpmvv_status status, std::string_view why) noexcept {
  try {
    message = why;
  } catch (const std::bad_alloc&) {
    message = "no memory";
  }
  return status;
}

/// Returns what `work` returns, or the status for the exception that it throws.
template <class Work>
mpmvv_status guarded(const Work& work) noexcept {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return failed(MPMVV_NO_MEMORY, "no memory");
  } catch (const std::domain_error& error) {
    return failed(MPMVV_NOT_FINITE, error.what());
  } catch (const std::exception& error) {
    return failed(MPMVV_FAILED, error.what());
  } catch (...) {
    return failed(MPMVV_FAILED, "unknown failure");
  }
}

/// Returns the entries of the catalogue, or none where there is no memory for it.
const std::vector<Entry>& entries() noexcept {
  static const std::vector<Entry> none;
  const std::vector<Entry>* all = &none;
  guarded([&all] {
    all = &catalogue();
    return MPMVV_OK;
  });
  return *all;
}

const Entry* entry(int k) {
  return k >= 0 && k < mpmvv_solution_count() ? &entries()[static_cast<std::size_t>(k)] : nullptr;
}

const Parameter* parameter(int k, int p) {
  const Entry* const of = entry(k);
  return of && p >= 0 && p < static_cast<int>(of->parameters.size()) ? &of->parameters[static_cast<std::size_t>(p)]
                                                                     : nullptr;
}

bool all_finite(const double* numbers, std::size_t count) {
  return std::all_of(numbers, numbers + count, [](double number) { return std::isfinite(number); });
}

template <int D>
using Rows = Eigen::Matrix<double, D, D, D == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

/// Calls `at(fields, p)` for each of n points at X. It writes a vector (`rank` 1) or matrix (`rank` 2) into `out`.
/// Fails where the time, a coordinate, a normal or a result is not finite; `what` begins the message.
template <class At>
mpmvv_status evaluate(const mpmvv_solution* solution, std::size_t n, const double* X, double t, const double* out,
                      int rank, const char* what, const At& at, const double* normals = nullptr) {
  return guarded([&] {
    if (!std::isfinite(t)) return failed(MPMVV_BAD_ARGUMENT, std::string(what) + ": the time is not a finite number");
    return std::visit(
        [&]<int D>(const std::shared_ptr<ManufacturedSolution<D>>& fields) {
          const std::size_t size = rank == 2 ? D * D : D;
          for (std::size_t p = 0; p < n; ++p) {
            if (!all_finite(X + p * D, D))
              return failed(MPMVV_BAD_ARGUMENT, std::string(what) + ": a coordinate of point " + std::to_string(p) +
                                                    " is not a finite number");
            if (normals && !all_finite(normals + p * D, D))
              return failed(MPMVV_BAD_ARGUMENT, std::string(what) + ": a component of the normal at point " +
                                                    std::to_string(p) + " is not a finite number");
            at(*fields, p);
            if (!all_finite(out + p * size, size))
              return failed(MPMVV_NOT_FINITE, std::string(what) + " is not finite at point " + std::to_string(p) +
                                                  " (points of the body, a time nearer to 0)");
          }
          return MPMVV_OK;
        },
        solution->fields);
  });
}

mpmvv_status refused(const char* what, const char* why) {
  return guarded([=] { return failed(MPMVV_BAD_ARGUMENT, std::string(what) + ": " + why); });
}

mpmvv_status lacking(const char* what) {
  return refused(what, "a null pointer");
}

template <class Of>
mpmvv_status vectors(const mpmvv_solution* solution, std::size_t n, const double* X, double t, double* out,
                     const char* what, const Of& of) {
  if (!solution || (n > 0 && (!X || !out))) return lacking(what);
  return evaluate(solution, n, X, t, out, 1, what, [&]<int D>(const ManufacturedSolution<D>& fields, std::size_t p) {
    Eigen::Map<Vec<D>>(out + p * D) = of(fields, Vec<D>(Eigen::Map<const Vec<D>>(X + p * D)));
  });
}

template <class Of>
mpmvv_status matrices(const mpmvv_solution* solution, std::size_t n, const double* X, double t, double* out,
                      const char* what, const Of& of) {
  if (!solution || (n > 0 && (!X || !out))) return lacking(what);
  return evaluate(solution, n, X, t, out, 2, what, [&]<int D>(const ManufacturedSolution<D>& fields, std::size_t p) {
    Eigen::Map<Rows<D>>(out + p * D * D) = of(fields, Vec<D>(Eigen::Map<const Vec<D>>(X + p * D)));
  });
}

/// Makes the solution of the entry with the values of `made`.
void make_fields(const Entry& of, mpmvv_solution& made) {
  std::visit([&]<int D>(Make<D> make) { made.fields = make(made.values); }, of.make);
}

}  // namespace

int mpmvv_version(void) {
  return MPMVV_MMS_VERSION;
}

const char* mpmvv_message(void) {
  return message.c_str();
}

int mpmvv_solution_count(void) {
  return static_cast<int>(entries().size());
}
const char* mpmvv_solution_name(int k) {
  return entry(k) ? entry(k)->name.data() : nullptr;
}
const char* mpmvv_solution_what(int k) {
  return entry(k) ? entry(k)->what.data() : nullptr;
}
int mpmvv_solution_dimension(int k) {
  return entry(k) ? entry(k)->dimension() : -1;
}
int mpmvv_parameter_count(int k) {
  return entry(k) ? static_cast<int>(entry(k)->parameters.size()) : -1;
}
const char* mpmvv_parameter_name(int k, int p) {
  return parameter(k, p) ? parameter(k, p)->name.c_str() : nullptr;
}
const char* mpmvv_parameter_unit(int k, int p) {
  return parameter(k, p) ? parameter(k, p)->unit.c_str() : nullptr;
}
const char* mpmvv_parameter_range(int k, int p) {
  return parameter(k, p) ? parameter(k, p)->range.c_str() : nullptr;
}
double mpmvv_parameter_default(int k, int p) {
  return parameter(k, p) ? parameter(k, p)->value : std::numeric_limits<double>::quiet_NaN();
}

mpmvv_status mpmvv_create(const char* name, int count, const char* const* parameter_names,
                          const double* parameter_values, mpmvv_solution** solution) {
  if (!solution) return lacking("mpmvv_create");
  *solution = nullptr;
  if (count < 0) return refused("mpmvv_create", "a negative number of parameters");
  if (!name || (count > 0 && (!parameter_names || !parameter_values))) return lacking("mpmvv_create");
  return guarded([&] {
    Values given;
    for (int k = 0; k < count; ++k) {
      if (!parameter_names[k]) return lacking("mpmvv_create");
      given[parameter_names[k]] = parameter_values[k];
    }
    try {
      const Entry& of = entry_named(name);
      auto made = std::make_unique<mpmvv_solution>();
      made->values = complete(of, given);
      make_fields(of, *made);
      *solution = made.release();
      return MPMVV_OK;
    } catch (const UnknownName& error) {
      return failed(MPMVV_UNKNOWN_NAME, error.what());
    } catch (const std::invalid_argument& error) {
      return failed(MPMVV_BAD_VALUE, error.what());
    }
  });
}

void mpmvv_destroy(mpmvv_solution* solution) {
  delete solution;
}

int mpmvv_dimension(const mpmvv_solution* solution) {
  return solution ? static_cast<int>(solution->fields.index()) + 1 : 0;
}

double mpmvv_parameter(const mpmvv_solution* solution, const char* name) {
  double value = std::numeric_limits<double>::quiet_NaN();
  if (!solution || !name) return value;
  guarded([&] {
    if (const auto found = solution->values.find(name); found != solution->values.end()) value = found->second;
    return MPMVV_OK;
  });
  return value;
}

double mpmvv_displacement_scale(const mpmvv_solution* solution) {
  if (!solution) return std::numeric_limits<double>::quiet_NaN();
  return std::visit([](const auto& fields) { return fields->displacement_scale(); }, solution->fields);
}

mpmvv_status mpmvv_displacement(const mpmvv_solution* solution, size_t n, const double* X, double t, double* u) {
  return vectors(solution, n, X, t, u, "mpmvv_displacement",
                 [t](const auto& fields, const auto& at) { return fields.u(at, t); });
}
mpmvv_status mpmvv_velocity(const mpmvv_solution* solution, size_t n, const double* X, double t, double* v) {
  return vectors(solution, n, X, t, v, "mpmvv_velocity",
                 [t](const auto& fields, const auto& at) { return fields.v(at, t); });
}
mpmvv_status mpmvv_acceleration(const mpmvv_solution* solution, size_t n, const double* X, double t, double* a) {
  return vectors(solution, n, X, t, a, "mpmvv_acceleration",
                 [t](const auto& fields, const auto& at) { return fields.a(at, t); });
}
mpmvv_status mpmvv_body_force(const mpmvv_solution* solution, size_t n, const double* X, double t, double* b) {
  return vectors(solution, n, X, t, b, "mpmvv_body_force",
                 [t](const auto& fields, const auto& at) { return fields.b(at, t); });
}
mpmvv_status mpmvv_reference_point(const mpmvv_solution* solution, size_t n, const double* x, double t, double* X) {
  return vectors(solution, n, x, t, X, "mpmvv_reference_point",
                 [t](const auto& fields, const auto& at) { return fields.reference_point(at, t); });
}
mpmvv_status mpmvv_deformation_gradient(const mpmvv_solution* solution, size_t n, const double* X, double t,
                                        double* F) {
  return matrices(solution, n, X, t, F, "mpmvv_deformation_gradient",
                  [t](const auto& fields, const auto& at) { return fields.F(at, t); });
}
mpmvv_status mpmvv_stress(const mpmvv_solution* solution, size_t n, const double* X, double t, double* P) {
  return matrices(solution, n, X, t, P, "mpmvv_stress",
                  [t](const auto& fields, const auto& at) { return fields.P(at, t); });
}

mpmvv_status mpmvv_traction(const mpmvv_solution* solution, size_t n, const double* X, const double* N, double t,
                            double* traction) {
  if (!solution || (n > 0 && (!X || !N || !traction))) return lacking("mpmvv_traction");
  return evaluate(
      solution, n, X, t, traction, 1, "mpmvv_traction",
      [&]<int D>(const ManufacturedSolution<D>& fields, std::size_t p) {
        const Vec<D> at = Eigen::Map<const Vec<D>>(X + p * D), normal = Eigen::Map<const Vec<D>>(N + p * D);
        Eigen::Map<Vec<D>>(traction + p * D) = fields.traction(at, normal, t);
      },
      N);
}
