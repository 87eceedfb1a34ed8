#include "cli/record_json.hpp"

#include <nlohmann/json.hpp>

#include "studies/cases/setting_keys.hpp"

namespace mpmvv::cli {

namespace {

/// The scheme as its keys; `none` where it has no such choice.
nlohmann::json scheme_json(const cases::Case& c) {
  nlohmann::json json;
  for (const cases::SettingKey& key : cases::setting_keys())
    if (key.member && key.member->part == cases::CasePart::scheme && key.is_of(c.scheme.code))
      std::visit([&](const auto& value) { json[key.key] = value; }, key.member->value(c));
  return json;
}

}  // namespace

nlohmann::json record_json(const records::Record& r) {
  nlohmann::json json{{"problem", r.the_case.problem.name},
                      {"quarter", r.the_case.problem.quarter},
                      {"parameters", r.the_case.problem.parameters},
                      {"scheme", scheme_json(r.the_case)},
                      {"cells", r.the_case.resolution.cells},
                      {"ppc", r.the_case.resolution.ppc},
                      {"particles", r.particles},
                      {"steps", r.steps},
                      {"dt", r.the_case.resolution.dt},
                      {"end_time", r.the_case.problem.end_time},
                      {"status", to_string(r.status)},
                      {"reason", r.reason}};
  if (records::has_own_step(r)) json["dt"] = nullptr;
  if (records::has_unknown_steps(r)) json["steps"] = nullptr;
  for (const auto* numbers : {&records::run_errors(), &records::run_by_products()})
    for (const records::RunNumber& number : *numbers) json[nlohmann::json::json_pointer(number.path)] = number.get(r);
  for (const records::ParticleError& one : r.particle_errors)
    json["particle_errors"].push_back({{"x", one.x}, {"y", one.y}, {"error", one.error}});
  if (const fits::Rounds& rounds = r.cost.rounds; !rounds.costs.empty())
    json["cost"].update({{"rounds", rounds.costs}, {"session", rounds.session}});
  return json;
}

}  // namespace mpmvv::cli
