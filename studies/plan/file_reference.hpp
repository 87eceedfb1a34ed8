#pragma once
#include <string>
#include <vector>

#include "studies/cases/setting_keys.hpp"
#include "studies/claims/criterion.hpp"

namespace mpmvv::plan {

/// docs/study-files.md: the tables and keys of study files, the measures of criteria and the settings, as Markdown.
std::string study_file_reference();

/// The keys that a criterion of this measure may have.
std::vector<std::string> keys_of(claims::Criterion::Kind kind);

/// What counts when a study does not give the key: a word, a number or a description; empty where the key is required.
std::string without(const cases::SettingKey& key);

}  // namespace mpmvv::plan
