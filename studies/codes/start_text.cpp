#include "studies/codes/start_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "studies/runs/vtu_text.hpp"

namespace mpmvv::codes {

std::vector<std::string> start_columns(int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  const std::string_view reference = "XYZ", current = "xyz";
  std::vector<std::string> names{"id"};
  for (const char axis : reference.substr(0, d)) names.emplace_back(1, axis);
  for (const char axis : current.substr(0, d)) names.emplace_back(1, axis);
  for (const char axis : current.substr(0, d)) names.push_back(fmt::format("v_{}", axis));
  names.insert(names.end(), {"m", "V"});
  for (const char row : current.substr(0, d))
    for (const char column : current.substr(0, d)) names.push_back(fmt::format("F_{}{}", row, column));
  return names;
}

std::string csv_text(const StartState& state) {
  const auto d = static_cast<std::size_t>(state.dimension);
  std::string text = fmt::format("{}\n", fmt::join(start_columns(state.dimension), ","));
  const auto add = [&](double value) { text += fmt::format(",{:.17g}", value); };
  for (std::size_t p = 0; p < state.size(); ++p) {
    text += fmt::format("{}", state.id[p]);
    for (const auto* vector : {&state.X[p], &state.x[p], &state.v[p]})
      for (std::size_t k = 0; k < d; ++k) add((*vector)[k]);
    add(state.m[p]);
    add(state.V[p]);
    for (std::size_t i = 0; i < d; ++i)
      for (std::size_t j = 0; j < d; ++j) add(state.F[p][3 * i + j]);
    text += '\n';
  }
  return text;
}

std::string vtu_text(const StartState& state) {
  const auto of = [](const auto& fields) {
    return [&fields](std::size_t p, int k) { return fields[p][static_cast<std::size_t>(k)]; };
  };
  runs::VtuText file(state.size(), of(state.x));
  file.add_integers("id", [&](std::size_t p) { return state.id[p]; });
  file.add("reference_position", 3, of(state.X));
  file.add("velocity", 3, of(state.v));
  file.add("mass", 1, [&](std::size_t p, int) { return state.m[p]; });
  file.add("reference_volume", 1, [&](std::size_t p, int) { return state.V[p]; });
  file.add("deformation_gradient", 9, of(state.F));
  return file.text();
}

}  // namespace mpmvv::codes
