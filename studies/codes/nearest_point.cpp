#include "studies/codes/nearest_point.hpp"

#include <cmath>
#include <nanoflann.hpp>

namespace mpmvv::codes {

template <int D>
struct NearestPoint<D>::Tree {
  /// Gives nanoflann access to the points.
  struct Points {
    const std::vector<solver::Vec<D>>& all;

    std::size_t kdtree_get_point_count() const { return all.size(); }
    double kdtree_get_pt(std::size_t point, std::size_t axis) const { return all[point][static_cast<int>(axis)]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };

  Points points;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, D, std::size_t> index{
      D, points};
};

template <int D>
NearestPoint<D>::NearestPoint(const std::vector<solver::Vec<D>>& points) : tree_(new Tree{{points}}) {
  tree_->index.buildIndex();
}

template <int D>
NearestPoint<D>::~NearestPoint() = default;

template <int D>
Neighbour NearestPoint<D>::operator()(const solver::Vec<D>& place) const {
  Neighbour nearest{};
  tree_->index.knnSearch(place.data(), 1, &nearest.point, &nearest.distance);
  nearest.distance = std::sqrt(nearest.distance);
  return nearest;
}

template class NearestPoint<1>;
template class NearestPoint<2>;
template class NearestPoint<3>;

}  // namespace mpmvv::codes
