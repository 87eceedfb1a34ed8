#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mms/elasticity.hpp"
#include "studies/cases/case.hpp"

namespace mpmvv::codes {

/// What a code has to know of a case besides the particles. SI units.
struct Conditions {
  int dimension = 0;
  std::string material;                       ///< the word of the material law
  double density = 0;                         ///< kg/m³
  std::optional<mms::Elasticity> elasticity;  ///< nullopt if the problem has no Young's modulus
  double wave_speed = 0;                      ///< the one in the CFL number, m/s
  double cfl = 0;                             ///< wave speed dt/h
  double length = 0;                          ///< L, m: h = L/cells
  double h = 0;                               ///< cell width, m
  double dt = 0;                              ///< s
  double end_time = 0;                        ///< number of steps times dt, s
  std::string body;                           ///< description of the body at rest
  std::vector<double> lower, upper;           ///< the background grid's corners, m; its faces are the boundaries
  std::vector<int> cells;                     ///< number of cells of the background grid along each axis
  std::vector<std::string> boundary;          ///< word of each face: xmin, xmax, ymin, ...
};

Conditions conditions(const cases::Case& c);

/// Bulk modulus λ + 2μ/3, Pa.
double bulk_modulus(const mms::Elasticity& material);

}  // namespace mpmvv::codes
