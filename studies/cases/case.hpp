#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "studies/cases/scheme.hpp"

namespace mpmvv::cases {

/// Which problem, with every physical value spelled out (defaults filled in).
struct ProblemChoice {
  std::string name;
  std::map<std::string, double> parameters;  ///< `amplitude`, `youngs_modulus`, ...
  double end_time = 0;                       ///< s
  bool quarter = false;  ///< the part of its body of which mirror images make the whole, instead of all of it

  auto operator<=>(const ProblemChoice&) const = default;
};

/// How finely a problem is resolved. The time step divides the end time into equal steps.
struct Resolution {
  int cells = 0;           ///< n; h = L/n
  int ppc = 0;             ///< particles per cell and direction
  double grid_offset = 0;  ///< of the grid against the body, in cells, along every axis on which nothing holds it
  int shuffle = 0;         ///< seed of the order in which the particles start; 0: as they fill the body
  double dt = 0;           ///< s
  std::int64_t steps = 0;  ///< number of steps taken; steps * dt is the time reached

  auto operator<=>(const Resolution&) const = default;
};

/// What is measured besides the errors at the end, and when a run counts as blown up.
struct Measure {
  bool every_step = false;       ///< errors over all steps
  bool nodal_error = false;      ///< error of the nodes' accelerations at the end
  bool velocity_error = false;   ///< mean over all steps of the particles' RMS velocity error
  bool stress_error = false;     ///< error of the particles' stresses at the end
  bool particle_errors = false;  ///< displacement errors of the particles at the end, each with its place
  double blowup_error =
      1;  ///< unstable when the largest displacement error exceeds this times the problem's displacement scale
  double blowup_energy = 10;  ///< unstable when kinetic + strain energy exceeds this times the initial total
  bool whole = false;         ///< all of the body is run, also where a part and its images give the same
  int repeat = 0;             ///< runs, each alone on the machine, of which the cost is taken; 0: it is no evidence

  auto operator<=>(const Measure&) const = default;
};

/// One run, wholly specified: Problem + Scheme + Resolution, and what is measured.
struct Case {
  ProblemChoice problem;
  Scheme scheme;
  Resolution resolution;
  Measure measure;

  auto operator<=>(const Case&) const = default;
};

/// The words that tell methods apart: basis, integrator and velocity update, or another code, its variant and nothing.
using Method = std::array<std::string, 3>;
Method method_of(const Scheme& scheme);

/// One line `key=value ...` in a fixed order with round-trip numbers, of what decides the result: where another code
/// runs, nothing of our own solver. Equal cases have equal texts.
std::string canonical_text(const Case& c);

/// 64-bit FNV-1a hash of a text in hexadecimal: a short name for people; stores compare the whole text.
std::string fingerprint(const std::string& text);

}  // namespace mpmvv::cases
