#pragma once
#include <string>
#include <vector>

namespace mpmvv::cli {

/// The words that a setting takes: problems for `problem`; empty for numbers, and for what is no setting.
std::vector<std::string> setting_words(const std::string& key);

}  // namespace mpmvv::cli
