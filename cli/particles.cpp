#include <fmt/format.h>

#include <memory>

#include "cli/case_options.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/outputs.hpp"
#include "studies/codes/conditions.hpp"
#include "studies/codes/start_text.hpp"

namespace mpmvv::cli {

namespace {

struct ParticlesOptions {
  CaseOptions of_case;
  std::string csv, vtu;
  bool json = false;
};

/// Adds the elastic constants, for a law that has a Young's modulus.
void add_elasticity(nlohmann::json& json, const mms::Elasticity& material) {
  json["youngs_modulus"] = material.youngs_modulus;
  json["poissons_ratio"] = material.poissons_ratio;
  json["lambda"] = material.lambda();
  json["mu"] = material.mu();
  json["bulk_modulus"] = codes::bulk_modulus(material);
}

nlohmann::json conditions_json(const cases::Case& c, const codes::StartState& state) {
  const codes::Conditions all = codes::conditions(c);
  nlohmann::json json{{"problem", c.problem.name},
                      {"quarter", c.problem.quarter},
                      {"parameters", c.problem.parameters},
                      {"dimension", all.dimension},
                      {"body", all.body},
                      {"material", all.material},
                      {"density", all.density},
                      {"wave_speed", all.wave_speed},
                      {"cfl", all.cfl},
                      {"length", all.length},
                      {"h", all.h},
                      {"ppc", c.resolution.ppc},
                      {"particles", state.size()},
                      {"starts_at_rest", codes::is_at_rest(state, all.wave_speed)},
                      {"starts_undeformed", codes::is_undeformed(state)},
                      {"dt", all.dt},
                      {"steps", c.resolution.steps},
                      {"end_time", all.end_time}};
  if (all.elasticity) add_elasticity(json, *all.elasticity);
  nlohmann::json& boundary = json["grid"]["boundary"];
  for (std::size_t face = 0; face < all.boundary.size(); ++face)
    boundary[fmt::format("{}{}", "xyz"[face / 2], face % 2 == 0 ? "min" : "max")] = all.boundary[face];
  json["grid"]["lower"] = all.lower;
  json["grid"]["upper"] = all.upper;
  json["grid"]["cells"] = all.cells;
  return json;
}

int particles(const ParticlesOptions& options) {
  if (!options.csv.empty() && !options.vtu.empty()) require_apart("--csv", options.csv, "--vtu", options.vtu);
  const cases::Case c = options.of_case.the_case();
  const codes::StartState state = codes::start_state(c);
  if (!options.csv.empty()) write_output("--csv", options.csv, codes::csv_text(state));
  if (!options.vtu.empty()) write_output("--vtu", options.vtu, codes::vtu_text(state));
  if (options.json)
    print_json(conditions_json(c, state));
  else if (options.csv.empty() && options.vtu.empty())
    print_text(codes::csv_text(state));
  return 0;
}

}  // namespace

void add_particles(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ParticlesOptions>();
  CLI::App* command = app.add_subcommand("particles", "Write the particles that a case starts with, for other codes");
  options->of_case.add_to(*command);
  command
      ->add_option("--csv", options->csv,
                   "write them to this file; without a file they are printed. Columns, as far as the problem has the "
                   "coordinate: id; X, Y, Z, reference position in m; x, y, z, position in m; v_x, v_y, v_z, velocity "
                   "in m/s; m, mass in kg, and V, reference volume in m3, in the plane per metre across, in one "
                   "dimension per square metre; F_xx, F_xy, ..., deformation gradient")
      ->type_name("FILE");
  command->add_option("--vtu", options->vtu, "write them to this file for ParaView")->type_name("FILE");
  command->add_flag("--json", options->json,
                    "print what a code has to know beside them as one JSON object: material, wave speed, h, grid and "
                    "boundaries, time step, steps");
  add_examples(*command, {"mpmvv particles --problem square-rest --cells 8 --ppc 2 --cfl 0.2 --csv particles.csv",
                          "mpmvv particles --problem ring --cells 16 --ppc 2 --cfl 0.4 --vtu particles.vtu",
                          "mpmvv particles --problem square-rest --cells 8 --ppc 2 --cfl 0.2 --json"});
  command->callback([options, &exit_code] { exit_code = particles(*options); });
}

}  // namespace mpmvv::cli
