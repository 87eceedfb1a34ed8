#include <fmt/format.h>

#include <memory>

#include "cli/checks.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/lines.hpp"
#include "cli/numbers.hpp"
#include "cli/outputs.hpp"
#include "studies/store/store.hpp"
#include "studies/store/trial.hpp"

namespace mpmvv::cli {

using store::Contents;
using store::Store;

namespace {

struct DbOptions {
  std::string db, out, study;
  std::vector<std::filesystem::path> others;
  std::size_t keep = 0;
  bool json = false;
};

nlohmann::json contents_json(const std::string& file, const Contents& contents) {
  nlohmann::json programs = nlohmann::json::array();
  for (const auto& [digest, commit, dirty, records, last] : contents.programs)
    programs.push_back(
        {{"digest", digest}, {"commit", commit}, {"dirty", dirty}, {"records", records}, {"last", last}});
  nlohmann::json codes = nlohmann::json::array();
  for (const auto& [name, versions] : contents.codes) {
    nlohmann::json known = nlohmann::json::array();
    for (const store::Version& version : versions)
      known.push_back({{"version", version.commits.front()}, {"digest", version.digest}, {"last", version.time}});
    codes.push_back({{"code", name}, {"versions", known}});
  }
  return {{"file", file},
          {"schema", contents.schema},
          {"bytes", contents.bytes},
          {"studies", contents.studies},
          {"records", contents.records},
          {"ok", contents.ok},
          {"unstable", contents.unstable},
          {"failed", contents.failed},
          {"programs", programs},
          {"codes", codes}};
}

void print_contents(const std::string& file, const Contents& contents) {
  print("file      {}\n", file);
  print("schema    {}\n", contents.schema);
  print("size      {} bytes\n", contents.bytes);
  print("studies   {}\n", contents.studies);
  print_indented(fmt::format("records   {}: {} ok, {} unstable, {} failed", contents.records, contents.ok,
                             contents.unstable, contents.failed),
                 0);
  for (const auto& [digest, commit, dirty, records, last] : contents.programs) {
    print_indented(fmt::format("digest {}", digest), 0);
    print_indented(fmt::format("commit {}{}, {}, last {}", commit, dirty ? " (dirty)" : "",
                               count_text(static_cast<std::size_t>(records), "record"), last));
  }
  for (const auto& [name, versions] : contents.codes) {
    print("code {}\n", name);
    for (const store::Version& version : versions)
      print_indented(fmt::format("{}, last study {}", label(version), version.time));
  }
}

int info(const DbOptions& options) {
  const Contents contents = Store(options.db, Store::Mode::read).contents();
  if (options.json)
    print_json(contents_json(options.db, contents));
  else
    print_contents(options.db, contents);
  return 0;
}

int check(const DbOptions& options) {
  const auto complaints = Store(options.db, Store::Mode::read).check();
  for (const std::string& complaint : complaints) print("{}\n", complaint);
  if (complaints.empty()) print("{} is sound\n", options.db);
  return complaints.empty() ? 0 : 1;
}

int merge(const DbOptions& options) {
  const std::int64_t copied = Store::merge(options.db, options.others);
  print("{} copied from {} to {}\n", count_text(static_cast<std::size_t>(copied), "record"),
        options.others.size() == 1 ? options.others[0].string() : count_text(options.others.size(), "store"),
        options.db);
  return 0;
}

int update(const DbOptions& options) {
  const Store up_to_date(options.db, Store::Mode::write);
  print("{} is up to date\n", options.db);
  return 0;
}

/// Opening the store for writing brings it up to date: a study that it lacks must be refused before.
int forget(const DbOptions& options) {
  Store::require_study(options.db, options.study);
  const std::size_t versions = Store(options.db, Store::Mode::write).forget(options.study);
  print("study {} removed from {} ({}); its runs stay\n", options.study, options.db, count_text(versions, "version"));
  return 0;
}

int prune(const DbOptions& options) {
  const Store::Pruned pruned = Store::prune(options.db, options.keep, store::current_provenance().digest);
  for (const store::Version& version : pruned.versions) print("{}, {}\n", label(version), version.time);
  const std::string size = pruned.bytes > 0
                               ? fmt::format("the file is {:.1f} MB smaller", 1e-6 * static_cast<double>(pruned.bytes))
                               : "the file keeps its size";
  print("{} removed from {}: {}, {}; {}\n", count_text(pruned.versions.size(), "version"), options.db,
        count_text(static_cast<std::size_t>(pruned.studies), "study", "studies"),
        count_text(static_cast<std::size_t>(pruned.records), "record"), size);
  if (!pruned.why_not_smaller.empty()) print("the space stays in the file: {}\n", pruned.why_not_smaller);
  return 0;
}

int print_study_file(const DbOptions& options) {
  const Store store(options.db, Store::Mode::read);
  print_text(store::without_trial(store.study_text(options.study, store::current_provenance().digest)));
  return 0;
}

int export_records(const DbOptions& options) {
  require_apart("--out", options.out, {options.db});
  const std::string csv = Store(options.db, Store::Mode::read).export_csv();
  if (options.out.empty()) {
    print_text(csv);
    return 0;
  }
  write_output("--out", options.out, csv);
  return 0;
}

}  // namespace

void add_db(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DbOptions>();
  CLI::App* db = app.add_subcommand("db", "Upkeep of a results store");
  db->require_subcommand(1);
  const auto add = [&](const char* name, const char* meaning, int (*work)(const DbOptions&),
                       const std::vector<std::string>& examples) {
    CLI::App* command = db->add_subcommand(name, meaning);
    command->add_option("--db", options->db, "results store")->required()->type_name("FILE");
    add_examples(*command, examples);
    command->callback([options, work, &exit_code] { exit_code = work(*options); });
    return command;
  };
  add("info", "Print what the store holds", &info, {"mpmvv db info --db results.db"})
      ->add_flag("--json", options->json, "print one JSON object");
  add("check", "Check the store's integrity", &check, {"mpmvv db check --db results.db"});
  add("update", "Bring a store of an earlier version of the program up to date; it runs nothing", &update,
      {"mpmvv db update --db results.db"});
  add("merge", "Copy what other stores have and this one lacks: of all of them or, where one is bad, of none", &merge,
      {"mpmvv db merge results.db --db all.db", "mpmvv db merge shard-1.db shard-2.db --db all.db"})
      ->add_option("others", options->others, "the other stores")
      ->required()
      ->type_name("FILE");
  add("forget", "Remove a study in all its versions; its runs stay, so that to run it again costs little", &forget,
      {"mpmvv db forget splines --db results.db"})
      ->add_option("study", options->study, "name of the study")
      ->required()
      ->type_name("STUDY");
  add("prune", "Remove all versions of mpmvv but the newest, by their first result; what other codes ran stays", &prune,
      {"mpmvv db prune --keep 30 --db results.db"})
      ->add_option("--keep", options->keep, "how many of the newest versions stay, beside that of the running program")
      ->check(from_to(1, 1000000))
      ->required()
      ->type_name("NUMBER");
  add("study", "Print the file of a study, as the store keeps it", &print_study_file,
      {"mpmvv db study s-fig4 --db results.db"})
      ->add_option("study", options->study, "name of the study")
      ->required()
      ->type_name("STUDY");
  add("export", "Write all records as CSV", &export_records, {"mpmvv db export --db results.db --out records.csv"})
      ->add_option("--out", options->out, "file (default: standard output)")
      ->type_name("FILE");
  add_examples(*db, {"mpmvv db info --db results.db", "mpmvv db merge results.db --db all.db"});
}

}  // namespace mpmvv::cli
