#pragma once
#include <string>

#include "goldens/comparison.hpp"

namespace mpmvv::cli {

/// "order of 'linear' in l2 over [16, 512]: -0.51 -> -0.49 (+0.02)": one finding of a study in two versions.
std::string change_text(const goldens::Change& change);

}  // namespace mpmvv::cli
