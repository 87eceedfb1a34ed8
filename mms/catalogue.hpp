#pragma once
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mms/parameter.hpp"
#include "mms/solution.hpp"

/// The solutions by name, with what they are made from: for problems, and for the C interface (mms/c/mpmvv_mms.h).
namespace mpmvv::mms {

template <int D>
using Make = std::shared_ptr<ManufacturedSolution<D>> (*)(const Values&);

struct Entry {
  std::string_view name;
  std::string_view what;  ///< one line for people
  std::vector<Parameter> parameters;
  /// Why the parameters do not go together, though each is allowed; empty when they do.
  std::string (*objection)(const Values&) = nullptr;
  std::variant<Make<1>, Make<2>, Make<3>> make;

  int dimension() const { return static_cast<int>(make.index()) + 1; }
};

/// The one place where they are named: add an entry for a new one.
const std::vector<Entry>& catalogue();

/// No solution, or no parameter of one, has that name.
struct UnknownName : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Throws UnknownName, with the known ones.
const Entry& entry_named(std::string_view name);

/// Defaults overwritten by the given ones. Throws UnknownName on a parameter that the entry has not,
/// std::invalid_argument on a value that is not allowed, and on values that do not go together.
Values complete(const Entry& entry, const Values& given);

/// Of D dimensions, with all of its parameters' values.
template <int D>
std::shared_ptr<ManufacturedSolution<D>> make(std::string_view name, const Values& values) {
  return std::get<Make<D>>(entry_named(name).make)(values);
}

}  // namespace mpmvv::mms
