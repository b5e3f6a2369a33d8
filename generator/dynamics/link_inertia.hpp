// The inertia of a link, numbers and runtime parameters apart: mass properties of a node in, a pseudo-inertia
// [K h; h^T m] that is linear in a few terms out, and back.
//
// Poses between frames that are numbers, and parts of an inertia that move from link to link, are linear maps
// of the pseudo-inertia. So they act on the numbers and on the coefficient of each term alike, and terms stay
// as they are: products of runtime parameters (m, m*l), or whole entries (m*(y^2 + z^2) + I) where these are
// fewer.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "dynamics/motion_tree.hpp"
#include "dynamics/units.hpp"
#include "mechanism/model.hpp"

namespace alembert {

/// Entries of a pseudo-inertia [K h; h^T m] in this order: Kxx Kyy Kzz Kxy Kxz Kyz hx hy hz m.
inline constexpr std::array<std::pair<int, int>, 10> kInertiaEntries{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}}};

/// number + sum over k of terms[k] * (term k of the RuntimeTerms it was made with).
struct LinkInertia {
  Eigen::Matrix4d number = Eigen::Matrix4d::Zero();
  std::map<std::size_t, Eigen::Matrix4d> terms;

  LinkInertia& operator+=(const LinkInertia& other);
  LinkInertia& operator-=(const LinkInertia& other);
  /// X S X^T: the same inertia in the frame that the pose X leads from.
  LinkInertia seen_through(const Eigen::Matrix4d& X) const;
};

/// The terms of one mechanism.
class RuntimeTerms {
 public:
  explicit RuntimeTerms(Units units) : units_(units) {}

  /// What is fixed to node `node` of the tree, in its axes.
  LinkInertia of_node(const Mechanism& mechanism, const MotionTree& tree, std::size_t node, ExprGraph& graph);

  /// The mass properties that an inertia stands for.
  NodeMass node_mass(const LinkInertia& inertia, const std::array<MomentForm, 3>& forms,
                     ExprGraph& graph) const;

  bool empty() const { return terms_.empty(); }

 private:
  LinkInertia with_terms(const NodeMass& mass, ExprGraph& graph);
  std::size_t index_of(Expr term);

  Units units_;  ///< of all pseudo-inertias
  std::vector<Expr> terms_;
};

/// Operations by which the entries of an inertia are put together from its terms; `about_z_only`: of which
/// only the moment about z is wanted.
std::size_t composition_cost(const LinkInertia& inertia, bool about_z_only);

/// A number of units in an expression, zero where it is nothing but rounding.
Expr rounded_number(ExprGraph& graph, double x, double unit = 1);

}  // namespace alembert
