// XML in, a model out: its sections in the order in which they need each other.
#include "import/mjcf/mjcf_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "import/mjcf/actuators.hpp"
#include "import/mjcf/context.hpp"
#include "import/mjcf/model_file.hpp"
#include "import/mjcf/reference_inertia.hpp"
#include "import/mjcf/spelling.hpp"

namespace alembert {
namespace {

/// What an option switches off.
struct Disabled {
  std::vector<std::string> flags;
  std::vector<double> actuator_groups;
};

void read_option(const MjcfText& text, MjcfModel& model, Disabled& disabled) {
  for (const pugi::xml_node node : text.children(text.root(), "option")) {
    const MjcfElement of(text, {node}, "the option");
    check_attributes(text, node);
    model.gravity = of.vector("gravity", model.gravity);
    model.wind = of.vector("wind", model.wind);
    model.density = of.number("density", model.density);
    model.viscosity = of.number("viscosity", model.viscosity);
    model.time_step = of.number("timestep", model.time_step);
    if (of.has("actuatorgroupdisable")) disabled.actuator_groups = of.list("actuatorgroupdisable", 0, 31);
    for (const pugi::xml_node flag : text.children(node, "flag"))
      for (const pugi::xml_attribute each : flag.attributes())
        if (std::string_view(each.value()) == "disable") disabled.flags.emplace_back(each.name());
  }
}

/// What attached files say of the whole is their own affair: the model's counts.
void pass_over_options(const MjcfTree& tree, const MjcfFile& own, const MjcfModel& model) {
  std::set<const MjcfFile*> seen;
  for (const MjcfPart& part : tree.parts()) {
    const MjcfText& text = part.file->text;
    if (part.file == &own || !seen.insert(part.file).second) continue;
    MjcfModel other;
    Disabled disabled;
    read_option(text, other, disabled);
    const bool differs = other.gravity != model.gravity || other.wind != model.wind ||
                         other.density != model.density || other.viscosity != model.viscosity ||
                         !disabled.flags.empty() || !disabled.actuator_groups.empty();
    const std::vector<pugi::xml_node> options = text.children(text.root(), "option");
    if (differs && !options.empty()) {
      const SourceLocation where = text.where(options[0]);
      if (own.compiler.resolves_conflicts)
        throw InputError(where, "the option of an attached model is another, and is not merged here",
                         "conflict=\"warning\" in the <compiler> lets that of the model count");
      text.warn({where,
                 "the option of an attached model is passed over: that of the model counts",
                 {},
                 "option of an attached model"});
    }
    for (const pugi::xml_node keys : text.children(text.root(), "keyframe"))
      text.warn({text.where(keys),
                 "keyframes of an attached model are left out",
                 {},
                 "keyframes of an attached model"});
  }
}

void disable(MjcfModel& model, const Disabled& disabled) {
  const auto is = [&](const char* name) {
    return std::ranges::find(disabled.flags, name) != disabled.flags.end();
  };
  for (MjcfActuator& actuator : model.actuators)
    if (std::ranges::find(disabled.actuator_groups, actuator.group) != disabled.actuator_groups.end()) {
      actuator.gain = {};
      actuator.bias = {};
    }
  const bool passive = is("passive"), springs = passive || is("spring"), dampers = passive || is("damper");
  const bool constraint = is("constraint"), friction = constraint || is("frictionloss");
  if (is("gravity")) model.gravity.setZero();
  if (is("actuation")) model.actuators.clear();
  if (constraint || is("equality")) model.equalities.clear();
  const auto calm = [&](auto& of) {
    if (springs) of.stiffness = 0;
    if (dampers) of.damping = 0;
    if (friction) of.friction = 0;
  };
  for (MjcfJoint& joint : model.joints) calm(joint);
  for (MjcfTendon& tendon : model.tendons) calm(tendon);
  const bool nothing_passive = springs && dampers;
  if (nothing_passive || is("gravity"))
    for (MjcfBody& body : model.bodies) body.weightless = 0;
  if (nothing_passive) model.density = model.viscosity = 0;
}

void read_start(const MjcfText& text, MjcfModel& model) {
  std::vector<pugi::xml_node> keys;
  for (const pugi::xml_node section : text.children(text.root(), "keyframe"))
    std::ranges::copy(text.children(section, "key"), std::back_inserter(keys));
  if (keys.empty()) return;
  const MjcfElement key(text, {keys[0]}, "the keyframe");
  std::size_t positions = 0, speeds = 0;
  for (const MjcfJoint& joint : model.joints) {
    positions += position_count(joint.type);
    speeds += speed_count(joint.type);
  }
  const auto read = [&](const char* name, std::size_t count, std::vector<double>& out) {
    text.of(keys[0]).tolerate("it is left out", [&] {
      if (key.has(name)) out = key.list(name, count, count);
    });
  };
  read("qpos", positions, model.start);
  read("qvel", speeds, model.start_speeds);
  read("ctrl", model.actuators.size(), model.start_inputs);
  std::vector<double*> states;
  for (MjcfActuator& actuator : model.actuators)
    if (actuator.activation != MjcfActivation::none) states.push_back(&actuator.start);
  std::vector<double> activations;
  read("act", states.size(), activations);
  for (std::size_t i = 0; i < activations.size(); ++i) *states[i] = activations[i];
}

RigidPose pose_at(const MjcfModel& model, std::size_t body, bool rest) {
  RigidPose out;
  for (; body != 0; body = model.bodies[body].parent) {
    RigidPose own = model.bodies[body].pose;
    for (const std::size_t j : model.bodies[body].joints) {
      const MjcfJoint& joint = model.joints[j];
      const double by = joint.rest - joint.reference;
      if (!rest || by == 0) continue;
      const Eigen::Vector3d axis = joint.axis.normalized();
      if (joint.type == MjcfJointType::slide) own = own * RigidPose{by * axis};
      if (joint.type != MjcfJointType::hinge) continue;
      const RigidPose turn{Eigen::Vector3d::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(by, axis))};
      own = own * joint.anchor * turn * inverse(joint.anchor);
    }
    out = own * out;
  }
  return out;
}

}  // namespace

std::size_t position_count(MjcfJointType type) {
  return type == MjcfJointType::free ? 7 : type == MjcfJointType::ball ? 4 : 1;
}
std::size_t speed_count(MjcfJointType type) {
  return type == MjcfJointType::free ? 6 : type == MjcfJointType::ball ? 3 : 1;
}

RigidPose reference_pose(const MjcfModel& model, std::size_t body) {
  return pose_at(model, body, false);
}

RigidPose rest_pose(const MjcfModel& model, std::size_t body) {
  return pose_at(model, body, true);
}

MjcfModel read_mjcf(std::shared_ptr<const SourceText> source, const std::vector<std::string>& folders,
                    Warnings& warnings) {
  MjcfFiles files(std::move(source), folders, warnings);
  const MjcfText& text = files.own().text;
  const pugi::xml_node root = text.root();
  MjcfModel model;
  const pugi::xml_attribute name = root.attribute("model");
  model.name = name ? name.value() : "model";
  model.where = name ? text.where(name) : text.where(root);
  Disabled disabled;
  read_option(text, model, disabled);
  MjcfTree tree(files, model);
  tree.read();
  model.places = files.places();
  pass_over_options(tree, files.own(), model);
  MjcfContext context{.tree = tree, .model = model};
  for (const MjcfPart& part : tree.parts()) {
    context.part = part;
    read_tendons(context);
    read_equalities(context);
    read_actuators(context);
    read_sensors(context);
  }
  context.check_unknown(files.own());
  work_out_spring_dampers(model);
  read_start(text, model);
  disable(model, disabled);
  model.files = files.names();
  return model;
}

}  // namespace alembert
