#include "import/mjcf/body_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "import/common/mass_nodes.hpp"
#include "import/common/snapped_angle.hpp"
#include "import/mjcf/sums.hpp"
#include "mechanism/model.hpp"

namespace alembert {
namespace {

using Vector = std::array<double, 3>;

Vector array_of(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// The name, or with as many additions as no body of the list has.
std::string unused_name(const YamlNode& list, std::string name, const char* addition) {
  while (std::ranges::any_of(list.items, [&](const YamlNode* body) { return body->items[1]->text == name; }))
    name += addition;
  return name;
}

}  // namespace

/// By joint, with those of its followers.
std::vector<double> MjcfBodyNodes::all_armatures() const {
  std::vector<double> out;
  for (const MjcfJoint& joint : model_.joints) out.push_back(joint.armature);
  for (const std::size_t follower : naming_.followers()) {
    const JointText& text = naming_.text(follower);
    if (text.base && text.constant_slope)
      out[*text.base] += *text.constant_slope * *text.constant_slope * model_.joints[follower].armature;
  }
  return out;
}

void MjcfBodyNodes::add_coordinates(YamlNode& list) const {
  std::size_t first = 0, first_speed = 0;
  const std::vector<double> armatures = all_armatures();
  for (std::size_t j = 0; j < model_.joints.size(); ++j) {
    if (!naming_.follows(j)) add_coordinate(list, j, first, first_speed, armatures[j]);
    first += position_count(model_.joints[j].type);
    first_speed += speed_count(model_.joints[j].type);
  }
}

/// `first` and `first_speed`: where its numbers begin in a keyframe.
void MjcfBodyNodes::add_coordinate(YamlNode& list, std::size_t j, std::size_t first, std::size_t first_speed,
                                   double armature) const {
  const MjcfJoint& joint = model_.joints[j];
  const std::vector<std::string>& names = naming_.coordinates(j);
  const SourceLocation& where = joint.where;
  const bool free = joint.type == MjcfJointType::free, single = speed_count(joint.type) == 1;
  std::vector<double> start;
  if (!model_.start.empty()) {
    start.assign(model_.start.begin() + static_cast<std::ptrdiff_t>(first),
                 model_.start.begin() + static_cast<std::ptrdiff_t>(first + position_count(joint.type)));
  } else if (free) {
    const RigidPose& pose = model_.bodies[joint.body].pose;
    start = {pose.shift.x(), pose.shift.y(), pose.shift.z(), pose.turn.w(),
             pose.turn.x(),  pose.turn.y(),  pose.turn.z()};
  } else {
    start = single ? std::vector{joint.reference} : std::vector{1.0, 0.0, 0.0, 0.0};
  }
  const bool hinge = joint.type == MjcfJointType::hinge;
  const auto text = [&](double value) {
    return hinge ? SnappedAngle(value, 1e-12).text() : number_text(value);
  };
  for (std::size_t k = 0; k < names.size(); ++k) {
    const bool quaternion = !single && k + 1 == names.size();
    YamlNode& node = nodes_.add_named(list, names[k], where);
    if (quaternion) {
      nodes_.put(node, "type", nodes_.text("quaternion", where));
      const std::size_t at = free ? 3 : 0;
      Eigen::Quaterniond q(start[at], start[at + 1], start[at + 2], start[at + 3]);
      q = q.norm() > 0 ? q.normalized() : Eigen::Quaterniond::Identity();
      if (!(q.vec().isZero() && q.w() == 1))
        nodes_.put(
            node, "initial",
            nodes_.list({number_text(q.x()), number_text(q.y()), number_text(q.z()), number_text(q.w())},
                        where));
    } else {
      double initial = start[k];
      if (joint.limits) {
        initial = std::clamp(initial, (*joint.limits)[0], (*joint.limits)[1]);
        if (initial != start[k])
          warnings_.push_back(
              {where,
               fmt::format("joint '{}' starts outside its range; it is moved to its end", names[k]),
               {},
               "start outside the range"});
      }
      if (initial != 0) nodes_.put(node, "initial", nodes_.text(text(initial), where));
      if (joint.limits)
        nodes_.put(node, "limits", nodes_.list({text((*joint.limits)[0]), text((*joint.limits)[1])}, where));
    }
    if (!model_.start_speeds.empty()) {
      const auto speed = model_.start_speeds.begin() + static_cast<std::ptrdiff_t>(first_speed + k);
      if (quaternion && (speed[0] != 0 || speed[1] != 0 || speed[2] != 0))
        nodes_.put(node, "initial_speed", nodes_.numbers({speed[0], speed[1], speed[2]}, where));
      if (!quaternion && speed[0] != 0)
        nodes_.put(node, "initial_speed", nodes_.text(number_text(speed[0]), where));
    }
    const auto number = [&](const char* key, double value) {
      if (value != 0) nodes_.put(node, key, nodes_.text(number_text(value), where));
    };
    number("armature", armature);
    if (options_.resistance) number("damping", joint.damping);
    if (single) number("stiffness", joint.stiffness);
    if (joint.stiffness != 0 && joint.rest != 0)
      nodes_.put(node, "rest", nodes_.text(text(joint.rest), where));
    if (joint.drive)
      nodes_.put(node, "effort",
                 nodes_.text(number_text(std::max(std::abs((*joint.drive)[0]), std::abs((*joint.drive)[1]))),
                             where));
    if (options_.resistance && joint.friction != 0) {
      nodes_.put_friction(node, joint.friction, where);
    }
    if (node.items.size() == 2) list.items.back() = node.items[1];
  }
}

void MjcfBodyNodes::add_turn(YamlNode& factors, std::size_t j) const {
  const MjcfJoint& joint = model_.joints[j];
  const Vector axis = array_of(joint.axis);
  if (joint.type == MjcfJointType::ball) {
    factors.items.push_back(&nodes_.single(
        "rotate", nodes_.single("quaternion", nodes_.text(naming_.quaternion(j), joint.where))));
  } else if (!naming_.follows(j) && joint.reference == 0) {
    factors_.add_joint(factors, joint.type == MjcfJointType::slide ? "prismatic" : "revolute", axis,
                       naming_.coordinates(j)[0], joint.where);
  } else {
    const std::string position = naming_.from_reference(j);
    if (joint.type == MjcfJointType::slide)
      factors_.add_shift_along(factors, axis, position, joint.where);
    else
      factors_.add_rotation(factors, factors_.axis(axis, joint.where), position, joint.where);
  }
}

void MjcfBodyNodes::add_joints(YamlNode& factors, const MjcfBody& body) const {
  if (!body.joints.empty() && model_.joints[body.joints[0]].type == MjcfJointType::free)
    return factors_.add_free(factors, naming_.coordinates(body.joints[0]), body.where);
  // Shifts that follow each other are one.
  RigidPose pending = body.pose;
  const auto flush = [&] {
    factors_.add_pose(factors, pending, body.where);
    pending = {};
  };
  for (const std::size_t j : body.joints) {
    const MjcfJoint& joint = model_.joints[j];
    const bool turns = joint.type != MjcfJointType::slide;
    if (turns && !joint.anchor.shift.isZero(0)) {
      if (!pending.turn.isApprox(Eigen::Quaterniond::Identity(), 1e-15)) flush();
      pending = pending * joint.anchor;
    }
    flush();
    add_turn(factors, j);
    if (turns) pending = inverse(joint.anchor);
  }
  flush();
}

void MjcfBodyNodes::add_shapes(YamlNode& node, const MjcfBody& body) const {
  // Those that MuJoCo's viewers show; of a body that has none, the others.
  const bool any = std::ranges::any_of(body.shapes, [](const PlacedShape& shape) { return !shape.hidden; });
  YamlNode& shapes = nodes_.sequence(body.where);
  for (const PlacedShape& shape : body.shapes) {
    if (any && shape.hidden) continue;
    add_shape(nodes_, factors_, shapes, shape, options_.folder);
  }
  if (!shapes.items.empty()) nodes_.put(node, "geometry", shapes);
}

void MjcfBodyNodes::add_body(YamlNode& list, std::size_t index) const {
  const MjcfBody& body = model_.bodies[index];
  YamlNode& node = nodes_.add_named(list, naming_.body(index), body.where);
  if (body.parent != 0) nodes_.put(node, "parent", nodes_.text(naming_.body(body.parent), body.where));
  YamlNode& factors = nodes_.sequence(body.where);
  add_joints(factors, body);
  if (!factors.items.empty()) nodes_.put(node, "transform", factors);
  add_mass(nodes_, node, body.mass, body.where);
  add_shapes(node, body);
}

void MjcfBodyNodes::add_scenery(YamlNode& list) const {
  if (!has_solid(model_.bodies[0].shapes)) return;
  add_shapes(nodes_.add_named(list, unused_name(list, "scenery", "_of_world"), model_.where),
             model_.bodies[0]);
}

void MjcfBodyNodes::add_tendon_armature(YamlNode& list, std::size_t tendon, const std::string& length) const {
  const MjcfTendon& of = model_.tendons[tendon];
  std::set<std::size_t> coordinates;
  for (const MjcfTerm& term : of.terms)
    if (const std::optional<std::size_t>& base = naming_.text(term.joint).base; base && term.factor != 0)
      coordinates.insert(*base);
  if (coordinates.empty()) return;
  if (static_cast<int>(coordinates.size()) > kMostSpeedsOfATransform)
    throw InputError(of.where,
                     fmt::format("the armature of a tendon along more than {} joints cannot be expressed",
                                 kMostSpeedsOfATransform));
  Eigen::Index least;
  model_.gravity.cwiseAbs().minCoeff(&least);
  Eigen::Vector3d across = Eigen::Vector3d::Unit(least);
  if (model_.gravity[least] != 0) across = model_.gravity.cross(across).normalized();
  YamlNode& node =
      nodes_.add_named(list, unused_name(list, naming_.tendon(tendon) + "_armature", "_of_tendon"), of.where);
  YamlNode& factors = nodes_.sequence(of.where);
  factors_.add_shift_along(factors, array_of(across), length, of.where);
  nodes_.put(node, "transform", factors);
  add_mass(nodes_, node, {of.armature}, of.where);
}

void MjcfBodyNodes::add_frame(YamlNode& list, const std::string& name, std::size_t body,
                              const RigidPose& pose, const SourceLocation& where) const {
  factors_.add_frame(list, name, naming_.body(body), pose, where);
}

}  // namespace alembert
