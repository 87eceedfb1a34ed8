#include "studies/support/toml_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/toml_depth.hpp"

namespace mpmvv::support {

namespace {

constexpr const char* a_number = "a finite number";
constexpr const char* a_text = "a text in quotes";
constexpr const char* a_list_of_tables = "an array of tables";

/// What the two commonest slips of the pen are, of which the parser says only where it stopped.
std::string_view hint_for(std::string_view description) {
  if (description.find("could not determine value type") != std::string_view::npos) return "; a text stands in quotes";
  if (description.find("control character") != std::string_view::npos) return "; is a closing quote missing?";
  return "";
}

std::string type_name(const toml::node& node) {
  std::ostringstream name;
  name << node.type();
  return name.str();
}

}  // namespace

struct TomlTable::Node {
  std::shared_ptr<const toml::table> document;  ///< keeps `table` alive
  const toml::table* table = nullptr;
  std::string file;

  std::string where(const toml::source_region& region) const { return fmt::format("{}:{}", file, region.begin.line); }

  TomlTable child(const toml::table& inner) const {
    return TomlTable(std::make_shared<const Node>(Node{document, &inner, file}));
  }

  const toml::node& require(const std::string& key, const char* wanted) const {
    if (const toml::node* node = table->get(key)) return *node;
    throw UsageError(fmt::format("'{}' is missing in {} ({})", key, where(table->source()), wanted));
  }

  [[noreturn]] void reject(const std::string& key, const toml::node& node, const char* wanted) const {
    throw UsageError(fmt::format("'{}' is of type {} in {} ({})", key, type_name(node), where(node.source()), wanted));
  }

  double number(const std::string& key, const toml::node& node) const {
    if (!node.is_number()) reject(key, node, a_number);
    const double value = node.is_integer() ? static_cast<double>(node.as_integer()->get())  // the nearest one
                                           : node.as_floating_point()->get();
    if (!std::isfinite(value)) {
      throw UsageError(fmt::format("'{}' is {} in {} ({})", key, value, where(node.source()), a_number));
    }
    return value;
  }

  std::string text(const std::string& key, const toml::node& node) const {
    if (!node.is_string()) reject(key, node, a_text);
    return node.as_string()->get();
  }

  const toml::array& array(const std::string& key, const toml::node& node, const char* wanted) const {
    if (!node.is_array()) reject(key, node, wanted);
    return *node.as_array();
  }
};

TomlTable TomlTable::read(const std::filesystem::path& file) {
  return parse(require_file(file, "a TOML file"), file.string());
}

TomlTable TomlTable::parse(const std::string& text, const std::string& name) {
  require_shallow(text, name);
  try {
    auto document = std::make_shared<const toml::table>(toml::parse(std::string_view(text), std::string_view(name)));
    return TomlTable(std::make_shared<const Node>(Node{document, document.get(), name}));
  } catch (const toml::parse_error& error) {
    throw UsageError(fmt::format("invalid TOML in {}:{} ({}{})", name, error.source().begin.line, error.description(),
                                 hint_for(error.description())));
  }
}

bool TomlTable::has(const std::string& key) const {
  return node_->table->contains(key);
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<const toml::key*> keys;
  for (auto&& [key, value] : *node_->table) keys.push_back(&key);
  const auto place = [](const toml::key* key) {
    const auto& begin = key->source().begin;
    return std::pair(begin.line, begin.column);
  };
  std::ranges::sort(keys, {}, place);
  std::vector<std::string> names;
  for (const toml::key* key : keys) names.emplace_back(key->str());
  return names;
}

std::string TomlTable::where() const {
  return node_->where(node_->table->source());
}

std::string TomlTable::where(const std::string& key) const {
  const toml::node* node = node_->table->get(key);
  return node ? node_->where(node->source()) : where();
}

void TomlTable::allow_only(const std::vector<std::string>& known) const {
  for (const std::string& key : keys()) {
    if (std::ranges::find(known, key) == known.end()) {
      throw UsageError(fmt::format("unknown key '{}' in {} (known: {})", key, where(key), fmt::join(known, ", ")));
    }
  }
}

std::string TomlTable::text(const std::string& key) const {
  return node_->text(key, node_->require(key, a_text));
}

std::string TomlTable::text(const std::string& key, const std::string& absent) const {
  return has(key) ? text(key) : absent;
}

double TomlTable::number(const std::string& key) const {
  return node_->number(key, node_->require(key, a_number));
}

double TomlTable::number(const std::string& key, double absent) const {
  return has(key) ? number(key) : absent;
}

bool TomlTable::flag(const std::string& key, bool absent) const {
  const toml::node* node = node_->table->get(key);
  if (!node) return absent;
  if (!node->is_boolean()) node_->reject(key, *node, "true or false");
  return node->as_boolean()->get();
}

std::vector<double> TomlTable::numbers(const std::string& key) const {
  constexpr const char* wanted = "an array of finite numbers";
  std::vector<double> values;
  for (const toml::node& element : node_->array(key, node_->require(key, wanted), wanted)) {
    values.push_back(node_->number(key, element));
  }
  return values;
}

std::vector<std::string> TomlTable::texts(const std::string& key) const {
  if (!has(key)) return {};
  constexpr const char* wanted = "an array of texts in quotes";
  std::vector<std::string> values;
  for (const toml::node& element : node_->array(key, node_->require(key, wanted), wanted)) {
    values.push_back(node_->text(key, element));
  }
  return values;
}

std::optional<TomlTable> TomlTable::table(const std::string& key) const {
  const toml::node* node = node_->table->get(key);
  if (!node) return std::nullopt;
  if (!node->is_table()) node_->reject(key, *node, "a table");
  return node_->child(*node->as_table());
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const {
  const toml::node* node = node_->table->get(key);
  if (!node) return {};
  std::vector<TomlTable> elements;
  for (const toml::node& element : node_->array(key, *node, a_list_of_tables)) {
    if (!element.is_table()) node_->reject(key, element, a_list_of_tables);
    elements.push_back(node_->child(*element.as_table()));
  }
  return elements;
}

std::string TomlTable::scalar_text(const std::string& key) const {
  constexpr const char* wanted = "a number, a text or true or false";
  const toml::node& node = node_->require(key, wanted);
  if (node.is_string()) return node_->text(key, node);
  if (node.is_boolean()) return node.as_boolean()->get() ? "true" : "false";
  if (node.is_integer()) return fmt::to_string(node.as_integer()->get());
  if (node.is_floating_point()) return fmt::to_string(node_->number(key, node));
  node_->reject(key, node, wanted);
}

}  // namespace mpmvv::support
