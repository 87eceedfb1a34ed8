#include "tests/mutation/mutant_schemata.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/mutation/operators.hpp"
#include "tests/mutation/tests/samples.hpp"

namespace mpmvv::mutation::mutant_schemata_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// What a program would be made of, were the choice made before it is compiled.
class Chosen {
 public:
  Chosen(const std::string& text, int number) : text_(text), number_(number) {
    at_ = text_.find('\n') + 1;
    read("");
  }
  const std::string& result() const { return result_; }

 private:
  bool take(const std::string& mark) {
    if (text_.compare(at_, mark.size(), mark) != 0) return false;
    at_ += mark.size();
    return true;
  }
  void read(const std::string& end) {
    const std::string mark = "if (mpmvv::chosen_mutant == ";
    while (at_ < text_.size()) {
      if (!end.empty() && take(end)) return;
      if (!take(mark)) {
        if (writes_) result_ += text_[at_];
        ++at_;
        continue;
      }
      const bool is_chosen = std::stoi(text_.substr(at_)) == number_;
      at_ = text_.find('\n', at_) + 1;
      const bool wrote = writes_;
      writes_ = wrote && is_chosen;
      read("\n} else {\n");
      writes_ = wrote && !is_chosen;
      read("\n}");
      writes_ = wrote;
    }
  }

  const std::string& text_;
  int number_;
  std::size_t at_ = 0;
  bool writes_ = true;
  std::string result_;
};

Edit edit_of(const std::string& text, const std::string& before, const std::string& after) {
  return {"file.cpp", text.find(before), before, after};
}

std::set<int> numbers_in(const Schemata& both) {
  std::set<int> numbers;
  for (const ChoicePlace& place : both.places) numbers.insert(place.number);
  return numbers;
}

TEST(MutantSchemata, TheHeaderIsNamedByItsWayFromTheFile) {
  const std::string text = "int f(int x) {\n  x += 1;\n  return x;\n}\n";
  Edit edit = edit_of(text, "+=", "-=");
  EXPECT_THAT(schemata_of(text, {{7, edit}}).text, StartsWith("#include \"chosen_mutant.hpp\"\n"));
  edit.file = "solver/boundary/f.cpp";
  EXPECT_THAT(schemata_of(text, {{7, edit}}).text, StartsWith("#include \"../../chosen_mutant.hpp\"\n"));
}

TEST(MutantSchemata, AStatementStandsTwice) {
  const std::string text = "int f(int x) {\n  x += 1;\n  return x;\n}\n";
  const Schemata both = schemata_of(text, {{7, edit_of(text, "+=", "-=")}});
  EXPECT_THAT(both.text, HasSubstr("chosen_mutant == 7) {\nx -= 1;\n} else {\nx += 1;\n}\n  return x;"));
  ASSERT_EQ(both.places.size(), 1U);
  EXPECT_EQ(both.places[0].first_line, 4);
  EXPECT_EQ(both.places[0].last_line, 4);
  EXPECT_EQ(both.places[0].last_line_of_both, 7);
}

TEST(MutantSchemata, WhatSeesADeclarationStandsTwiceWithIt) {
  const std::string text = "int f(int x) {\n  const int y = x + 1;\n  g(y);\n  return y;\n}\n";
  const Schemata both = schemata_of(text, {{1, edit_of(text, "+", "-")}, {2, edit_of(text, "return y", "return 0")}});
  EXPECT_THAT(both.text, HasSubstr("{\nconst int y = x - 1;\n  g(y);\n  return y;\n} else {\nconst int y = x + 1;"));
  EXPECT_EQ(Chosen(both.text, 0).result(), text);
  EXPECT_THAT(Chosen(both.text, 2).result(), HasSubstr("x + 1;\n  g(y);\n  return 0;"));
}

TEST(MutantSchemata, WhatMayDeclareTakesTheRestAlong) {
  for (const char* const statement : {"T x(1 + 2);", "auto [a, b] = f(1 + 2);", "using A = B<1 + 2>;",
                                      "std::lock_guard lock(m[1 + 2]);", "double x[1 + 2];"}) {
    const std::string text = fmt::format("void f() {{\n  {}\n  g();\n}}\n", statement);
    EXPECT_THAT(schemata_of(text, {{1, edit_of(text, "+ 2", "- 2")}}).text, HasSubstr("\n  g();\n}\n}\n")) << statement;
  }
  for (const char* const statement :
       {"x.y[0] = 1 + 2;", "f(1 + 2);", "*x += 1 + 2;", "a.b(1)->c(1 + 2);", "throw 1 + 2;"}) {
    const std::string text = fmt::format("void f() {{\n  {}\n  g();\n}}\n", statement);
    EXPECT_THAT(schemata_of(text, {{1, edit_of(text, "+ 2", "- 2")}}).text, HasSubstr("\n}\n  g();\n}\n")) << statement;
  }
}

TEST(MutantSchemata, AnEditThatDeclaresTakesTheRestAlong) {
  const std::string text = "void f() {\n  x = 1;\n  g(x);\n}\n";
  const Schemata both = schemata_of(text, {{1, edit_of(text, "x = 1", "double x = 1")}});
  EXPECT_THAT(both.text, HasSubstr("double x = 1;\n  g(x);\n} else {"));
}

TEST(MutantSchemata, ControlStatementsStayWhole) {
  const std::string text = "void f(int x) {\n  for (int i = 0; i < x; ++i) if (i > 2) g(i); else h(i + 1);\n}\n";
  const Schemata both = schemata_of(text, {{1, edit_of(text, "i < x", "i <= x")}, {2, edit_of(text, "+ 1", "- 1")}});
  EXPECT_THAT(both.text, HasSubstr("== 1) {\nfor (int i = 0; i <= x; ++i) if (i > 2) g(i); else h(i + 1);\n}"));
  EXPECT_THAT(Chosen(both.text, 2).result(), HasSubstr("else h(i - 1);"));
}

TEST(MutantSchemata, WhatIsNoPartOfABodyIsLeftOut) {
  for (const std::string text :
       {"struct A {\n  double one = 1 + 2;\n};\n", "constexpr int f(int x) {\n  return x + 2;\n}\n",
        "const double table[]{1 + 2};\n", "inline constexpr auto f = [](int x) {\n  return x + 2;\n};\n",
        "int f(int x) {\n  switch (x) {\n    case 1: int y = 1 + 2; return y;\n    default: return 0;\n  }\n}\n"})
    EXPECT_THAT(numbers_in(schemata_of(text, {{1, edit_of(text, "+ 2", "- 2")}})), IsEmpty()) << text;
}

TEST(MutantSchemata, BodiesAreFound) {
  for (const std::string text :
       {"struct A {\n  int f(int x) const noexcept {\n    return x + 2;\n  }\n};\n",
        "auto f(int x) -> std::vector<int> {\n  return {x + 2};\n}\n", "const auto f = [] {\n  return 1 + 2;\n};\n",
        "void f() {\n  if constexpr (true) {\n    static constexpr int y = 1 + 2;\n    g(y);\n  }\n}\n",
        "A::A(int x) : a_(x), b_(x) {\n  a_ = x + 2;\n}\n"})
    EXPECT_THAT(numbers_in(schemata_of(text, {{1, edit_of(text, "+ 2", "- 2")}})), Not(IsEmpty())) << text;
}

/// All mutations of a file at once, as far as they can stand side by side: most can. Campaigns leave these tests out:
/// their sources have been edited.
TEST(PlantedMistakes, StandSideBySideAsTheyAre) {
  std::size_t all = 0, placed = 0;
  const std::vector<std::string> files = mutated_files(samples::sources());
  ASSERT_GT(files.size(), 100U);
  for (std::size_t k = 0; k < files.size(); k += 16) {
    const std::string &file = files[k], text = samples::source(file);
    std::vector<Choice> choices;
    for (const Edit& edit : mutations_of(file, text)) choices.push_back({static_cast<int>(choices.size()) + 1, edit});
    const Schemata both = schemata_of(text, choices);
    const std::set<int> numbers = numbers_in(both);
    EXPECT_EQ(Chosen(both.text, 0).result(), text) << file;
    for (const Choice& choice : choices)
      if (numbers.contains(choice.number)) {
        ASSERT_EQ(Chosen(both.text, choice.number).result(), edited(choice.edit, text)) << file;
      }
    all += choices.size();
    placed += numbers.size();
  }
  EXPECT_GT(all, 100U);
  EXPECT_GT(placed, all / 2);
}

}  // namespace mpmvv::mutation::mutant_schemata_test
