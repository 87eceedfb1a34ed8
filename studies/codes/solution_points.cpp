#include "studies/codes/solution_points.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "studies/problems/setup.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using support::UsageError;

std::vector<std::string> solution_fields() {
  return {"u", "v", "a", "b", "F", "P", "traction"};
}

namespace {

constexpr std::string_view axis_names = "xyz";

bool is_tensor(const std::string& field) {
  return field == "F" || field == "P";
}

template <int D>
class PointTable {
 public:
  using Solution = mms::ManufacturedSolution<D>;
  using Point = mms::Vec<D>;

  PointTable(const PointQuery& query, const problems::Setup<D>& setup)
      : query_(query), setup_(setup), table_(read_csv(query.points)), fields_(query.fields) {
    for (int d = 0; d < D; ++d) X_.push_back(&column(std::string(1, "XYZ"[d])));
    choose_time();
    choose_normal();
    if (!fields_.empty()) return;
    fields_ = solution_fields();
    if (!query_.normal && N_.empty()) fields_.pop_back();
  }

  void write(const std::function<void(const std::string&)>& write) const {
    constexpr std::size_t part = 1 << 20;
    std::string text = header();
    for (std::size_t row = 0; row < X_[0]->values.size(); ++row) {
      add(text, row);
      if (text.size() < part) continue;
      write(text);
      text.clear();
    }
    write(text);
  }

 private:
  const TableColumn* find(const std::string& name) const { return only_column(table_, name, query_.points.file); }

  const TableColumn& column(const std::string& name) const {
    if (const TableColumn* found = find(name)) return *found;
    std::vector<std::string> names;
    for (const TableColumn& each : table_.columns) names.push_back(each.name);
    throw UsageError(
        fmt::format("no column '{}' in {} (it has: {})", name, query_.points.file, fmt::join(names, ", ")));
  }

  void choose_time() {
    t_ = find("t");
    if (t_ && query_.time)
      throw UsageError(fmt::format("--time beside a column t of {} (one of them)", query_.points.file));
    if (!t_ && !query_.time)
      throw UsageError(fmt::format("no time for the points of {} (--time, or a column t)", query_.points.file));
  }

  void choose_normal() {
    const bool has_columns = find("NX") != nullptr, is_given = query_.normal.has_value();
    if (has_columns && is_given)
      throw UsageError(fmt::format("--normal beside columns NX, ... of {} (one of them)", query_.points.file));
    if (has_columns)
      for (int d = 0; d < D; ++d) N_.push_back(&column(fmt::format("N{}", "XYZ"[d])));
    const bool is_asked = std::ranges::find(fields_, "traction") != fields_.end();
    if (is_asked && !has_columns && !is_given)
      throw UsageError(
          fmt::format("traction without a normal (--normal, or columns NX, ... of {})", query_.points.file));
  }

  std::string header() const {
    std::vector<std::string> names;
    for (int d = 0; d < D; ++d) names.emplace_back(1, "XYZ"[d]);
    names.emplace_back("t");
    for (const std::string& field : fields_)
      for (const char i : axis_names.substr(0, D)) {
        if (!is_tensor(field)) names.push_back(fmt::format("{}_{}", field, i));
        for (const char J : axis_names.substr(0, is_tensor(field) ? D : 0))
          names.push_back(fmt::format("{}_{}{}", field, i, J));
      }
    return fmt::format("{}\n", fmt::join(names, ","));
  }

  std::string place(std::size_t row) const { return fmt::format("{}:{}", query_.points.file, table_.lines[row]); }

  static Point vector(const std::vector<const TableColumn*>& columns, std::size_t row) {
    Point of_row;
    for (int d = 0; d < D; ++d) of_row[d] = columns[static_cast<std::size_t>(d)]->values[row];
    return of_row;
  }

  Point reference_point(std::size_t row) const {
    constexpr double round_off = 1e-12;  // m; a point so little outside the body counts as on its surface
    Point X = vector(X_, row);
    if (std::visit([&X](const auto& body) { return problems::contains(body, X, round_off); }, setup_.body)) return X;
    throw UsageError(
        fmt::format("X = {} in {} is outside the body ({})", fmt::join(X.begin(), X.end(), ","), place(row),
                    std::visit([](const auto& body) { return problems::description(body); }, setup_.body)));
  }

  Point normal(std::size_t row) const {
    const Point N = N_.empty() ? Point(Eigen::Map<const Point>(query_.normal->data())) : vector(N_, row);
    if (N.isZero(0) || !N.allFinite())
      throw UsageError(fmt::format("the normal for {} has no direction (numbers that are not all 0)", place(row)));
    return (N / N.cwiseAbs().maxCoeff()).normalized();  // squares of N may be beyond the range of doubles
  }

  void add(std::string& text, std::size_t row) const {
    const Point X = reference_point(row);
    const double t = t_ ? t_->values[row] : *query_.time;
    text += fmt::format("{:.17g}", X[0]);
    for (int d = 1; d < D; ++d) add(text, X[d], row);
    add(text, t, row);
    for (const std::string& field : fields_)
      if (is_tensor(field))
        add_tensor(text, field == "F" ? setup_.solution->F(X, t) : setup_.solution->P(X, t), row);
      else
        add_vector(text, field_at(field, X, t, row), row);
    text += '\n';
  }

  Point field_at(const std::string& field, const Point& X, double t, std::size_t row) const {
    const Solution& solution = *setup_.solution;
    if (field == "u") return solution.u(X, t);
    if (field == "v") return solution.v(X, t);
    if (field == "a") return solution.a(X, t);
    if (field == "b") return solution.b(X, t);
    return solution.traction(X, normal(row), t);
  }

  void add_vector(std::string& text, const Point& components, std::size_t row) const {
    for (int d = 0; d < D; ++d) add(text, components[d], row);
  }
  void add_tensor(std::string& text, const mms::Mat<D>& entries, std::size_t row) const {
    for (int i = 0; i < D; ++i)
      for (int J = 0; J < D; ++J) add(text, entries(i, J), row);
  }

  void add(std::string& text, double value, std::size_t row) const {
    if (!std::isfinite(value))
      throw UsageError(fmt::format("the solution is not finite in {} (a time nearer to 0)", place(row)));
    text += fmt::format(",{:.17g}", value);
  }

  const PointQuery& query_;
  const problems::Setup<D>& setup_;
  ParticleTable table_;
  std::vector<std::string> fields_;
  std::vector<const TableColumn*> X_, N_;
  const TableColumn* t_ = nullptr;
};

}  // namespace

void solution_at(const cases::ProblemChoice& choice, const PointQuery& query,
                 const std::function<void(const std::string&)>& write) {
  const problems::Problem& problem = problems::find_problem(choice.name, "the query");
  const auto of_setup = [&]<int D>(problems::SetupFunction<D>) {
    const auto setup = problems::make_setup<D>(problem, choice, 0);
    if (!setup.solution) problems::refuse_without_solution(problem);
    PointTable<D>(query, setup).write(write);
  };
  std::visit(of_setup, problem.setup);
}

}  // namespace mpmvv::codes
