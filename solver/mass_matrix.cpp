#include "solver/mass_matrix.hpp"

#include <algorithm>
#include <variant>

#include "solver/kernels/add_couplings.hpp"
#include "solver/simd/doubles.hpp"
#include "solver/stencils/any_block.hpp"
#include "solver/stencils/node_boxes.hpp"
#include "solver/stencils/node_loop.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

namespace {

template <int D>
int box_width_of(const AnyBasis& basis) {
  return std::visit([]<class B>(const B&) { return box_width<BlockOf<D, B>>; }, basis);
}

}  // namespace

template <int D>
MassMatrix<D>::MassMatrix(const Step<D>& s) {
  const int reach = box_width_of<D>(s.scene().basis) - 1, L = 2 * reach + 1;
  for (int k = 0; k < power(L, D); ++k) {
    std::ptrdiff_t offset = 0;
    for (int d = 0; d < D; ++d) offset += (k / power(L, d) % L - reach) * std::ptrdiff_t{s.grid().stride(d)};
    offsets_.push_back(offset);
  }
  earlier_ = static_cast<std::size_t>(power(L, D - 1) / 2 * L);
  row_size_ = offsets_.size() - earlier_ + 1;
  margin_ = static_cast<std::size_t>(*std::max_element(offsets_.begin(), offsets_.end())) + at_once;
  const std::size_t nodes = s.grid().size() + 2 * margin_;
  rows_.resize(nodes * row_size_);
  couplings_.resize((s.grid().size() / at_once + 1) * at_once * offsets_.size());
  for (auto& component : u_) component.resize(nodes);
}

template <int D>
void MassMatrix<D>::clear() {
  if (has_couplings_) std::fill(rows_.begin(), rows_.end(), 0.0);
  has_couplings_ = false;
  fits_ = true;
}

template <int D>
bool MassMatrix<D>::assemble(Step<D>& s) {
  if (!has_couplings_) {
    clear();
    s.sweep({AddCouplings<D>{s.particles(), this}});
  }
  for (auto& component : u_) std::fill(component.begin(), component.end(), 0.0);
  s.for_nodes([this](std::size_t n) { complete(n); });
  s.for_nodes([this](std::size_t n) { std::fill_n(row_of(n), row_size_, 0.0); });
  has_couplings_ = false;
  return fits_;
}

/// Copies all couplings of a node to `couplings_`, side by side with those of the other nodes of its group of eight. M
/// is symmetric: couplings to nodes on earlier lines come from the rows of these.
template <int D>
void MassMatrix<D>::complete(std::size_t n) {
  const double* const row = row_of(n);
  double* to = &couplings_[n / at_once * at_once * offsets_.size() + n % at_once];
  const auto last = static_cast<std::ptrdiff_t>(offsets_.size() - earlier_) - 1;
  for (std::size_t k = 0; k < earlier_; ++k, to += at_once)
    *to = row[offsets_[k] * static_cast<std::ptrdiff_t>(row_size_) + last - static_cast<std::ptrdiff_t>(k)];
  for (std::size_t k = earlier_; k < offsets_.size(); ++k, to += at_once) *to = row[k - earlier_];
}

template <int D>
template <class Shape>
void MassMatrix<D>::add_block(const Shape& block, const Grid<D>& grid, const Array<double>& m) {
  constexpr int W = box_width<Shape>;
  if (!has_couplings_) has_couplings_ = true;
  NodeBoxes<D, W> boxes;
  if (!find_boxes(block, grid, boxes)) {
    fits_ = false;
    return;
  }
  for_interleaved(block.count, [&](int k) {
    add_particle<W>(boxes.N[k], m[block.begin + static_cast<std::size_t>(k)], static_cast<std::size_t>(boxes.first[k]),
                    grid);
  });
}

/// Adds m_p N_ip N_jp to the row of each node i of the box, for its own line and later ones: all j of a line at once.
template <int D>
template <int W>
void MassMatrix<D>::add_particle(const double* N, double m, std::size_t first, const Grid<D>& grid) {
  using Line = Doubles<NodeBoxes<D, W>::line>;
  constexpr int L = 2 * W - 1, width = NodeBoxes<D, W>::line, lines = NodeBoxes<D, W>::lines;
  for (int i = 0; i < lines; ++i) {
    const std::size_t node = margin_ + first + static_cast<std::size_t>(i * grid.stride(D - 1));
    double* const row = start_of_line(&rows_[node * row_size_]);
    for (int j = i; j < lines; ++j) {
      const Line partners = Line::load(N + j * width);
      double* couplings = row + L * (j - i) + W - 1;
      for (int a = 0; a < W; ++a) {
        Line sum = Line::load(couplings);
        sum += m * N[i * width + a] * partners;
        sum.store(couplings);
        couplings += row_size_ - 1;
      }
    }
  }
}

template <int D>
void MassMatrix<D>::add(Step<D>& s, const Field& u, Field& field) {
  s.for_nodes([this, &u](std::size_t n) {
    for (std::size_t d = 0; d < D; ++d) u_[d][margin_ + n] = u[n][static_cast<int>(d)];
  });
  s.for_spans_of_nodes([this, &field](std::size_t first, std::size_t end) { add_span(first, end, field); });
}

template <int D>
void MassMatrix<D>::add_span(std::size_t first, std::size_t end, Field& field) const {
  using Nodes = Doubles<at_once>;
  for (std::size_t group = first / at_once * at_once; group < end; group += at_once) {
    const double* M = &couplings_[group * offsets_.size()];
    std::array<const double*, D> u;
    std::array<Nodes, D> sum{};
    for (std::size_t d = 0; d < D; ++d) u[d] = &u_[d][margin_ + group];
    for (const std::ptrdiff_t offset : offsets_) {
      const Nodes couplings = Nodes::load(M);
      for (std::size_t d = 0; d < D; ++d) sum[d] += couplings * Nodes::load(u[d] + offset);
      M += at_once;
    }
    double sums[D][at_once];
    for (std::size_t d = 0; d < D; ++d) sum[d].store(sums[d]);
    for (std::size_t n = std::max(first, group); n < std::min(end, group + at_once); ++n)
      for (int d = 0; d < D; ++d) field[n][d] += sums[d][n - group];
  }
}

template Fault run_kernel<1>(const AddCouplings<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel<2>(const AddCouplings<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel<3>(const AddCouplings<3>&, AnyBlock<3>&, const Grid<3>&);
template class MassMatrix<1>;
template class MassMatrix<2>;

}  // namespace mpmvv::solver
