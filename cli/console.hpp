#pragma once
#include <fmt/format.h>

#include <string>
#include <type_traits>
#include <utility>

#include "studies/support/printable.hpp"

namespace mpmvv::cli {

/// To standard output as it is; a UsageError where it cannot be written.
void print_text(const std::string& text);
void flush_text();  ///< the same of what has been held back

/// To standard error; whether it can be written changes nothing.
void note_text(const std::string& text);

/// A number as it is; a text, which may come from a user's file, without what a terminal obeys.
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
