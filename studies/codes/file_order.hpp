#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace mpmvv::codes {

/// Sorts files by their names, part by part: texts as texts, numbers by value. A number may have decimals, 0.008, and
/// an exponent, 1e-3.
void sort_by_name(std::vector<std::filesystem::path>& files);

/// Returns the file whose name comes last. A name such as state_1.10.csv has two readings: one decimal number, or two
/// whole numbers. Throws UsageError, which names both files, if the readings differ in the last one. Decimals are meant
/// where any name has an exponent, or zeros that would pad a whole number to more digits than others have: 0.0075
/// beside 0.008. `pattern` is what the names match, for the message. There is at least one file.
std::filesystem::path last_by_name(const std::vector<std::filesystem::path>& files, const std::string& pattern);

}  // namespace mpmvv::codes
