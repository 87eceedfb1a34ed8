#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "solver/integrator/integrators.hpp"
#include "solver/velocity_update/velocity_updates.hpp"

/// Velocity updates for the properties that all of them have: a new one is among them as soon as it is named.
namespace mpmvv::solver {

/// Adds an update as the list has it, or where it leaves something to choose, by several choices.
template <class Update>
void add_choices(std::vector<AnyVelocityUpdate>& all) {
  Update update;
  const auto add = [&](auto& choice, const auto& values) {
    for (const auto value : values) choice = value, all.emplace_back(update);
  };
  if constexpr (requires { update.position; })
    add(update.position, std::array{FlipPosition::first_order, FlipPosition::second_order, FlipPosition::particle});
  else if constexpr (requires { update.order; })
    add(update.order, std::array{1, 2, 8});
  else
    all.emplace_back(update);
  if constexpr (requires { update.interval; }) add(update.interval, std::array{3});
}

inline std::vector<AnyVelocityUpdate> every_velocity_update() {
  std::vector<AnyVelocityUpdate> all;
  const auto add = [&all]<class... Updates>(const std::variant<Updates...>*) { (add_choices<Updates>(all), ...); };
  add(static_cast<const AnyVelocityUpdate*>(nullptr));
  return all;
}

/// What a failure says of one.
inline std::string name_of(const AnyVelocityUpdate& update) {
  return std::visit(
      []<class Update>(const Update& own) {
        std::string name(Update::word);
        if constexpr (requires { own.position; }) name += " " + std::to_string(static_cast<int>(own.position));
        if constexpr (requires { own.order; }) name += " " + std::to_string(own.order);
        return name;
      },
      update);
}

/// Those that take any velocity update: the others want positions and velocities elsewhere than at the ends of a step.
inline std::vector<std::string_view> integrators_of_whole_steps() {
  std::vector<std::string_view> words;
  for (const Integrator& integrator : integrators())
    if (!integrator.is_staggered && !integrator.is_staged) words.push_back(integrator.word);
  return words;
}

}  // namespace mpmvv::solver
