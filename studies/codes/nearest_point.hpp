#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "solver/types.hpp"

namespace mpmvv::codes {

struct Neighbour {
  std::size_t point;  ///< its index in the list
  double distance;
};

/// Finds the nearest one of many points.
template <int D>
class NearestPoint {
 public:
  explicit NearestPoint(const std::vector<solver::Vec<D>>& points);  ///< not empty; it must outlive this
  ~NearestPoint();

  Neighbour operator()(const solver::Vec<D>& place) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

extern template class NearestPoint<1>;
extern template class NearestPoint<2>;
extern template class NearestPoint<3>;

}  // namespace mpmvv::codes
