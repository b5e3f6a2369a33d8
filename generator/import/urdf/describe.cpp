// Links to bodies and frames, joints to coordinates and factors of transforms.
#include "import/urdf/describe.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "import/common/description_nodes.hpp"
#include "import/common/fit_names.hpp"
#include "import/common/snapped_angle.hpp"
#include "import/urdf/joint_factors.hpp"
#include "import/urdf/link_nodes.hpp"
#include "import/urdf/massless.hpp"

namespace alembert {
namespace {

class Describer {
 public:
  Describer(const UrdfRobot& robot, const DescribeOptions& options)
      : robot_(robot), options_(options), massless_(massless_joints(robot)) {}

  DescribedRobot describe(std::shared_ptr<const SourceText> source) {
    const SourceLocation& top = robot_.where;
    name_links();
    YamlNode& coordinates = nodes_.sequence(top);
    add_coordinates(coordinates);
    if (coordinates.items.empty()) fail_without_coordinates();
    const YamlNode& definitions = add_definitions();
    YamlNode& bodies = nodes_.sequence(top);
    YamlNode& frames = nodes_.sequence(top);
    for (std::size_t link = 0; link < robot_.links.size(); ++link) {
      if (link == robot_.root && root_is_world_) continue;
      (is_frame(link) ? frames : bodies).items.push_back(&add_link(link));
    }
    YamlNode& root = nodes_.root(options_.name_or(robot_.name),
                                 fmt::format("URDF robot '{}'", printable(robot_.name)), top);
    nodes_.put(root, "coordinates", coordinates);
    if (!definitions.items.empty()) nodes_.put(root, "definitions", definitions);
    nodes_.put(root, "bodies", bodies);
    if (!frames.items.empty()) nodes_.put(root, "frames", frames);
    YamlNode& forces = nodes_.sequence(top);
    add_forces(forces);
    if (!forces.items.empty()) nodes_.put(root, "forces", forces);
    warn();
    return {Document(std::move(source), nodes_.take(), root), std::move(warnings_),
            left_text({}, robot_.left_out)};
  }

 private:
  // Names and coordinates.
  /// Shapes of a frame are drawn with the body that it is on, which must be there.
  bool is_frame(std::size_t link) const {
    const UrdfLink& of = robot_.links[link];
    if (link == robot_.root || has_mass(of) || !robot_.children[link].empty()) return false;
    const UrdfJoint& joint = robot_.joints[robot_.joint_of[link]];
    const bool on_world = root_is_world_ && joint.parent == robot_.root;
    return joint.type == UrdfJointType::fixed && (of.shapes.empty() || !on_world);
  }

  void name_links() {
    const UrdfLink& root = robot_.links[robot_.root];
    root_is_world_ = !options_.floating && root.name == "world" && !has_mass(root) && !has_solid(root.shapes);
    FitNames bodies("link", warnings_), frames("link", warnings_);
    for (const UrdfLink& link : robot_.links) {
      bodies.reserve(link.name);
      frames.reserve(link.name);
    }
    for (std::size_t link = 0; link < robot_.links.size(); ++link) {
      const UrdfLink& of = robot_.links[link];
      const bool world = link == robot_.root && root_is_world_;
      link_names_.push_back(world ? "world" : (is_frame(link) ? frames : bodies).add(of.name, of.where));
    }
  }

  void add_coordinate(YamlNode& list, const std::string& name, const SourceLocation& where, bool massless,
                      const UrdfJoint* joint = nullptr, const char* type = nullptr) {
    const std::array<double, 2>* limits = joint != nullptr && joint->limits ? &*joint->limits : nullptr;
    std::vector<std::pair<const char*, double>> numbers;
    const double armature =
        joint != nullptr ? rotors_[static_cast<std::size_t>(joint - robot_.joints.data())] : 0;
    if (armature > 0)
      numbers.emplace_back("armature", armature);
    else if (massless && options_.massless == Massless::armature)
      numbers.emplace_back("armature", options_.armature);
    const bool rubbed = joint != nullptr && options_.resistance && joint->friction != 0;
    if (joint != nullptr) {
      if (options_.resistance && joint->damping != 0) numbers.emplace_back("damping", joint->damping);
      if (joint->effort) numbers.emplace_back("effort", *joint->effort);
      if (joint->velocity) numbers.emplace_back("speed", *joint->velocity);
    }
    if (limits == nullptr && numbers.empty() && !rubbed && type == nullptr) {
      list.items.push_back(&nodes_.text(name, where));
      return;
    }
    YamlNode& node = nodes_.add_named(list, name, where);
    if (type != nullptr) nodes_.put(node, "type", nodes_.text(type, where));
    if (limits != nullptr) {
      const double initial = std::clamp(0.0, (*limits)[0], (*limits)[1]);
      if (initial != 0) nodes_.put(node, "initial", nodes_.text(number_text(initial), where));
      nodes_.put(node, "limits", nodes_.list({number_text((*limits)[0]), number_text((*limits)[1])}, where));
    }
    for (const auto& [key, value] : numbers) nodes_.put(node, key, nodes_.text(number_text(value), where));
    if (rubbed) nodes_.put_friction(node, joint->friction, where);
  }
  /// Inertia that rotors have for each joint: that of its own drive, and those of joints that mimic it.
  std::vector<double> rotors() const {
    std::vector<double> out(robot_.joints.size(), 0);
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
      const UrdfJoint& driven = robot_.joints[i];
      if (driven.rotor_inertia == 0) continue;
      const auto [of, multiplier] = moved_by(i);
      const double turns = multiplier * driven.reduction;
      out[of] += turns * turns * driven.rotor_inertia;
    }
    return out;
  }
  /// The joint at the end of a chain of mimics, and how far this one moves for it. (One that mimics none that
  /// is left stands still, and is an end too.)
  std::pair<std::size_t, double> moved_by(std::size_t joint) const {
    double multiplier = 1;
    while (robot_.joints[joint].mimic && robot_.joints[joint].mimic->of) {
      multiplier *= robot_.joints[joint].mimic->multiplier;
      joint = *robot_.joints[joint].mimic->of;
    }
    return {joint, multiplier};
  }
  /// Position and rotation of what moves freely; their names.
  std::vector<std::string> add_free(YamlNode& list, const std::string& name, const SourceLocation& where,
                                    bool massless) {
    std::vector<std::string> names;
    for (const char* suffix : {"_x", "_y", "_z", "_rotation"})
      names.push_back(names_.add(name, where, suffix));
    for (std::size_t i = 0; i < 3; ++i) add_coordinate(list, names[i], where, massless);
    add_coordinate(list, names[3], where, massless, nullptr, "quaternion");
    return names;
  }

  void add_coordinates(YamlNode& list) {
    const UrdfLink& root = robot_.links[robot_.root];
    for (const UrdfJoint& joint : robot_.joints)
      if (has_position(joint) || joint.type == UrdfJointType::spherical) names_.reserve(joint.name);
    if (options_.floating) root_names_ = add_free(list, root.name, root.where, root_is_massless());
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      const UrdfJoint& joint = robot_.joints[j];
      std::vector<std::string>& names = joint_names_.emplace_back();
      switch (joint.type) {
        case UrdfJointType::fixed:
          break;
        case UrdfJointType::floating:
          names = add_free(list, joint.name, joint.where, massless_[j]);
          break;
        case UrdfJointType::spherical:
          names.push_back(names_.add(joint.name, joint.where));
          add_coordinate(list, names[0], joint.where, massless_[j], nullptr, "quaternion");
          break;
        case UrdfJointType::planar:
          for (const char* suffix : {"_x", "_y", "_angle"}) {
            names.push_back(names_.add(joint.name, joint.where, suffix));
            add_coordinate(list, names.back(), joint.where, massless_[j]);
          }
          break;
        case UrdfJointType::revolute:
        case UrdfJointType::continuous:
        case UrdfJointType::prismatic:
          names.push_back(names_.add(joint.name, joint.where));
          if (!joint.mimic) add_coordinate(list, names.back(), joint.where, massless_[j], &joint);
          break;
      }
    }
  }

  /// Positions of mimicking joints, those that others need first.
  const YamlNode& add_definitions() {
    YamlNode& out = nodes_.mapping(robot_.where);
    std::vector<bool> defined(robot_.joints.size(), false);
    std::vector<std::size_t> path;
    for (std::size_t first = 0; first < robot_.joints.size(); ++first) {
      for (std::size_t at = first; robot_.joints[at].mimic && !defined[at];
           at = *robot_.joints[at].mimic->of) {
        path.push_back(at);
        defined[at] = true;
        if (!robot_.joints[at].mimic->of) break;
      }
      for (; !path.empty(); path.pop_back()) {
        const UrdfMimic& mimic = *robot_.joints[path.back()].mimic;
        nodes_.put(out, joint_names_[path.back()][0], nodes_.text(position_of(mimic), mimic.where));
      }
    }
    return out;
  }
  std::string position_of(const UrdfMimic& mimic) const {
    if (!mimic.of) return number_text(mimic.offset);
    std::string value = joint_names_[*mimic.of][0];
    if (mimic.multiplier != 1) value = fmt::format("{}*{}", number_text(mimic.multiplier), value);
    if (mimic.offset != 0)
      value += fmt::format(" {} {}", mimic.offset < 0 ? '-' : '+', number_text(std::abs(mimic.offset)));
    return value;
  }

  /// Damping and friction of joints that mimic others act on those.
  void add_forces(YamlNode& out) {
    if (!options_.resistance) return;
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
      const UrdfJoint& joint = robot_.joints[i];
      if (!joint.mimic || (joint.damping == 0 && joint.friction == 0)) continue;
      const auto [of, multiplier] = moved_by(i);
      if (robot_.joints[of].mimic) continue;  // stands still
      const std::string& coordinate = joint_names_[of][0];
      const auto add = [&](const char* what, const std::string& value) {
        YamlNode& force =
            nodes_.add_named(out, force_names_.add(joint_names_[i][0], joint.where, what), joint.where);
        nodes_.put(force, "on", nodes_.text(coordinate, joint.where));
        nodes_.put(force, "value", nodes_.text(value, joint.where));
      };
      if (joint.damping != 0)
        add("_damping",
            fmt::format("{}*d({})", number_text(-multiplier * multiplier * joint.damping), coordinate));
      if (joint.friction != 0)
        add("_friction", fmt::format("{}*tanh({}*d({}))", number_text(-multiplier * joint.friction),
                                     number_text(multiplier / kFrictionVelocity), coordinate));
    }
  }

  [[noreturn]] void fail_without_coordinates() const {
    if (options_.massless == Massless::freeze || options_.massless == Massless::drop)
      throw InputError(robot_.where, "no joint of the robot moves mass: nothing that moves is left",
                       "--massless armature=1e-4 leaves all joints as they are");
    throw InputError(robot_.where, "no joint of the robot moves", "--root floating lets it move as one body");
  }

  bool root_is_massless() const {
    return std::ranges::none_of(robot_.links, [](const UrdfLink& link) { return has_mass(link); });
  }

  // Links.
  const YamlNode& add_link(std::size_t link) {
    const UrdfLink& of = robot_.links[link];
    const bool frame = is_frame(link), root = link == robot_.root;
    YamlNode& node = nodes_.mapping(of.where);
    nodes_.put(node, "name", nodes_.text(link_names_[link], of.where));
    YamlNode& factors = nodes_.sequence(of.where);
    if (!root) {
      const std::size_t j = robot_.joint_of[link];
      const UrdfJoint& joint = robot_.joints[j];
      if (const std::string& parent = link_names_[joint.parent]; frame || parent != "world")
        nodes_.put(node, frame ? "body" : "parent", nodes_.text(parent, joint.where));
      count_nearly_right(joint.origin);
      factors_.add_origin(factors, joint.origin);
      factors_.add_joint(factors, joint, joint_names_[j]);
    } else if (options_.floating) {
      factors_.add_free(factors, root_names_, of.where);
    }
    if (!factors.items.empty()) nodes_.put(node, "transform", factors);
    if (has_mass(of)) link_nodes_.add_inertial(node, *of.inertial);
    if (!frame) add_geometry(node, link);
    return node;
  }

  void add_geometry(YamlNode& node, std::size_t link) {
    YamlNode& shapes = nodes_.sequence(robot_.links[link].where);
    link_nodes_.add_shapes(shapes, robot_.links[link], {});
    for (const std::size_t j : robot_.children[link])
      if (const UrdfJoint& joint = robot_.joints[j]; is_frame(joint.child))
        link_nodes_.add_shapes(shapes, robot_.links[joint.child], joint.origin);
    if (!shapes.items.empty()) nodes_.put(node, "geometry", shapes);
  }

  void count_nearly_right(const UrdfPose& pose) {
    for (const double radians : pose.rpy)
      if (SnappedAngle(radians, options_.snap_angles).nearly_right() && nearly_right_++ == 0)
        nearly_right_at_ = pose.where;
  }

  void warn() {
    if (nearly_right_ > 0)
      warnings_.push_back(
          {nearly_right_at_,
           fmt::format(
               "{} angle{} nearly a right angle but not one, as here: such axes are not parallel, and the "
               "code is longer; --snap-angles 1e-3 takes them for right angles",
               nearly_right_, nearly_right_ == 1 ? " is" : "s are")});
    if (options_.massless == Massless::keep) warn_of_massless();
  }

  void warn_of_massless() {
    constexpr std::size_t kListed = 8;
    std::vector<std::string> names;
    std::optional<SourceLocation> where;
    const auto add = [&](const std::string& name, const SourceLocation& at) {
      if (!where) where = at;
      names.push_back(printable(name));
    };
    const UrdfLink& root = robot_.links[robot_.root];
    if (options_.floating && root_is_massless()) add(root.name, root.where);
    for (std::size_t j = 0; j < robot_.joints.size(); ++j)
      if (massless_[j]) add(robot_.joints[j].name, robot_.joints[j].where);
    if (!where) return;
    const std::size_t count = names.size(), listed = std::min(count, kListed);
    names.resize(listed);
    warnings_.push_back({*where,
                         fmt::format("{} joint{} no mass ({}{}): forward dynamics has no solution with {}",
                                     count, count == 1 ? " moves" : "s move", fmt::join(names, ", "),
                                     count > listed ? ", ..." : "", count == 1 ? "it" : "them"),
                         "--massless armature=1e-4 gives each the inertia of a rotor, kg m^2; --massless "
                         "freeze fixes it at zero; "
                         "--massless drop leaves it out, with what it moves"});
  }

  const UrdfRobot& robot_;
  const DescribeOptions& options_;
  DescriptionNodes nodes_;
  JointFactors factors_{nodes_, robot_, options_.snap_angles};
  LinkNodes link_nodes_{nodes_, factors_, options_};
  std::vector<bool> massless_;            ///< by joint
  std::vector<double> rotors_{rotors()};  ///< likewise
  Warnings warnings_;
  FitNames names_{"joint", warnings_}, force_names_{"force", warnings_};
  bool root_is_world_ = false;
  std::vector<std::string> link_names_;                ///< by link
  std::vector<std::string> root_names_;                ///< coordinates of a floating root
  std::vector<std::vector<std::string>> joint_names_;  ///< by joint: coordinates, or a definition
  int nearly_right_ = 0;
  SourceLocation nearly_right_at_;
};

}  // namespace

DescribedRobot describe_robot(const UrdfRobot& robot, std::shared_ptr<const SourceText> source,
                              const DescribeOptions& options) {
  if (options.massless != Massless::freeze && options.massless != Massless::drop)
    return Describer(robot, options).describe(std::move(source));
  DescribeOptions rest = options;  // a floating root is a massless joint, too, if nothing has mass
  rest.floating = options.floating && std::ranges::any_of(robot.links, has_mass);
  const UrdfRobot changed =
      options.massless == Massless::freeze ? with_massless_frozen(robot) : without_massless(robot);
  return Describer(changed, rest).describe(std::move(source));
}

}  // namespace alembert
