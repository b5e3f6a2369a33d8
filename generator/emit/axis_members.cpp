#include "emit/axis_members.hpp"

#include <fmt/format.h>

#include <span>

#include "emit/common_slots.hpp"
#include "emit/statements/literals.hpp"

namespace alembert {
namespace {

std::string constant(std::string_view type, std::string_view name, std::string_view doc,
                     const std::string& values) {
  const std::string start = fmt::format("static constexpr {} {} = ", type, name);
  return prefix_lines(wrap_words(comment_text(doc), 8, 0, 112) + "\n", "/// ") + start +
         wrap_list(values, start.size() + 4, 4, 114) + ";\n";
}

std::string doubles(std::span<const double> values) {
  std::vector<std::string> items;
  for (const double x : values) items.push_back(number_literal(x));
  return cpp_array(items);
}
template <class Number>
std::string integers(const std::vector<Number>& values) {
  std::vector<std::string> items;
  for (const Number x : values) items.push_back(fmt::format("{}", x));
  return cpp_array(items);
}
template <std::size_t count>
std::string rows_of_doubles(const std::array<std::vector<double>, count>& rows) {
  std::vector<std::string> items;
  for (const std::vector<double>& row : rows) items.push_back(doubles(row));
  return cpp_array(items);
}

}  // namespace

std::vector<ExtraFunction> axis_functions(const AxisPrograms& axes) {
  std::vector<ExtraFunction> functions = {
      {{"axis_frames",
        Topic::kinematics,
        false,
        {ArgumentKind::q},
        true,
        "Frames that follow the motion of each speed, for alembert::linearize.",
        "",
        {{"frames",
          "entries of the matrix [R p] of each row of Axes: the columns of R are the frame's axes in the "
          "world, p "
          "leads to its origin from that of one of the frames, m",
          12, kPerSpeed}},
        "",
        ""},
       axes.frames}};
  if (axes.forces)
    functions.push_back(
        {{"axis_forces",
          Topic::derivatives,
          false,
          {ArgumentKind::q, ArgumentKind::qd},
          true,
          "Applied forces by the rows of Axes, and their derivatives, for alembert::linearize.",
          "",
          {{"Q", "generalized forces, in units of tau", kPerSpeed},
           {"changes", "kForceEntries of their derivatives",
            static_cast<int>(axes.table.force_entries.size())}},
          "",
          ""},
         *axes.forces});
  return functions;
}

std::string axis_members(const AxisPrograms& axes, std::string_view name_space) {
  const AxisTable& table = axes.table;
  const std::string numbers = "::std::array<double, kNv>";
  const auto several = [&](int count) { return fmt::format("::std::array<{}, {}>", numbers, count); };
  std::string members =
      "using Of = Mechanism;\n" +
      constant("::std::array<int, kNv>", "kSpeeds", "Speeds, branch by branch: rows.",
               integers(table.speeds)) +
      constant("::std::array<int, kNv>", "kParents", "The row that carries each, or -1.",
               integers(table.parents)) +
      constant(several(3), "kDirections", "x y z of what each turns about or slides along, in its frame.",
               rows_of_doubles(table.directions)) +
      constant("::std::array<bool, kNv>", "kTurns", "Whether it turns.", integers(table.turns)) +
      constant(numbers, "kMasses", "Of what is fixed to the frame, kg.", doubles(table.masses)) +
      constant(several(3), "kCenters", "Its centre of mass in the frame, x y z, m.",
               rows_of_doubles(table.centers)) +
      constant(several(6), "kInertias",
               "Its inertia about that, in the frame's axes, xx yy zz xy xz yz, kg m^2.",
               rows_of_doubles(table.inertias)) +
      constant(numbers, "kArmatures", "Inertia of each speed's own.", doubles(table.armatures)) +
      constant("::std::array<bool, kNv>", "kFirstOfThree",
               "Whether the three speeds of a quaternion start here.", integers(table.first_of_three)) +
      constant("::std::array<double, 3>", "kGravity", "In the world, m/s^2.", doubles(table.gravity));
  members += fmt::format(
      "static void frames(const CoordinateVector& q, const Inputs& in, S* frames) {{\n"
      "  ::{}::axis_frames<S>(q.data(), in, frames);\n"
      "}}\n",
      name_space);
  if (axes.forces) {
    members += constant(fmt::format("::std::array<int, {}>", table.force_entries.size()), "kForceEntries",
                        "Which entries of the forces' derivatives are not zero: along the speeds, row by "
                        "row, then by the speeds.",
                        integers(table.force_entries));
    members += fmt::format(
        "static void forces(const CoordinateVector& q, const SpeedVector& qd, const Inputs& in, S* Q, S* "
        "changes) {{\n"
        "  ::{}::axis_forces<S>(q.data(), qd.data(), in, Q, changes);\n"
        "}}\n",
        name_space);
  }
  return "/// For alembert::linearize: each speed turns or slides one frame about or along an axis that is "
         "fixed in it.\n"
         "struct Axes {\n" +
         prefix_lines(members, "  ") + "};\n";
}

}  // namespace alembert
