#pragma once
#include <cctype>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace mpmvv::mms {

/// What a grammar has beside + - * / ^ and parentheses: the words that the code documents.
struct Grammar {
  std::map<std::string, std::size_t> variables;  ///< and their places among the values
  std::map<std::string, std::function<double(double)>> functions;
  double (*number)(const std::string& digits);  ///< as the code reads them
  bool has_exponents;                           ///< 1e-5 is a number
  bool has_signs;                               ///< - at the start of an expression or group
};

/// Reads an expression by a grammar and evaluates it on the way. Powers bind more than signs and go from the left.
class Evaluator {
 public:
  Evaluator(const Grammar& grammar, std::string text, const auto& values)
      : grammar_(grammar), text_(std::move(text)), values_(values.begin(), values.end()) {}

  double value() {
    const double result = sum();
    if (at_ != text_.size()) fail("more than one expression");
    return result;
  }

 private:
  char next() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool takes(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(why + " at " + std::to_string(at_) + " of " + text_);
  }

  double sum() {
    double total = 0;
    if (takes('-')) {
      if (!grammar_.has_signs) fail("a sign");
      total = -product();
    } else {
      total = product();
    }
    for (;;) {
      if (takes('+'))
        total += product();
      else if (takes('-'))
        total -= product();
      else
        return total;
    }
  }

  double product() {
    double total = power();
    for (;;) {
      if (takes('*'))
        total *= power();
      else if (takes('/'))
        total /= power();
      else
        return total;
    }
  }

  double power() {
    double base = word();
    while (takes('^')) base = std::pow(base, word());
    return base;
  }

  double word() {
    if (takes('(')) return closed(sum());
    if (std::isdigit(static_cast<unsigned char>(next()))) return grammar_.number(digits());
    std::string name;
    while (std::isalnum(static_cast<unsigned char>(text_[at_]))) name += text_[at_++];
    if (takes('(')) {
      if (!grammar_.functions.contains(name)) fail("unknown function '" + name + "'");
      return grammar_.functions.at(name)(closed(sum()));
    }
    if (!grammar_.variables.contains(name)) fail("unknown variable '" + name + "'");
    return values_[grammar_.variables.at(name)];
  }

  double closed(double value) {
    if (!takes(')')) fail("no )");
    return value;
  }

  std::string digits() {
    std::size_t end = text_.find_first_not_of("0123456789.", at_);
    if (end < text_.size() && text_[end] == 'e') {
      if (!grammar_.has_exponents) fail("an exponent");
      end = text_.find_first_not_of("0123456789", end + 2);
    }
    const std::string number = text_.substr(at_, end - at_);
    at_ = std::min(end, text_.size());
    return number;
  }

  const Grammar& grammar_;
  std::string text_;
  std::vector<double> values_;
  std::size_t at_ = 0;
};

}  // namespace mpmvv::mms
