#include "studies/plan/claim_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <system_error>

#include "studies/plan/file_tables.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/words.hpp"

namespace mpmvv::plan {

namespace fs = std::filesystem;
using records::ClaimText;
using support::TomlTable;
using support::UsageError;

namespace {

bool say_the_same(const ClaimText& a, const ClaimText& b) {
  return a.statement == b.statement && a.source == b.source && a.where == b.where;
}

/// Claims by id. Adding one that is there in other words is a UsageError that names both places.
class ClaimsById {
 public:
  void add(const StatedClaim& claim) {
    const auto [first, is_new] = claims_.try_emplace(claim.text.id, claim);
    if (!is_new && !say_the_same(first->second.text, claim.text))
      throw UsageError(fmt::format("claim '{}' in {} says something else than in {} (state it in one of them)",
                                   claim.text.id, claim.where, first->second.where));
  }
  void add(const std::vector<StatedClaim>& claims) {
    for (const StatedClaim& claim : claims) add(claim);
  }
  const StatedClaim* find(const std::string& id) const {
    const auto found = claims_.find(id);
    return found == claims_.end() ? nullptr : &found->second;
  }
  std::set<std::string> ids() const {
    std::set<std::string> ids;
    for (const auto& [id, claim] : claims_) ids.insert(id);
    return ids;
  }

 private:
  std::map<std::string, StatedClaim> claims_;
};

std::vector<fs::path> study_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, absent))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// The claims that the study files of a folder state. Only files that contain one of `texts` are parsed.
ClaimsById claims_in(const fs::path& folder, const std::set<std::string>& texts) {
  ClaimsById claims;
  for (const fs::path& file : study_files(folder)) {
    const std::string text = support::read_file(file).value_or("");
    if (std::ranges::none_of(texts, [&](const std::string& each) { return text.find(each) != std::string::npos; }))
      continue;
    claims.add(read_claims(TomlTable::parse(text, file.string()), file.stem().string()));
  }
  return claims;
}

bool states(const StudyPlan& plan, const std::string& id) {
  return std::ranges::any_of(plan.statements, [&](const StatedClaim& claim) { return claim.text.id == id; });
}

/// Ids that the plans name and that are not among the `known` claims.
std::set<std::string> not_stated(const std::vector<StudyPlan>& plans, const ClaimsById& known) {
  std::set<std::string> ids;
  for (const StudyPlan& plan : plans)
    for (const std::string& id : plan.claims)
      if (!known.find(id)) ids.insert(id);
  return ids;
}

[[noreturn]] void fail_unknown(const std::string& id, const std::string& where, const ClaimsById& known,
                               const std::vector<fs::path>& folders) {
  std::set<std::string> ids = known.ids();
  for (const fs::path& folder : folders) ids.merge(claims_in(folder, {"[[claim]]"}).ids());
  throw UsageError(fmt::format("unknown claim '{}' in {}, which no [[claim]] states there or beside it (known: {})", id,
                               where, support::listed({ids.begin(), ids.end()})));
}

}  // namespace

std::vector<StatedClaim> read_claims(const TomlTable& root, const std::string& study) {
  std::vector<StatedClaim> claims;
  ClaimsById known;
  for (const TomlTable& table : root.tables("claim")) {
    require_known_keys(table, "claim");
    const ClaimText text{table.text("id"), table.text("statement"), table.text("source", ""), table.text("where", ""),
                         study};
    if (!support::is_file_stem(text.id))
      throw UsageError(
          fmt::format("id '{}' of a claim in {} ({})", text.id, table.where("id"), support::file_stem_rule));
    if (text.statement.empty())
      throw UsageError(fmt::format("claim '{}' in {} says nothing (one sentence that a study can judge)", text.id,
                                   table.where("statement")));
    if (const StatedClaim* first = known.find(text.id))
      throw UsageError(fmt::format("claim '{}' in {} and in {} (once)", text.id, table.where(), first->where));
    claims.push_back({text, table.where()});
    known.add(claims.back());
  }
  return claims;
}

void state_claims(std::vector<StudyPlan>& plans, const std::vector<fs::path>& folders) {
  ClaimsById known;
  for (const StudyPlan& plan : plans) known.add(plan.statements);
  std::set<std::string> missing = not_stated(plans, known);
  for (auto folder = folders.begin(); folder != folders.end() && !missing.empty(); ++folder) {
    const ClaimsById more = claims_in(*folder, missing);
    std::erase_if(missing, [&](const std::string& id) {
      const StatedClaim* claim = more.find(id);
      if (claim) known.add(*claim);
      return claim != nullptr;
    });
  }
  for (StudyPlan& plan : plans)
    for (const std::string& id : plan.claims) {
      if (states(plan, id)) continue;
      const StatedClaim* claim = known.find(id);
      if (!claim) fail_unknown(id, plan.claims_where, known, folders);
      plan.statements.push_back(*claim);
    }
}

void require_one_voice(const std::vector<StudyPlan>& plans, const std::vector<ClaimText>& stored,
                       const std::string& db) {
  for (const ClaimText& other : stored) {
    if (std::ranges::find(plans, other.study, &StudyPlan::name) != plans.end()) continue;
    for (const StudyPlan& plan : plans)
      for (const StatedClaim& own : plan.statements)
        if (own.text.id == other.id && own.text.study == plan.name && !say_the_same(own.text, other))
          throw UsageError(fmt::format(
              "claim '{}' in {} says something else than in study '{}' of {} (another id, or another store)", other.id,
              own.where, other.study, db));
  }
}

}  // namespace mpmvv::plan
