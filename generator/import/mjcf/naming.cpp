#include "import/mjcf/naming.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "import/common/snapped_angle.hpp"
#include "import/mjcf/sums.hpp"
#include "mechanism/names.hpp"

namespace alembert {
namespace {

constexpr int kMaximumChain = 100;  // of equalities, by which texts grow

bool is_single(MjcfJointType type) {
  return type == MjcfJointType::hinge || type == MjcfJointType::slide;
}

bool is_linear(const std::array<double, 5>& p) {
  return p[2] == 0 && p[3] == 0 && p[4] == 0;
}

}  // namespace

MjcfNaming::MjcfNaming(const MjcfModel& model, Warnings& warnings)
    : model_(model), equality_of_(model.joints.size(), kNone), texts_(model.joints.size()) {
  name_bodies(warnings);
  name_joints(warnings);
  find_followers(warnings);
  name_others();
}

std::string MjcfNaming::unique(Names& taken, const std::string& name) {
  std::string fit = fit_name(name, "name");
  const auto with = [&](const std::string& end) {
    std::string start = fit.substr(0, kMaximumName - end.size());
    while (start.ends_with('_')) start.pop_back();
    return start + end;
  };
  std::string out = with("");
  for (int i = 2; !taken.insert(out).second; ++i) out = with("_" + std::to_string(i));
  return out;
}

std::string MjcfNaming::new_output(const std::string& name) {
  return unique(variables_, variables_.contains(fit_name(name, "output")) ? name + "_output" : name);
}

void MjcfNaming::name_bodies(Warnings& warnings) {
  FitNames names("body", warnings);
  for (const MjcfBody& body : model_.bodies) names.reserve(body.name);
  bodies_.emplace_back("world");
  for (std::size_t i = 1; i < model_.bodies.size(); ++i) {
    const MjcfBody& body = model_.bodies[i];
    bodies_.push_back(names.add(body.name.empty() ? fmt::format("body_{}", i) : body.name, body.where));
  }
}

void MjcfNaming::name_joints(Warnings& warnings) {
  FitNames names("joint", warnings);
  for (const MjcfJoint& joint : model_.joints)
    if (is_single(joint.type)) names.reserve(joint.name);
  for (std::size_t j = 0; j < model_.joints.size(); ++j) {
    const MjcfJoint& joint = model_.joints[j];
    const std::vector<std::size_t>& siblings = model_.bodies[joint.body].joints;
    const std::string& body = bodies_[joint.body];
    const bool free = joint.type == MjcfJointType::free;
    std::string name = joint.name;
    if (name.empty() && free) name = body;
    if (name.empty())
      name = siblings.size() == 1 ? body + "_joint" : fmt::format("{}_joint{}", body, j - siblings[0] + 1);
    std::vector<std::string>& coordinates = coordinates_.emplace_back();
    if (free)
      for (const char* suffix : {"_x", "_y", "_z", "_rotation"})
        coordinates.push_back(names.add(name, joint.where, suffix));
    else
      coordinates.push_back(names.add(name, joint.where));
    for (const std::string& each : coordinates) variables_.insert(each);
  }
}

void MjcfNaming::name_others() {
  for (std::size_t i = 0; i < model_.sites.size(); ++i) {
    const std::string& name = model_.sites[i].name;
    sites_.push_back(new_frame(name.empty() ? fmt::format("site_{}", i + 1) : name));
  }
  for (std::size_t i = 0; i < model_.tendons.size(); ++i) {
    const std::string& name = model_.tendons[i].name;
    tendons_.push_back(new_force(name.empty() ? fmt::format("tendon_{}", i + 1) : name));
  }
  for (std::size_t i = 0; i < model_.actuators.size(); ++i) {
    const MjcfActuator& of = model_.actuators[i];
    const std::string name = of.name.empty() ? fmt::format("actuator_{}", i + 1) : of.name;
    const std::string fit = fit_name(name, "actuator");
    actuators_.push_back(new_force(name));
    inputs_.push_back(unique(variables_, variables_.contains(fit) ? name + "_input" : name));
    states_.push_back(of.activation == MjcfActivation::none ? "" : unique(variables_, name + "_activation"));
  }
}

/// By how many equalities a joint follows the last of its chain; those that are too many are no functions.
void MjcfNaming::shorten_chains(const Demote& demote) {
  std::vector<int> steps(model_.joints.size(), -1);
  std::vector<std::size_t> path;
  for (std::size_t first = 0; first < steps.size(); ++first) {
    std::size_t at = first;
    for (; steps[at] < 0 && follows(at); at = *model_.equalities[equality_of_[at]].second) {
      path.push_back(at);
      if (!model_.equalities[equality_of_[at]].second) break;
    }
    int count = std::max(steps[at], 0);
    for (; !path.empty(); path.pop_back()) {
      if (++count > kMaximumChain) {
        demote(path.back(), "it follows by way of too many others");
        count = 0;
      }
      steps[path.back()] = count;
    }
  }
}

/// Whether its position is a linear function of a coordinate, or stays what it is.
bool MjcfNaming::follows_straight(std::size_t joint) const {
  while (equality_of_[joint] != kNone) {
    const MjcfEquality& of = model_.equalities[equality_of_[joint]];
    if (!of.second) return true;
    if (!is_linear(of.polynomial)) return false;
    joint = *of.second;
  }
  return true;
}

void MjcfNaming::find_followers(Warnings& warnings) {
  const auto warn = [&](std::size_t equality, const char* why) {
    warnings.push_back({model_.equalities[equality].where,
                        fmt::format("an equality of joints is a constraint and no function: {}", why),
                        {},
                        "equality as constraint"});
  };
  // By joint: another that it follows, nearer to the last of its chain.
  std::vector<std::size_t> ahead(model_.joints.size());
  std::iota(ahead.begin(), ahead.end(), std::size_t{0});
  const auto last_of = [&](std::size_t joint) {
    while (ahead[joint] != joint) joint = ahead[joint] = ahead[ahead[joint]];
    return joint;
  };
  for (std::size_t e = 0; e < model_.equalities.size(); ++e) {
    const MjcfEquality& of = model_.equalities[e];
    if (of.type != MjcfEqualityType::joint) continue;
    const char* why = nullptr;
    if (equality_of_[of.first] != kNone) why = "its joint follows another already";
    if (of.second && last_of(*of.second) == of.first) why = "its joints would follow each other";
    if (why != nullptr) {
      warn(e, why);
      continue;
    }
    equality_of_[of.first] = e;
    functions_.insert(e);
    if (of.second) ahead[of.first] = *of.second;
  }
  const auto demote = [&](std::size_t joint, const char* text) {
    warn(equality_of_[joint], text);
    functions_.erase(equality_of_[joint]);
    equality_of_[joint] = kNone;
  };
  shorten_chains(demote);
  // Once all are known: a chain of them bends where one of them does.
  const std::set<std::size_t> functions = functions_;
  for (const std::size_t e : functions) {
    const std::size_t joint = model_.equalities[e].first;
    if (model_.joints[joint].armature == 0 || follows_straight(joint)) continue;
    demote(joint, "its joint has an armature and follows no straight line");
  }
  for (std::size_t j = 0; j < model_.joints.size(); ++j) write_text(j);
}

void MjcfNaming::write_text(std::size_t joint) {
  JointText& out = texts_[joint];
  if (!out.position.empty() || !is_single(model_.joints[joint].type)) return;
  const std::string& name = coordinates_[joint][0];
  out.position = name;
  if (!follows(joint)) {
    out.speed = "d(" + name + ")";
    out.base = joint;
    out.constant_slope = 1;
    return;
  }
  const MjcfEquality& equality = model_.equalities[equality_of_[joint]];
  if (!equality.second) {
    out.speed = "0";
    out.constant_slope = 0;
    followers_.push_back(joint);
    return;
  }
  write_text(*equality.second);
  followers_.push_back(joint);
  const JointText& other = texts_[*equality.second];
  const std::array<double, 5>& p = equality.polynomial;
  out.base = other.base;
  if (is_linear(p) && other.constant_slope) {
    out.constant_slope = p[1] * *other.constant_slope;
    out.slope = number_text(*out.constant_slope);
  } else {
    const std::string own =
        polynomial_text(std::array{p[1], 2 * p[2], 3 * p[3], 4 * p[4]}, from_reference(*equality.second));
    out.slope = other.slope.empty() ? factor_text(own) : factor_text(own) + "*" + factor_text(other.slope);
  }
  if (!out.base) {
    out.speed = "0";
    out.constant_slope = 0;
    return;
  }
  out.speed = factor_text(out.slope) + "*" + texts_[*out.base].speed;
}

std::string MjcfNaming::from_reference(std::size_t joint) const {
  const std::string& position = texts_[joint].position;
  const MjcfJoint& of = model_.joints[joint];
  if (of.reference == 0) return position;
  const double size = std::abs(of.reference);
  return position + (of.reference < 0 ? " + " : " - ") +
         (of.type == MjcfJointType::hinge ? SnappedAngle(size, 1e-12).text() : number_text(size));
}

std::string MjcfNaming::definition(std::size_t joint) const {
  const MjcfEquality& equality = model_.equalities[equality_of_[joint]];
  const std::array<double, 5>& p = equality.polynomial;
  const double own = model_.joints[joint].reference;
  if (!equality.second) return number_text(own + p[0]);
  const double other = model_.joints[*equality.second].reference;
  const std::string& position = texts_[*equality.second].position;
  if (is_linear(p)) return sum_text({{p[1], position}, {own + p[0] - p[1] * other, ""}});
  return polynomial_text(std::array{own + p[0], p[1], p[2], p[3], p[4]}, from_reference(*equality.second));
}

}  // namespace alembert
