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

/// Opens a store and brings it to the newest schema, a new one in one transaction with the first work on it, if there
/// is some. UsageError on anything that is no store of ours; where that or the work fails all stays as it is, but for
/// an older schema, and no new file is left.
Database open_store(const std::filesystem::path& file, Store::Mode mode,
                    std::span<const char* const> steps = migrations(), const std::function<void(Database&)>& work = {});

}  // namespace mpmvv::store
