// Names of a model's bodies, joints, sites and actuators in the language, and what stands for the position and
// speed of a joint that follows another.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "import/common/fit_names.hpp"
#include "import/mjcf/mjcf_model.hpp"

namespace alembert {

/// A hinge or slide in expressions.
struct JointText {
  std::string position, speed;
  std::optional<std::size_t>
      base;           ///< the joint whose coordinate it is a function of in the end; none: stands still
  std::string slope;  ///< d position / d coordinate of the base; empty: 1
  std::optional<double> constant_slope;
};

class MjcfNaming {
 public:
  MjcfNaming(const MjcfModel& model, Warnings& warnings);

  const std::string& body(std::size_t body) const { return bodies_[body]; }
  /// One; of a free joint three shifts and a quaternion.
  const std::vector<std::string>& coordinates(std::size_t joint) const { return coordinates_[joint]; }
  bool follows(std::size_t joint) const { return equality_of_[joint] != kNone; }
  const JointText& text(std::size_t joint) const { return texts_[joint]; }
  /// How far a hinge or slide is from its reference, an angle being a multiple of pi/12 if it is one.
  std::string from_reference(std::size_t joint) const;
  /// The position of a joint that follows another.
  std::string definition(std::size_t joint) const;
  /// Joints that follow others, each behind the one that it needs.
  const std::vector<std::size_t>& followers() const { return followers_; }
  /// Whether the equality is a function that a joint is given by.
  bool is_function(std::size_t equality) const { return functions_.contains(equality); }
  const std::string& frame(std::size_t site) const { return sites_[site]; }
  const std::string& input(std::size_t actuator) const { return inputs_[actuator]; }
  const std::string& state(std::size_t actuator) const { return states_[actuator]; }
  const std::string& actuator(std::size_t actuator) const { return actuators_[actuator]; }
  const std::string& tendon(std::size_t tendon) const { return tendons_[tendon]; }
  /// A name for a further frame, force, output or constraint.
  std::string new_frame(const std::string& name) { return unique(frames_, name); }
  std::string new_force(const std::string& name) { return unique(forces_, name); }
  std::string new_output(const std::string& name);
  std::string new_constraint(const std::string& name) { return unique(constraints_, name); }
  /// The rotation of a ball or free joint.
  const std::string& quaternion(std::size_t joint) const { return coordinates_[joint].back(); }

 private:
  using Names = std::set<std::string, std::less<>>;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  static std::string unique(Names& taken, const std::string& name);
  void name_bodies(Warnings& warnings);
  void name_joints(Warnings& warnings);
  void name_others();
  void find_followers(Warnings& warnings);
  bool follows_straight(std::size_t joint) const;
  /// Makes a joint's equality a constraint again, and says why.
  using Demote = std::function<void(std::size_t joint, const char* why)>;
  void shorten_chains(const Demote& demote);
  void write_text(std::size_t joint);

  const MjcfModel& model_;
  std::vector<std::string> bodies_, sites_, inputs_, states_, actuators_, tendons_;
  std::vector<std::vector<std::string>> coordinates_;
  std::vector<std::size_t> equality_of_, followers_;
  std::set<std::size_t> functions_;
  std::vector<JointText> texts_;
  Names variables_, frames_, forces_, constraints_;
};

}  // namespace alembert
