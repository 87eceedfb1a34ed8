#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "studies/cases/case.hpp"
#include "studies/codes/adapter.hpp"

namespace mpmvv::codes {

/// A code that is there.
struct Code {
  Adapter adapter;
  std::filesystem::path program;
  std::string version;  ///< that the program gives, or a digest of its file
  std::string digest;   ///< of the adapter and the program's file: it decides results, as a version may be forgotten
};

/// The codes that a command has found, by name.
using Codes = std::map<std::string, Code>;

/// The program that the environment names, or the adapter; none where it is not there. UsageError where the environment
/// names what cannot be run, or the program gives no version.
std::optional<Code> find_code(const Adapter& adapter);

/// What to do where it is not there.
std::string how_to_get(const Adapter& adapter);

/// UsageError that says why the code cannot carry out the case, where it cannot.
void require_able(const Adapter& adapter, const cases::Case& c);

}  // namespace mpmvv::codes
