#include <memory>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/results.hpp"
#include "studies/claims/claim.hpp"

namespace mpmvv::cli {

namespace {

int claims(const std::string& db, bool json) {
  const auto judged = judged_claims(own_results(db), own_mutation(db));
  if (json) {
    nlohmann::json all = nlohmann::json::array();
    for (const claims::Claim& c : judged)
      all.push_back({{"id", c.id},
                     {"statement", c.statement},
                     {"source", c.source},
                     {"where", c.where},
                     {"verdict", c.verdict},
                     {"evidence", c.evidence},
                     {"studies", c.studies}});
    print_json({{"claims", all}});
    return 0;
  }
  if (judged.empty()) print("no study of this program in {} names a claim\n", db);
  for (const claims::Claim& c : judged)
    print("{:<10} {:<10} {}\n", c.id, c.verdict, c.verdict == "open" ? c.statement : c.evidence);
  return 0;
}

}  // namespace

void add_claims(CLI::App& app, int& exit_code) {
  auto db = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("claims", "Print every claim with its verdict and evidence");
  command->add_option("--db", *db, "results store")->required();
  command->add_flag("--json", *json, "print one JSON object");
  command->callback([db, json, &exit_code] { exit_code = claims(*db, *json); });
}

}  // namespace mpmvv::cli
