#pragma once
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mms/parameter.hpp"
#include "mms/solution.hpp"

/// The solutions by name, with their parameters: for problems, and for the C interface (mms/c/mpmvv_mms.h).
namespace mpmvv::mms {

template <int D>
using Make = std::shared_ptr<ManufacturedSolution<D>> (*)(const Values&);

struct Entry {
  std::string_view name;
  std::string_view what;  ///< a description of one line, for people
  std::vector<Parameter> parameters;
  /// Returns why the parameters do not go together, though each is allowed; empty when they do. Null: they always do.
  std::string (*objection)(const Values&) = nullptr;
  std::variant<Make<1>, Make<2>, Make<3>> make;

  int dimension() const { return static_cast<int>(make.index()) + 1; }
};

/// All solutions. This is the one place where they are listed: add an entry for a new one.
const std::vector<Entry>& catalogue();

/// Thrown where no solution, or no parameter of a solution, has a given name.
struct UnknownName : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Returns the entry with this name. Throws UnknownName, whose message lists the known names.
const Entry& entry_named(std::string_view name);

/// Returns all values of the entry's parameters: the given ones, and defaults for the rest. Throws UnknownName on a
/// parameter that the entry does not have, std::invalid_argument on a value that is not allowed and on values that do
/// not go together.
Values complete(const Entry& entry, const Values& given);

/// Makes the solution with this name, which must have D dimensions. `values` must have all of its parameters.
template <int D>
std::shared_ptr<ManufacturedSolution<D>> make(std::string_view name, const Values& values) {
  return std::get<Make<D>>(entry_named(name).make)(values);
}

}  // namespace mpmvv::mms
