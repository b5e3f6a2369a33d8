// XML in, a robot out: its links and joints, then the tree that they make and the joints that follow others.
#include "import/urdf/robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "import/common/xml_text.hpp"
#include "import/urdf/joint_elements.hpp"
#include "import/urdf/link_elements.hpp"

namespace alembert {
namespace {

/// Elements that close chains. URDF has none, but some dialects do.
constexpr std::string_view kLoops[] = {"loop_joint", "loop", "constraint"};

/// What a <mujoco> says that would change equations, by its element.
constexpr std::pair<const char*, const char*> kMujoco[] = {{"compiler", "balanceinertia"},
                                                           {"compiler", "boundinertia"},
                                                           {"compiler", "boundmass"},
                                                           {"compiler", "inertiafromgeom"},
                                                           {"compiler", "inertiagrouprange"},
                                                           {"compiler", "settotalmass"},
                                                           {"option", "density"},
                                                           {"option", "gravity"},
                                                           {"option", "viscosity"},
                                                           {"option", "wind"}};

/// What a <gazebo> says that would change equations, where its text is one that does.
struct GazeboRow {
  const char* name;
  bool (*changes)(const std::string& text);
  const char* note;
};
bool is_on(const std::string& text) {
  return text == "true" || text == "1";
}
bool is_off(const std::string& text) {
  return text == "false" || text == "0";
}
bool is_something(const std::string& text) {
  return std::ranges::any_of(text, [](char c) { return c >= '1' && c <= '9'; });
}
constexpr GazeboRow kGazebo[] = {
    {"springStiffness", is_something, "write `stiffness` at the coordinate in the description"},
    {"dampingFactor", is_something, "write `damping` at the coordinates in the description"},
    {"gravity", is_off, ""},
    {"turnGravityOff", is_on, ""},
    {"kinematic", is_on, ""},
    {"static", is_on, "a root that is fixed (without --root floating) stands still"}};

/// What else has no place in a description: in the robot, its links and its joints.
constexpr std::string_view kLeftOut[] = {"calibration", "collision",         "contact",      "gazebo",
                                         "mujoco",      "safety_controller", "ros2_control", "sensor"};

constexpr std::string_view kVital[] = {"link",   "joint", "inertial",   "origin", "mass",  "inertia",
                                       "parent", "child", "axis",       "mimic",  "value", "ixx",
                                       "iyy",    "izz",   "ixy",        "ixz",    "iyz",   "xyz",
                                       "rpy",    "type",  "multiplier", "offset"};
constexpr XmlFormat kUrdf{"robot", kVital};

class RobotReader {
 public:
  RobotReader(std::shared_ptr<const SourceText> source, Warnings& warnings)
      : xml_(std::move(source), warnings, kUrdf) {}

  UrdfRobot read() {
    const pugi::xml_node root = xml_.root();
    if (std::string_view(root.name()) != "robot")
      throw InputError(xml_.where(root),
                       fmt::format("expected a <robot>, found <{}>", printable(root.name())),
                       "URDF is read, and no other format of robots");
    xml_.check_spelling(root, "the robot",
                        {"link", "joint", "material", "transmission", "gazebo", "sensor", "mujoco",
                         "ros2_control", "loop_joint", "loop", "constraint"},
                        {"name", "version"});
    read_robot_name(root);
    for (const pugi::xml_node element : root.children()) {
      count_left_out(element);
      for (const pugi::xml_node inner : element.children()) count_left_out(inner);
    }
    warn_of_loops(root);
    warn_of_mujoco(root);
    for (const pugi::xml_node gazebo : root.children("gazebo")) warn_of_gazebo(gazebo);
    Colours colours;
    for (const pugi::xml_node material : root.children("material")) read_material(xml_, material, colours);
    for (const pugi::xml_node link : root.children("link")) {
      robot_.links.push_back(read_link(xml_, link, colours));
      const UrdfLink& last = robot_.links.back();
      if (!links_.emplace(last.name, links_.size()).second)
        throw InputError(last.where, fmt::format("a second link '{}'", printable(last.name)));
    }
    if (robot_.links.empty())
      throw InputError(xml_.where(root), "no <link> in the robot", uses_xacro(root) ? kExpandXacro : "");
    add_world(root);
    for (const pugi::xml_node joint : root.children("joint")) {
      robot_.joints.push_back(read_joint(xml_, joint, links_));
      const UrdfJoint& last = robot_.joints.back();
      if (!last.name.empty() && !joints_.emplace(last.name, robot_.joints.size() - 1).second)
        throw InputError(last.where, fmt::format("a second joint '{}'", printable(last.name)));
    }
    for (const pugi::xml_node transmission : root.children("transmission"))
      read_transmission(xml_, transmission, robot_.joints, joints_);
    check_tree();
    find_mimicked();
    return std::move(robot_);
  }

 private:
  static bool uses_xacro(pugi::xml_node root) {
    return std::ranges::any_of(root.children(), [](pugi::xml_node element) {
      return std::string_view(element.name()).starts_with(kXacroPrefix);
    });
  }

  void read_robot_name(pugi::xml_node root) {
    const pugi::xml_attribute name = root.attribute("name");
    robot_.name = name.value();
    robot_.where = name ? xml_.where(name) : xml_.where(root);
    if (!robot_.name.empty()) return;
    robot_.name = "robot";
    xml_.warn({robot_.where, "the robot has no name; it is called 'robot'"});
  }

  void count_left_out(pugi::xml_node element) {
    const auto is_among = [&](std::span<const std::string_view> names) {
      return std::ranges::find(names, std::string_view(element.name())) != names.end();
    };
    if (is_among(kLeftOut) || is_among(kLoops)) ++robot_.left_out[element.name()];
  }

  void warn_of_loops(pugi::xml_node root) const {
    for (const pugi::xml_node element : root.children()) {
      if (std::ranges::find(kLoops, std::string_view(element.name())) == std::end(kLoops)) continue;
      xml_.warn({xml_.where(element),
                 fmt::format(
                     "<{}> '{}' closes a chain, which is left out: the equations are those of the open tree",
                     element.name(), printable(element.attribute("name").value())),
                 "add it to the description as a constraint (mechanisms/README.md)", "loop"});
    }
  }

  void warn_of_mujoco(pugi::xml_node root) const {
    for (const pugi::xml_node mujoco : root.children("mujoco")) {
      for (const auto& [element, name] : kMujoco) {
        const pugi::xml_attribute attribute = mujoco.child(element).attribute(name);
        if (!attribute) continue;
        xml_.warn({xml_.where(attribute),
                   fmt::format("{} of MuJoCo's {} is left out: other readers of URDF do not have it", name,
                               element),
                   std::string_view(name) == "gravity" ? "write `gravity` into the description" : "", name});
      }
    }
  }

  void warn_of_gazebo(pugi::xml_node gazebo) const {
    for (const pugi::xml_node element : gazebo.children()) {
      const std::string_view name = element.name();
      if (name == "joint" && element.attribute("type")) {
        xml_.warn({xml_.where(element),
                   fmt::format("<joint> '{}' of a <gazebo> is left out: the equations are those of the tree "
                               "without it",
                               printable(element.attribute("name").value())),
                   "add it to the description as a constraint (mechanisms/README.md)", "gazebo joint"});
      } else if (const auto row = std::ranges::find(kGazebo, name, &GazeboRow::name);
                 row != std::end(kGazebo) && row->changes(text_of_element(element))) {
        xml_.warn({xml_.where(element),
                   fmt::format("<{}> of a <gazebo> is left out: only Gazebo reads it", name), row->note,
                   row->name});
      } else if (name == "plugin" && std::string_view(element.attribute("filename").value()).find("mimic") !=
                                         std::string_view::npos) {
        xml_.warn({xml_.where(element), "a <plugin> by which a joint follows another is left out",
                   "write <mimic joint=\"...\"/> into that joint", "gazebo mimic"});
      }
    }
  }

  /// Some dialects have a link `world` without saying so.
  void add_world(pugi::xml_node root) {
    constexpr std::string_view kWorld = "world";
    if (links_.contains(kWorld)) return;
    for (const pugi::xml_node joint : root.children("joint")) {
      const pugi::xml_attribute parent = joint.child("parent").attribute("link");
      if (parent.value() != kWorld) continue;
      xml_.warn({xml_.where(parent), "no link 'world'; it is the frame that does not move"});
      links_.emplace(kWorld, robot_.links.size());
      robot_.links.push_back({std::string(kWorld), {}, {}, xml_.where(parent)});
      return;
    }
  }

  void check_tree() {
    const std::size_t none = robot_.joints.size(), count = robot_.links.size();
    std::vector<std::size_t> joint_of(count, none);
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      const UrdfJoint& joint = robot_.joints[j];
      std::size_t& of = joint_of[joint.child];
      if (of != none)
        throw InputError(
            joint.where,
            fmt::format("link '{}' is the child of joint '{}' already; a tree has one joint a link",
                        printable(robot_.links[joint.child].name), printable(robot_.joints[of].name)),
            "URDF has no closed chains: leave out one of the two, and add a constraint to the description");
      of = j;
    }
    std::optional<std::size_t> root;
    for (std::size_t link = 0; link < count; ++link) {
      if (joint_of[link] != none) continue;
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
    connect(robot_);
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
        throw InputError(robot_.joints[joint_of[link]].where,
                         fmt::format("link '{}' is its own ancestor", printable(robot_.links[link].name)));
  }

  /// A joint follows one that has a single position, and in the end one that follows none. Others are
  /// independent.
  void find_mimicked() {
    for (UrdfJoint& joint : robot_.joints)
      if (joint.mimic && !find_mimicked(joint)) joint.mimic.reset();
    enum class Mark { unseen, on_path, good };
    std::vector<Mark> marks(robot_.joints.size(), Mark::unseen);
    std::vector<std::size_t> path;
    for (std::size_t first = 0; first < robot_.joints.size(); ++first) {
      std::size_t at = first;
      while (follows(at) && marks[at] == Mark::unseen) {
        marks[at] = Mark::on_path;
        path.push_back(at);
        at = *robot_.joints[at].mimic->of;
      }
      if (marks[at] == Mark::on_path) {
        UrdfJoint& joint = robot_.joints[at];
        warn_independent(joint, fmt::format("joint '{}' mimics itself{}", printable(joint.name),
                                            path.back() == at ? "" : " by way of others"));
        joint.mimic.reset();
      }
      for (; !path.empty(); path.pop_back()) marks[path.back()] = Mark::good;
    }
  }
  bool follows(std::size_t joint) const {
    return robot_.joints[joint].mimic && robot_.joints[joint].mimic->of;
  }
  bool find_mimicked(UrdfJoint& joint) const {
    const auto found = joints_.find(joint.mimic->joint);
    if (found == joints_.end()) {
      warn_independent(joint, fmt::format("joint '{}' mimics an unknown joint '{}'{}", printable(joint.name),
                                          printable(joint.mimic->joint), suggestion(joint.mimic->joint)));
      return false;
    }
    const UrdfJoint& other = robot_.joints[found->second];
    if (has_position(other)) {
      joint.mimic->of = found->second;
    } else if (other.type == UrdfJointType::fixed) {
      xml_.warn({joint.mimic->where,
                 fmt::format("joint '{}' mimics '{}', which is fixed; it stands still at its offset",
                             printable(joint.name), printable(other.name)),
                 {},
                 "mimics fixed"});
    } else {
      warn_independent(joint, fmt::format("joint '{}' mimics '{}', which has no single position",
                                          printable(joint.name), printable(other.name)));
      return false;
    }
    return true;
  }
  /// Only a few are looked for: each looks at all names.
  std::string suggestion(const std::string& name) const {
    constexpr int kSuggestions = 8;
    return suggestions_++ < kSuggestions ? did_you_mean(name, keys(joints_)) : "";
  }
  void warn_independent(const UrdfJoint& joint, const std::string& message) const {
    xml_.warn({joint.mimic->where, message + "; it is independent", {}, "independent"});
  }

  XmlText xml_;
  UrdfRobot robot_;
  Indices links_, joints_;
  mutable int suggestions_ = 0;
};

}  // namespace

void connect(UrdfRobot& robot) {
  robot.joint_of.assign(robot.links.size(), robot.joints.size());
  robot.children.assign(robot.links.size(), {});
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    robot.joint_of[robot.joints[j].child] = j;
    robot.children[robot.joints[j].parent].push_back(j);
  }
}

UrdfRobot read_urdf(std::shared_ptr<const SourceText> source, Warnings& warnings) {
  return RobotReader(std::move(source), warnings).read();
}

}  // namespace alembert
