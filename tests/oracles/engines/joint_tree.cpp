// Description to links and joints (see the header).
#include "oracles/engines/joint_tree.hpp"

#include <cmath>

namespace alembert::oracles {

namespace {

Eigen::Isometry3d translation(const Eigen::Vector3d& by) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = by;
  return pose;
}

/// Joints and fixed poses in the order in which factors come.
struct Path {
  std::vector<Joint> joints;
  Eigen::Isometry3d tail = Eigen::Isometry3d::Identity();  ///< after the last joint

  void fix(const Eigen::Isometry3d& pose) { tail = tail * pose; }
  void join(Joint::Kind kind, const Eigen::Vector3d& axis, const Expression& position, int first_q = 0) {
    joints.push_back({kind, tail, axis, position, first_q, 0, 0});
    tail.setIdentity();
  }
};

/// A translation `k d` along a constant vector k by one distance d.
bool along_one_axis(const Expression3& offset) {
  for (const Expression& e : offset) {
    if (e->operation != Operation::multiply || e->operand[1] != offset[0]->operand[1] ||
        e->operand[0]->operation != Operation::number) {
      return false;
    }
  }
  return true;
}

class PathBuilder {
 public:
  PathBuilder(Path& path, bool inverted) : path_(path), inverted_(inverted) {}

  void operator()(const Translation& f) const {
    if (along_one_axis(f.offset) && !is_constant(f.offset[0]->operand[1])) {
      Eigen::Vector3d axis;
      for (int i = 0; i < 3; ++i) axis[i] = f.offset[static_cast<std::size_t>(i)]->operand[0]->number;
      const Expression stretched = product(number(axis.norm()), f.offset[0]->operand[1]);
      return path_.join(Joint::Kind::prismatic, axis.normalized(), signed_expression(stretched));
    }
    for (int i = 0; i < 3; ++i) {
      const Expression& e = f.offset[static_cast<std::size_t>(i)];
      if (is_constant(e)) {
        path_.fix(translation(constant_value(signed_expression(e)) * Eigen::Vector3d::Unit(i)));
      } else {
        path_.join(Joint::Kind::prismatic, Eigen::Vector3d::Unit(i), signed_expression(e));
      }
    }
  }
  void operator()(const Rotation& f) const {
    const Eigen::Vector3d axis(f.axis[0], f.axis[1], f.axis[2]);
    if (is_constant(f.angle)) {
      path_.fix(Eigen::Isometry3d(Eigen::AngleAxisd(constant_value(signed_expression(f.angle)), axis)));
    } else {
      path_.join(Joint::Kind::revolute, axis, signed_expression(f.angle));
    }
  }
  void operator()(const QuaternionRotation& f) const {
    if (inverted_) throw NotExpressible("an inverted spherical joint");
    path_.join(Joint::Kind::ball, Eigen::Vector3d::UnitX(), nullptr, f.first_q);
  }
  void operator()(const Matrix& f) const {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (int i = 0; i < 12; ++i) {
      const Expression& e = f.entry[static_cast<std::size_t>(i)];
      if (!is_constant(e)) throw NotExpressible("a matrix that varies");
      pose(i / 4, i % 4) = constant_value(e);
    }
    path_.fix(inverted_ ? pose.inverse() : pose);
  }
  void operator()(const Curve&) const { throw NotExpressible("a frame on a curve"); }
  void operator()(const Surface&) const { throw NotExpressible("a frame on a surface"); }
  void operator()(const Mate&) const { throw NotExpressible("mated surfaces"); }
  void operator()(const Inverse& f) const { append(path_, f.of, !inverted_); }

  static void append(Path& path, const std::vector<Factor>& factors, bool inverted) {
    for (std::size_t i = 0; i < factors.size(); ++i) {
      std::visit(PathBuilder(path, inverted), factors[inverted ? factors.size() - 1 - i : i].value);
    }
  }

 private:
  Expression signed_expression(const Expression& e) const { return inverted_ ? negated(e) : e; }

  Path& path_;
  bool inverted_;
};

using T = Jet<double>;

std::vector<T> moving(const Description& description, const State& state, bool with_rates) {
  const std::vector<double> qd = coordinate_rates(description, state.q, state.speeds);
  std::vector<T> q;
  for (std::size_t i = 0; i < qd.size(); ++i) q.emplace_back(state.q[i], qd[i], 0.0);
  for (const Coordinate& c : description.coordinates) {
    if (!c.quaternion && with_rates) {
      q[static_cast<std::size_t>(c.first_q)].second = state.rates[static_cast<std::size_t>(c.first_speed)];
    }
  }
  return q;
}

int first_speed_of(const Description& description, int first_q) {
  for (const Coordinate& c : description.coordinates) {
    if (c.first_q == first_q) return c.first_speed;
  }
  throw std::logic_error("no coordinate at this index");
}

}  // namespace

JointTree::JointTree(const Description& from) : description(from) {
  for (const Coordinate& c : from.coordinates)
    if (c.armature != 0) throw NotExpressible("an armature");
  if (from.has_forces()) throw NotExpressible("forces");
  gravity = {from.gravity[0], from.gravity[1], from.gravity[2]};
  std::vector<Path> open(from.bodies.size());        // of a massless body: from the link before it
  std::vector<int> link_of(from.bodies.size(), -1);  // link a body is, or hangs on
  for (std::size_t i = 0; i < from.bodies.size(); ++i) {
    const Body& body = from.bodies[i];
    Path path;
    if (body.parent >= 0) {
      path = open[static_cast<std::size_t>(body.parent)];
      link_of[i] = link_of[static_cast<std::size_t>(body.parent)];
    }
    PathBuilder::append(path, body.transform, false);
    const auto& m = body.inertia;
    const bool massless = body.mass == 0 && m == std::array<double, 6>{};
    if (massless && !body.external_wrench) {
      open[i] = path;
      continue;
    }
    Link link;
    link.name = body.name;
    link.parent = link_of[i];
    link.joints = path.joints;
    link.after = path.tail;
    link.mass = body.mass;
    link.com = {body.com[0], body.com[1], body.com[2]};
    link.inertia << m[0], m[3], m[4], m[3], m[1], m[5], m[4], m[5], m[2];
    for (Joint& joint : link.joints) {
      joint.first_position = positions;
      joint.first_speed = speeds;
      positions += joint.positions();
      speeds += joint.speeds();
    }
    link_of[i] = static_cast<int>(links.size());
    links.push_back(std::move(link));
  }
}

JointMotion JointTree::motion(const State& state, bool with_rates) const {
  const std::vector<T> q = moving(description, state, with_rates);
  const T time(state.time, 1.0, 0.0);
  JointMotion m{Eigen::VectorXd::Zero(positions), Eigen::VectorXd::Zero(speeds),
                Eigen::VectorXd::Zero(speeds)};
  for (const Link& link : links) {
    for (const Joint& joint : link.joints) {
      if (joint.kind == Joint::Kind::ball) {
        const int k = first_speed_of(description, joint.first_q);
        for (int i = 0; i < 4; ++i)
          m.position[joint.first_position + i] = state.q[static_cast<std::size_t>(joint.first_q + i)];
        for (int i = 0; i < 3; ++i) {
          m.speed[joint.first_speed + i] = state.speeds[static_cast<std::size_t>(k + i)];
          if (with_rates) m.rate[joint.first_speed + i] = state.rates[static_cast<std::size_t>(k + i)];
        }
      } else {
        const T position = evaluate(joint.position, q, time);
        m.position[joint.first_position] = position.value;
        m.speed[joint.first_speed] = position.first;
        m.rate[joint.first_speed] = position.second;
      }
    }
  }
  return m;
}

Eigen::MatrixXd JointTree::jacobian(const State& state) const {
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(speeds, description.nv);
  for (const Coordinate& c : description.coordinates) {
    std::vector<T> q;
    for (std::size_t i = 0; i < state.q.size(); ++i) {
      q.emplace_back(state.q[i], !c.quaternion && static_cast<int>(i) == c.first_q ? 1.0 : 0.0, 0.0);
    }
    for (const Link& link : links) {
      for (const Joint& joint : link.joints) {
        if (joint.kind == Joint::Kind::ball) {
          if (c.quaternion && joint.first_q == c.first_q) {
            J.block<3, 3>(joint.first_speed, c.first_speed).setIdentity();
          }
        } else if (!c.quaternion) {
          J(joint.first_speed, c.first_speed) = evaluate(joint.position, q, T(state.time)).first;
        }
      }
    }
  }
  return J;
}

std::vector<LinkWrench> JointTree::wrenches(const State& state) const {
  std::vector<LinkWrench> result(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto found = state.wrenches.find(links[i].name);
    if (found == state.wrenches.end()) continue;
    const Wrench& w = found->second;
    result[i] = {{w[0], w[1], w[2]}, {w[3], w[4], w[5]}};
  }
  return result;
}

}  // namespace alembert::oracles
