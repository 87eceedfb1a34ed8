#pragma once

namespace mpmvv::solver {

/// How a wall moves along its axis, as the caller of the solver supplies it. Asked once per step.
class WallMotion {
 public:
  virtual ~WallMotion() = default;
  virtual double position(double t) const = 0;  ///< x_wall, m
  virtual double velocity(double t) const = 0;  ///< v_b, m/s
  virtual double gradient(double t) const = 0;  ///< ∂v_b/∂x of the body there, 1/s
};

}  // namespace mpmvv::solver
