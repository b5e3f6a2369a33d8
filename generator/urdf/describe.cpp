// Links to bodies and frames, joints to coordinates and factors of transforms.
#include "urdf/describe.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <numeric>

#include "urdf/description_nodes.hpp"
#include "urdf/joint_factors.hpp"
#include "urdf/names.hpp"
#include "urdf/snapped_angle.hpp"

namespace alembert {
namespace {

class Describer {
 public:
  Describer(const UrdfRobot& robot, const DescribeOptions& options) : robot_(robot), options_(options) {}

  DescribedRobot describe(std::shared_ptr<const SourceText> source) {
    const SourceLocation& top = robot_.where;
    name_links();
    YamlNode& coordinates = nodes_.sequence(top);
    add_coordinates(coordinates);
    if (coordinates.items.empty())
      throw InputError(top, "no joint of the robot moves", "a robot without joints can have a floating root");
    const YamlNode& definitions = add_definitions();
    check_masses();
    YamlNode& bodies = nodes_.sequence(top);
    YamlNode& frames = nodes_.sequence(top);
    for (std::size_t link = 0; link < robot_.links.size(); ++link) {
      if (link == robot_.root && root_is_world_) continue;
      (is_frame(link) ? frames : bodies).items.push_back(&add_link(link));
    }
    YamlNode& root = nodes_.mapping(top);
    nodes_.put(root, "alembert", nodes_.text("1", top));
    nodes_.put(root, "name", nodes_.text(fit_name(robot_.name, "robot"), top));
    nodes_.put(root, "description", nodes_.text(fmt::format("URDF robot '{}'", printable(robot_.name)), top));
    nodes_.put(root, "coordinates", coordinates);
    if (!definitions.items.empty()) nodes_.put(root, "definitions", definitions);
    nodes_.put(root, "bodies", bodies);
    if (!frames.items.empty()) nodes_.put(root, "frames", frames);
    warn();
    return {Document(std::move(source), nodes_.take(), root), std::move(warnings_)};
  }

 private:
  // Names and coordinates.
  bool has_mass(std::size_t link) const {
    const std::optional<UrdfInertial>& inertial = robot_.links[link].inertial;
    return inertial &&
           (inertial->mass != 0 || std::ranges::any_of(inertial->inertia, [](double i) { return i != 0; }));
  }
  bool is_bare(std::size_t link) const { return !has_mass(link) && robot_.links[link].shapes.empty(); }
  bool is_frame(std::size_t link) const {
    return link != robot_.root && is_bare(link) && robot_.children[link].empty() &&
           robot_.joints[robot_.joint_of[link]].type == UrdfJointType::fixed;
  }

  void name_links() {
    root_is_world_ = !options_.floating && robot_.links[robot_.root].name == "world" && is_bare(robot_.root);
    FitNames bodies("link"), frames("link");
    for (std::size_t link = 0; link < robot_.links.size(); ++link) {
      const UrdfLink& of = robot_.links[link];
      const bool world = link == robot_.root && root_is_world_;
      link_names_.push_back(world ? "world" : (is_frame(link) ? frames : bodies).add(of.name, of.where));
    }
  }

  void add_coordinate(YamlNode& list, const std::string& name, const SourceLocation& where,
                      const std::optional<std::array<double, 2>>& limits = {}) {
    if (!limits) {
      list.items.push_back(&nodes_.text(name, where));
      return;
    }
    YamlNode& node = nodes_.mapping(where);
    nodes_.put(node, "name", nodes_.text(name, where));
    const double initial = std::clamp(0.0, (*limits)[0], (*limits)[1]);
    if (initial != 0) nodes_.put(node, "initial", nodes_.text(number_text(initial), where));
    nodes_.put(node, "limits", nodes_.list({number_text((*limits)[0]), number_text((*limits)[1])}, where));
    list.items.push_back(&node);
  }
  /// Position and rotation of what moves freely; their names.
  std::vector<std::string> add_free(YamlNode& list, const std::string& name, const SourceLocation& where) {
    std::vector<std::string> names;
    for (const char* suffix : {"_x", "_y", "_z", "_rotation"})
      names.push_back(names_.add(name, where, suffix));
    for (std::size_t i = 0; i < 3; ++i) add_coordinate(list, names[i], where);
    YamlNode& rotation = nodes_.mapping(where);
    nodes_.put(rotation, "name", nodes_.text(names[3], where));
    nodes_.put(rotation, "type", nodes_.text("quaternion", where));
    list.items.push_back(&rotation);
    return names;
  }

  void add_coordinates(YamlNode& list) {
    const UrdfLink& root = robot_.links[robot_.root];
    if (options_.floating) root_names_ = add_free(list, root.name, root.where);
    for (const UrdfJoint& joint : robot_.joints) {
      std::vector<std::string>& names = joint_names_.emplace_back();
      switch (joint.type) {
        case UrdfJointType::fixed:
          break;
        case UrdfJointType::floating:
          names = add_free(list, joint.name, joint.where);
          break;
        case UrdfJointType::planar:
          for (const char* suffix : {"_x", "_y", "_angle"}) {
            names.push_back(names_.add(joint.name, joint.where, suffix));
            add_coordinate(list, names.back(), joint.where);
          }
          break;
        case UrdfJointType::revolute:
        case UrdfJointType::continuous:
        case UrdfJointType::prismatic:
          names.push_back(names_.add(joint.name, joint.where));
          if (!joint.mimic) add_coordinate(list, names.back(), joint.where, joint.limits);
          break;
      }
    }
  }

  /// Positions of mimicking joints, those that others need first.
  const YamlNode& add_definitions() {
    YamlNode& out = nodes_.mapping(robot_.where);
    driver_.resize(robot_.joints.size());
    std::iota(driver_.begin(), driver_.end(), std::size_t{0});
    std::vector<bool> defined(robot_.joints.size(), false);
    std::vector<std::size_t> path;
    for (std::size_t first = 0; first < robot_.joints.size(); ++first) {
      for (std::size_t at = first; robot_.joints[at].mimic && !defined[at];
           at = robot_.joints[at].mimic->of) {
        path.push_back(at);
        defined[at] = true;
      }
      for (; !path.empty(); path.pop_back()) {
        const std::size_t at = path.back();
        const UrdfMimic& mimic = *robot_.joints[at].mimic;
        driver_[at] = driver_[mimic.of];
        std::string value = joint_names_[mimic.of][0];
        if (mimic.multiplier != 1) value = fmt::format("{}*{}", number_text(mimic.multiplier), value);
        if (mimic.offset != 0)
          value += fmt::format(" {} {}", mimic.offset < 0 ? '-' : '+', number_text(std::abs(mimic.offset)));
        nodes_.put(out, joint_names_[at][0], nodes_.text(std::move(value), mimic.where));
      }
    }
    return out;
  }

  /// Every coordinate must move mass.
  void check_masses() const {
    std::vector<std::size_t> order{robot_.root};
    for (std::size_t i = 0; i < order.size(); ++i)
      for (const std::size_t j : robot_.children[order[i]]) order.push_back(robot_.joints[j].child);
    std::vector<bool> heavy(robot_.links.size(), false), moves_mass(robot_.joints.size(), false);
    for (std::size_t i = order.size(); i-- > 0;) {
      const std::size_t link = order[i];
      if (has_mass(link)) heavy[link] = true;
      if (link == robot_.root || !heavy[link]) continue;
      const std::size_t joint = robot_.joint_of[link];
      heavy[robot_.joints[joint].parent] = true;
      moves_mass[driver_[joint]] = true;
    }
    const UrdfLink& root = robot_.links[robot_.root];
    if (options_.floating && !heavy[robot_.root])
      throw InputError(root.where, fmt::format("the floating root '{}' moves no mass", printable(root.name)));
    for (std::size_t j = 0; j < robot_.joints.size(); ++j)
      if (!joint_names_[j].empty() && driver_[j] == j && !moves_mass[j])
        throw InputError(robot_.joints[j].where,
                         fmt::format("joint '{}' moves no mass", printable(robot_.joints[j].name)),
                         "give its link an <inertial>, or make it fixed");
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
    if (has_mass(link)) add_inertial(node, *of.inertial);
    if (!of.shapes.empty()) add_shapes(node, of);
    return node;
  }

  void add_inertial(YamlNode& node, const UrdfInertial& inertial) {
    nodes_.put(node, "mass", nodes_.text(number_text(inertial.mass), inertial.mass_where));
    if (inertial.origin.xyz != std::array<double, 3>{})
      nodes_.put(node, "com", nodes_.numbers(inertial.origin.xyz, inertial.origin.where));
    const auto& i = inertial.inertia;
    if (std::ranges::all_of(i, [](double x) { return x == 0; })) return;
    Eigen::Matrix3d inertia;
    inertia << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
    for (const int about : {0, 1, 2}) {
      const SnappedAngle angle(inertial.origin.rpy[static_cast<std::size_t>(about)], options_.snap_angles);
      if (angle.is_zero()) continue;
      const auto [c, s] = angle.cosine_and_sine();
      const int u = (about + 1) % 3, v = (about + 2) % 3;
      Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
      turn(u, u) = turn(v, v) = c;
      turn(v, u) = s;
      turn(u, v) = -s;
      inertia = (turn * inertia * turn.transpose()).eval();
    }
    YamlNode& entries = nodes_.mapping(inertial.inertia_where);
    constexpr std::string_view kKeys[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
    for (const std::string_view key : kKeys) {
      const double value = inertia(key[0] - 'x', key[1] - 'x');
      if (key[0] == key[1] || value != 0)
        nodes_.put(entries, std::string(key), nodes_.text(number_text(value), inertial.inertia_where));
    }
    nodes_.put(node, "inertia", entries);
  }

  void add_shapes(YamlNode& node, const UrdfLink& link) {
    YamlNode& shapes = nodes_.sequence(link.where);
    for (const UrdfShape& shape : link.shapes) {
      const std::vector<double>& sizes = shape.sizes;
      YamlNode& item = nodes_.mapping(shape.where);
      const auto put_radius_and_length = [&](std::string key) {
        YamlNode& size = nodes_.mapping(shape.where);
        nodes_.put(size, "radius", nodes_.text(number_text(sizes[0]), shape.where));
        nodes_.put(size, "length", nodes_.text(number_text(sizes[1]), shape.where));
        nodes_.put(item, std::move(key), size);
      };
      switch (shape.kind) {
        case UrdfShape::Kind::box:
          nodes_.put(item, "box", nodes_.numbers({sizes[0], sizes[1], sizes[2]}, shape.where));
          break;
        case UrdfShape::Kind::sphere:
          nodes_.put(item, "sphere", nodes_.text(number_text(sizes[0]), shape.where));
          break;
        case UrdfShape::Kind::cylinder:
          put_radius_and_length("cylinder");
          break;
        case UrdfShape::Kind::capsule:
          put_radius_and_length("capsule");
          break;
      }
      YamlNode& factors = nodes_.sequence(shape.where);
      factors_.add_origin(factors, shape.origin);
      if (!factors.items.empty()) nodes_.put(item, "transform", factors);
      if (shape.color) nodes_.put(item, "color", nodes_.numbers(*shape.color, shape.where));
      shapes.items.push_back(&item);
    }
    nodes_.put(node, "geometry", shapes);
  }

  void count_nearly_right(const UrdfPose& pose) {
    for (const double radians : pose.rpy)
      if (SnappedAngle(radians, options_.snap_angles).nearly_right() && nearly_right_++ == 0)
        nearly_right_at_ = pose.where;
  }

  void warn() {
    if (nearly_right_ > 0)
      warnings_.push_back(warning_text(
          nearly_right_at_,
          fmt::format(
              "{} angle{} nearly a right angle but not one, as here: such axes are not parallel, and the "
              "code is longer; --snap-angles 1e-3 takes them for right angles",
              nearly_right_, nearly_right_ == 1 ? " is" : "s are")));
    const auto resists = std::ranges::find(robot_.joints, true, &UrdfJoint::resists);
    if (resists != robot_.joints.end())
      warnings_.push_back(
          warning_text(resists->where,
                       "damping and friction are no part of the equations: subtract them from the forces"));
  }

  const UrdfRobot& robot_;
  const DescribeOptions& options_;
  DescriptionNodes nodes_;
  JointFactors factors_{nodes_, options_.snap_angles};
  FitNames names_{"joint"};
  bool root_is_world_ = false;
  std::vector<std::string> link_names_;                ///< by link
  std::vector<std::string> root_names_;                ///< coordinates of a floating root
  std::vector<std::vector<std::string>> joint_names_;  ///< by joint: coordinates, or a definition
  std::vector<std::size_t> driver_;  ///< by joint: itself, or that which it mimics in the end
  int nearly_right_ = 0;
  SourceLocation nearly_right_at_;
  std::vector<std::string> warnings_;
};

}  // namespace

DescribedRobot describe_robot(const UrdfRobot& robot, std::shared_ptr<const SourceText> source,
                              const DescribeOptions& options) {
  return Describer(robot, options).describe(std::move(source));
}

}  // namespace alembert
