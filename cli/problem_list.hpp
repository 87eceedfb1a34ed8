#pragma once
#include <nlohmann/json_fwd.hpp>

namespace mpmvv::cli {

/// All problems: source, values, what their default boundary costs in order.
nlohmann::json problem_list();

/// The same for people: a table of the problems, then the values of each.
void print_problems();

}  // namespace mpmvv::cli
