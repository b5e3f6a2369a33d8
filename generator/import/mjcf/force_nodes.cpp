#include "import/mjcf/force_nodes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "import/common/mass_nodes.hpp"
#include "import/common/snapped_angle.hpp"
#include "import/mjcf/sums.hpp"

namespace alembert {
namespace {

// A step of `simulate`: activations stop at the ends of their ranges over no shorter time.
constexpr double kShortestStop = 1e-3;

std::string within(const std::string& force, const std::optional<std::array<double, 2>>& range) {
  if (!range || force.empty()) return force;
  return fmt::format("clamp({}, {}, {})", force, number_text((*range)[0]), number_text((*range)[1]));
}

std::string tanh_of(double force, const std::string& speed) {
  return fmt::format("{}*tanh({}*{})", number_text(-force), number_text(1 / kFrictionVelocity),
                     factor_text(speed));
}

/// Of a spring that is slack between two lengths.
std::string spring_energy(double stiffness, const std::string& length, const std::array<double, 2>& rest) {
  const std::string half = number_text(stiffness / 2);
  if (rest[0] == rest[1])
    return fmt::format("{}*{}^2", half, base_text(sum_text({{1, length}, {-rest[0], ""}})));
  return fmt::format("{}*(max(0, {})^2 + max(0, {})^2)", half, sum_text({{1, length}, {-rest[1], ""}}),
                     sum_text({{-1, factor_text(length)}, {rest[0], ""}}));
}

}  // namespace

/// A force along a joint, which acts on the coordinate that it follows.
void MjcfForceNodes::add_on(YamlNode& list, const std::string& name, std::size_t joint,
                            const std::string& value, const SourceLocation& where) {
  const JointText& text = naming_.text(joint);
  if (!text.base || (text.constant_slope && *text.constant_slope == 0)) return;
  YamlNode& force = nodes_.add_named(list, name, where);
  nodes_.put(force, "on", nodes_.text(naming_.coordinates(*text.base)[0], where));
  const std::string along = text.constant_slope ? product_text(*text.constant_slope, value)
                                                : factor_text(text.slope) + "*" + factor_text(value);
  nodes_.put(force, "value", nodes_.text(along, where));
}

void MjcfForceNodes::add_followers(YamlNode& list) {
  for (const std::size_t j : naming_.followers()) {
    const MjcfJoint& joint = model_.joints[j];
    const JointText& text = naming_.text(j);
    const std::string& name = naming_.coordinates(j)[0];
    if (!text.base) continue;
    if (options_.resistance && joint.damping != 0)
      add_on(list, naming_.new_force(name + "_damping"), j, product_text(-joint.damping, text.speed),
             joint.where);
    if (options_.resistance && joint.friction != 0)
      add_on(list, naming_.new_force(name + "_friction"), j, tanh_of(joint.friction, text.speed),
             joint.where);
    if (joint.stiffness == 0) continue;
    YamlNode& spring = nodes_.add_named(list, naming_.new_force(name + "_spring"), joint.where);
    nodes_.put(
        spring, "potential",
        nodes_.text(spring_energy(joint.stiffness, text.position, {joint.rest, joint.rest}), joint.where));
  }
}

/// Of ball and free joints: k/2 times the square of how far they have turned, and shifted.
void MjcfForceNodes::add_springs_of_turns(YamlNode& list) {
  for (std::size_t j = 0; j < model_.joints.size(); ++j) {
    const MjcfJoint& joint = model_.joints[j];
    if (joint.stiffness == 0 || speed_count(joint.type) == 1) continue;
    const std::vector<std::string>& names = naming_.coordinates(j);
    std::string square = turn_energy(j);
    for (std::size_t k = 0; k + 1 < names.size(); ++k) {
      const double rest = model_.bodies[joint.body].pose.shift[static_cast<Eigen::Index>(k)];
      square += fmt::format(" + {}^2", base_text(sum_text({{1, names[k]}, {-rest, ""}})));
    }
    YamlNode& spring = nodes_.add_named(list, naming_.new_force(names.back() + "_spring"), joint.where);
    nodes_.put(spring, "potential",
               nodes_.text(fmt::format("{}*({})", number_text(joint.stiffness / 2), square), joint.where));
  }
}

/// The square of the angle between the axes before a ball or free joint and those behind it. With the matrix R from one
/// to the other it is atan2(|r|, (tr R - 1)/2), where r is the axial vector of R: 1e-30 lets it be differentiated at 0.
std::string MjcfForceNodes::turn_energy(std::size_t j) {
  const MjcfJoint& joint = model_.joints[j];
  const MjcfBody& body = model_.bodies[joint.body];
  const auto is_hinge = [&](std::size_t each) { return model_.joints[each].type == MjcfJointType::hinge; };
  if (std::ranges::any_of(body.joints, is_hinge))
    throw InputError(joint.where, "the stiffness of a ball joint beside a hinge of its body is not taken",
                     "a body between them may have the ball joint alone");
  const std::string own = naming_.new_frame(naming_.body(joint.body) + "_turned");
  bodies_.add_frame(frames_, own, joint.body, {}, joint.where);
  std::string before;
  if (body.parent != 0) {
    before = naming_.new_frame(naming_.body(joint.body) + "_unturned");
    bodies_.add_frame(frames_, before, body.parent, body.pose, joint.where);
  }
  const Eigen::Matrix3d fixed = body.pose.turn.toRotationMatrix();
  const auto column = [](const std::string& frame, std::size_t m, std::string(&out)[3]) {
    for (std::size_t k = 0; k < 3; ++k) out[k] = fmt::format("rotation({}).{}{}", frame, kAxes[k], kAxes[m]);
  };
  const auto entry = [&](std::size_t row, std::size_t m) {
    std::string turned[3], unturned[3];
    column(own, m, turned);
    if (body.parent == 0)
      return sum_text({{fixed(0, static_cast<Eigen::Index>(row)), turned[0]},
                       {fixed(1, static_cast<Eigen::Index>(row)), turned[1]},
                       {fixed(2, static_cast<Eigen::Index>(row)), turned[2]}});
    column(before, row, unturned);
    return dot_text(unturned, turned);
  };
  std::vector<std::string> axial, trace;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    axial.push_back(fmt::format("({} - {})^2", entry(b, a), factor_text(entry(a, b))));
    trace.push_back(entry(k, k));
  }
  return fmt::format("atan2(sqrt({} + 1e-30)/2, ({} - 1)/2)^2", fmt::join(axial, " + "),
                     fmt::join(trace, " + "));
}

std::string MjcfForceNodes::length(std::size_t tendon) const {
  std::vector<SumTerm> terms;
  const MjcfTendon& of = model_.tendons[tendon];
  for (const MjcfTerm& term : of.terms) terms.push_back({term.factor, naming_.text(term.joint).position});
  if (!of.fixed)
    for (std::size_t b = 0; b < of.branches.size(); ++b)
      terms.push_back({1 / of.branches[b].divisor, fmt::format("length({})", paths_.at(tendon)[b])});
  return sum_text(terms);
}

std::string MjcfForceNodes::rate(std::size_t tendon) const {
  std::vector<SumTerm> terms;
  const MjcfTendon& of = model_.tendons[tendon];
  for (const MjcfTerm& term : of.terms)
    if (naming_.text(term.joint).base) terms.push_back({term.factor, naming_.text(term.joint).speed});
  if (!of.fixed)
    for (std::size_t b = 0; b < of.branches.size(); ++b)
      terms.push_back({1 / of.branches[b].divisor, fmt::format("rate({})", paths_.at(tendon)[b])});
  return sum_text(terms);
}

YamlNode& MjcfForceNodes::wrap_node(const MjcfWrap& wrap, const SourceLocation& where) {
  const MjcfRound& round = *model_.sites[wrap.geom].round;
  YamlNode& out = nodes_.mapping(where);
  nodes_.put(out, round.cylinder ? "cylinder" : "sphere", nodes_.text(naming_.frame(wrap.geom), where));
  nodes_.put(out, "radius", nodes_.text(number_text(round.radius), where));
  if (wrap.side) nodes_.put(out, "side", nodes_.text(naming_.frame(*wrap.side), where));
  return out;
}

/// `pull`: what actuators add along its length, or nothing.
void MjcfForceNodes::add_tendon(YamlNode& list, std::size_t tendon, const std::string& pull) {
  const MjcfTendon& of = model_.tendons[tendon];
  const std::string& name = naming_.tendon(tendon);
  std::vector<SumTerm> along;
  if (options_.resistance && of.damping != 0) along.push_back({-of.damping, factor_text(rate(tendon))});
  if (options_.resistance && of.friction != 0) along.push_back({1, tanh_of(of.friction, rate(tendon))});
  std::string passive, sum = pull;
  for (const SumTerm& term : along) {
    const std::string text = product_text(term.factor, term.of);
    passive += (passive.empty() ? "" : " + ") + text;
    sum += (sum.empty() ? "" : " + ") + text;
  }
  if (of.fixed) {
    for (const MjcfTerm& term : of.terms) {
      if (term.factor == 0) continue;
      const std::string force =
          naming_.new_force(fmt::format("{}_{}", name, naming_.coordinates(term.joint)[0]));
      const bool driven = !pull.empty() && model_.joints[term.joint].drive;
      if (driven) drives_[term.joint].push_back({force, product_text(term.factor, pull), of.where});
      const std::string& left = driven ? passive : sum;
      if (!left.empty())
        add_on(list, driven ? naming_.new_force(force + "_passive") : force, term.joint,
               product_text(term.factor, left), of.where);
    }
  } else {
    for (std::size_t b = 0; b < of.branches.size(); ++b) {
      YamlNode& force = nodes_.add_named(list, paths_[tendon][b], of.where);
      YamlNode& path = nodes_.sequence(of.where);
      const std::vector<std::size_t>& sites = of.branches[b].sites;
      for (std::size_t i = 0; i < sites.size(); ++i) {
        if (i == 0 || sites[i] != sites[i - 1])
          path.items.push_back(&nodes_.text(naming_.frame(sites[i]), of.where));
        const auto wrap = of.branches[b].wraps.find(i);
        if (wrap != of.branches[b].wraps.end() && sites[i + 1] != sites[i])
          path.items.push_back(&wrap_node(wrap->second, of.where));
      }
      nodes_.put(force, "path", path);
      nodes_.put(force, "tension",
                 nodes_.text(sum.empty() ? "0" : product_text(-1 / of.branches[b].divisor, sum), of.where));
    }
  }
  if (of.stiffness == 0) return;
  YamlNode& spring = nodes_.add_named(list, naming_.new_force(name + "_spring"), of.where);
  nodes_.put(spring, "potential",
             nodes_.text(spring_energy(of.stiffness, length(tendon), of.rest), of.where));
}

bool MjcfForceNodes::acts(std::size_t actuator) const {
  const MjcfActuator& of = model_.actuators[actuator];
  const auto any = [](const auto& values) {
    return std::ranges::any_of(values, [](double v) { return v != 0; });
  };
  return any(of.gear) && (any(of.gain) || any(of.bias) || of.pull || of.resistance);
}

std::string MjcfForceNodes::actuator_length(const MjcfActuator& of) const {
  if (of.through == MjcfTransmission::tendon) return product_text(of.gear[0], length(of.of));
  if (of.through == MjcfTransmission::site || speed_count(model_.joints[of.of].type) != 1) return "0";
  return product_text(of.gear[0], naming_.text(of.of).position);
}

std::string MjcfForceNodes::actuator_rate(const MjcfActuator& of) const {
  if (of.through == MjcfTransmission::tendon) return product_text(of.gear[0], rate(of.of));
  std::vector<SumTerm> terms;
  if (of.through == MjcfTransmission::site) {
    // Of the site, in its own axes.
    const std::string& frame = naming_.frame(of.of);
    for (const auto& [quantity, first] :
         {std::pair("velocity", std::size_t{0}), {"angular_velocity", std::size_t{3}}}) {
      std::string v[3];
      for (int k = 0; k < 3; ++k) v[k] = fmt::format("{}({}).{}", quantity, frame, kAxes[k]);
      turn_into(frame, v);
      for (std::size_t k = 0; k < 3; ++k) terms.push_back({of.gear[first + k], factor_text(v[k])});
    }
    return sum_text(terms);
  }
  if (speed_count(model_.joints[of.of].type) == 1) return product_text(of.gear[0], naming_.text(of.of).speed);
  const std::vector<std::string>& names = naming_.coordinates(of.of);
  const std::size_t shifts = names.size() - 1;
  for (std::size_t k = 0; k < shifts; ++k) terms.push_back({of.gear[k], fmt::format("d({})", names[k])});
  for (std::size_t k = 0; k < 3; ++k)
    terms.push_back({of.gear[shifts + k], fmt::format("d({}).{}", names.back(), kAxes[k])});
  return sum_text(terms);
}

/// What it exerts at a length, a velocity and an activation: no activation, only what resists.
std::string MjcfForceNodes::muscle_force(const MjcfMuscle& muscle, const std::string& length,
                                         const std::string& velocity, const std::string& activation) {
  const double offset = muscle.first - muscle.lengths[0] / muscle.optimal;
  // From 0 to 1 between two lengths, in optimal ones.
  const auto between = [&](double from, double to) {
    return sum_text(
        {{1 / (muscle.optimal * (to - from)), factor_text(length)}, {(offset - from) / (to - from), ""}});
  };
  if (activation.empty()) {
    // A parabola, and a straight line from half of the way to `most` on.
    const double half = (1 + muscle.most) / 2;
    return fmt::format("-{}*(max(0, {})^2 - max(0, {})^2)", number_text(muscle.force * muscle.passive / 2),
                       between(1, half), between(half, muscle.most));
  }
  // Two parabolas on each side of the peak.
  const std::string x = fmt::format("max(0, min({}, {}))", between(muscle.least, 1), between(muscle.most, 1));
  const std::string v = product_text(1 / (muscle.optimal * muscle.fastest), velocity);
  const double faster = muscle.eccentric - 1;
  const std::string lengthening =
      faster > 0 ? fmt::format("{} - max(0, {} - {})^2/{}", number_text(muscle.eccentric),
                               number_text(faster), factor_text(v), number_text(faster))
                 : number_text(muscle.eccentric);
  return fmt::format("-{}*{}*(2*{}^2 - max(0, 2*{} - 1)^2)*select({}, {}, max(0, {})^2)",
                     number_text(muscle.force), activation, x, x, v, lengthening,
                     sum_text({{1, v}, {1, ""}}));
}

/// gain*u + bias, within its range.
std::string MjcfForceNodes::law(std::size_t actuator) const {
  const MjcfActuator& of = model_.actuators[actuator];
  const std::string& u =
      of.activation == MjcfActivation::none ? naming_.input(actuator) : naming_.state(actuator);
  const std::string l = actuator_length(of), v = actuator_rate(of);
  std::string out;
  const auto add = [&](double factor, const std::string& text) {
    if (factor == 0 || text == "0") return;
    const std::string size = number_text(std::abs(factor));
    const std::string term = text.empty()            ? size
                             : std::abs(factor) == 1 ? factor_text(text)
                                                     : size + "*" + factor_text(text);
    if (out.empty())
      out = factor < 0 ? "-" + term : term;
    else
      out += (factor < 0 ? " - " : " + ") + term;
  };
  const auto of_input = [&](const std::string& text) { return u + "*" + factor_text(text); };
  if (of.gain[0] != 0 && of.bias[1] == -of.gain[0] && l != "0") {
    add(of.gain[0], fmt::format("{} - {}", u, factor_text(l)));
  } else {
    add(of.gain[0], u);
    add(of.bias[1], l);
  }
  if (of.gain[1] != 0 && l != "0") add(of.gain[1], of_input(l));
  if (of.gain[2] != 0 && v != "0") add(of.gain[2], of_input(v));
  add(of.bias[0], "");
  add(of.bias[2], v);
  const auto add_muscle = [&](const std::optional<MjcfMuscle>& muscle, const std::string& activation) {
    if (!muscle || muscle->force == 0) return;
    out += (out.empty() ? "" : " + ") + muscle_force(*muscle, l, v, activation);
  };
  add_muscle(of.pull, u);
  add_muscle(of.resistance, "");
  return out.empty() ? "0" : within(out, of.forces);
}

/// What actuators exert along the length of a tendon: where the sum of their forces leaves its range, MuJoCo makes
/// them smaller by one factor, before the gears.
std::string MjcfForceNodes::pull_of(const MjcfTendon& tendon,
                                    const std::vector<std::size_t>& actuators) const {
  std::vector<std::string> laws, geared;
  bool alike = true;
  for (const std::size_t a : actuators) {
    const double gear = model_.actuators[a].gear[0];
    laws.push_back(law(a));
    geared.push_back(product_text(gear, laws.back()));
    alike = alike && gear == model_.actuators[actuators[0]].gear[0];
  }
  if (!tendon.drive || actuators.empty()) return fmt::format("{}", fmt::join(geared, " + "));
  const std::string sum = fmt::format("{}", fmt::join(laws, " + "));
  if (alike) return product_text(model_.actuators[actuators[0]].gear[0], within(sum, tendon.drive));
  const auto [low, high] = *tendon.drive;
  if (!(low < 0 && high > 0))
    throw InputError(tendon.where,
                     fmt::format("the actuatorfrcrange of tendon '{}', {} to {}, is without 0, and gears "
                                 "of its actuators differ: that is not taken",
                                 printable(tendon.name), low, high));
  return fmt::format("min({1}/max({1}, {0}), {2}/min({2}, {0}))*({3})", sum, number_text(high),
                     number_text(low), fmt::join(geared, " + "));
}

void MjcfForceNodes::add_actuator(YamlNode& list, std::size_t actuator) {
  const MjcfActuator& of = model_.actuators[actuator];
  const std::string& name = naming_.actuator(actuator);
  const std::string force = law(actuator);
  if (of.through == MjcfTransmission::site) {
    YamlNode& node = nodes_.add_named(list, name, of.where);
    nodes_.put(node, "at", nodes_.text(naming_.frame(of.of), of.where));
    for (const auto& [key, first] : {std::pair("force", std::size_t{0}), {"torque", std::size_t{3}}}) {
      std::array<std::string, 3> entries;
      bool any = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const double gear = of.gear[first + k];
        any = any || gear != 0;
        entries[k] = gear == 0 ? "0" : product_text(gear, force);
      }
      if (any) nodes_.put(node, key, nodes_.list({entries[0], entries[1], entries[2]}, of.where));
    }
  } else if (speed_count(model_.joints[of.of].type) == 1) {
    add_on(list, name, of.of, product_text(of.gear[0], force), of.where);
  } else {
    const std::vector<std::string>& names = naming_.coordinates(of.of);
    std::vector<std::string> speeds(names.begin(), names.end() - 1);
    if (of.in_parent)
      add_turn_in_parent(list, of, force,
                         {of.gear[speeds.size()], of.gear[speeds.size() + 1], of.gear[speeds.size() + 2]});
    else
      for (const char* axis : kAxes) speeds.push_back(names.back() + "." + axis);
    bool first = true;
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      if (of.gear[k] == 0) continue;
      YamlNode& node = nodes_.add_named(list, first ? name : naming_.new_force(name), of.where);
      nodes_.put(node, "on", nodes_.text(speeds[k], of.where));
      nodes_.put(node, "value", nodes_.text(product_text(of.gear[k], force), of.where));
      first = false;
    }
  }
}

/// A torque on a body in the axes that it has where its joint has not turned it, and the opposite one on its parent.
void MjcfForceNodes::add_turn_in_parent(YamlNode& list, const MjcfActuator& of, const std::string& force,
                                        const Eigen::Vector3d& torque) {
  if (torque.isZero(0)) return;
  const std::size_t index = model_.joints[of.of].body;
  const MjcfBody& body = model_.bodies[index];
  const std::string axes = naming_.new_frame(naming_.body(index) + "_parent_axes");
  bodies_.add_frame(frames_, axes, body.parent, body.pose, of.where);
  const std::string own = naming_.new_frame(naming_.body(index) + "_turned");
  bodies_.add_frame(frames_, own, index, {}, of.where);
  std::array<std::string, 3> on_body, on_parent;
  for (int k = 0; k < 3; ++k) {
    std::vector<SumTerm> terms;
    for (int m = 0; m < 3; ++m)
      terms.push_back({torque[m], fmt::format("rotation({}).{}{}", axes, kAxes[k], kAxes[m])});
    on_body[static_cast<std::size_t>(k)] = factor_text(sum_text(terms)) + "*" + factor_text(force);
    on_parent[static_cast<std::size_t>(k)] = torque[k] == 0 ? "0" : product_text(-torque[k], force);
  }
  YamlNode& node = nodes_.add_named(list, naming_.new_force(naming_.body(index) + "_turn"), of.where);
  nodes_.put(node, "at", nodes_.text(own, of.where));
  nodes_.put(node, "axes", nodes_.text("world", of.where));
  nodes_.put(node, "torque", nodes_.list({on_body[0], on_body[1], on_body[2]}, of.where));
  if (body.parent == 0) return;
  YamlNode& reaction =
      nodes_.add_named(list, naming_.new_force(naming_.body(index) + "_turn_reaction"), of.where);
  nodes_.put(reaction, "at", nodes_.text(axes, of.where));
  nodes_.put(reaction, "torque", nodes_.list({on_parent[0], on_parent[1], on_parent[2]}, of.where));
}

void MjcfForceNodes::add_forces(YamlNode& list) {
  add_followers(list);
  add_springs_of_turns(list);
  std::vector<std::vector<std::size_t>> pulling(model_.tendons.size());
  for (std::size_t a = 0; a < model_.actuators.size(); ++a)
    if (model_.actuators[a].through == MjcfTransmission::tendon && acts(a))
      pulling[model_.actuators[a].of].push_back(a);
  for (std::size_t t = 0; t < model_.tendons.size(); ++t) {
    // Names of its branches stand in the laws of its actuators.
    const MjcfTendon& of = model_.tendons[t];
    if (!of.fixed) {
      std::vector<std::string>& paths = paths_[t];
      for (std::size_t b = 0; b < of.branches.size(); ++b)
        paths.push_back(b == 0 ? naming_.tendon(t)
                               : naming_.new_force(fmt::format("{}_branch{}", naming_.tendon(t), b + 1)));
    }
    add_tendon(list, t, pull_of(of, pulling[t]));
  }
  for (std::size_t a = 0; a < model_.actuators.size(); ++a) {
    const MjcfActuator& of = model_.actuators[a];
    if (of.through == MjcfTransmission::tendon || !acts(a)) continue;
    if (of.through == MjcfTransmission::joint && model_.joints[of.of].drive)
      drives_[of.of].push_back({naming_.actuator(a), product_text(of.gear[0], law(a)), of.where});
    else
      add_actuator(list, a);
  }
  for (const auto& [joint, parts] : drives_) {
    std::vector<std::string> forces;
    for (const DrivePart& part : parts) forces.push_back(part.force);
    add_on(list,
           parts.size() == 1 ? parts[0].name : naming_.new_force(naming_.coordinates(joint)[0] + "_drive"),
           joint, within(fmt::format("{}", fmt::join(forces, " + ")), model_.joints[joint].drive),
           parts[0].where);
  }
  add_borne_weight(list);
  add_fluid(list);
}

void MjcfForceNodes::add_inputs(YamlNode& list) const {
  for (std::size_t a = 0; a < model_.actuators.size(); ++a) {
    const MjcfActuator& of = model_.actuators[a];
    const bool used = of.pull || std::ranges::any_of(of.gain, [](double v) { return v != 0; });
    if (!acts(a) || !used) continue;
    // MuJoCo takes an input to the end of its range, too.
    double initial = model_.start_inputs.empty() ? 0 : model_.start_inputs[a];
    if (of.inputs) initial = std::clamp(initial, (*of.inputs)[0], (*of.inputs)[1]);
    YamlNode& node = nodes_.add_named(list, naming_.input(a), of.where);
    if (initial != 0) nodes_.put(node, "initial", nodes_.text(number_text(initial), of.where));
    if (of.inputs)
      nodes_.put(node, "limits",
                 nodes_.list({number_text((*of.inputs)[0]), number_text((*of.inputs)[1])}, of.where));
    if (node.items.size() == 2) list.items.back() = node.items[1];
  }
}

/// The rate of a muscle's activation: it rises and falls with two time constants.
std::string MjcfForceNodes::excitation(const MjcfActuator& of, const std::string& input,
                                       const std::string& state) {
  const auto [rise, fall, width] = of.muscle_times;
  const std::string more = fmt::format("clamp({}, 0, 1) - {}", input, state),
                    slower = fmt::format("(0.5 + 1.5*clamp({}, 0, 1))", state);
  const std::string rising = product_text(rise, slower), falling = number_text(fall) + "/" + slower;
  if (!(width > 0)) return fmt::format("({})/select({}, {}, {})", more, more, rising, falling);
  // From one to the other along a polynomial whose first two derivatives are 0 at its ends.
  const std::string part =
      fmt::format("clamp({}, 0, 1)", sum_text({{1 / width, factor_text(more)}, {0.5, ""}}));
  return fmt::format("({0})/({2} + ({1} - {2})*{3}^3*(10 - 15*{3} + 6*{3}^2))", more, rising, falling, part);
}

void MjcfForceNodes::add_states(YamlNode& list) const {
  for (std::size_t a = 0; a < model_.actuators.size(); ++a) {
    const MjcfActuator& of = model_.actuators[a];
    if (of.activation == MjcfActivation::none || !acts(a)) continue;
    const std::string &input = naming_.input(a), &state = naming_.state(a);
    YamlNode& node = nodes_.add_named(list, state, of.where);
    std::string rate = of.activation == MjcfActivation::integrator ? input
                       : of.activation == MjcfActivation::muscle
                           ? excitation(of, input, state)
                           : fmt::format("({} - {})/{}", input, state, number_text(of.time_constant));
    double initial = of.start;
    if (of.activations) {
      // Within a time step of MuJoCo, which moves it back, it does not leave its range.
      const std::string time = number_text(std::max(model_.time_step, kShortestStop));
      rate = fmt::format("clamp({}, ({} - {})/{}, ({} - {})/{})", rate, number_text((*of.activations)[0]),
                         state, time, number_text((*of.activations)[1]), state, time);
      initial = std::clamp(initial, (*of.activations)[0], (*of.activations)[1]);
    }
    nodes_.put(node, "rate", nodes_.text(rate, of.where));
    if (initial != 0) nodes_.put(node, "initial", nodes_.text(number_text(initial), of.where));
    if (of.activations)
      nodes_.put(
          node, "limits",
          nodes_.list({number_text((*of.activations)[0]), number_text((*of.activations)[1])}, of.where));
  }
}

bool MjcfForceNodes::moves(std::size_t body) const {
  for (; body != 0; body = model_.bodies[body].parent)
    if (!model_.bodies[body].joints.empty()) return true;
  return false;
}

void MjcfForceNodes::add_borne_weight(YamlNode& list) {
  for (std::size_t b = 1; b < model_.bodies.size(); ++b) {
    const MjcfBody& body = model_.bodies[b];
    if (body.weightless == 0 || body.mass.mass == 0 || !moves(b)) continue;
    const std::string frame = naming_.new_frame(naming_.body(b) + "_centre");
    bodies_.add_frame(frames_, frame, b, body.mass.frame(), body.where);
    alembert::add_borne_weight(nodes_, list, naming_.new_force(naming_.body(b) + "_gravcomp"), frame,
                               -body.weightless * body.mass.mass * model_.gravity, body.where);
  }
}

void MjcfForceNodes::add_fluid(YamlNode& list) {
  if (!model_.has_fluid()) return;
  for (std::size_t b = 1; b < model_.bodies.size(); ++b) {
    const MjcfBody& body = model_.bodies[b];
    if (body.mass.mass == 0 || !moves(b)) continue;
    for (const MjcfFluidShape& shape : body.fluid_shapes) {
      if (!(shape.semiaxes[0] > 0))
        throw InputError(shape.where, "the fluidshape of a mesh cannot be expressed: its sizes are MuJoCo's",
                         "without it the fluid acts on a box of the body's inertia, which can");
      add_fluid_at(list, b, shape.pose,
                   [&](const FluidMotion& motion) { return fluid_on_ellipsoid(model_, shape, motion); });
    }
    if (body.fluid_shapes.empty()) add_fluid_on_inertia(list, b);
  }
}

/// On a box of the body's inertia.
void MjcfForceNodes::add_fluid_on_inertia(YamlNode& list, std::size_t b) {
  const MjcfBody& body = model_.bodies[b];
  const Eigen::Matrix3d axes = body.inertial_turn->toRotationMatrix();
  const Eigen::Vector3d i = (axes.transpose() * body.mass.inertia * axes).diagonal();
  constexpr double kLeast = 1e-15;  // MuJoCo's own, kg m^2
  std::array<double, 3> box;
  for (int k = 0; k < 3; ++k)
    box[static_cast<std::size_t>(k)] = std::sqrt(std::max(kLeast, i.sum() - 2 * i[k]) / body.mass.mass * 6);
  add_fluid_at(list, b, body.mass.frame(Eigen::Quaterniond(axes)),
               [&](const FluidMotion& motion) { return fluid_on_box(model_, box, motion); });
}

/// At a frame of the body, whose axes the loads are in.
void MjcfForceNodes::add_fluid_at(YamlNode& list, std::size_t b, const RigidPose& pose,
                                  const std::function<FluidLoads(const FluidMotion&)>& law) {
  const MjcfBody& body = model_.bodies[b];
  const std::string frame = naming_.new_frame(naming_.body(b) + "_fluid");
  bodies_.add_frame(frames_, frame, b, pose, body.where);
  YamlNode& node = nodes_.add_named(list, naming_.new_force(naming_.body(b) + "_fluid"), body.where);
  nodes_.put(node, "at", nodes_.text(frame, body.where));
  std::string v[3], w[3];
  for (int m = 0; m < 3; ++m) {
    v[m] = sum_text({{1, fmt::format("velocity({}).{}", frame, kAxes[m])}, {-model_.wind[m], ""}});
    w[m] = fmt::format("angular_velocity({}).{}", frame, kAxes[m]);
  }
  turn_into(frame, v);
  turn_into(frame, w);
  FluidMotion motion;
  for (std::size_t k = 0; k < 3; ++k) {
    motion.velocity[k] = factor_text(v[k]);
    motion.angular_velocity[k] = factor_text(w[k]);
  }
  const auto [force, torque] = law(motion);
  nodes_.put(node, "force", nodes_.list({force[0], force[1], force[2]}, body.where));
  nodes_.put(node, "torque", nodes_.list({torque[0], torque[1], torque[2]}, body.where));
}

}  // namespace alembert
