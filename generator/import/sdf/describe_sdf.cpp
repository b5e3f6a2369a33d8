// The sections of a description in order (see the header).
#include "import/sdf/describe_sdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "import/common/counts.hpp"
#include "import/common/fit_names.hpp"
#include "import/common/loop_equations.hpp"
#include "import/common/mass_nodes.hpp"
#include "import/common/snapped_angle.hpp"
#include "import/sdf/sdf_tree.hpp"

namespace alembert {
namespace {

std::array<double, 3> entries(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// A position that follows another: factor*base + offset.
struct Following {
  std::size_t joint, axis;
  double factor = 1, offset = 0;
};

class SdfDescriber {
 public:
  SdfDescriber(const SdfModel& model, const DescribeOptions& options)
      : model_(model),
        options_(options),
        tree_(span_tree(model)),
        nodes_(model.places),
        factors_(nodes_, options.snap_angles) {}

  DescribedRobot describe(const std::shared_ptr<const SourceText>& source) {
    const SourceLocation& top = model_.where;
    check_cuts();
    name_links();
    YamlNode &coordinates = nodes_.sequence(top), &definitions = nodes_.mapping(top),
             &bodies = nodes_.sequence(top), &frames = nodes_.sequence(top), &forces = nodes_.sequence(top),
             &constraints = nodes_.sequence(top);
    add_coordinates(coordinates);
    if (coordinates.items.empty())
      throw InputError(top, "nothing moves: every link is fixed to the world",
                       "a model that is not static moves freely");
    add_definitions(definitions);
    for (std::size_t link = 0; link < model_.links.size(); ++link) add_body(bodies, link);
    for (const SdfFrame& frame : model_.frames)
      add_frame(frames, frame_names_.add(frame.name, frame.where), frame.link, frame.pose, frame.where);
    add_forces(forces, frames);
    for (const std::size_t cut : tree_.cuts) add_constraint(constraints, forces, frames, cut);
    YamlNode& root =
        nodes_.root(options_.name_or(model_.name), fmt::format("SDF '{}'", printable(model_.name)), top);
    if (model_.gravity != Eigen::Vector3d(0, 0, -9.81))
      nodes_.put(root, "gravity", nodes_.numbers(entries(model_.gravity), top));
    nodes_.put(root, "coordinates", coordinates);
    for (const auto& [key, section] : {std::pair("definitions", &definitions),
                                       {"bodies", &bodies},
                                       {"frames", &frames},
                                       {"forces", &forces},
                                       {"constraints", &constraints}})
      if (!section->items.empty()) nodes_.put(root, key, *section);
    return {Document(source, nodes_.take(), root), std::move(warnings_), left_text({}, model_.left_out),
            model_.files};
  }

 private:
  const SdfAxis& axis_of(std::size_t joint, std::size_t axis) const {
    return model_.joints[joint].axes[axis];
  }
  bool is_cut(std::size_t joint) const { return std::ranges::binary_search(tree_.cuts, joint); }
  bool stands_still(const SdfJoint& joint) const {
    return joint.parent == kSdfWorld && joint.child == kSdfWorld;
  }
  bool is_used(std::size_t joint) const { return !is_cut(joint) && !stands_still(model_.joints[joint]); }

  bool resists(const SdfAxis& axis) const {
    return options_.resistance && (axis.damping != 0 || axis.friction != 0);
  }

  /// What a joint that closes a chain cannot have.
  void check_cuts() const {
    for (const std::size_t cut : tree_.cuts) {
      const SdfJoint& joint = model_.joints[cut];
      const char* what = joint.type == SdfJointType::screw ? "is a screw" : nullptr;
      for (const SdfAxis& axis : joint.axes) {
        if (axis.mimic) what = "follows another";
        if (axis.stiffness != 0) what = "has a spring";
        if (resists(axis) && joint.axes.size() > 1) what = "has damping or friction about two axes";
      }
      if (what != nullptr)
        throw InputError(joint.where,
                         fmt::format("joint '{}' closes a chain and {}, which cannot be expressed",
                                     printable(joint.name), what),
                         "one joint of the chain must be without a mimic and springs, and no screw");
    }
    for (std::size_t j = 0; j < model_.joints.size(); ++j)
      for (const SdfAxis& axis : model_.joints[j].axes)
        if (axis.mimic && is_used(j) && !is_used(axis.mimic->joint))
          throw InputError(axis.mimic->where,
                           fmt::format("joint '{}' closes a chain or stands still: it has no position",
                                       printable(model_.joints[axis.mimic->joint].name)));
  }

  void name_links() {
    for (const SdfLink& link : model_.links) body_names_.reserve(link.name);
    for (const SdfLink& link : model_.links) link_names_.push_back(body_names_.add(link.name, link.where));
  }
  std::string link_name(std::size_t link) const { return link == kSdfWorld ? "world" : link_names_[link]; }

  // Coordinates.
  void add_coordinates(YamlNode& list) {
    for (const SdfJoint& joint : model_.joints) names_.reserve(joint.name);
    free_names_.resize(model_.links.size());
    for (std::size_t link = 0; link < model_.links.size(); ++link)
      if (tree_.places[link].free) add_free(list, link);
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      const SdfJoint& joint = model_.joints[j];
      std::vector<std::string>& names = joint_names_.emplace_back();
      if (!is_used(j)) continue;
      if (joint.type == SdfJointType::ball) {
        names.push_back(names_.add(joint.name, joint.where));
        nodes_.put(nodes_.add_named(list, names[0], joint.where), "type",
                   nodes_.text("quaternion", joint.where));
      }
      for (std::size_t a = 0; a < joint.axes.size(); ++a) {
        names.push_back(
            names_.add(joint.name, joint.where, joint.axes.size() == 1 ? "" : fmt::format("_{}", a + 1)));
        if (!joint.axes[a].mimic) add_coordinate(list, joint, joint.axes[a], names.back());
      }
    }
  }

  void add_free(YamlNode& list, std::size_t link) {
    const SdfLink& of = model_.links[link];
    for (const char* suffix : {"_x", "_y", "_z", "_rotation"})
      free_names_[link].push_back(names_.add(of.name, of.where, suffix));
    for (int i = 0; i < 4; ++i) {
      YamlNode& node = nodes_.add_named(list, free_names_[link][static_cast<std::size_t>(i)], of.where);
      if (i < 3) {
        const double initial = shift_without_rounding(of.pose)[static_cast<std::size_t>(i)];
        if (initial != 0) nodes_.put(node, "initial", nodes_.text(number_text(initial), of.where));
      } else {
        nodes_.put(node, "type", nodes_.text("quaternion", of.where));
        const Eigen::Quaterniond& q = of.pose.turn;
        if (!q.vec().isZero())
          nodes_.put(
              node, "initial",
              nodes_.list({number_text(q.x()), number_text(q.y()), number_text(q.z()), number_text(q.w())},
                          of.where));
      }
      if (node.items.size() == 2) list.items.back() = node.items[1];
    }
  }

  void add_coordinate(YamlNode& list, const SdfJoint& joint, const SdfAxis& axis, const std::string& name) {
    const SourceLocation& where = axis.where;
    YamlNode& node = nodes_.mapping(where);
    nodes_.put(node, "name", nodes_.text(name, joint.where));  // which stands elsewhere
    const bool turns = joint.type != SdfJointType::prismatic;
    const auto text = [&](double value) {
      return turns ? SnappedAngle(value, 1e-12).text() : number_text(value);
    };
    double initial = axis.initial;
    if (axis.limits) {
      initial = std::clamp(initial, (*axis.limits)[0], (*axis.limits)[1]);
      if (initial != axis.initial)
        warnings_.push_back(
            {where,
             fmt::format("joint '{}' begins outside its limits; it is moved to the nearer one", name),
             {},
             "begins outside"});
    }
    if (initial != 0) nodes_.put(node, "initial", nodes_.text(text(initial), where));
    if (axis.limits)
      nodes_.put(node, "limits", nodes_.list({text((*axis.limits)[0]), text((*axis.limits)[1])}, where));
    const auto number = [&](const char* key, double value) {
      if (value != 0) nodes_.put(node, key, nodes_.text(number_text(value), where));
    };
    if (options_.resistance) number("damping", axis.damping);
    if (options_.resistance && axis.friction != 0) {
      nodes_.put_friction(node, axis.friction, where);
    }
    number("stiffness", axis.stiffness);
    if (axis.stiffness != 0) number("rest", axis.rest);
    if (axis.effort) number("effort", *axis.effort);
    if (axis.speed) number("speed", *axis.speed);
    list.items.push_back(node.items.size() == 2 ? node.items[1] : &node);
  }

  // What follows others.
  Following following(std::size_t joint, std::size_t axis) const {
    Following out{joint, axis};
    while (const std::optional<SdfMimic>& mimic = axis_of(out.joint, out.axis).mimic) {
      out.offset += out.factor * (mimic->offset - mimic->multiplier * mimic->reference);
      out.factor *= mimic->multiplier;
      out.joint = mimic->joint;
      out.axis = mimic->axis;
    }
    return out;
  }

  void add_definitions(YamlNode& definitions) {
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      if (!is_used(j)) continue;
      for (std::size_t a = 0; a < model_.joints[j].axes.size(); ++a) {
        if (!axis_of(j, a).mimic) continue;
        const Following of = following(j, a);
        std::string value = joint_names_[of.joint][of.axis];
        if (of.factor != 1) value = fmt::format("{}*{}", number_text(of.factor), value);
        if (of.offset != 0)
          value += fmt::format(" {} {}", of.offset < 0 ? '-' : '+', number_text(std::abs(of.offset)));
        nodes_.put(definitions, joint_names_[j][a], nodes_.text(value, axis_of(j, a).mimic->where));
      }
    }
  }

  // Bodies.
  void add_joint(YamlNode& list, std::size_t j) const {
    const SdfJoint& joint = model_.joints[j];
    const std::vector<std::string>& names = joint_names_[j];
    if (joint.type == SdfJointType::ball) {
      list.items.push_back(
          &nodes_.single("rotate", nodes_.single("quaternion", nodes_.text(names[0], joint.where))));
      return;
    }
    for (std::size_t a = 0; a < joint.axes.size(); ++a) {
      const SdfAxis& axis = joint.axes[a];
      const std::array<double, 3> xyz = entries(axis.xyz);
      const bool slides = joint.type == SdfJointType::prismatic;
      if (!axis.mimic && joint.type != SdfJointType::screw) {
        factors_.add_joint(list, slides ? "prismatic" : "revolute", xyz, names[a], axis.where);
        continue;
      }
      if (!slides) factors_.add_rotation(list, factors_.axis(xyz, axis.where), names[a], axis.where);
      if (slides) factors_.add_shift_along(list, xyz, names[a], axis.where);
      if (joint.type == SdfJointType::screw)
        factors_.add_shift_along(list, xyz, fmt::format("{}*{}", number_text(joint.pitch), names[a]),
                                 axis.where);
    }
  }

  void add_body(YamlNode& list, std::size_t link) {
    const SdfLink& of = model_.links[link];
    const SdfPlace& place = tree_.places[link];
    if (of.fixed && !has_solid(of.shapes)) return;
    YamlNode& node = nodes_.add_named(list, link_names_[link], of.where);
    YamlNode& factors = nodes_.sequence(of.where);
    if (place.free) {
      factors_.add_free(factors, free_names_[link], of.where);
    } else if (place.joint == kNoSdfJoint) {
      factors_.add_pose(factors, of.pose, of.where);
    } else {
      const SdfJoint& joint = model_.joints[place.joint];
      const std::size_t parent = place.reversed ? joint.child : joint.parent;
      if (parent != kSdfWorld) nodes_.put(node, "parent", nodes_.text(link_names_[parent], joint.where));
      const RigidPose& from = place.reversed ? joint.in_child : joint.in_parent;
      const RigidPose to = inverse(place.reversed ? joint.in_parent : joint.in_child);
      if (joint.type == SdfJointType::fixed) {
        factors_.add_pose(factors, from * to, joint.where);
      } else {
        factors_.add_pose(factors, from, joint.where);
        YamlNode& own = place.reversed ? nodes_.sequence(joint.where) : factors;
        add_joint(own, place.joint);
        if (place.reversed) factors.items.push_back(&nodes_.single("inverse", own));
        factors_.add_pose(factors, to, joint.where);
      }
    }
    if (!factors.items.empty()) nodes_.put(node, "transform", factors);
    if (!of.fixed) add_mass(nodes_, node, of.mass, of.where);
    YamlNode& shapes = nodes_.sequence(of.where);
    for (const PlacedShape& shape : of.shapes) add_shape(nodes_, factors_, shapes, shape, options_.folder);
    if (!shapes.items.empty()) nodes_.put(node, "geometry", shapes);
  }

  void add_frame(YamlNode& list, const std::string& name, std::size_t link, const RigidPose& pose,
                 const SourceLocation& where) {
    factors_.add_frame(list, name, link_name(link), pose, where);
  }

  // Forces.
  void add_forces(YamlNode& list, YamlNode& frames) {
    for (std::size_t j = 0; j < model_.joints.size(); ++j)
      if (is_used(j))
        for (std::size_t a = 0; a < model_.joints[j].axes.size(); ++a)
          if (axis_of(j, a).mimic) add_forces_of_follower(list, j, a);
    for (std::size_t link = 0; link < model_.links.size(); ++link) {
      const SdfLink& of = model_.links[link];
      if (!of.weightless || of.fixed || of.mass.mass == 0) continue;
      const std::string frame = frame_names_.add(of.name, of.where, "_centre");
      add_frame(frames, frame, link, of.mass.frame(), of.where);
      add_borne_weight(nodes_, list, force_names_.add(of.name, of.where, "_weightless"), frame,
                       -of.mass.mass * model_.gravity, of.where);
    }
  }

  void add_forces_of_follower(YamlNode& list, std::size_t j, std::size_t a) {
    const SdfAxis& axis = axis_of(j, a);
    const Following of = following(j, a);
    const std::string &own = joint_names_[j][a], &base = joint_names_[of.joint][of.axis];
    const auto add = [&](const char* what, const char* key, const std::string& value) {
      YamlNode& force = nodes_.add_named(list, force_names_.add(own, axis.where, what), axis.where);
      if (key == std::string_view("value")) nodes_.put(force, "on", nodes_.text(base, axis.where));
      nodes_.put(force, key, nodes_.text(value, axis.where));
    };
    if (options_.resistance && axis.damping != 0)
      add("_damping", "value",
          fmt::format("{}*d({})", number_text(-of.factor * of.factor * axis.damping), base));
    if (options_.resistance && axis.friction != 0)
      add("_friction", "value",
          fmt::format("{}*tanh({}*d({}))", number_text(-of.factor * axis.friction),
                      number_text(of.factor / kFrictionVelocity), base));
    if (axis.stiffness != 0)
      add("_spring", "potential",
          fmt::format("{}*({} - ({}))^2", number_text(axis.stiffness / 2), own, number_text(axis.rest)));
  }

  // Loops.
  void add_constraint(YamlNode& list, YamlNode& forces, YamlNode& frames, std::size_t cut) {
    const SdfJoint& joint = model_.joints[cut];
    const std::string name = constraint_names_.add(joint.name, joint.where);
    std::array<std::string, 2> ends;
    LoopEquations loop([&](int end, const std::string& suffix, const Eigen::Vector3d& offset) {
      const RigidPose& pose = end == 1 ? joint.in_parent : joint.in_child;
      const std::string frame =
          frame_names_.add(fmt::format("{}_{}{}", joint.name, end, suffix), joint.where);
      add_frame(frames, frame, end == 1 ? joint.parent : joint.child, pose * RigidPose{offset}, joint.where);
      if (suffix.empty()) ends[static_cast<std::size_t>(end - 1)] = frame;
      return frame;
    });
    if (joint.type == SdfJointType::prismatic)
      loop.origin_on(joint.axes[0].xyz);
    else
      loop.origins_meet();
    switch (joint.type) {
      case SdfJointType::fixed:
      case SdfJointType::prismatic:
        loop.axes_meet();
        break;
      case SdfJointType::revolute:
        loop.axis_meets(joint.axes[0].xyz);
        break;
      case SdfJointType::universal:
        loop.angle_stays(joint.axes[0].xyz, joint.axes[1].xyz);
        break;
      case SdfJointType::ball:
      case SdfJointType::screw:
        break;
    }
    nodes_.add_holonomic(list, name, loop.take(), joint.where);
    for (const SdfAxis& axis : joint.axes)
      if (resists(axis)) add_resistance(forces, joint, axis, ends);
  }

  /// Of a hinge or slide that closes a chain: along its axis, on both ends.
  void add_resistance(YamlNode& list, const SdfJoint& joint, const SdfAxis& axis,
                      const std::array<std::string, 2>& ends) {
    const bool slides = joint.type == SdfJointType::prismatic;
    const char* velocity = slides ? "velocity" : "angular_velocity";
    std::string rate;
    for (const char row : {'x', 'y', 'z'}) {
      std::string direction;
      for (int k = 0; k < 3; ++k)
        if (axis.xyz[k] != 0)
          direction += fmt::format("{}({})*rotation({}).{}{}", direction.empty() ? "" : " + ",
                                   number_text(axis.xyz[k]), ends[0], row, "xyz"[k]);
      rate += fmt::format("{}({}({}).{} - {}({}).{})*({})", rate.empty() ? "" : " + ", velocity, ends[1], row,
                          velocity, ends[0], row, direction);
    }
    std::string resistance;
    if (axis.damping != 0) resistance = fmt::format("{}*({})", number_text(axis.damping), rate);
    if (axis.friction != 0)
      resistance += fmt::format("{}{}*tanh(({})/{})", resistance.empty() ? "" : " + ",
                                number_text(axis.friction), rate, number_text(kFrictionVelocity));
    for (std::size_t end = 0; end < 2; ++end) {
      if ((end == 0 ? joint.parent : joint.child) == kSdfWorld) continue;
      std::array<std::string, 3> along;
      for (int k = 0; k < 3; ++k) {
        const double factor = (end == 0 ? 1 : -1) * axis.xyz[k];
        along[static_cast<std::size_t>(k)] =
            factor == 0 ? "0" : fmt::format("({})*({})", number_text(factor), resistance);
      }
      YamlNode& node =
          nodes_.add_named(list, force_names_.add(ends[end], axis.where, "_resistance"), axis.where);
      nodes_.put(node, "at", nodes_.text(ends[end], axis.where));
      nodes_.put(node, slides ? "force" : "torque", nodes_.list({along[0], along[1], along[2]}, axis.where));
    }
  }

  const SdfModel& model_;
  const DescribeOptions& options_;
  SdfTree tree_;
  mutable DescriptionNodes nodes_;
  TransformFactors factors_;
  Warnings warnings_;
  FitNames body_names_{"link", warnings_}, names_{"joint", warnings_}, frame_names_{"frame", warnings_},
      force_names_{"force", warnings_}, constraint_names_{"constraint", warnings_};
  std::vector<std::string> link_names_;
  std::vector<std::vector<std::string>> free_names_, joint_names_;  ///< by link; by joint and axis
};

}  // namespace

DescribedRobot describe_sdf(const std::shared_ptr<const SourceText>& source, const DescribeOptions& options,
                            Warnings& warnings) {
  const SdfModel model = read_sdf(source, options.include_folders, warnings);
  return SdfDescriber(model, options).describe(source);
}

}  // namespace alembert
