#pragma once
#include <stdexcept>
#include <string>

#include "solver/scene.hpp"
#include "studies/cases/scheme.hpp"

/// Functions that turn the choices of a scheme into the enumerations of the solver. A new choice does not compile until
/// it is added here, too.
namespace mpmvv::runs {

[[noreturn]] inline void fail_without(const std::string& what) {
  throw std::logic_error("a scheme without " + what);
}

inline solver::FlipPosition for_solver(cases::Position chosen) {
  switch (chosen) {
    case cases::Position::first_order:
      return solver::FlipPosition::first_order;
    case cases::Position::second_order:
      return solver::FlipPosition::second_order;
    case cases::Position::particle:
      return solver::FlipPosition::particle;
    case cases::Position::none:
      break;
  }
  fail_without("a position");
}

inline solver::WallMethod for_solver(cases::WallMethod chosen) {
  switch (chosen) {
    case cases::WallMethod::velocity:
      return solver::WallMethod::velocity;
    case cases::WallMethod::lumped:
      return solver::WallMethod::lumped;
    case cases::WallMethod::combined:
      return solver::WallMethod::combined;
    case cases::WallMethod::elimination:
      return solver::WallMethod::elimination;
    case cases::WallMethod::none:
      break;
  }
  fail_without("a wall method");
}

inline solver::WallGradient for_solver(cases::WallGradient chosen) {
  switch (chosen) {
    case cases::WallGradient::zero:
      return solver::WallGradient::zero;
    case cases::WallGradient::given:
      return solver::WallGradient::given;
    case cases::WallGradient::estimated:
      return solver::WallGradient::estimated;
    case cases::WallGradient::none:
      break;
  }
  fail_without("a wall gradient");
}

inline solver::Deformation for_solver(cases::Deformation chosen) {
  switch (chosen) {
    case cases::Deformation::linear:
      return solver::Deformation::linear;
    case cases::Deformation::exponential:
      return solver::Deformation::exponential;
  }
  fail_without("an update of F");
}

inline solver::BodyForceOn for_solver(cases::BodyForce chosen) {
  switch (chosen) {
    case cases::BodyForce::particles:
      return solver::BodyForceOn::particles;
    case cases::BodyForce::grid:
      return solver::BodyForceOn::grid;
  }
  fail_without("a place for the body force");
}

}  // namespace mpmvv::runs
