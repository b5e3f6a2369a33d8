#include "import/mjcf/actuators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "import/mjcf/reference_inertia.hpp"

namespace alembert {
namespace {

const std::vector<std::string> kTags = {"general",  "motor",  "position", "velocity", "intvelocity", "damper",
                                        "cylinder", "muscle", "adhesion", "plugin",   "dcmotor"};

/// The law of an actuator while the elements of its classes change it.
struct Law {
  enum Kind { fixed, affine, none, muscle, other };
  Kind gain_type = fixed, bias_type = none;
  std::array<double, 9> gain{1}, bias{};
  std::array<double, 3> times{1, 0, 0};  ///< the first is the time constant of a filter
  double inherit_range = 0;
  std::size_t dynamics = 0;  ///< none, integrator, filter, filterexact, muscle, user

  /// MuJoCo keeps a damping ratio where the factor of velocity is, which is negative where it is none.
  double damping_ratio() const { return gain[0] == -bias[1] && bias[2] > 0 ? bias[2] : 0; }
  std::string left_out;  ///< what cannot be expressed
};

template <std::size_t kCount>
void copy_first(const std::vector<double>& from, std::array<double, kCount>& to) {
  for (std::size_t i = 0; i < std::min(kCount, from.size()); ++i) to[i] = from[i];
}

void apply_general(const MjcfElement& of, Law& law) {
  if (of.has("gaintype")) {
    const std::size_t type = of.word("gaintype", {"fixed", "affine", "muscle", "user", "dcmotor"}, 0);
    constexpr Law::Kind kKinds[] = {Law::fixed, Law::affine, Law::muscle, Law::other, Law::other};
    law.gain_type = kKinds[type];
  }
  if (of.has("biastype")) {
    const std::size_t type = of.word("biastype", {"none", "affine", "muscle", "user", "dcmotor"}, 0);
    constexpr Law::Kind kKinds[] = {Law::none, Law::affine, Law::muscle, Law::other, Law::other};
    law.bias_type = kKinds[type];
  }
  if (of.has("dyntype"))
    law.dynamics =
        of.word("dyntype", {"none", "integrator", "filter", "filterexact", "muscle", "user", "dcmotor"}, 0);
  copy_first(of.list("gainprm", 1, 20), law.gain);
  copy_first(of.list("biasprm", 1, 20), law.bias);
  copy_first(of.list("dynprm", 1, 20), law.times);
}

/// Parameters that are still MuJoCo's defaults for all actuators become those of muscles.
void apply_muscle(const MjcfElement& of, Law& law) {
  constexpr std::array<double, 9> kDefaults{0.75, 1.05, -1, 200, 0.5, 1.6, 1.5, 1.3, 1.2};
  for (std::size_t i = 0; i < 9; ++i)
    if (law.gain[i] == (i == 0 ? 1 : 0)) law.gain[i] = kDefaults[i];
  if (law.times[0] == 1) law.times[0] = 0.01;
  if (law.times[1] == 0) law.times[1] = 0.04;
  copy_first(of.list("timeconst", 2, 2), law.times);
  law.times[2] = of.number("tausmooth", law.times[2]);
  copy_first(of.list("range", 2, 2), law.gain);
  constexpr const char* kNames[] = {"force", "scale", "lmin", "lmax", "vmax", "fpmax", "fvmax"};
  for (std::size_t i = 0; i < std::size(kNames); ++i)
    if (const double given = of.number(kNames[i], -1); given >= 0) law.gain[2 + i] = given;
  law.bias = law.gain;
  law.gain_type = law.bias_type = Law::muscle;
  law.dynamics = 4;
}

/// kp and kv as MuJoCo's shortcuts have them.
void apply_servo(const MjcfElement& of, Law& law, bool integrates) {
  const double kp = of.number("kp", law.gain[0]);
  law.gain = {kp};
  law.bias[1] = -kp;
  if (of.has("kv")) law.bias[2] = -of.number("kv", 0);
  if (of.has("dampratio")) law.bias[2] = of.number("dampratio", 0);
  law.gain_type = Law::fixed;
  law.bias_type = Law::affine;
  law.inherit_range = of.number("inheritrange", law.inherit_range);
  if (integrates) {
    law.dynamics = 1;
  } else if (of.has("timeconst")) {
    law.times[0] = of.number("timeconst", 0);
    law.dynamics = law.times[0] == 0 ? 0 : 3;  // filterexact
  }
}

void apply(const MjcfElement& of, Law& law) {
  const std::string_view kind = of.node().name();
  law.left_out.clear();
  if (kind == "general") {
    apply_general(of, law);
  } else if (kind == "motor") {
    law.gain_type = Law::fixed;
    law.bias_type = Law::none;
    law.gain = {1};
    law.dynamics = 0;
  } else if (kind == "position" || kind == "intvelocity") {
    apply_servo(of, law, kind == "intvelocity");
  } else if (kind == "velocity") {
    const double kv = of.number("kv", law.gain[0]);
    law.gain = {kv};
    law.bias = {0, 0, -kv};
    law.gain_type = Law::fixed;
    law.bias_type = Law::affine;
    law.dynamics = 0;
  } else if (kind == "damper") {
    const double kv = of.has("kv") ? of.number("kv", 0) : -law.gain[2];
    law.gain = {0, 0, -kv};
    law.gain_type = Law::affine;
    law.bias_type = Law::none;
    law.dynamics = 0;
  } else if (kind == "cylinder") {
    law.times[0] = of.number("timeconst", law.times[0]);
    copy_first(of.list("bias", 3, 3), law.bias);
    law.gain[0] = of.number("area", law.gain[0]);
    if (of.has("diameter")) law.gain[0] = std::numbers::pi / 4 * std::pow(of.number("diameter", 0), 2);
    law.gain_type = Law::fixed;
    law.bias_type = Law::affine;
    law.dynamics = 2;
  } else if (kind == "muscle") {
    apply_muscle(of, law);
  } else {
    // What is inside of such a class has the same law, unless it says another.
    law.gain_type = law.bias_type = Law::other;
    law.left_out = fmt::format("<{}>", printable(kind));
  }
}

Law law_of(const MjcfContext& context, const MjcfElement& of) {
  Law law;
  // From the outermost class to the element itself.
  for (auto layer = of.layers().rbegin(); layer != of.layers().rend(); ++layer)
    apply({context.text(), {*layer}, of.what()}, law);
  if (law.gain_type == Law::other || law.bias_type == Law::other || law.dynamics > 4)
    if (law.left_out.empty())
      law.left_out = "a law of gain, bias or activation that is neither fixed, affine nor a muscle's";
  return law;
}

/// What it acts through, or why it cannot be expressed.
std::string find_target(MjcfContext& context, const MjcfElement& of, const Law& law, MjcfActuator& actuator) {
  if (of.has("joint") || of.has("jointinparent")) {
    actuator.in_parent = !of.has("joint");
    actuator.of =
        context.find(of, actuator.in_parent ? "jointinparent" : "joint", "joint", context.tree.joints);
    const MjcfJoint& joint = context.model.joints[actuator.of];
    if (speed_count(joint.type) == 1) return "";
    const bool of_length = law.gain[1] != 0 || law.bias[1] != 0,
               of_speed = law.gain[2] != 0 || law.bias[2] != 0;
    if (joint.type == MjcfJointType::ball && of_length) return "the rotation of a ball joint as its length";
    if (actuator.in_parent && of_speed) return "a speed in the axes of the parent";
    if (actuator.in_parent && context.model.bodies[joint.body].joints[0] != actuator.of)
      return "the axes of a parent that other joints of the body turn";
    return "";
  }
  if (of.has("tendon")) {
    actuator.through = MjcfTransmission::tendon;
    actuator.of = context.find(of, "tendon", "tendon", context.tendons);
    return "";
  }
  if (of.has("site")) {
    actuator.through = MjcfTransmission::site;
    actuator.of = context.find(of, "site", "site", context.tree.sites);
    return of.has("refsite") ? "a refsite" : "";
  }
  return of.has("cranksite") ? "a slider and crank" : of.has("body") ? "a body" : "nothing";
}

/// A range as wide as that of its joint, or narrower: of the input, or of what integrates it.
void inherit_range(const MjcfContext& context, const Law& law, MjcfActuator& actuator) {
  if (!(law.inherit_range > 0) || actuator.through != MjcfTransmission::joint) return;
  const std::optional<std::array<double, 2>>& limits = context.model.joints[actuator.of].limits;
  if (!limits) return;
  const double middle = ((*limits)[0] + (*limits)[1]) / 2,
               half = ((*limits)[1] - (*limits)[0]) / 2 * law.inherit_range;
  (law.dynamics == 1 ? actuator.activations : actuator.inputs) = std::array{middle - half, middle + half};
}

MjcfMuscle muscle_of(const MjcfElement& of, const std::array<double, 9>& given,
                     const std::array<double, 2>& lengths) {
  if (!(given[0] < given[1]) || !(given[4] < 1 && given[5] > 1) ||
      !(given[6] > 0 && given[7] > 0 && given[8] > 0))
    throw InputError(of.where(),
                     fmt::format("expected a range that increases, lmin < 1 < lmax, and positive vmax, fpmax "
                                 "and fvmax of {}",
                                 of.what()));
  return {.lengths = lengths,
          .first = given[0],
          .optimal = (lengths[1] - lengths[0]) / (given[1] - given[0]),
          .force = given[2],
          .least = given[4],
          .most = given[5],
          .fastest = given[6],
          .passive = given[7],
          .eccentric = given[8]};
}

/// Its gain and bias, where they are a muscle's; or why they cannot be expressed.
std::string find_muscles(const MjcfElement& of, const Law& law, MjcfActuator& actuator) {
  const bool pulls = law.gain_type == Law::muscle, resists = law.bias_type == Law::muscle;
  if (!pulls && !resists) return {};
  const std::vector<double> lengths = of.list("lengthrange", 2, 2);
  if (lengths.empty() || !(lengths[0] < lengths[1])) return "a lengthrange that MuJoCo finds by simulating";
  if ((pulls && law.gain[2] < 0) || (resists && law.bias[2] < 0))
    return "a force that MuJoCo works out from accelerations";
  if (pulls) actuator.pull = muscle_of(of, law.gain, {lengths[0], lengths[1]});
  if (resists) actuator.resistance = muscle_of(of, law.bias, {lengths[0], lengths[1]});
  if (pulls) actuator.gain = {};
  return {};
}

void read_actuator(MjcfContext& context, pugi::xml_node node) {
  const MjcfElement of = context.element(node, kTags);
  Law law = law_of(context, of);
  if (law.gain_type == Law::fixed) law.gain = {law.gain[0]};
  if (law.bias_type == Law::none) law.bias = {};
  MjcfActuator actuator;
  actuator.name = context.name(of);
  actuator.where = of.has("name") ? of.where("name") : of.where();
  actuator.group = static_cast<int>(of.number("group", 0));
  std::string left_out = law.left_out;
  if (left_out.empty()) left_out = find_target(context, of, law, actuator);
  if (left_out.empty()) left_out = find_muscles(of, law, actuator);
  if (left_out.empty() && (of.number("armature", 0) != 0 || of.list("damping", 1, 3) > std::vector{0.0}))
    throw of.error("armature", fmt::format("armature and damping of {} itself are not taken", of.what()),
                   "those of joints are");
  if (!left_out.empty()) {
    context.text().warn(
        {of.where(),
         fmt::format("{} acts by {}, which cannot be expressed; it is left out", of.what(), left_out),
         "its force is not in the equations; what it exerts is part of tau", "actuator " + left_out});
    return;
  }
  const std::vector<double> gear = of.overlaid("gear", 6);
  std::ranges::copy(gear, actuator.gear.begin());
  if (!actuator.pull) copy_first({law.gain.begin(), law.gain.end()}, actuator.gain);
  if (!actuator.resistance) copy_first({law.bias.begin(), law.bias.end()}, actuator.bias);
  actuator.muscle_times = law.times;
  actuator.activation = law.dynamics == 0   ? MjcfActivation::none
                        : law.dynamics == 1 ? MjcfActivation::integrator
                        : law.dynamics == 4 ? MjcfActivation::muscle
                                            : MjcfActivation::filter;
  actuator.time_constant = law.times[0];
  if (law.dynamics > 1 && !(law.times[0] > 0 && (law.dynamics != 4 || law.times[1] > 0)))
    throw of.error("dynprm", fmt::format("the time constant of {} is {}; expected a positive number",
                                         of.what(), law.times[law.times[0] > 0 ? 1 : 0]));
  if (of.number("delay", 0) != 0)
    context.text().warn({of.where("delay"),
                         fmt::format("the delay of {} is left out: its input acts at once", of.what()),
                         {},
                         "delay"});
  if (law.dynamics != 0 && of.flag("actearly", false))
    context.text().warn(
        {of.where("actearly"),
         fmt::format("actearly of {} is left out: its force is that of the activation now, not of "
                     "MuJoCo's next time step",
                     of.what()),
         {},
         "actearly"});
  actuator.inputs = context.range(of, "ctrlrange", "ctrllimited");
  actuator.forces = context.range(of, "forcerange", "forcelimited");
  actuator.activations = context.range(of, "actrange", "actlimited");
  inherit_range(context, law, actuator);
  if (const double ratio = law.damping_ratio(); ratio > 0) {
    const bool single = actuator.through == MjcfTransmission::joint &&
                        speed_count(context.model.joints[actuator.of].type) == 1;
    if (!single)
      throw of.error(
          "dampratio",
          fmt::format("dampratio of {}, which acts on no single joint, is not worked out", of.what()),
          "give kv; a positive third biasprm is a dampratio, too");
    const double mass =
        inertia_at_reference(context.model, actuator.of) / (actuator.gear[0] * actuator.gear[0]);
    actuator.bias[2] = -2 * ratio * std::sqrt(law.gain[0] * mass);
  }
  if (!actuator.name.empty() &&
      !context.actuators.emplace(actuator.name, context.model.actuators.size()).second)
    throw InputError(actuator.where, fmt::format("a second actuator '{}'", printable(actuator.name)));
  context.model.actuators.push_back(std::move(actuator));
}

}  // namespace

void read_actuators(MjcfContext& context) {
  context.read_each("actuator", [&](pugi::xml_node node) { read_actuator(context, node); });
}

}  // namespace alembert
