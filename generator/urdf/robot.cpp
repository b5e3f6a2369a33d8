// XML in, a robot out: what URDF defines, each element read where it stands, then the tree that joints make.
#include "urdf/robot.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "urdf/xml_text.hpp"

namespace alembert {
namespace {

using Colour = std::array<double, 3>;
using Indices = std::map<std::string, std::size_t, std::less<>>;

constexpr std::pair<std::string_view, UrdfJointType> kJointTypes[] = {
    {"revolute", UrdfJointType::revolute},   {"continuous", UrdfJointType::continuous},
    {"prismatic", UrdfJointType::prismatic}, {"fixed", UrdfJointType::fixed},
    {"floating", UrdfJointType::floating},   {"planar", UrdfJointType::planar},
};

class RobotReader {
 public:
  explicit RobotReader(std::shared_ptr<const SourceText> source) : xml_(std::move(source)) {}

  UrdfRobot read() {
    const pugi::xml_node root = xml_.root();
    if (std::string_view(root.name()) != "robot")
      throw InputError(xml_.where(root),
                       fmt::format("expected a <robot>, found <{}>", printable(root.name())),
                       "URDF is read, and no other format of robots");
    xml_.check_spelling(root, "the robot",
                        {"link", "joint", "material", "transmission", "gazebo", "sensor", "mujoco"},
                        {"name", "version"});
    robot_.name = xml_.require_attribute(root, "name", "the robot").value();
    robot_.where = xml_.where(root.attribute("name"));
    for (const pugi::xml_node material : root.children("material")) {
      const pugi::xml_attribute name = material.attribute("name");
      if (const std::optional<Colour> color = read_color(material)) colors_[name.value()] = *color;
    }
    for (const pugi::xml_node link : root.children("link")) read_link(link);
    if (robot_.links.empty()) throw InputError(xml_.where(root), "no <link> in the robot");
    for (const pugi::xml_node joint : root.children("joint")) read_joint(joint);
    find_tree();
    find_mimicked();
    return std::move(robot_);
  }

 private:
  /// The name of an element, entered with its index. Throws if it is taken.
  std::string read_name(pugi::xml_node element, std::string_view kind, Indices& indices) const {
    const pugi::xml_attribute attribute = xml_.require_attribute(element, "name", fmt::format("a {}", kind));
    std::string name = attribute.value();
    if (!indices.emplace(name, indices.size()).second)
      throw InputError(xml_.where(attribute), fmt::format("a second {} '{}'", kind, printable(name)));
    return name;
  }

  std::size_t find_link(pugi::xml_node element, std::string_view what) const {
    xml_.check_spelling(element, what, {}, {"link"});
    const pugi::xml_attribute attribute = xml_.require_attribute(element, "link", what);
    if (const auto found = links_.find(attribute.value()); found != links_.end()) return found->second;
    throw InputError(xml_.where(attribute),
                     fmt::format("unknown link '{}' as {}{}", printable(attribute.value()), what,
                                 did_you_mean(attribute.value(), keys(links_))));
  }
  static std::vector<std::string> keys(const Indices& indices) {
    std::vector<std::string> names;
    for (const auto& [name, index] : indices) names.push_back(name);
    return names;
  }

  UrdfPose read_origin(pugi::xml_node element, const std::string& what) const {
    UrdfPose pose;
    const pugi::xml_node origin = xml_.find(element, "origin", what);
    pose.where = xml_.where(origin ? origin : element);
    if (!origin) return pose;
    const std::string of = "the origin of " + what;
    xml_.check_spelling(origin, of, {}, {"xyz", "rpy"});
    if (const pugi::xml_attribute xyz = origin.attribute("xyz"))
      pose.xyz = xml_.numbers<3>(xyz, "the shift of " + of);
    if (const pugi::xml_attribute rpy = origin.attribute("rpy"))
      pose.rpy = xml_.numbers<3>(rpy, "roll, pitch and yaw of " + of);
    return pose;
  }

  std::optional<Colour> read_color(pugi::xml_node material) const {
    const pugi::xml_attribute rgba = material.child("color").attribute("rgba");
    if (!rgba) return std::nullopt;
    const std::array<double, 4> values = xml_.numbers<4>(rgba, "a color");
    for (const double value : values)
      if (value < 0 || value > 1)
        throw InputError(xml_.where(rgba),
                         fmt::format("a color has components from 0 to 1, found {}", value));
    return Colour{values[0], values[1], values[2]};
  }

  void read_link(pugi::xml_node element) {
    UrdfLink link;
    link.name = read_name(element, "link", links_);
    link.where = xml_.where(element.attribute("name"));
    const std::string what = fmt::format("link '{}'", printable(link.name));
    xml_.check_spelling(element, what, {"inertial", "visual", "collision", "contact", "sensor"},
                        {"name", "type"});
    if (const pugi::xml_node inertial = xml_.find(element, "inertial", what))
      link.inertial = read_inertial(inertial, "the inertial of " + what);
    for (const pugi::xml_node visual : element.children("visual"))
      read_shape(visual, "a visual of " + what, link.shapes);
    robot_.links.push_back(std::move(link));
  }

  UrdfInertial read_inertial(pugi::xml_node element, const std::string& what) const {
    xml_.check_spelling(element, what, {"origin", "mass", "inertia"}, {});
    UrdfInertial out;
    out.origin = read_origin(element, what);
    const pugi::xml_node mass = xml_.require(element, "mass", what);
    xml_.check_spelling(mass, "the mass in " + what, {}, {"value"});
    const pugi::xml_attribute value = xml_.require_attribute(mass, "value", "the mass in " + what);
    out.mass = xml_.number(value, "the mass in " + what);
    out.mass_where = xml_.where(value);
    const pugi::xml_node inertia = xml_.require(element, "inertia", what);
    out.inertia_where = xml_.where(inertia);
    // Some write the lower half as well.
    xml_.check_spelling(inertia, "the inertia in " + what, {},
                        {"ixx", "iyy", "izz", "ixy", "ixz", "iyz", "iyx", "izx", "izy"});
    constexpr const char* kEntries[] = {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"};
    for (std::size_t i = 0; i < 6; ++i)
      out.inertia[i] = xml_.number(xml_.require_attribute(inertia, kEntries[i], "the inertia in " + what),
                                   fmt::format("{} of {}", kEntries[i], what));
    return out;
  }

  void read_shape(pugi::xml_node visual, const std::string& what, std::vector<UrdfShape>& shapes) const {
    xml_.check_spelling(visual, what, {"origin", "geometry", "material"}, {"name"});
    const pugi::xml_node geometry = xml_.require(visual, "geometry", what);
    xml_.check_spelling(geometry, "the geometry of " + what, {"box", "sphere", "cylinder", "capsule", "mesh"},
                        {});
    UrdfShape shape;
    shape.origin = read_origin(visual, what);
    shape.where = xml_.where(geometry);
    const auto sizes = [&](pugi::xml_node element, std::initializer_list<const char*> names) {
      for (const char* name : names)
        shape.sizes.push_back(xml_.number(
            xml_.require_attribute(element, name, fmt::format("the {} of {}", element.name(), what)),
            fmt::format("the {} of {}", name, what)));
    };
    if (const pugi::xml_node box = geometry.child("box")) {
      const std::string of = "the box of " + what;
      const auto edges = xml_.numbers<3>(xml_.require_attribute(box, "size", of), "the size of " + of);
      shape.sizes.assign(edges.begin(), edges.end());
    } else if (const pugi::xml_node sphere = geometry.child("sphere")) {
      shape.kind = UrdfShape::Kind::sphere;
      sizes(sphere, {"radius"});
    } else if (const pugi::xml_node cylinder = geometry.child("cylinder")) {
      shape.kind = UrdfShape::Kind::cylinder;
      sizes(cylinder, {"radius", "length"});
    } else if (const pugi::xml_node capsule = geometry.child("capsule")) {
      shape.kind = UrdfShape::Kind::capsule;
      sizes(capsule, {"radius", "length"});
    } else {
      return;
    }
    if (const pugi::xml_node material = visual.child("material")) {
      const auto known = colors_.find(material.attribute("name").value());
      shape.color = read_color(material);
      if (!shape.color && known != colors_.end()) shape.color = known->second;
    }
    shapes.push_back(std::move(shape));
  }

  void read_joint(pugi::xml_node element) {
    // A <joint> of a transmission is elsewhere; these are the robot's own.
    UrdfJoint joint;
    joint.name = read_name(element, "joint", joints_);
    joint.where = xml_.where(element.attribute("name"));
    const std::string what = fmt::format("joint '{}'", printable(joint.name));
    xml_.check_spelling(element, what,
                        {"origin", "parent", "child", "axis", "limit", "mimic", "dynamics", "calibration",
                         "safety_controller"},
                        {"name", "type"});
    const pugi::xml_attribute type = xml_.require_attribute(element, "type", what);
    joint.type = read_type(type, what);
    joint.type_where = xml_.where(type);
    joint.parent = find_link(xml_.require(element, "parent", what), "the parent of " + what);
    joint.child = find_link(xml_.require(element, "child", what), "the child of " + what);
    joint.origin = read_origin(element, what);
    if (const pugi::xml_node axis = xml_.find(element, "axis", what)) {
      const std::string of = "the axis of " + what;
      xml_.check_spelling(axis, of, {}, {"xyz"});
      const pugi::xml_attribute xyz = xml_.require_attribute(axis, "xyz", of);
      joint.axis = xml_.numbers<3>(xyz, of);
      const auto& a = joint.axis;
      if (joint.type != UrdfJointType::fixed && a[0] == 0 && a[1] == 0 && a[2] == 0)
        throw InputError(xml_.where(xyz), of + " has length 0");
    }
    if (const pugi::xml_node limit = xml_.find(element, "limit", what)) {
      const std::string of = "the limits of " + what;
      xml_.check_spelling(limit, of, {}, {"lower", "upper", "effort", "velocity"});
      std::array<double, 2> limits{};
      constexpr const char* kEnds[] = {"lower", "upper"};
      for (std::size_t i = 0; i < 2; ++i)
        if (const pugi::xml_attribute end = limit.attribute(kEnds[i])) limits[i] = xml_.number(end, of);
      if (joint.type != UrdfJointType::continuous && limits[0] < limits[1]) joint.limits = limits;
    }
    if (const pugi::xml_node mimic = xml_.find(element, "mimic", what)) {
      const std::string of = "the mimic of " + what;
      xml_.check_spelling(mimic, of, {}, {"joint", "multiplier", "offset"});
      const pugi::xml_attribute name = xml_.require_attribute(mimic, "joint", of);
      joint.mimic = UrdfMimic{name.value(), 0, 1, 0, xml_.where(name)};
      if (const pugi::xml_attribute m = mimic.attribute("multiplier"))
        joint.mimic->multiplier = xml_.number(m, "the multiplier in " + of);
      if (const pugi::xml_attribute o = mimic.attribute("offset"))
        joint.mimic->offset = xml_.number(o, "the offset in " + of);
    }
    if (const pugi::xml_node dynamics = xml_.find(element, "dynamics", what)) {
      const std::string of = "the dynamics of " + what;
      xml_.check_spelling(dynamics, of, {}, {"damping", "friction"});
      for (const char* name : {"damping", "friction"})
        if (const pugi::xml_attribute value = dynamics.attribute(name))
          joint.resists |= xml_.number(value, fmt::format("the {} of {}", name, what)) != 0;
    }
    robot_.joints.push_back(std::move(joint));
  }

  UrdfJointType read_type(pugi::xml_attribute attribute, const std::string& what) const {
    const std::string text = attribute.value();
    std::vector<std::string> known;
    for (const auto& [name, type] : kJointTypes) {
      if (name == text) return type;
      known.emplace_back(name);
    }
    throw InputError(
        xml_.where(attribute),
        fmt::format("unknown type '{}' of {}{}", printable(text), what, did_you_mean(text, known)),
        "joints are revolute, continuous, prismatic, fixed, floating, planar");
  }

  void find_tree() {
    const std::size_t none = robot_.joints.size(), count = robot_.links.size();
    robot_.joint_of.assign(count, none);
    robot_.children.resize(count);
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      const UrdfJoint& joint = robot_.joints[j];
      std::size_t& of = robot_.joint_of[joint.child];
      if (of != none)
        throw InputError(
            joint.where,
            fmt::format("link '{}' is the child of joint '{}' already; a tree has one joint a link",
                        printable(robot_.links[joint.child].name), printable(robot_.joints[of].name)));
      of = j;
      robot_.children[joint.parent].push_back(j);
    }
    std::optional<std::size_t> root;
    for (std::size_t link = 0; link < count; ++link) {
      if (robot_.joint_of[link] != none) continue;
      if (root)
        throw InputError(
            robot_.links[link].where,
            fmt::format("link '{}' is the child of no joint, and '{}' is none either; a tree has one "
                        "such link, its root",
                        printable(robot_.links[link].name), printable(robot_.links[*root].name)));
      root = link;
    }
    if (!root) throw InputError(robot_.links[0].where, "every link is the child of a joint: no root");
    robot_.root = *root;
    // What the root does not reach goes round in a circle.
    std::vector<bool> reached(count, false);
    std::vector<std::size_t> open{*root};
    while (!open.empty()) {
      const std::size_t link = open.back();
      open.pop_back();
      reached[link] = true;
      for (const std::size_t j : robot_.children[link]) open.push_back(robot_.joints[j].child);
    }
    for (std::size_t link = 0; link < count; ++link)
      if (!reached[link])
        throw InputError(robot_.joints[robot_.joint_of[link]].where,
                         fmt::format("link '{}' is its own ancestor", printable(robot_.links[link].name)));
  }

  /// A joint can follow one that has a single position, and in the end one that follows none.
  void find_mimicked() {
    enum class Mark { unseen, on_path, good };
    std::vector<Mark> marks(robot_.joints.size(), Mark::unseen);
    std::vector<std::size_t> path;
    for (std::size_t first = 0; first < robot_.joints.size(); ++first) {
      std::size_t at = first;
      while (robot_.joints[at].mimic && marks[at] == Mark::unseen) {
        marks[at] = Mark::on_path;
        path.push_back(at);
        at = robot_.joints[at].mimic->of = mimicked(robot_.joints[at]);
      }
      if (marks[at] == Mark::on_path)
        throw InputError(robot_.joints[at].mimic->where,
                         fmt::format("joint '{}' mimics itself{}", printable(robot_.joints[at].name),
                                     path.back() == at ? "" : " by way of others"));
      for (; !path.empty(); path.pop_back()) marks[path.back()] = Mark::good;
    }
  }
  std::size_t mimicked(const UrdfJoint& joint) const {
    const auto found = joints_.find(joint.mimic->joint);
    if (found == joints_.end())
      throw InputError(joint.mimic->where, fmt::format("unknown joint '{}'{}", printable(joint.mimic->joint),
                                                       did_you_mean(joint.mimic->joint, keys(joints_))));
    for (const UrdfJoint* one : {&joint, &robot_.joints[found->second]})
      if (!has_position(*one))
        throw InputError(joint.mimic->where,
                         fmt::format("joint '{}' has no single position; only revolute, continuous and "
                                     "prismatic joints mimic and are mimicked",
                                     printable(one->name)));
    return found->second;
  }
  static bool has_position(const UrdfJoint& joint) {
    return joint.type == UrdfJointType::revolute || joint.type == UrdfJointType::continuous ||
           joint.type == UrdfJointType::prismatic;
  }

  XmlText xml_;
  UrdfRobot robot_;
  Indices links_, joints_;
  std::map<std::string, Colour, std::less<>> colors_;
};

}  // namespace

UrdfRobot read_urdf(std::shared_ptr<const SourceText> source) {
  return RobotReader(std::move(source)).read();
}

}  // namespace alembert
