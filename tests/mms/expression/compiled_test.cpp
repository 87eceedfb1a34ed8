#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/mms/expression/formula_samples.hpp"
#include "tests/own_folder.hpp"

/// The dialects of languages, by their compilers and interpreter.
namespace mpmvv::mms::expression::compiled_test {

class Compiled : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& file, const std::string& text) const { std::ofstream(folder_ / file) << text; }

  static bool has(const std::string& program) {
    return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
  }

  /// Carries out a command in the folder that prints a number for each place of each sample, and compares.
  void expect_values(const std::string& command) const {
    const std::string all = "cd '" + folder_.string() + "' && " + command + " > values";
    ASSERT_EQ(std::system(all.c_str()), 0) << all;
    std::ifstream values(folder_ / "values");
    for (const FormulaSample& sample : samples_)
      for (const double expected : sample.expected) {
        std::string word;
        ASSERT_TRUE(values >> word) << sample.what;
        ASSERT_NEAR(std::stod(word), expected, 1e-13 * sample.scale()) << sample.what;
      }
  }

  const std::vector<FormulaSample> samples_ = formula_samples(false);

 private:
  const std::filesystem::path folder_ = own_folder("expressions");
};

/// The seven values of a place, in order.
std::string numbers(const std::vector<double>& place) {
  std::ostringstream text;
  text.precision(17);
  for (const double& value : place) text << (&value == &place.front() ? "" : ", ") << value;
  return text.str();
}

TEST_F(Compiled, ByACCompiler) {
  std::ostringstream source, names, places;
  source << "#include <math.h>\n#include <stdio.h>\n";
  for (std::size_t n = 0; n < samples_.size(); ++n) {
    source << "static double f" << n
           << "(double X, double Y, double Z, double x, double y, double z, double t) {\n"
              "  (void)X, (void)Y, (void)Z, (void)x, (void)y, (void)z, (void)t;\n  return "
           << text(samples_[n].formula, dialect("c")) << ";\n}\n";
    for (const PlaceAndTime& place : samples_[n].places) {
      names << 'f' << n << ", ";
      places << numbers({place.begin(), place.end()}) << '\n';
    }
  }
  source << "static double (*const f[])(double, double, double, double, double, double, double) = {" << names.str()
         << "};\nint main(void) {\n  double p[7];\n  for (unsigned k = 0; k < sizeof f / sizeof *f; ++k) {\n"
            "    for (int d = 0; d < 7; ++d) scanf(\"%lf,\", &p[d]);\n"
            "    printf(\"%.17g\\n\", f[k](p[0], p[1], p[2], p[3], p[4], p[5], p[6]));\n  }\n  return 0;\n}\n";
  write("values.c", source.str());
  write("places", places.str());
  expect_values("cc -O0 values.c -o by_c -lm && ./by_c < places");
}

TEST_F(Compiled, ByPython) {
  std::ostringstream source;
  source << "from math import *\ndef show(f, places):\n    for p in places:\n        print(repr(float(f(*p))))\n";
  for (const FormulaSample& sample : samples_) {
    source << "show(lambda X, Y, Z, x, y, z, t: " << text(sample.formula, dialect("python")) << ", [";
    for (const PlaceAndTime& place : sample.places) source << "(" << numbers({place.begin(), place.end()}) << "), ";
    source << "])\n";
  }
  write("values.py", source.str());
  expect_values("python3 values.py");
}

/// Fortran does not tell X from x, so that each sample has the coordinates that are its own.
TEST_F(Compiled, ByAFortranCompiler) {
  if (!has("gfortran")) GTEST_SKIP() << "no gfortran";
  std::ostringstream functions, calls, places;
  for (std::size_t n = 0; n < samples_.size(); ++n) {
    functions << "  double precision function f" << n
              << "(x, y, z, t)\n    double precision, intent(in) :: x, y, z, t\n"
              << "    f" << n << " = " << text(samples_[n].formula, dialect("fortran")) << "\n  end function\n";
    calls << "  do k = 1, " << samples_[n].places.size() << "\n    read *, x, y, z, t\n    print '(es25.17e3)', f" << n
          << "(x, y, z, t)\n  end do\n";
    for (const PlaceAndTime& place : samples_[n].places) {
      const std::size_t first = samples_[n].is_of_reference ? 0 : 3;
      places << numbers({place[first], place[first + 1], place[first + 2], place[6]}) << '\n';
    }
  }
  write("places", places.str());
  write("values.f90", "program values\n  implicit none\n  integer :: k\n  double precision :: x, y, z, t\n" +
                          calls.str() + "contains\n" + functions.str() + "end program\n");
  expect_values("gfortran -O0 -ffree-line-length-none values.f90 -o by_fortran && ./by_fortran < places");
}

}  // namespace mpmvv::mms::expression::compiled_test
