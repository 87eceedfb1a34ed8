#include <fmt/format.h>

#include "studies/store/run_rows.hpp"
#include "studies/store/schema.hpp"
#include "studies/store/study_rows.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::store {

namespace fs = std::filesystem;

namespace {

void require_another(const fs::path& file, const fs::path& other) {
  if (std::error_code absent; fs::equivalent(other, file, absent))
    throw support::UsageError(fmt::format("results store '{}' merged into itself (name another store)", file.string()));
}

std::int64_t copy(const fs::path& other, Database& to) {
  Database from = open_store(other, Store::Mode::read);
  Transaction one_state(from, Transaction::Kind::read);
  const std::int64_t copied = copy_runs(from, to);
  copy_studies(from, to);
  return copied;
}

}  // namespace

std::int64_t Store::merge(const fs::path& file, std::span<const fs::path> others) {
  for (const fs::path& other : others) require_another(file, other);
  std::int64_t copied = 0;
  open_store(file, Mode::create_or_write, migrations(), [&](Database& to) {
    to.execute("PRAGMA cache_size = -400000");  // kB: runs arrive in no order of their keys and touch all of the index
    for (const fs::path& other : others) copied += copy(other, to);
  });
  return copied;
}

}  // namespace mpmvv::store
