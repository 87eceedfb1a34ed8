#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace mpmvv::runs {

/// The text of a VTK file in which each particle is a cell of its own: ASCII, 17 digits. The values of a field are
/// given as a function of particle and component.
class VtuText {
 public:
  using Component = std::function<double(std::size_t p, int k)>;

  VtuText(std::size_t particles, const Component& position);

  void add(const char* name, int components, const Component& component);
  void add_integers(const char* name, const std::function<std::int64_t(std::size_t p)>& value);

  std::string text(std::optional<double> time = {}) const;

 private:
  std::size_t particles_;
  std::string points_, data_;
};

}  // namespace mpmvv::runs
