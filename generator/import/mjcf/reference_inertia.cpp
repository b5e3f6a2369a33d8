#include "import/mjcf/reference_inertia.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "support/error.hpp"
#include "support/inverse_diagonal.hpp"

namespace alembert {
namespace {

/// M is dense here.
constexpr Eigen::Index kMostSpeeds = 1000;

/// MuJoCo's own, for what is zero.
constexpr double kSame = 1e-14;

/// A speed: how fast the point `anchor` shifts and what is around it turns, world axes.
struct Motion {
  Eigen::Vector3d shift, turn, anchor;
  std::size_t joint;

  Eigen::Vector3d at(const Eigen::Vector3d& point) const { return shift + turn.cross(point - anchor); }
};

void add_motions(const MjcfModel& model, std::size_t j, const RigidPose& body, std::vector<Motion>& out) {
  const MjcfJoint& joint = model.joints[j];
  const Eigen::Vector3d none = Eigen::Vector3d::Zero(), axis = body.turn * joint.axis.normalized(),
                        anchor = (body * joint.anchor).shift;
  const Eigen::Matrix3d axes = body.turn.toRotationMatrix();
  switch (joint.type) {
    case MjcfJointType::slide:
      out.push_back({axis, none, none, j});
      break;
    case MjcfJointType::hinge:
      out.push_back({none, axis, anchor, j});
      break;
    case MjcfJointType::free:
      for (int k = 0; k < 3; ++k) out.push_back({Eigen::Vector3d::Unit(k), none, none, j});
      [[fallthrough]];
    case MjcfJointType::ball:
      for (int k = 0; k < 3; ++k) out.push_back({none, axes.col(k), anchor, j});
  }
}

Eigen::MatrixXd mass_matrix(const MjcfModel& model, const std::vector<Motion>& motions) {
  // What each body carries, world axes; children come behind their parents.
  std::vector<BodyMass> carried(model.bodies.size());
  for (std::size_t b = model.bodies.size(); b-- > 1;) {
    carried[b] += model.bodies[b].mass.moved(reference_pose(model, b));
    carried[model.bodies[b].parent] += carried[b];
  }
  std::vector<std::vector<Eigen::Index>> of_body(model.bodies.size());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(motions.size()),
                                              static_cast<Eigen::Index>(motions.size()));
  std::vector<Eigen::Index> first(model.joints.size());
  for (std::size_t i = motions.size(); i-- > 0;) first[motions[i].joint] = static_cast<Eigen::Index>(i);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& a = motions[i];
    const Eigen::Index row = static_cast<Eigen::Index>(i);
    std::size_t body = model.joints[a.joint].body;
    of_body[body].push_back(row);
    const BodyMass& moved = carried[body];
    const Eigen::Vector3d momentum = moved.mass * a.at(moved.centre), spin = moved.inertia * a.turn;
    for (;; body = model.bodies[body].parent) {
      for (const Eigen::Index column : of_body[body]) {
        const Motion& b = motions[static_cast<std::size_t>(column)];
        out(row, column) = out(column, row) = momentum.dot(b.at(moved.centre)) + spin.dot(b.turn);
      }
      if (body == 0) break;
    }
    out(row, row) += model.joints[a.joint].armature;
  }
  for (const MjcfTendon& tendon : model.tendons)
    for (const MjcfTerm& a : tendon.terms)
      for (const MjcfTerm& b : tendon.terms)
        out(first[a.joint], first[b.joint]) += tendon.armature * a.factor * b.factor;
  return out;
}

/// Whether MuJoCo takes the mass of the body for all of the inertia of its speeds, without armatures: a body that only
/// slides, along its own axes, which are those of its inertia about its origin, and carries none.
bool slides_simply(const MjcfModel& model, std::size_t index) {
  const MjcfBody& body = model.bodies[index];
  const MjcfBody& parent = model.bodies[body.parent];
  const Eigen::Vector3d moments = body.mass.inertia.diagonal();
  const Eigen::Matrix3d products = body.mass.inertia - Eigen::Matrix3d(moments.asDiagonal());
  // Axes that it works out are sorted by their moments.
  const bool own_axes = body.turn_is_exact
                            ? body.inertial_turn->isApprox(Eigen::Quaterniond::Identity(), kSame)
                            : products.isZero(kSame * moments.sum()) && moments.x() >= moments.y() &&
                                  moments.y() >= moments.z();
  const bool fixed_parent = body.parent == 0 || (parent.parent == 0 && parent.joints.empty());
  if (!own_axes || !fixed_parent || !body.mass.centre.isZero(kSame)) return false;
  if (std::ranges::any_of(model.bodies, [&](const MjcfBody& other) { return other.parent == index; }))
    return false;
  return std::ranges::all_of(body.joints, [&](std::size_t j) {
    const MjcfJoint& joint = model.joints[j];
    return joint.type == MjcfJointType::slide && joint.anchor.shift.isZero(kSame) &&
           (joint.axis.array().abs() > kSame).count() == 1;
  });
}

}  // namespace

double inertia_at_reference(const MjcfModel& model, std::size_t joint) {
  const MjcfJoint& of = model.joints[joint];
  std::vector<Motion> motion;
  add_motions(model, joint, reference_pose(model, of.body), motion);
  double sum = of.armature;
  // What a body carries comes right behind it.
  for (std::size_t b = of.body; b < model.bodies.size(); ++b) {
    if (b != of.body && model.bodies[b].parent < of.body) break;
    const BodyMass mass = model.bodies[b].mass.moved(reference_pose(model, b));
    sum += mass.mass * motion[0].at(mass.centre).squaredNorm() +
           motion[0].turn.dot(mass.inertia * motion[0].turn);
  }
  return sum;
}

void work_out_spring_dampers(MjcfModel& model) {
  const auto asks = [](const MjcfJoint& joint) { return joint.spring_damper.has_value(); };
  const auto asking = std::ranges::find_if(model.joints, asks);
  if (asking == model.joints.end()) return;
  std::vector<Motion> motions;
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    add_motions(model, j, reference_pose(model, model.joints[j].body), motions);
  const Eigen::Index size = static_cast<Eigen::Index>(motions.size());
  const auto refuse = [&](const std::string& why) -> InputError {
    return InputError(asking->where, fmt::format("springdamper is not worked out: {}", why),
                      "give stiffness and damping");
  };
  if (size > kMostSpeeds) throw refuse(fmt::format("the model has more than {} speeds", kMostSpeeds));
  const std::optional<Eigen::VectorXd> light = inverse_diagonal(mass_matrix(model, motions));
  if (!light) throw refuse("the mass matrix of the model is singular");
  std::vector<double> sums(model.joints.size());
  for (Eigen::Index i = 0; i < size; ++i) sums[motions[static_cast<std::size_t>(i)].joint] += (*light)[i];
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    MjcfJoint& joint = model.joints[j];
    if (!joint.spring_damper) continue;
    const auto& [time, ratio] = *joint.spring_damper;
    const double inertia = slides_simply(model, joint.body)
                               ? model.bodies[joint.body].mass.mass
                               : static_cast<double>(speed_count(joint.type)) / sums[j];
    joint.stiffness = inertia / (time * time * ratio * ratio);
    joint.damping = 2 * inertia / time;
  }
}

}  // namespace alembert
