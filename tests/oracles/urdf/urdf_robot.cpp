// XML in, a tree of links out (see the header).
#include "oracles/urdf/urdf_robot.hpp"

#include <map>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>

namespace alembert::oracles {

namespace {

WideVector triple_of(const pugi::xml_attribute& attribute, const WideVector& otherwise) {
  if (!attribute) return otherwise;
  std::istringstream text(attribute.value());
  std::array<double, 3> v{};
  if (!(text >> v[0] >> v[1] >> v[2]))
    throw std::runtime_error(std::string("no three numbers: ") + attribute.value());
  return {v[0], v[1], v[2]};
}

/// Roll about x, then pitch about y, then yaw about z, all of them fixed.
RigidMotion<long double> origin_pose(const pugi::xml_node& origin) {
  const WideVector rpy = triple_of(origin.attribute("rpy"), {});
  RigidMotion<long double> pose = rotation<long double>({0, 0, 1}, rpy[2]) *
                                  rotation<long double>({0, 1, 0}, rpy[1]) *
                                  rotation<long double>({1, 0, 0}, rpy[0]);
  pose.translation = triple_of(origin.attribute("xyz"), {});
  return pose;
}

UrdfBody body_with_inertia(const pugi::xml_node& link) {
  UrdfBody body;
  body.name = link.attribute("name").value();
  const pugi::xml_node inertial = link.child("inertial"), entries = inertial.child("inertia");
  if (!inertial) return body;
  const RigidMotion<long double> pose = origin_pose(inertial.child("origin"));
  body.mass = inertial.child("mass").attribute("value").as_double();
  body.com = pose.translation;
  const auto entry = [&](const char* name) {
    return static_cast<long double>(entries.attribute(name).as_double());
  };
  const std::array<WideVector, 3> I{WideVector{entry("ixx"), entry("ixy"), entry("ixz")},
                                    WideVector{entry("ixy"), entry("iyy"), entry("iyz")},
                                    WideVector{entry("ixz"), entry("iyz"), entry("izz")}};
  // R I R^T, entry by entry: rows of R times I times rows of R.
  const auto turned = [&](std::size_t r, std::size_t c) {
    long double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) sum += pose.column[i][r] * I[i][k] * pose.column[k][c];
    return sum;
  };
  body.inertia = {turned(0, 0), turned(1, 1), turned(2, 2), turned(0, 1), turned(0, 2), turned(1, 2)};
  return body;
}

UrdfMotion motion_named(const std::string& type) {
  if (type == "fixed") return UrdfMotion::fixed;
  if (type == "revolute" || type == "continuous") return UrdfMotion::turn;
  if (type == "prismatic") return UrdfMotion::shift;
  if (type == "planar") return UrdfMotion::planar;
  if (type == "floating") return UrdfMotion::free;
  if (type == "spherical") return UrdfMotion::ball;
  throw std::runtime_error("unknown type of joint '" + type + "'");
}

/// Of a drive for its joint: the rotor turns `ratio` times as far. The inertia stands in Drake's dialect only; the ratio
/// there, or where ROS has it (in the actuator, formerly in the joint), either way round but not 0.
long double reflected_inertia(const pugi::xml_node& transmission, const pugi::xml_node& joint) {
  const pugi::xml_node actuator = transmission.child("actuator");
  const long double inertia = actuator.child("drake:rotor_inertia").attribute("value").as_double();
  long double ratio = 0;
  for (const double given : {actuator.child("drake:gear_ratio").attribute("value").as_double(),
                             joint.child("mechanicalReduction").text().as_double(),
                             actuator.child("mechanicalReduction").text().as_double()}) {
    if (ratio == 0) ratio = given;
  }
  if (ratio == 0) ratio = 1;
  return ratio * ratio * inertia;
}

void order_tree(UrdfTree& tree) {
  std::vector<int> reached(tree.bodies.size(), 0);
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < tree.linkages.size(); ++i) {
      const UrdfLinkage& linkage = tree.linkages[i];
      if (reached[static_cast<std::size_t>(linkage.child)] != 0) continue;
      if (linkage.parent >= 0 && reached[static_cast<std::size_t>(linkage.parent)] == 0) continue;
      reached[static_cast<std::size_t>(linkage.child)] = 1;
      tree.order.push_back(i);
      more = true;
    }
  }
  if (tree.order.size() != tree.linkages.size() || tree.linkages.size() != tree.bodies.size())
    throw std::runtime_error("links and joints are no tree");
}

}  // namespace

UrdfTree read_urdf_tree(const std::string& file, bool floating) {
  pugi::xml_document document;
  if (!document.load_file(file.c_str())) throw std::runtime_error("no XML: " + file);
  const pugi::xml_node robot = document.child("robot");
  UrdfTree tree;
  std::map<std::string, int> bodies, linkages;
  for (const pugi::xml_node link : robot.children("link")) {
    bodies[link.attribute("name").value()] = static_cast<int>(tree.bodies.size());
    tree.bodies.push_back(body_with_inertia(link));
  }
  // Some tools know the world as a link that no file declares.
  for (const pugi::xml_node joint : robot.children("joint")) {
    const std::string parent = joint.child("parent").attribute("link").value();
    if (parent != "world" || bodies.count(parent) != 0) continue;
    bodies[parent] = static_cast<int>(tree.bodies.size());
    tree.bodies.emplace_back().name = parent;
  }
  std::vector<bool> is_child(tree.bodies.size(), false);
  std::vector<std::pair<std::string, pugi::xml_node>> mimics;
  tree.linkages.emplace_back();  // of the root
  for (const pugi::xml_node joint : robot.children("joint")) {
    UrdfLinkage linkage;
    linkage.name = joint.attribute("name").value();
    linkage.motion = motion_named(joint.attribute("type").value());
    linkage.parent = bodies.at(joint.child("parent").attribute("link").value());
    linkage.child = bodies.at(joint.child("child").attribute("link").value());
    linkage.origin = origin_pose(joint.child("origin"));
    linkage.axis = triple_of(joint.child("axis").attribute("xyz"), linkage.axis);
    if (linkage.motion != UrdfMotion::fixed) linkage.axis = normalized(linkage.axis);
    is_child[static_cast<std::size_t>(linkage.child)] = true;
    linkages[linkage.name] = static_cast<int>(tree.linkages.size());
    const bool single = linkage.motion == UrdfMotion::turn || linkage.motion == UrdfMotion::shift;
    if (single) {
      linkage.damping = joint.child("dynamics").attribute("damping").as_double();
      linkage.friction = joint.child("dynamics").attribute("friction").as_double();
    }
    tree.linkages.push_back(linkage);
    if (joint.child("mimic") && single) mimics.emplace_back(linkage.name, joint.child("mimic"));
  }
  for (const pugi::xml_node transmission : robot.children("transmission")) {
    for (const pugi::xml_node joint : transmission.children("joint")) {
      const auto of = linkages.find(joint.attribute("name").value());
      if (of == linkages.end()) continue;
      UrdfLinkage& linkage = tree.linkages[static_cast<std::size_t>(of->second)];
      const bool single = linkage.motion == UrdfMotion::turn || linkage.motion == UrdfMotion::shift;
      if (single) linkage.rotor += reflected_inertia(transmission, joint);
    }
  }
  for (std::size_t i = 0; i < is_child.size(); ++i) {
    if (is_child[i]) continue;
    if (tree.linkages[0].child >= 0) throw std::runtime_error("more than one root");
    tree.linkages[0].child = static_cast<int>(i);
  }
  if (tree.linkages[0].child < 0) throw std::runtime_error("no root");
  if (floating) tree.linkages[0].motion = UrdfMotion::free;
  for (const auto& [name, mimic] : mimics) {
    const auto of = linkages.find(mimic.attribute("joint").value());
    if (of == linkages.end()) continue;
    const UrdfMotion other = tree.linkages[static_cast<std::size_t>(of->second)].motion;
    if (other == UrdfMotion::planar || other == UrdfMotion::free || other == UrdfMotion::ball) continue;
    UrdfLinkage& linkage = tree.linkages[static_cast<std::size_t>(linkages.at(name))];
    linkage.follows = of->second;
    linkage.multiplier = mimic.attribute("multiplier").as_double(1);
    linkage.offset = mimic.attribute("offset").as_double(0);
  }
  // To the joint at the end of a chain of mimics.
  for (UrdfLinkage& linkage : tree.linkages) {
    for (int steps = 0; linkage.follows >= 0; ++steps) {
      const UrdfLinkage& of = tree.linkages[static_cast<std::size_t>(linkage.follows)];
      if (of.follows < 0) break;
      if (steps > 1000) throw std::runtime_error("mimics go round in a circle");
      linkage.offset += linkage.multiplier * of.offset;
      linkage.multiplier *= of.multiplier;
      linkage.follows = of.follows;
    }
  }
  // One that follows a fixed joint stands still.
  for (UrdfLinkage& linkage : tree.linkages) {
    if (linkage.follows < 0 ||
        tree.linkages[static_cast<std::size_t>(linkage.follows)].motion != UrdfMotion::fixed)
      continue;
    RigidMotion<long double> moved;
    if (linkage.motion == UrdfMotion::turn)
      moved = rotation_about(linkage.axis, linkage.offset);
    else
      moved.translation = linkage.offset * linkage.axis;
    linkage.origin = linkage.origin * moved;
    linkage.motion = UrdfMotion::fixed;
    linkage.follows = -1;
    linkage.damping = linkage.friction = linkage.rotor = 0;
  }
  order_tree(tree);
  return tree;
}

}  // namespace alembert::oracles
