#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

using support::UsageError;

namespace {

nlohmann::json scheme_json(const cases::Scheme& s) {
  nlohmann::json json{{"basis", s.basis},
                      {"integrator", s.integrator},
                      {"velocity_update", s.velocity_update},
                      {"mass", s.mass},
                      {"boundary", s.boundary},
                      {"wall_acceleration", s.wall_acceleration},
                      {"deformation", s.deformation},
                      {"body_force", s.body_force},
                      {"fill", s.fill},
                      {"material", s.material}};
  if (s.start != "none") json["start"] = s.start;
  if (s.smoothing_length > 0) json["smoothing_length"] = s.smoothing_length;
  if (s.position != "none") json["position"] = s.position;
  if (s.order > 0) json["order"] = s.order, json["wall_method"] = s.wall_method;
  if (s.cfl_x > 0) json["cfl_x"] = s.cfl_x;
  if (s.wall_gradient != "none") json["wall_depth"] = s.wall_depth, json["wall_gradient"] = s.wall_gradient;
  return json;
}

nlohmann::json record_json(const records::Record& r) {
  const records::Errors& e = r.error;
  return {
      {"problem", r.the_case.problem.name},
      {"quarter", r.the_case.problem.quarter},
      {"parameters", r.the_case.problem.parameters},
      {"scheme", scheme_json(r.the_case.scheme)},
      {"cells", r.the_case.resolution.cells},
      {"ppc", r.the_case.resolution.ppc},
      {"particles", r.particles},
      {"steps", r.steps},
      {"dt", r.the_case.resolution.dt},
      {"cfl", r.cfl},
      {"end_time", r.the_case.problem.end_time},
      {"status", to_string(r.status)},
      {"reason", r.reason},
      {"error",
       {{"l1", e.l1},
        {"l2", e.l2},
        {"linf", e.linf},
        {"l1_all_steps", e.l1_all_steps},
        {"l2_all_steps", e.l2_all_steps},
        {"linf_all_steps", e.linf_all_steps},
        {"nodal_l1", e.nodal_l1},
        {"nodal_l2", e.nodal_l2},
        {"nodal_linf", e.nodal_linf},
        {"velocity", e.velocity},
        {"stress", e.stress}}},
      {"energy",
       {{"kinetic", r.energy.kinetic}, {"strain", r.energy.strain}, {"initial_total", r.energy.initial_total}}},
      {"balance",
       {{"mass", r.balance.mass}, {"momentum", r.balance.momentum}, {"angular_momentum", r.balance.angular_momentum}}},
      {"wall_seconds", r.wall_seconds},
      {"ns_per_particle_step", r.ns_per_particle_step},
      {"cost", {{"step_seconds", r.cost.step_seconds}, {"spread", r.cost.spread}}}};
}

std::string or_dash(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.6e}", value);
}

void print_record(const records::Record& r) {
  const cases::Scheme& s = r.the_case.scheme;
  print("{}  basis {}  integrator {}  boundary {}\n", r.the_case.problem.name, s.basis, s.integrator, s.boundary);
  print("cells {}  ppc {}  particles {}  steps {}  dt {:.6g} s  cfl {:.4g}  end time {:.6g} s\n",
        r.the_case.resolution.cells, r.the_case.resolution.ppc, r.particles, r.steps, r.the_case.resolution.dt, r.cfl,
        r.the_case.problem.end_time);
  print("status {}{}\n", to_string(r.status), r.reason.empty() ? "" : " (" + r.reason + ")");
  print("error at the end     l1 {}  l2 {}  linf {}\n", or_dash(r.error.l1), or_dash(r.error.l2),
        or_dash(r.error.linf));
  if (r.the_case.measure.every_step)
    print("error over all steps l1 {}  l2 {}  linf {}\n", or_dash(r.error.l1_all_steps), or_dash(r.error.l2_all_steps),
          or_dash(r.error.linf_all_steps));
  if (r.the_case.measure.nodal_error)
    print("error of nodal a     l1 {}  l2 {}  linf {} m/s2\n", or_dash(r.error.nodal_l1), or_dash(r.error.nodal_l2),
          or_dash(r.error.nodal_linf));
  if (r.the_case.measure.velocity_error)
    print("error of the velocity, mean over all steps {} % of the problem's speed\n", or_dash(r.error.velocity));
  if (r.the_case.measure.stress_error) print("error of the stress  l2 {} Pa\n", or_dash(r.error.stress));
  print("energy kinetic {}  strain {}  initial total {} J\n", or_dash(r.energy.kinetic), or_dash(r.energy.strain),
        or_dash(r.energy.initial_total));
  print("change of mass {}  momentum {}  angular momentum {}\n", or_dash(r.balance.mass), or_dash(r.balance.momentum),
        or_dash(r.balance.angular_momentum));
  print("{:.3g} s, {:.2f} ns per particle and step\n", r.wall_seconds, r.ns_per_particle_step);
  if (r.the_case.measure.repeat > 0)
    print("cost {} s of steps, median of {} runs (range {:.0f} %)\n", or_dash(r.cost.step_seconds),
          r.the_case.measure.repeat, 100 * r.cost.spread);
}

struct RunOptions {
  std::map<std::string, CLI::Option*> given;  ///< by setting key
  std::vector<std::string> parameters;
  std::map<std::string, CLI::Option*> flags;  ///< by setting key
  bool json = false;
  int threads = 1;
  std::string vtu;
};

int run(const RunOptions& options) {
  std::vector<settings::Setting> settings;
  for (const auto& [key, option] : options.given)
    if (option->count() > 0) settings.push_back({key, option->as<std::string>(), option->get_name()});
  for (const std::string& parameter : options.parameters) {
    settings.push_back(parameter_setting(parameter));
    const auto same = [&](const settings::Setting& earlier) { return earlier.key == settings.back().key; };
    if (std::any_of(settings.begin(), settings.end() - 1, same))
      throw UsageError(fmt::format("--param {} after another value for it (each parameter once)", parameter));
  }
  for (const auto& [key, option] : options.flags)
    if (option->count() > 0) settings.push_back({key, option->as<std::string>(), option->get_name()});
  const cases::Case c = settings::make_case(settings);
  if (c.measure.repeat > 0 && options.threads > 1)
    throw UsageError("--threads beside --repeat (cost is measured on one thread)");
  if (c.measure.repeat > 0 && !options.vtu.empty())
    throw UsageError("--vtu beside --repeat (cost is measured without writing; run twice)");
  const records::Record record = runs::run_case(c, options.threads, options.vtu);
  if (options.json)
    print_json(record_json(record));
  else
    print_record(record);
  return record.status == records::Status::failed ? 1 : 0;
}

}  // namespace

settings::Setting parameter_setting(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw UsageError(fmt::format("--param {} (name=value, as in --param amplitude=0.02)", text));
  return {"param." + text.substr(0, equals), text.substr(equals + 1), "--param"};
}

void add_run(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Run one case and print its record");
  for (const settings::SettingKey& key : settings::setting_keys()) {
    std::string name = "--" + key.key;
    std::replace(name.begin(), name.end(), '_', '-');
    if (key.is_flag)
      options->flags[key.key] = command->add_flag(name, key.meaning);
    else
      options->given[key.key] = command->add_option(name, key.meaning)->expected(1);
  }
  command->add_option("--param", options->parameters, "physical value of the problem, name=value (repeatable)");
  command->add_option("--threads", options->threads, "threads of the step")->check(CLI::Range(1, 256));
  command->add_option("--vtu", options->vtu, "write eleven particle states for ParaView to this directory");
  command->add_flag("--json", options->json, "print the record as one JSON object");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mpmvv::cli
