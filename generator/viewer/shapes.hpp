// Shapes of the description as meshes. In: a shape and a mechanism's values at its initial state. Out: its
// mesh.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "mechanism/model.hpp"
#include "viewer/mesh.hpp"

namespace alembert {

/// Values of expressions at the mechanism's initial state and the runtime parameters' defaults, some symbols
/// changed.
class InitialValues {
 public:
  InitialValues(const Mechanism& mechanism, ExprGraph& graph);
  void set(Expr symbol, double value);
  Eigen::Vector3d operator()(const Vec3& expressions) const;
  /// Pose that a transform leads to. Throws as elementary_motions (dynamics) does.
  Eigen::Isometry3d pose(const Transform& transform) const;
  const Mechanism& mechanism() const { return mechanism_; }

 private:
  const Mechanism& mechanism_;
  ExprGraph& graph_;
  std::vector<double> symbols_;
};

/// Mesh of a shape that is not of a file, in its own axes. Throws InputError where it is not finite or has no extent.
Mesh shape_mesh(const Shape& shape, const InitialValues& values);

}  // namespace alembert
