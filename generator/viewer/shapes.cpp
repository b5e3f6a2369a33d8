// Shapes of the description to meshes, and values of expressions at the initial state.
#include "viewer/shapes.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "dynamics/tree/motion.hpp"
#include "dynamics/tree/motion_tree.hpp"
#include "symbolic/evaluate.hpp"
#include "viewer/looks.hpp"
#include "viewer/swept_mesh.hpp"

namespace alembert {

InitialValues::InitialValues(const Mechanism& mechanism, ExprGraph& graph)
    : mechanism_(mechanism), graph_(graph) {
  for (const Coordinate& coordinate : mechanism.coordinates) {
    for (std::size_t i = 0; i < coordinate.symbols.size(); ++i)
      set(coordinate.symbols[i], coordinate.initial[i]);
  }
  for (const Parameter& parameter : mechanism.parameters) {
    if (parameter.runtime) set(graph.symbol(parameter.name), parameter.value);
  }
}

void InitialValues::set(Expr symbol, double value) {
  symbols_.resize(graph_.symbol_count(), 0.0);
  symbols_[graph_.symbol_index(symbol.ref().node())] = value;
}

Eigen::Vector3d InitialValues::operator()(const Vec3& expressions) const {
  std::vector<double> symbols = symbols_;
  symbols.resize(graph_.symbol_count(), 0.0);
  const std::vector<double> values = evaluate(expressions.entries, symbols);
  return {values[0], values[1], values[2]};
}

Eigen::Isometry3d InitialValues::pose(const Transform& transform) const {
  Pose pose = identity_pose(graph_);
  for (const Motion& motion : elementary_motions(transform, mechanism_, graph_))
    pose = moved(std::move(pose), motion);
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.translation() = (*this)(pose.origin);
  for (std::size_t c = 0; c < 3; ++c) {
    Vec3 column;
    for (std::size_t r = 0; r < 3; ++r) column[r] = pose.rotation(r, c);
    out.linear().col(static_cast<Eigen::Index>(c)) = (*this)(column);
  }
  return out;
}

Mesh shape_mesh(const Shape& shape, const InitialValues& initial) {
  const std::vector<double>& size = shape.sizes;
  const auto curve = [&](double u) {
    InitialValues values = initial;
    values.set(shape.u, u);
    return values(shape.point);
  };
  const auto surface = [&](double u, double v) {
    InitialValues values = initial;
    values.set(shape.u, u);
    values.set(shape.v, v);
    return values(shape.point);
  };
  try {
    switch (shape.kind) {
      case ShapeKind::box:
        return box_mesh({size.at(0), size.at(1), size.at(2)});
      case ShapeKind::sphere:
        return ellipsoid_mesh(Eigen::Vector3d::Constant(size.at(0)));
      case ShapeKind::ellipsoid:
        return ellipsoid_mesh({size.at(0), size.at(1), size.at(2)});
      case ShapeKind::cylinder:
        return cylinder_mesh(size.at(0), size.at(1));
      case ShapeKind::capsule:
        return capsule_mesh(size.at(0), size.at(1));
      case ShapeKind::torus:
        return torus_mesh(size.at(0), size.at(1));
      case ShapeKind::tube:
        return tube_mesh(curve, shape.u_range, size.at(0));
      case ShapeKind::surface:
        return surface_mesh(surface, shape.u_range, shape.v_range);
      case ShapeKind::mesh:
        break;  // file_meshes (file_mesh.hpp)
    }
  } catch (const std::domain_error& error) {
    throw InputError(shape.where, fmt::format("this shape cannot be drawn: {}", error.what()));
  }
  throw InternalError("a shape of no kind");
}

}  // namespace alembert
