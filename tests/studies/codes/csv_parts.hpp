#pragma once
#include <sstream>
#include <string>
#include <vector>

/// CSV texts taken apart.
namespace mpmvv::codes {

inline std::vector<double> numbers(const std::string& line) {
  std::vector<double> all;
  std::istringstream text(line);
  for (std::string field; std::getline(text, field, ',');) all.push_back(std::stod(field));
  return all;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

}  // namespace mpmvv::codes
