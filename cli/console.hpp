#pragma once
#include <fmt/format.h>

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "studies/support/printable.hpp"

namespace mpmvv::cli {

/// Writes to standard output; a UsageError where that fails.
void print_text(const std::string& text);
void flush_text();  ///< writes out what is still buffered; a UsageError where that fails

/// One JSON object, indented, to standard output. NaN and infinity become null.
void print_json(const nlohmann::json& object);

/// Writes to standard error; a failure to do so is ignored.
void note_text(const std::string& text);

/// Columns of the terminal on standard output and on standard error, where they are one.
std::optional<std::size_t> output_columns();
std::optional<std::size_t> note_columns();

/// What lines should fit: the terminal on standard output, at least 40 columns; 100 elsewhere.
std::size_t text_width();

/// Whether standard output is a terminal that shows colours, and the user wants some (NO_COLOR is not set).
bool has_colours();

/// The word, blanks around it included, in the colour of what it says: green holds, red fails, yellow is in between.
std::string coloured_verdict(const std::string& word);

/// A number as it is; a text without control sequences, as it may come from a user's file.
template <class T>
auto shown(const T& value) {
  if constexpr (std::is_arithmetic_v<T>)
    return value;
  else
    return support::printable(value);
}

template <class T>
using Shown = decltype(shown(std::declval<const T&>()));

template <class... T>
void print(fmt::format_string<Shown<T>...> format, const T&... values) {
  print_text(fmt::format(format, shown(values)...));
}

template <class... T>
void note(fmt::format_string<Shown<T>...> format, const T&... values) {
  note_text(fmt::format(format, shown(values)...));
}

}  // namespace mpmvv::cli
