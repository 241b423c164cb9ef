#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

#include "plastica/model/torsion.hpp"

namespace plastica {
namespace {

/// Grid lines along one axis of the quarter section, [0, hole] and [hole, outer], with
/// `elements` elements in each part and small ones at the hole's corner.
///
/// The stress at the corner grows like distance^(-1/3). Spacing distance ~ (i/n)^p with p > 3/2
/// restores the full order of bilinear elements there, so that errors fall by 4 from grid to grid
/// and Richardson's extrapolation applies.
std::vector<double> graded_lines(double hole, double outer, int elements) {
  constexpr double kGrading = 2.5;
  std::vector<double> lines;
  lines.reserve(static_cast<std::size_t>(2 * elements + 1));
  const auto graded = [&](int i) { return std::pow(static_cast<double>(i) / elements, kGrading); };
  for (int i = elements; i > 0; --i) lines.push_back(hole * (1.0 - graded(i)));
  for (int i = 0; i <= elements; ++i) lines.push_back(hole + (outer - hole) * graded(i));
  return lines;
}

/// One quarter, x in [0, b/2], y in [0, h/2]; unknown 0 is phi over the whole hole.
class QuarterSection {
 public:
  QuarterSection(const BoxDimensions& box, int elements)
      : elements_(elements),
        x_(graded_lines(box.inner_width / 2.0, box.width / 2.0, elements)),
        y_(graded_lines(box.inner_height / 2.0, box.height / 2.0, elements)) {}

  struct Solution {
    Eigen::VectorXd phi;    ///< (unknowns)
    double constant = 0.0;  ///< J [m^4]
  };

  BoxTorsion torsion(const Solution& found) const {
    return {.constant = found.constant, .modulus = found.constant / largest_stress(found.phi)};
  }

  /// Slope of phi at a point of the wall.
  double slope_at(const Eigen::VectorXd& phi, const std::array<double, 2>& point) const {
    const double x = std::fabs(point[0]);
    const double y = std::fabs(point[1]);
    const std::size_t i = interval(x_, x);
    const std::size_t j = interval(y_, y);
    const Element e = element(i, j);
    const double dx = x_[i + 1] - x_[i];
    const double dy = y_[j + 1] - y_[j];
    const double u = (x - x_[i]) / dx;
    const double v = (y - y_[j]) / dy;
    std::array<double, 4> corner{};
    for (std::size_t p = 0; p < 4; ++p) corner[p] = value(phi, e.unknown[p]);
    const double by_x = ((corner[1] - corner[0]) * (1.0 - v) + (corner[3] - corner[2]) * v) / dx;
    const double by_y = ((corner[2] - corner[0]) * (1.0 - u) + (corner[3] - corner[1]) * u) / dy;
    return std::hypot(by_x, by_y);
  }

  Solution solve() const {
    const Eigen::Index n = unknowns();
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
    for_each_element([&](const Element& e) {
      for (std::size_t i = 0; i < 4; ++i) {
        if (e.unknown[i] < 0) continue;
        load[e.unknown[i]] += e.load;
        for (std::size_t j = 0; j < 4; ++j) {
          if (e.unknown[j] >= 0)
            entries.emplace_back(e.unknown[i], e.unknown[j], e.stiffness[i][j]);
        }
      }
    });
    Eigen::SparseMatrix<double> stiffness(n, n);
    stiffness.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(stiffness);
    if (factors.info() != Eigen::Success) {
      throw std::runtime_error("torsion of a rectangular tube: the factorization failed");
    }
    Solution found{factors.solve(load)};
    // J = 2 integral(phi) over the whole section, four quarters; the load is 2 integral(N_i).
    found.constant = 4.0 * load.dot(found.phi);
    return found;
  }

 private:
  struct Element {
    std::array<Eigen::Index, 4> unknown{};  ///< of the corners; -1: phi = 0
    std::array<std::size_t, 4> column{};    ///< of the corners
    std::array<std::size_t, 4> row{};
    std::array<std::array<double, 4>, 4> stiffness{};
    double load = 0.0;  ///< the same for each corner
  };

  static double value(const Eigen::VectorXd& phi, Eigen::Index unknown) {
    return unknown < 0 ? 0.0 : phi[unknown];
  }

  static std::size_t interval(const std::vector<double>& lines, double at) {
    const auto after = std::upper_bound(lines.begin() + 1, lines.end() - 1, at);
    return static_cast<std::size_t>(after - lines.begin()) - 1;
  }

  /// Unknowns are numbered densely: 0 for the hole, then the nodes beside it (i <= n, j > n), then
  /// those beyond (i > n), without the outer lines i = 2n and j = 2n where phi = 0.
  Eigen::Index node(int i, int j) const {
    const int n = elements_;
    const int last = 2 * n;
    if (i == last || j == last) return -1;
    if (i <= n && j <= n) return 0;
    if (i <= n) return 1 + i * (n - 1) + (j - n - 1);
    return 1 + (n + 1) * (n - 1) + (i - n - 1) * last + j;
  }

  Eigen::Index unknowns() const { return node(2 * elements_ - 1, 2 * elements_ - 1) + 1; }

  template <typename Visit>
  void for_each_element(const Visit& visit) const {
    const auto count = static_cast<std::size_t>(2 * elements_);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) visit(element(i, j));
    }
  }

  Element element(std::size_t i, std::size_t j) const {
    const double dx = x_[i + 1] - x_[i];
    const double dy = y_[j + 1] - y_[j];
    Element e;
    e.load = 2.0 * dx * dy / 4.0;
    e.column = {i, i + 1, i, i + 1};
    e.row = {j, j, j + 1, j + 1};
    for (std::size_t p = 0; p < 4; ++p) {
      e.unknown[p] = node(static_cast<int>(e.column[p]), static_cast<int>(e.row[p]));
      for (std::size_t q = 0; q < 4; ++q) {
        const bool same_x = e.column[p] == e.column[q];
        const bool same_y = e.row[p] == e.row[q];
        // Products of the one-dimensional stiffness (+-1/d) and mass (d/3, d/6) matrices.
        e.stiffness[p][q] = (same_x ? 1.0 : -1.0) / dx * (same_y ? dy / 3.0 : dy / 6.0) +
                            (same_y ? 1.0 : -1.0) / dy * (same_x ? dx / 3.0 : dx / 6.0);
      }
    }
    return e;
  }

  /// The larger stress (per G theta) at the middles of the outer sides, from the weighted residual
  /// of the boundary node: integral(tau N ds) = load - stiffness phi, with integral(N ds) half the
  /// width of the adjacent element. Of higher order than the slope of the element.
  double largest_stress(const Eigen::VectorXd& phi) const {
    const std::size_t last = x_.size() - 1;
    const double top = residual(element(0, last - 1), 0, last, phi) / ((x_[1] - x_[0]) / 2.0);
    const double side = residual(element(last - 1, 0), last, 0, phi) / ((y_[1] - y_[0]) / 2.0);
    return std::max(top, side);
  }

  static double residual(const Element& e, std::size_t column, std::size_t row,
                         const Eigen::VectorXd& phi) {
    double value = 0.0;
    for (std::size_t p = 0; p < 4; ++p) {
      if (e.column[p] != column || e.row[p] != row) continue;
      value = e.load;
      for (std::size_t q = 0; q < 4; ++q) {
        if (e.unknown[q] >= 0) value -= e.stiffness[p][q] * phi[e.unknown[q]];
      }
    }
    return value;
  }

  int elements_;
  std::vector<double> x_;
  std::vector<double> y_;
};

/// Elements over each of hole and wall, of the coarser grid.
constexpr int kElements = 20;

double extrapolated(double coarse, double fine) { return fine + (fine - coarse) / 3.0; }

struct BoxOnGrid final : SolvedBox {
  explicit BoxOnGrid(const BoxDimensions& box) : coarse(box, kElements) {
    const QuarterSection fine(box, 2 * kElements);
    QuarterSection::Solution on_coarse = coarse.solve();
    const BoxTorsion low = coarse.torsion(on_coarse);
    const BoxTorsion high = fine.torsion(fine.solve());
    torsion = {extrapolated(low.constant, high.constant), extrapolated(low.modulus, high.modulus)};
    plastic_modulus = sand_heap_modulus_box(box);
    phi = std::move(on_coarse.phi);
  }
  double shear_at(const std::array<double, 2>& point) const override {
    return coarse.slope_at(phi, point);
  }

  QuarterSection coarse;
  Eigen::VectorXd phi;  ///< of the coarse grid
};

/// The last boxes that were solved, for all threads. A model solves each of its boxes once; a sweep
/// or a fit prepares a model of the same boxes for each of thousands of cases, and most of these
/// run in less than the 10 ms that a box takes.
class LastBoxes {
 public:
  std::shared_ptr<const SolvedBox> of(const BoxDimensions& box) {
    for (const double side : {box.width, box.height, box.inner_width, box.inner_height}) {
      // No order among boxes has a place for it.
      if (!std::isfinite(side))
        throw std::invalid_argument("a rectangular tube needs finite sides");
    }
    if (auto known = find(box)) return known;
    // Two threads may solve the same box at first; both get the same numbers.
    auto solved = std::make_shared<const BoxOnGrid>(box);
    const std::lock_guard lock(mutex_);
    ++solved_;
    const auto [at, is_new] = kept_.emplace(box, solved);
    if (is_new) order_.push_back(at);
    if (order_.size() > kKept) {
      kept_.erase(order_.front());
      order_.pop_front();
    }
    return solved;
  }
  std::size_t solved() {
    const std::lock_guard lock(mutex_);
    return solved_;
  }

 private:
  /// As many as a taper of 500 segments has, in some 10 MB.
  static constexpr std::size_t kKept = 1024;
  using Kept = std::map<BoxDimensions, std::shared_ptr<const SolvedBox>>;

  std::shared_ptr<const SolvedBox> find(const BoxDimensions& box) {
    const std::lock_guard lock(mutex_);
    const auto known = kept_.find(box);
    return known == kept_.end() ? nullptr : known->second;
  }

  std::mutex mutex_;
  Kept kept_;
  std::deque<Kept::iterator> order_;  ///< the oldest first
  std::size_t solved_ = 0;
};

LastBoxes& last_boxes() {
  static LastBoxes boxes;
  return boxes;
}

}  // namespace

std::shared_ptr<const SolvedBox> solved_box(const BoxDimensions& box) {
  return last_boxes().of(box);
}

std::size_t boxes_solved() { return last_boxes().solved(); }

BoxTorsion bredt_box(const BoxDimensions& box) {
  const double side_wall = (box.width - box.inner_width) / 2.0;
  const double top_wall = (box.height - box.inner_height) / 2.0;
  const double width = box.width - side_wall;
  const double height = box.height - top_wall;
  const double enclosed = width * height;
  const double flow_length = 2.0 * width / top_wall + 2.0 * height / side_wall;
  return {.constant = 4.0 * enclosed * enclosed / flow_length,
          .modulus = 2.0 * enclosed * std::min(side_wall, top_wall)};
}

double sand_heap_modulus_box(const BoxDimensions& box) {
  const double side_wall = (box.width - box.inner_width) / 2.0;
  const double top_wall = (box.height - box.inner_height) / 2.0;
  const double plateau = std::min(side_wall, top_wall);
  if (side_wall == top_wall) {
    return sand_heap_modulus_rectangle(box.width, box.height) -
           sand_heap_modulus_rectangle(box.inner_width, box.inner_height);
  }
  const auto heap = [&](double x, double y) {
    const double to_outer = std::min(box.width / 2.0 - x, box.height / 2.0 - y);
    const double to_hole = std::hypot(std::max(x - box.inner_width / 2.0, 0.0),
                                      std::max(y - box.inner_height / 2.0, 0.0));
    return std::min(to_outer, plateau + to_hole);
  };
  // Midpoint rule on one of the three rectangles that make up a quarter of the wall.
  const auto volume = [&](double x0, double x1, double y0, double y1) {
    constexpr int kPoints = 200;
    const double dx = (x1 - x0) / kPoints;
    const double dy = (y1 - y0) / kPoints;
    double sum = 0.0;
    for (int i = 0; i < kPoints; ++i) {
      for (int j = 0; j < kPoints; ++j) sum += heap(x0 + (i + 0.5) * dx, y0 + (j + 0.5) * dy);
    }
    return sum * dx * dy;
  };
  const double xi = box.inner_width / 2.0, xo = box.width / 2.0;
  const double yi = box.inner_height / 2.0, yo = box.height / 2.0;
  const double quarter = volume(0.0, xi, yi, yo) + volume(xi, xo, 0.0, yi) +
                         volume(xi, xo, yi, yo) + plateau * xi * yi;
  return 2.0 * 4.0 * quarter;
}

}  // namespace plastica
