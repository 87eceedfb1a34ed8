#pragma once
#include <string>

#include "studies/codes/adapter.hpp"

namespace mpmvv::codes {

/// Returns the digest of all that the adapter's folder determines of a run: the adapter's file (`text`), the templates,
/// and the files that its commands may name as `{{adapter}}/...`. A name may be that of a folder; for fields in it any
/// text may stand.
std::string adapter_digest(const std::string& text, const Adapter& adapter);

}  // namespace mpmvv::codes
