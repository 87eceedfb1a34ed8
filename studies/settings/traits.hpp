#pragma once
#include <functional>
#include <string>
#include <vector>

#include "solver/basis/bases.hpp"
#include "solver/integrator/integrators.hpp"
#include "solver/material/materials.hpp"
#include "solver/velocity_update/velocity_updates.hpp"
#include "studies/settings/named.hpp"

/// Properties of bases, integrators, velocity updates and materials. Rules ask for these and so need not name any of
/// them.
namespace mpmvv::settings {

inline bool takes_smoothing_length(const solver::AnyBasis& basis) {
  return std::visit(
      [](const auto& b) {
        return requires {
          b.smoothing_length;
        };
      },
      basis);
}

inline bool takes_position(const solver::AnyVelocityUpdate& update) {
  return std::visit(
      [](const auto& u) {
        return requires {
          u.position;
        };
      },
      update);
}

inline bool takes_interval(const solver::AnyVelocityUpdate& update) {
  return std::visit(
      [](const auto& u) {
        return requires {
          u.interval;
        };
      },
      update);
}

inline bool keeps_history(const solver::AnyMaterial& material) {
  return std::visit([]<class M>(const M&) { return solver::has_history<M>; }, material);
}

/// Returns the words of the integrators that have a property, which a message offers to the user.
template <class Property>
std::vector<std::string> integrators_with(const Property& property) {
  std::vector<std::string> words;
  for (const solver::Integrator& integrator : solver::integrators())
    if (std::invoke(property, integrator)) words.emplace_back(integrator.word);
  return words;
}

}  // namespace mpmvv::settings
