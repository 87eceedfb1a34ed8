#include "studies/store/seal.hpp"

#include <fmt/format.h>

#include <array>
#include <boost/crc.hpp>
#include <utility>
#include <variant>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::store {

namespace {

/// CRC-64/XZ.
using Crc = boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xFFFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF, true, true>;

void add(Crc& crc, const std::string& text) {
  const std::size_t size = text.size();
  crc.process_bytes(&size, sizeof size);
  crc.process_bytes(text.data(), size);
}

void add(Crc& crc, const Value& value) {
  const std::size_t kind = value.held().index();
  crc.process_bytes(&kind, sizeof kind);
  std::visit(
      [&](const auto& held) {
        using Held = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<Held, std::string>)
          add(crc, held);
        else if constexpr (!std::is_same_v<Held, std::monostate>)
          crc.process_bytes(&held, sizeof held);
      },
      value.held());
}

void add(Crc& crc, const Row& row) {
  for (std::size_t i = 0; i < row.names().size(); ++i) {
    if (row.names()[i] == "seal" || row.values()[i].null()) continue;
    add(crc, row.names()[i]);
    add(crc, row.values()[i]);
  }
}

struct SealedTable {
  const char* name;
  const char* label;                    ///< column that names it in a message
  std::vector<std::string> rows;        ///< what the seal of the row with id ?1 covers
  std::vector<std::string> later_rows;  ///< of tables younger than the first seals: covered where there are any
};

std::vector<std::string> rows_of_study() {
  const std::string series = "(SELECT id FROM series WHERE study = ?1)";
  const std::string points = "(SELECT id FROM points WHERE series IN " + series + ")";
  const std::string fits = "(SELECT id FROM fits WHERE series IN " + series + ")";
  const std::string figures = "(SELECT id FROM figures WHERE study = ?1)";
  return {"studies WHERE id = ?1",
          "provenance WHERE id = (SELECT provenance FROM studies WHERE id = ?1)",
          "study_claims WHERE study = ?1 ORDER BY ordinal",
          "claim_parts WHERE study = ?1 ORDER BY ordinal",
          "check_values WHERE study = ?1 ORDER BY ordinal",
          "series WHERE study = ?1 ORDER BY ordinal",
          "points WHERE series IN " + series + " ORDER BY series, ordinal",
          "point_values WHERE point IN " + points + " ORDER BY point, quantity",
          "point_replicates WHERE point IN " + points + " ORDER BY point, quantity, ordinal",
          "fits WHERE series IN " + series + " ORDER BY series, ordinal",
          "segments WHERE fit IN " + fits + " ORDER BY fit, ordinal",
          "limits WHERE series IN " + series + " ORDER BY series",
          "probes WHERE series IN " + series + " ORDER BY series, ordinal",
          "extrapolations WHERE series IN " + series + " ORDER BY series, ordinal",
          "figures WHERE study = ?1 ORDER BY ordinal",
          "figure_series WHERE figure IN " + figures + " ORDER BY figure, ordinal",
          "figure_marks WHERE figure IN " + figures + " ORDER BY figure, ordinal",
          "figure_slopes WHERE figure IN " + figures + " ORDER BY figure, ordinal"};
}

const SealedTable& table_of(Sealed kind) {
  static const std::array<SealedTable, 2> tables{
      {{"runs",
        "problem",
        {"runs WHERE id = ?1", "provenance WHERE id = (SELECT provenance FROM runs WHERE id = ?1)"},
        {}},
       {"studies", "name", rows_of_study(), {"claim_found WHERE study = ?1 ORDER BY part, ordinal"}}}};
  return tables[static_cast<std::size_t>(kind)];
}

constexpr std::array all_kinds{Sealed::run, Sealed::study};

std::int64_t seal_of(const Database& database, const SealedTable& table, const Value& id) {
  Crc crc;
  for (const std::string& rows : table.rows) {
    add(crc, rows);
    database.each("SELECT * FROM " + rows, {id}, [&](const Row& row) { add(crc, row); });
  }
  for (const std::string& rows : table.later_rows) {
    bool first = true;
    database.each("SELECT * FROM " + rows, {id}, [&](const Row& row) {
      if (std::exchange(first, false)) add(crc, rows);
      add(crc, row);
    });
  }
  return static_cast<std::int64_t>(crc.checksum());
}

bool is_intact(const Database& database, const SealedTable& table, const Value& id) {
  const Value kept = database.scalar(fmt::format("SELECT seal FROM {} WHERE id = ?", table.name), {id});
  return kept.held() == Value(seal_of(database, table, id)).held();
}

/// The message on a broken seal. It shows the name only where that is sound, as damage can make anything of it.
std::string complaint(const Database& database, const SealedTable& table, const Value& id) {
  const std::string name =
      database.scalar(fmt::format("SELECT {} FROM {} WHERE id = ?", table.label, table.name), {id}).to_string();
  return fmt::format("row {} of {} ({}) is not as it was written", id.to_string(), table.name,
                     support::is_file_stem(name) ? name : "without a name");
}

std::vector<Value> ids(const Database& database, const SealedTable& table) {
  std::vector<Value> all;
  database.each(fmt::format("SELECT id FROM {} NOT INDEXED", table.name), {},
                [&](const Row& row) { all.push_back(row["id"]); });
  return all;
}

/// Whether the row is still there: since its id was read another program may have removed it.
bool is_there(const Database& database, const SealedTable& table, const Value& id) {
  return database.scalar(fmt::format("SELECT count(*) FROM {} WHERE id = ?", table.name), {id}).flag();
}

}  // namespace

void seal(Database& database, Sealed kind, std::int64_t id) {
  const SealedTable& table = table_of(kind);
  database.change(fmt::format("UPDATE {} SET seal = ? WHERE id = ?", table.name), {seal_of(database, table, id), id});
}

std::int64_t seal_of_run(const Row& run, const Row& provenance) {
  const std::vector<std::string>& rows = table_of(Sealed::run).rows;
  Crc crc;
  add(crc, rows[0]);
  add(crc, run);
  add(crc, rows[1]);
  add(crc, provenance);
  return static_cast<std::int64_t>(crc.checksum());
}

void seal_all(Database& database) {
  for (const Sealed kind : all_kinds)
    for (const Value& id : ids(database, table_of(kind))) seal(database, kind, id.integer());
}

void require_intact(const Database& database, Sealed kind, const Value& id) {
  if (const SealedTable& table = table_of(kind); !is_intact(database, table, id))
    database.fail_damaged(complaint(database, table, id) + "; `mpmvv db check` lists all that is not");
}

void require_intact_run(const Database& database, const Row& run) {
  bool is_intact = false;
  database.each("SELECT * FROM provenance WHERE id = ?", {run["provenance"]}, [&](const Row& provenance) {
    is_intact = run["seal"].held() == Value(seal_of_run(run, provenance)).held();
  });
  if (!is_intact) require_intact(database, Sealed::run, run["id"]);
}

std::vector<std::string> broken_seals(Database& database) {
  std::vector<std::string> broken;
  for (const Sealed kind : all_kinds)
    for (const Value& id : ids(database, table_of(kind))) try {
        const Transaction one_state(database, Transaction::Kind::read);
        if (is_there(database, table_of(kind), id) && !is_intact(database, table_of(kind), id))
          broken.push_back(complaint(database, table_of(kind), id));
      } catch (const support::UsageError& e) {
        broken.emplace_back(e.what());
      }
  return broken;
}

}  // namespace mpmvv::store
