#pragma once

namespace mpmvv::solver {

/// How a wall moves along its axis, which the caller of the solver supplies. A step calls each function at most once,
/// `velocity` twice: at the step's start and end.
class WallMotion {
 public:
  virtual ~WallMotion() = default;
  virtual double position(double t) const = 0;  ///< x_wall, m
  virtual double velocity(double t) const = 0;  ///< v_b, m/s
  virtual double gradient(double t) const = 0;  ///< ∂v_b/∂x of the body at the wall, 1/s
};

}  // namespace mpmvv::solver
