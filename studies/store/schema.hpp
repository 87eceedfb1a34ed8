#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

#include "studies/store/database.hpp"
#include "studies/store/store.hpp"

namespace mpmvv::store {

inline constexpr std::int64_t application_id = 0x4D504D56;  ///< "MPMV" in the file's header

/// The statements that lead from one schema to the next: the first makes schema 1 in an empty file, and so on. A
/// released one is never changed; a new schema is a new entry.
std::span<const char* const> migrations();

/// Opens a store. For writing it also brings the store to the newest schema, and does `work`; for a new store both are
/// one transaction. For reading the schema must be the newest. UsageError on anything that is no store of ours. When
/// opening or the work fails, everything stays as it was, except that an older schema may be up to date, and no new
/// file is left.
Database open_store(const std::filesystem::path& file, Store::Mode mode,
                    std::span<const char* const> steps = migrations(), const std::function<void(Database&)>& work = {});

/// Opens a store for reading, also one of an older schema, which stays as it is.
Database open_older_store(const std::filesystem::path& file);

}  // namespace mpmvv::store
