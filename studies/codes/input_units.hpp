#pragma once

namespace mpmvv::codes {

/// The units of the numbers in a template, in m, s and kg.
struct InputUnits {
  double length = 1, time = 1, mass = 1;
  double thickness = 1;  ///< of a plane body in m, by which masses and volumes are multiplied

  double velocity() const { return length / time; }
  double volume() const { return length * length * length; }
  double density() const { return mass / volume(); }
  double pressure() const { return mass / (length * time * time); }
};

}  // namespace mpmvv::codes
