// Joints: names for common products of factors.
#include "mechanism/joints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "mechanism/coordinates.hpp"
#include "mechanism/section.hpp"
#include "mechanism/transforms.hpp"

namespace alembert {
namespace {

/// One joint while its factors are being made.
struct JointReader {
  Loading& loading;
  const Section& section;
  std::string what;
  const std::vector<const YamlNode*>& names;
  SourceLocation where;
  Transform& transform;

  Expr real(std::size_t i) const {
    const int index =
        expect_coordinate(loading, *names[i], CoordinateType::real, fmt::format("a coordinate of {}", what));
    return loading.mechanism.coordinates[static_cast<std::size_t>(index)].symbols[0];
  }
  Axis axis() const {
    const YamlNode* node = section.find("axis");
    return node != nullptr ? read_axis(loading, *node, fmt::format("the axis of {}", what))
                           : coordinate_axis(loading.graph, 2);
  }
  void append(Factor factor) const { transform.factors.push_back(std::move(factor)); }
  void turn(const Axis& axis, std::size_t i) const { append(rotation_about(axis, real(i), where)); }
  void slide(const Axis& axis, const Expr& distance) const { append(shift_along(axis, distance, where)); }
  void turn_by_quaternion(std::size_t i) const { append(rotation_by_quaternion(loading, *names[i], what)); }

  void helix() const {
    const Axis about = axis();
    const Expr angle = real(0);
    const Expr pitch =
        loading.reader
            .read(section.require("pitch"), Allowed::parameters, fmt::format("the pitch of {}", what))
            .expr;
    append(rotation_about(about, angle, where));
    slide(about, pitch * angle);
  }
  void universal() const {
    Axis first = coordinate_axis(loading.graph, 0), second = coordinate_axis(loading.graph, 1);
    if (const YamlNode* node = section.find("axes")) {
      const std::string what_axes = fmt::format("the axes of {}", what);
      const auto& items = expect_list(loading.document, *node, what_axes, 2);
      first = read_axis(loading, *items[0], what_axes);
      second = read_axis(loading, *items[1], what_axes);
      const Vec3 normal = cross(first.direction, second.direction);
      if (normal[0].is_zero() && normal[1].is_zero() && normal[2].is_zero())
        throw InputError(loading.document.where(*node), fmt::format("{} are parallel", what_axes));
    }
    turn(first, 0);
    turn(second, 1);
  }
  void shift(std::size_t count) const {
    Vec3 offset = zeros<3, 1>(loading.graph);
    for (std::size_t i = 0; i < count; ++i) offset[i] = real(i);
    append({Translation{offset}, where});
  }
};

/// What a type of joint takes, and the factors it stands for. `coordinates` names them in order.
struct JointType {
  std::string_view name;
  std::string_view coordinates;
  int count;
  bool axis, axes, pitch;
  void (*append)(const JointReader& joint);
};
constexpr std::array kJointTypes = {
    JointType{"revolute", "[angle]", 1, true, false, false,
              [](const JointReader& joint) { joint.turn(joint.axis(), 0); }},
    JointType{"prismatic", "[shift]", 1, true, false, false,
              [](const JointReader& joint) {
                const Axis axis = joint.axis();
                joint.slide(axis, joint.real(0));
              }},
    JointType{"helical", "[angle]", 1, true, false, true, [](const JointReader& joint) { joint.helix(); }},
    JointType{"cylindrical", "[angle, shift]", 2, true, false, false,
              [](const JointReader& joint) {
                const Axis axis = joint.axis();
                joint.turn(axis, 0);
                joint.slide(axis, joint.real(1));
              }},
    JointType{"universal", "[first angle, second angle]", 2, false, true, false,
              [](const JointReader& joint) { joint.universal(); }},
    JointType{"planar", "[x, y, angle]", 3, false, false, false,
              [](const JointReader& joint) {
                joint.shift(2);
                joint.turn(coordinate_axis(joint.loading.graph, 2), 2);
              }},
    JointType{"spherical", "[quaternion]", 1, false, false, false,
              [](const JointReader& joint) { joint.turn_by_quaternion(0); }},
    JointType{"free", "[x, y, z, quaternion]", 4, false, false, false,
              [](const JointReader& joint) {
                joint.shift(3);
                joint.turn_by_quaternion(3);
              }},
};

const JointType& read_joint_type(const Document& document, const YamlNode& node) {
  const std::string& text = expect_text(document, node, "the type of a joint");
  for (const JointType& type : kJointTypes)
    if (type.name == text) return type;
  std::vector<std::string> known;
  for (const JointType& type : kJointTypes) known.emplace_back(type.name);
  throw InputError(document.where(node),
                   fmt::format("unknown joint type '{}'{}", printable(text), did_you_mean(text, known)),
                   fmt::format("joints are {}", fmt::join(known, ", ")));
}

}  // namespace

void append_joint(Loading& loading, const YamlNode& node, const std::string& what, Transform& transform) {
  const Document& document = loading.document;
  const Section section(document, node, fmt::format("a joint of {}", what),
                        {"type", "coordinates", "axis", "axes", "pitch"});
  const JointType& type = read_joint_type(document, section.require("type"));
  const std::string what_joint = fmt::format("a {} joint of {}", type.name, what);
  for (const auto& [key, taken] :
       {std::pair{"axis", type.axis}, std::pair{"axes", type.axes}, std::pair{"pitch", type.pitch}})
    if (!taken && section.find(key) != nullptr)
      throw InputError(section.where_key(key), fmt::format("a {} joint takes no '{}'", type.name, key));
  const YamlNode& list = section.require("coordinates");
  const auto& names = expect_list(
      document, list, fmt::format("coordinates {} of {}", type.coordinates, what_joint), type.count);
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (names[i]->kind == YamlNode::Kind::scalar && names[i]->text == names[k]->text)
        throw InputError(document.where(*names[i]),
                         fmt::format("coordinate '{}' twice in {}", printable(names[i]->text), what_joint));

  type.append({loading, section, what_joint, names, document.where(node), transform});
}

}  // namespace alembert
