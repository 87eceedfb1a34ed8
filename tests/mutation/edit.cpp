#include "tests/mutation/edit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace mpmvv::mutation {

std::string edited(const Edit& edit, const std::string& text) {
  if (text.compare(edit.at, edit.before.size(), edit.before) != 0)
    throw std::logic_error(fmt::format("{} does not hold '{}' at byte {}", edit.file, edit.before, edit.at));
  return text.substr(0, edit.at) + edit.after + text.substr(edit.at + edit.before.size());
}

int line_of(const std::string& text, std::size_t at) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

std::string lines_at(const std::string& text, std::size_t at, std::size_t length) {
  const std::size_t line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  const std::size_t begin = std::min(text.find_first_not_of(' ', line), at);
  const std::size_t end = std::min(text.find('\n', at + std::max<std::size_t>(length, 1) - 1), text.size());
  return text.substr(begin, end - begin);
}

}  // namespace mpmvv::mutation
