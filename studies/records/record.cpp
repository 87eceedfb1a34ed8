#include "studies/records/record.hpp"

#include <new>
#include <system_error>

#include "studies/support/error.hpp"

namespace mpmvv::records {

namespace {

/// The number reached from a Record through this chain of members.
template <auto... members>
RunNumber number(int schema, const char* name, const char* path, const char* unit = "", const char* setting = "") {
  return {name,
          path,
          [](const Record& r) -> const double& { return (r.*....*members); },
          [](Record& r) -> double& { return (r.*....*members); },
          schema,
          unit,
          setting};
}

}  // namespace

const std::vector<RunNumber>& run_errors() {
  static const std::vector<RunNumber> numbers{
      number<&Record::error, &Errors::l1>(1, "l1", "/error/l1", "m"),
      number<&Record::error, &Errors::l2>(1, "l2", "/error/l2", "m"),
      number<&Record::error, &Errors::linf>(1, "linf", "/error/linf", "m"),
      number<&Record::error, &Errors::l1_all_steps>(1, "l1_all_steps", "/error/l1_all_steps", "m", "every_step"),
      number<&Record::error, &Errors::l2_all_steps>(1, "l2_all_steps", "/error/l2_all_steps", "m", "every_step"),
      number<&Record::error, &Errors::linf_all_steps>(1, "linf_all_steps", "/error/linf_all_steps", "m", "every_step"),
      number<&Record::error, &Errors::nodal_l1>(2, "nodal_l1", "/error/nodal_l1", "m/s2", "nodal_error"),
      number<&Record::error, &Errors::nodal_l2>(2, "nodal_l2", "/error/nodal_l2", "m/s2", "nodal_error"),
      number<&Record::error, &Errors::nodal_linf>(2, "nodal_linf", "/error/nodal_linf", "m/s2", "nodal_error"),
      number<&Record::error, &Errors::velocity>(4, "velocity_error", "/error/velocity", "%", "velocity_error"),
      number<&Record::error, &Errors::stress>(4, "stress_error", "/error/stress", "Pa", "stress_error"),
      number<&Record::balance, &Balance::mass>(4, "mass_change", "/balance/mass"),
      number<&Record::balance, &Balance::momentum>(4, "momentum_change", "/balance/momentum"),
      number<&Record::balance, &Balance::angular_momentum>(4, "angular_momentum_change", "/balance/angular_momentum"),
  };
  return numbers;
}

const std::vector<RunNumber>& run_by_products() {
  static const std::vector<RunNumber> numbers{
      number<&Record::energy, &Energy::kinetic>(1, "kinetic", "/energy/kinetic"),
      number<&Record::energy, &Energy::strain>(1, "strain", "/energy/strain"),
      number<&Record::energy, &Energy::initial_total>(1, "initial_total", "/energy/initial_total"),
      number<&Record::wall_seconds>(1, "wall_seconds", "/wall_seconds", "s"),
      number<&Record::ns_per_particle_step>(1, "ns_per_particle_step", "/ns_per_particle_step", "ns"),
      number<&Record::cost, &Cost::step_seconds>(3, "step_seconds", "/cost/step_seconds", "s"),
      number<&Record::cost, &Cost::spread>(3, "step_seconds_spread", "/cost/spread"),
      number<&Record::cfl>(1, "cfl", "/cfl"),
      number<&Record::images>(10, "images", "/images"),
      number<&Record::output_floor>(12, "output_floor", "/output_floor", "m"),
      number<&Record::solution_floor>(13, "solution_floor", "/solution_floor", "m"),
  };
  return numbers;
}

const std::vector<std::string>& norm_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> all{"energy_loss"};
    for (const RunNumber& number : run_errors()) all.emplace_back(number.name);
    return all;
  }();
  return words;
}

std::string unit_of_energy(int dimension) {
  constexpr const char* units[] = {"J, in 2D J/m, in 1D J/m²", "J/m²", "J/m", "J"};
  return units[dimension];
}

std::string unit_of(const std::string& quantity, int dimension) {
  if (quantity == "dt") return "s";
  if (quantity == "kinetic" || quantity == "strain" || quantity == "initial_total") return unit_of_energy(dimension);
  for (const auto* numbers : {&run_errors(), &run_by_products()})
    for (const RunNumber& number : *numbers)
      if (number.name == quantity) return number.unit;
  return "";
}

std::string with_unit(const std::string& quantity, int dimension) {
  const std::string unit = unit_of(quantity, dimension);
  return unit.empty() ? quantity : quantity + " (" + unit + ")";
}

Failure failure_of(const std::exception& e) {
  const bool of_machine = dynamic_cast<const std::bad_alloc*>(&e) != nullptr ||
                          dynamic_cast<const std::system_error*>(&e) != nullptr ||
                          dynamic_cast<const support::WriteError*>(&e) != nullptr;
  return of_machine ? Failure::of_machine : Failure::of_case;
}

}  // namespace mpmvv::records
