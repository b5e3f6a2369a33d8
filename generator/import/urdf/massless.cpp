// Masses are summed from the tips to the root; links and joints that go are taken out of the lists.
#include "import/urdf/massless.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace alembert {
namespace {

/// Links, parents before children.
std::vector<std::size_t> from_root(const UrdfRobot& robot) {
  std::vector<std::size_t> order{robot.root};
  for (std::size_t i = 0; i < order.size(); ++i)
    for (const std::size_t j : robot.children[order[i]]) order.push_back(robot.joints[j].child);
  return order;
}

void freeze(UrdfRobot& robot, const std::vector<bool>& joints) {
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    if (joints[j]) robot.joints[j].type = UrdfJointType::fixed;
  for (UrdfJoint& joint : robot.joints)
    if (joint.mimic && joint.mimic->of && joints[*joint.mimic->of]) joint.mimic->of.reset();
}

/// Keeps the links and joints that are marked; indices become those of the shorter lists.
void keep_only(UrdfRobot& robot, const std::vector<bool>& links, const std::vector<bool>& joints) {
  std::vector<std::size_t> new_link, new_joint;
  const auto shorten = [](auto& list, const std::vector<bool>& kept, std::vector<std::size_t>& new_index) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      new_index.push_back(count);
      if (!kept[i]) continue;
      if (count != i) list[count] = std::move(list[i]);
      ++count;
    }
    list.resize(count);
  };
  shorten(robot.links, links, new_link);
  shorten(robot.joints, joints, new_joint);
  robot.root = new_link[robot.root];
  for (UrdfJoint& joint : robot.joints) {
    joint.parent = new_link[joint.parent];
    joint.child = new_link[joint.child];
    if (joint.mimic && joint.mimic->of) joint.mimic->of = new_joint[*joint.mimic->of];
  }
  connect(robot);
}

}  // namespace

bool has_mass(const UrdfLink& link) {
  const std::optional<UrdfInertial>& inertial = link.inertial;
  return inertial &&
         (inertial->mass != 0 || std::ranges::any_of(inertial->inertia, [](double i) { return i != 0; }));
}

std::vector<std::size_t> drivers(const UrdfRobot& robot) {
  std::vector<std::size_t> driver(robot.joints.size()), path;
  std::iota(driver.begin(), driver.end(), std::size_t{0});
  for (std::size_t first = 0; first < driver.size(); ++first) {
    std::size_t at = first;
    for (; driver[at] == at && robot.joints[at].mimic && robot.joints[at].mimic->of;
         at = *robot.joints[at].mimic->of)
      path.push_back(at);
    for (; !path.empty(); path.pop_back()) driver[path.back()] = driver[at];
  }
  return driver;
}

std::vector<bool> massless_joints(const UrdfRobot& robot) {
  const std::vector<std::size_t> order = from_root(robot), driver = drivers(robot);
  std::vector<bool> heavy(robot.links.size(), false), moves_mass(robot.joints.size(), false);
  for (std::size_t i = order.size(); i-- > 1;) {
    const std::size_t link = order[i], joint = robot.joint_of[link];
    if (has_mass(robot.links[link])) heavy[link] = true;
    if (!heavy[link]) continue;
    heavy[robot.joints[joint].parent] = true;
    moves_mass[driver[joint]] = true;
  }
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    if (has_position(robot.joints[j]) && robot.joints[j].rotor_inertia > 0) moves_mass[driver[j]] = true;
  std::vector<bool> massless(robot.joints.size(), false);
  for (std::size_t j = 0; j < massless.size(); ++j)
    massless[j] = robot.joints[j].type != UrdfJointType::fixed && !robot.joints[j].mimic && !moves_mass[j];
  return massless;
}

UrdfRobot with_massless_frozen(UrdfRobot robot) {
  freeze(robot, massless_joints(robot));
  return robot;
}

UrdfRobot without_massless(UrdfRobot robot) {
  const std::vector<std::size_t> order = from_root(robot), driver = drivers(robot);
  const std::vector<bool> massless = massless_joints(robot);
  // A link cannot go if it moves a joint that others need, or by one that mimics and is mimicked.
  std::vector<bool> needed(robot.links.size(), false);
  for (const UrdfJoint& joint : robot.joints) {
    const UrdfJoint* other = joint.mimic && joint.mimic->of ? &robot.joints[*joint.mimic->of] : nullptr;
    if (other != nullptr && other->mimic) needed[other->child] = true;
  }
  for (std::size_t i = order.size(); i-- > 1;) {
    const UrdfJoint& joint = robot.joints[robot.joint_of[order[i]]];
    const std::size_t first = driver[robot.joint_of[order[i]]];
    const bool moves = joint.type != UrdfJointType::fixed && !robot.joints[first].mimic;
    if (needed[order[i]] || (moves && !massless[first])) needed[joint.parent] = true;
  }
  std::vector<bool> links(robot.links.size(), true), joints(robot.joints.size(), true);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t j = robot.joint_of[order[i]];
    const bool goes = massless[driver[j]] && !needed[order[i]];
    joints[j] = links[order[i]] = links[robot.joints[j].parent] && !goes;
  }
  freeze(robot, massless);
  keep_only(robot, links, joints);
  return robot;
}

}  // namespace alembert
