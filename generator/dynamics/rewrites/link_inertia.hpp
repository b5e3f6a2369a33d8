// The inertia of a link, numbers and runtime parameters apart: mass properties of a node in, a pseudo-inertia
// [K h; h^T m] that is linear in a few terms out, and back.
//
// Numbers have 50 digits, so that entries which cancel are told from small ones.
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

#include "dynamics/tree/motion_tree.hpp"
#include "mechanism/model.hpp"
#include "symbolic/extended.hpp"

namespace alembert {

/// Entries of a pseudo-inertia [K h; h^T m] in this order: Kxx Kyy Kzz Kxy Kxz Kyz hx hy hz m.
inline constexpr std::array<std::pair<int, int>, 10> kInertiaEntries{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}}};

using Vector3e = Eigen::Matrix<Extended, 3, 1>;
using Matrix3e = Eigen::Matrix<Extended, 3, 3>;
using Matrix4e = Eigen::Matrix<Extended, 4, 4>;

/// number + sum over k of terms[k] * (term k of the RuntimeTerms it was made with).
struct LinkInertia {
  Matrix4e number = Matrix4e::Zero();
  std::map<std::size_t, Matrix4e> terms;

  LinkInertia& operator+=(const LinkInertia& other);
  LinkInertia& operator-=(const LinkInertia& other);
  /// X S X^T: the same inertia in the frame that the pose X leads from.
  LinkInertia seen_through(const Matrix4e& X) const;
};

/// The terms of one mechanism.
class RuntimeTerms {
 public:
  /// What is fixed to node `node` of the tree, in its axes.
  LinkInertia of_node(const Mechanism& mechanism, const MotionTree& tree, std::size_t node, ExprGraph& graph);

  /// The mass properties that an inertia stands for.
  NodeMass node_mass(const LinkInertia& inertia, ExprGraph& graph) const;

  bool empty() const { return terms_.empty(); }

 private:
  LinkInertia with_terms(const NodeMass& mass, ExprGraph& graph);
  std::size_t index_of(Expr term);

  std::vector<Expr> terms_;
};

/// Operations by which the entries of an inertia are put together from its terms; `about_z_only`: of which
/// only the moment about z is wanted.
std::size_t composition_cost(const LinkInertia& inertia, bool about_z_only);

/// The mass that a pseudo-inertia in a frame is like, if its lengths are like `length`: with it, entries are
/// told from rounding and sizes compared, whatever the units.
Extended mass_scale(const Matrix4e& S, const Extended& length);
/// Entries that are rounding beside a mass and a length are zero.
void drop_rounding(Matrix4e& S, const Extended& mass, const Extended& length);

/// A number in an expression.
Expr rounded_number(ExprGraph& graph, const Extended& x);

}  // namespace alembert
