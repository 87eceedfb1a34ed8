#include "studies/settings/other_code.hpp"

#include <fmt/format.h>

#include "studies/settings/validate.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings {

using support::UsageError;

void require_keys_of_code(const Settings& settings) {
  const auto given = settings.find("code");
  const std::string code = given == settings.end() ? "" : given->second.value;
  for (const SettingKey& key : setting_keys()) {
    const auto it = settings.find(key.key);
    if (it == settings.end() || key.is_of(code)) continue;
    if (code.empty())
      throw UsageError(fmt::format("{} in {} has no meaning without code (it is of another code than our own solver)",
                                   key.key, it->second.where));
    throw UsageError(
        fmt::format("{} in {} has no meaning for code '{}' (it is of our own solver; what a code does is its variant)",
                    key.key, it->second.where, code));
  }
}

void validate_other_code(const cases::Case& c, const problems::Problem& problem) {
  const auto refuse = [&](const std::string& why) {
    throw UsageError(fmt::format("problem '{}' with code '{}': {}", problem.name, c.scheme.code, why));
  };
  if (!problem.has_solution(c.problem.parameters))
    refuse("it has no exact solution, by which codes are measured (another problem)");
  if (problem.is_loaded && problem.is_loaded(c.problem.parameters))
    refuse("it needs a traction on its surface, which adapters do not give (another problem or parameters)");
  if (c.scheme.fill == cases::Fill::conforming && !problem.is_curved(c.problem.parameters))
    refuse("fill 'conforming' has no meaning for it, which a lattice fills (use lattice)");
  if (ends_between_nodes(c))
    refuse(fmt::format("its quarter on {} cells has planes of symmetry between nodes (an even number)",
                       c.resolution.cells));
  if (c.measure.stress_error && c.scheme.material != problem.material)
    refuse(fmt::format("stress_error with material '{}', of which its solution is not exact (leave it out)",
                       c.scheme.material));
  if (problem.is_one_particle) refuse("it is of our own solver's single particle (another problem)");
  if (!(c.measure.blowup_error > 0)) refuse(fmt::format("blowup_error = {} (a number > 0)", c.measure.blowup_error));
}

}  // namespace mpmvv::settings
