#include "import/mjcf/inertial.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace alembert {
namespace {

bool counts(const MjcfGeom& geom, const MjcfCompiler& compiler) {
  return geom.group() >= compiler.inertia_groups[0] && geom.group() <= compiler.inertia_groups[1];
}

}  // namespace

BodyMass read_inertial(const MjcfElement& element, const RigidPose& frame, const MjcfCompiler& compiler) {
  element.text()
      .of(element.node())
      .check_spelling(
          element.node(), element.what(), {},
          {"pos", "quat", "mass", "diaginertia", "axisangle", "xyaxes", "zaxis", "euler", "fullinertia"});
  BodyMass out;
  const RigidPose pose = frame * compiler.pose(element);
  if (!element.has("mass")) throw InputError(element.where(), "no attribute 'mass' of an inertial");
  out.mass = element.number("mass", 0);
  if (out.mass < 0) throw element.error("mass", "the mass of an inertial is negative");
  out.centre = pose.shift;
  const Eigen::Matrix3d turn = pose.turn.toRotationMatrix();
  if (const std::vector<double> full = element.list("fullinertia", 6, 6); !full.empty()) {
    if (element.has("diaginertia"))
      throw element.error("fullinertia", "an inertial has both diaginertia and fullinertia");
    out.inertia << full[0], full[3], full[4], full[3], full[1], full[5], full[4], full[5], full[2];
  } else if (const std::vector<double> diagonal = element.list("diaginertia", 3, 3); !diagonal.empty()) {
    out.inertia = Eigen::Vector3d(diagonal[0], diagonal[1], diagonal[2]).asDiagonal();
  } else {
    return out;
  }
  if (pose.turn.vec().norm() > 0) out.inertia = (turn * out.inertia * turn.transpose()).eval();
  return out;
}

BodyMass mass_of_geoms(const std::vector<MjcfGeom>& geoms, const MjcfCompiler& compiler) {
  BodyMass out;
  for (const MjcfGeom& geom : geoms)
    if (counts(geom, compiler)) out += geom.mass();
  return out;
}

const MjcfGeom* only_geom_with_mass(const std::vector<MjcfGeom>& geoms, const MjcfCompiler& compiler) {
  const MjcfGeom* out = nullptr;
  for (const MjcfGeom& geom : geoms) {
    if (!counts(geom, compiler) || geom.mass().mass == 0) continue;
    if (out != nullptr) return nullptr;
    out = &geom;
  }
  return out;
}

Eigen::Quaterniond principal_turn(const BodyMass& mass) {
  Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(mass.inertia).eigenvectors();
  if (axes.determinant() < 0) axes.col(2) *= -1;
  return Eigen::Quaterniond(axes);
}

BodyMass corrected(BodyMass mass, const MjcfCompiler& compiler, const SourceLocation& where,
                   const std::string& what) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(mass.inertia);
  Eigen::Vector3d principal = solver.eigenvalues();  // ascending
  const double rounding = 1e-12 * principal.cwiseAbs().maxCoeff();
  if (principal[0] < -rounding)
    throw InputError(
        where, fmt::format("the inertia of {} has a negative principal moment, {}", what, principal[0]));
  const bool impossible = principal[0] + principal[1] < principal[2] - rounding;
  const bool small = principal[0] < compiler.least_inertia;
  mass.mass = std::max(mass.mass, compiler.least_mass);
  if (!impossible && !small) return mass;
  // MuJoCo balances what is bounded already.
  principal = principal.cwiseMax(compiler.least_inertia);
  if (principal[0] + principal[1] < principal[2] - rounding) {
    if (!compiler.balance)
      throw InputError(
          where,
          fmt::format("no body can have the inertia of {}: its principal moments are {}, {} and {}", what,
                      principal[0], principal[1], principal[2]),
          "<compiler balanceinertia=\"true\"/> takes the mean of the three");
    principal.setConstant(principal.mean());
  }
  mass.inertia = solver.eigenvectors() * principal.asDiagonal() * solver.eigenvectors().transpose();
  return mass;
}

}  // namespace alembert
