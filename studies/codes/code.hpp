#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "studies/cases/case.hpp"
#include "studies/codes/adapter.hpp"

namespace mpmvv::codes {

/// Another code whose program was found.
struct Code {
  Adapter adapter;
  std::filesystem::path program;
  std::string version;  ///< the version that the program prints, or a digest of its file
  std::string digest;   ///< digest of adapter and program file; it tells results apart, as a version may be forgotten
};

/// The codes that a command has found, by name.
using Codes = std::map<std::string, Code>;

/// Finds the program that the environment names, else that of the adapter; nullopt if there is none. Throws UsageError
/// if the program that the environment names cannot be run, or if a program that was found gives no version.
std::optional<Code> find_code(const Adapter& adapter);

/// Says how to get a code whose program was not found.
std::string how_to_get(const Adapter& adapter);

/// Returns the case with boundaries that the code has and with which it moves in the same way: `symmetry` for
/// `periodic` where the problem has planes of symmetry on its faces and the code has only these.
cases::Case as_given_to(const Adapter& adapter, cases::Case c);

/// Throws UsageError, which says why, if the case is beyond the capabilities of the code.
void require_able(const Adapter& adapter, const cases::Case& c);

}  // namespace mpmvv::codes
