#pragma once
#include <optional>
#include <string>

namespace mpmvv::reports {

/// A small picture, as an element of a page: the band that a criterion asks for and a dot where the number was found,
/// on a logarithmic scale where everything is positive and far apart. Empty where nothing was asked or found.
std::string criterion_bar(std::optional<double> at_least, std::optional<double> at_most, double found);

}  // namespace mpmvv::reports
