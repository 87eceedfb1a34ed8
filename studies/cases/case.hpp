#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "studies/cases/scheme.hpp"

namespace mpmvv::cases {

/// The problem and all of its physical values, defaults filled in.
struct ProblemChoice {
  std::string name;
  std::map<std::string, double> parameters;  ///< `amplitude`, `youngs_modulus`, ...
  double end_time = 0;                       ///< s
  bool quarter = false;  ///< whether its body is only the part of which mirror images make the whole

  auto operator<=>(const ProblemChoice&) const = default;
};

/// How finely a problem is resolved. The time step divides the end time into equal steps.
struct Resolution {
  int cells = 0;           ///< n; h = L/n
  int ppc = 0;             ///< particles per cell and direction
  double grid_offset = 0;  ///< shift of the grid against the body, in cells, along every axis where no face holds it
  int shuffle = 0;         ///< seed of the order in which the particles start; 0: as they fill the body
  double dt = 0;           ///< s
  std::int64_t steps = 0;  ///< number of steps taken; steps * dt is the time reached

  auto operator<=>(const Resolution&) const = default;
};

/// What is measured besides the errors at the end, and when a run counts as blown up.
struct Measure {
  bool every_step = false;       ///< errors over all steps, too
  bool nodal_error = false;      ///< error of the nodes' accelerations at the end
  bool velocity_error = false;   ///< mean over all steps of the particles' RMS velocity error
  bool stress_error = false;     ///< error of the particles' stresses at the end
  bool particle_errors = false;  ///< displacement errors of the particles at the end, each with its place
  double blowup_error =
      1;  ///< unstable when the largest displacement error exceeds this times the problem's displacement scale
  double blowup_energy = 10;  ///< unstable when kinetic + strain energy exceeds this times the initial total
  bool whole = false;         ///< run the whole body, even where a part and its images give the same numbers
  int repeat = 0;             ///< timed runs, alone on the machine, whose mean cost is kept; 0: the cost is no evidence

  auto operator<=>(const Measure&) const = default;
};

/// One run, completely specified: problem, scheme, resolution, and what is measured.
struct Case {
  ProblemChoice problem;
  Scheme scheme;
  Resolution resolution;
  Measure measure;

  auto operator<=>(const Case&) const = default;
};

/// The words that tell methods apart: basis, integrator and velocity update; or another code, its variant and an empty
/// word.
using Method = std::array<std::string, 3>;
Method method_of(const Scheme& scheme);

/// Returns one line `key=value ...` with all that decides the result, in a fixed order, with numbers that read back as
/// the same. Where another code runs, settings of our own solver are left out. Equal cases have equal texts.
std::string canonical_text(const Case& c);

/// Returns the 64-bit FNV-1a hash of a text in hexadecimal, as a short name for people. Stores compare the whole text.
std::string fingerprint(const std::string& text);

}  // namespace mpmvv::cases
