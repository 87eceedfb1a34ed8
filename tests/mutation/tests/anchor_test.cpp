#include "tests/mutation/anchor.hpp"

#include <gmock/gmock.h>

#include "studies/support/error.hpp"
#include "tests/mutation/mistake.hpp"

namespace mpmvv::mutation::anchor_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> files{"cli/gate.cpp",   "goldens/gate.cpp",  "mms/bar.cpp",   "solver/basis/bspline.hpp",
                                     "studies/a.toml", "tests/mms/bar.cpp", "tests/only.cpp"};

TEST(Anchors, AFileIsNamedByAsMuchOfItsPathAsItTakes) {
  EXPECT_THAT(sources_named("bspline.hpp", files), ElementsAre("solver/basis/bspline.hpp"));
  EXPECT_THAT(sources_named("goldens/gate.cpp", files), ElementsAre("goldens/gate.cpp"));
  EXPECT_THAT(sources_named("gate.cpp", files), ElementsAre("cli/gate.cpp", "goldens/gate.cpp"));
  EXPECT_THAT(sources_named("bar.cpp", files), ElementsAre("mms/bar.cpp")) << "tests are not the program";
  for (const char* none : {"spline.hpp", "a.toml", "only.cpp", ""}) EXPECT_THAT(sources_named(none, files), IsEmpty());
}

std::vector<std::string> found(const std::string& code, const std::string& text) {
  std::vector<std::string> parts;
  for (const Region& r : occurrences_of(code, text)) parts.push_back(text.substr(r.begin, r.end - r.begin));
  return parts;
}

TEST(Anchors, CodeIsFoundByItsTokens) {
  EXPECT_THAT(found("a = b + c;", "x;\n  a  =\n b+c ; y"), ElementsAre("a  =\n b+c ;"));
  EXPECT_THAT(found("b + c;", "b  // one\n + /* two */ c; d"), ElementsAre("b  // one\n + /* two */ c;"));
  EXPECT_THAT(found("a < b >= c", "a<b>=c"), ElementsAre("a<b>=c"));
  EXPECT_THAT(found("A<B<int>>", "A<B<int> > x"), ElementsAre("A<B<int> >"));
  EXPECT_THAT(found("f(\"a b\", 'c')", "f( \"a b\" ,'c') f(\"ab\", 'c')"), ElementsAre("f( \"a b\" ,'c')"));
  EXPECT_THAT(found("b + c", "b + cc; bb + c; b + c1; // b + c"), IsEmpty());
  EXPECT_THAT(found("// b", "b"), IsEmpty());
  EXPECT_EQ(found("b + c", "b + c + b + c").size(), 2U);
}

std::string nearest(const std::string& code, const std::string& text, std::size_t differing) {
  const Likeness found = most_like(code, text);
  EXPECT_EQ(found.differing, differing) << code;
  return text.substr(found.region.begin, found.region.end - found.region.begin);
}

TEST(Anchors, SimilarCodeIsFoundByTheTokensThatDiffer) {
  EXPECT_EQ(nearest("a = b + c;", "x; a = b+c; y", 0), "a = b+c;");
  EXPECT_EQ(nearest("a = b + c;", "x; a = renamed + c; y", 1), "a = renamed + c;");
  EXPECT_EQ(nearest("r = a * b + c;", "x; r = a * s.b + c; y", 2), "r = a * s.b + c;");
  EXPECT_EQ(nearest("r = a * s.b + c;", "x; r = a * b  // here\n + c; y", 2), "r = a * b  // here\n + c;");
  EXPECT_EQ(nearest("a = b + c;", "a - b + d; a = b - c;", 1), "a = b - c;");
  EXPECT_EQ(nearest("a", "", 1), "");
}

TEST(Anchors, DefinitionsAreFound) {
  const auto size_of = [](const std::string& name, const std::string& text) {
    return definitions_of(name, text).size();
  };
  for (const char* defined :
       {"int f(int x) { return x; }", "template <int D>\nauto f(const A<D>& a) const noexcept(true) -> B<D> {}",
        "A::f() : a_{1}, b_(2), c<int>{3} {\n g(); }", "const auto f = [&](int x) { return x; };",
        "const auto f = [] { return 1; };", "struct f : public A<int>, B {};", "enum class f { one };",
        "namespace f {}", "class f final {};"})
    EXPECT_EQ(size_of("f", defined), 1U) << defined;
  for (const char* used : {"int f(int x);", "a = f(1) + b;", "if (f(x)) { g(); }", "template <class f> struct A {};",
                           "for (int k = f(0); k < 2; ++k) { g(); }", "struct f;", "f x{1};", "A a = f{2};",
                           "virtual void f() = 0; int g() {}"})
    EXPECT_EQ(size_of("f", used), 0U) << used;
  EXPECT_EQ(size_of("f", "int f(int) { return 1; } int f(double) { return 2; }"), 2U);
}

const std::string two = "struct A {\n  int f(int x) {\n    return x + 1;\n  }\n};\n\nint g(int x) { return x + 1; }\n";

/// What is wrong with a mistake in `two`; empty where it can be made.
std::string complaint(const std::string& function, const std::string& find) {
  Mistake mistake{.name = "m", .file = "a.hpp", .function = function, .find = find, .replace = "0"};
  mistake.where = "planted.toml:7";
  try {
    edit_of(mistake, "solver/a.hpp", two);
  } catch (const support::UsageError& e) {
    return e.what();
  }
  return "";
}

TEST(Anchors, AFunctionOrClassMakesCodeTheOnlyOne) {
  EXPECT_THAT(complaint("", "x + 1"), HasSubstr("occurs in solver/a.hpp on lines 3 and 7 in planted.toml:7"));
  EXPECT_EQ(complaint("f", "x + 1"), "");
  EXPECT_EQ(complaint("A", "x + 1"), "");
  EXPECT_EQ(complaint("g", "x+1"), "");
  EXPECT_THAT(complaint("f", "x + 2"), HasSubstr("occurs nowhere in 'f' of solver/a.hpp in planted.toml:7"));
  EXPECT_THAT(complaint("h", "x + 1"), HasSubstr("no function or class 'h' of mistake 'm' in solver/a.hpp"));
  const Mistake mistake{.name = "m", .file = "a.hpp", .function = "g", .find = "x+1", .replace = "x - 1"};
  EXPECT_THAT(edited(edit_of(mistake, "solver/a.hpp", two), two),
              testing::EndsWith("int g(int x) { return x - 1; }\n"));
}

TEST(Anchors, AFileThatIsNoneOrTwoIsNamed) {
  const auto refusal = [](const std::string& file) -> std::string {
    try {
      file_of({.name = "m", .file = file, .where = "planted.toml:7"}, files);
    } catch (const support::UsageError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("bspline.hpp"), "");
  EXPECT_THAT(refusal("spline.hpp"), HasSubstr("no source 'spline.hpp' for mistake 'm' in planted.toml:7"));
  EXPECT_THAT(refusal("gate.cpp"), HasSubstr("is cli/gate.cpp and goldens/gate.cpp in planted.toml:7"));
}

}  // namespace mpmvv::mutation::anchor_test
