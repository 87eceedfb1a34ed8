#pragma once
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "studies/settings/settings.hpp"

namespace mpmvv::cli {

/// Each command adds itself to the program: its options, and a callback that does the work and sets `exit_code`.
void add_run(CLI::App& app, int& exit_code);
void add_solution(CLI::App& app, int& exit_code);
void add_particles(CLI::App& app, int& exit_code);
void add_expression(CLI::App& app, int& exit_code);
void add_case(CLI::App& app, int& exit_code);
void add_score(CLI::App& app, int& exit_code);
void add_study(CLI::App& app, int& exit_code);
void add_submit(CLI::App& app, int& exit_code);
void add_gate(CLI::App& app, int& exit_code);
void add_propose(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);
void add_figure(CLI::App& app, int& exit_code);
void add_paper(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_trend(CLI::App& app, int& exit_code);
void add_cost(CLI::App& app, int& exit_code);
void add_claims(CLI::App& app, int& exit_code);
void add_list(CLI::App& app, int& exit_code);
void add_db(CLI::App& app, int& exit_code);
void add_manual(CLI::App& app, int& exit_code);

/// What `mpmvv list` can list.
std::vector<std::string> list_names();

/// `--param k=v` as a setting; UsageError when it has not that form.
settings::Setting parameter_setting(const std::string& text);

}  // namespace mpmvv::cli
