#pragma once
#include <string>
#include <vector>

#include "studies/records/result.hpp"
#include "studies/store/database.hpp"
#include "studies/store/version.hpp"

/// Versions of other codes. A study names those that ran it in a line each: name, version and digest.
namespace mpmvv::store {

/// The lines of the codes that ran these series; empty where none did.
std::string code_lines(const std::vector<records::Series>& series);

/// The digest that the lines give the code; empty where they do not name it.
std::string digest_in(const std::string& lines, const records::OtherCode& code);

/// The line of a code's version.
std::string code_line(const std::string& code, const Version& version);

/// The codes that ran studies of a store, in alphabetical order.
std::vector<std::string> codes_in(const Database& database);

/// The versions of a code that ran kept studies, ordered by the time of their last study. The last version is the one
/// that is judged.
std::vector<Version> versions_of_code(const Database& database, const std::string& code);

}  // namespace mpmvv::store
