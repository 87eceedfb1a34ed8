#pragma once
#include <string>

#include "studies/records/result.hpp"

namespace mpmvv::reports {

/// A small picture, as an element of a page: the band that a criterion asks for and a dot where one of its numbers was
/// found, with a line as far as its interval reaches. All numbers of a criterion share a scale, a logarithmic one where
/// they are positive and far apart. Empty where nothing was asked or found.
std::string criterion_bar(const records::ClaimPart& part, const records::Found& found);

}  // namespace mpmvv::reports
