// Members with Eigen's types (see the header).
#include "emit/eigen_members.hpp"

#include <fmt/format.h>

#include "emit/argument_lists.hpp"
#include "emit/function_docs.hpp"
#include "emit/statements/literals.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

std::string extent_constant(const Extent& extent) {
  switch (extent.of) {
    case Extent::Of::number:
      return std::to_string(extent.number);
    case Extent::Of::coordinates:
      return "kNq";
    case Extent::Of::speeds:
      return "kNv";
    case Extent::Of::constraint_rows:
      return "kNc";
    case Extent::Of::outputs:
      return "kNoutputs";
    case Extent::Of::parameters:
      return "kNparameters";
    case Extent::Of::inputs:
      return "kNinputs";
    case Extent::Of::base_parameters:
      return "kNbase";
    case Extent::Of::forces:
      return "kNforces";
    case Extent::Of::states:
      return "kNstates";
    case Extent::Of::bodies:
      return std::to_string(extent.number) + " * kNbodies";
  }
  throw InternalError("emit: no such extent");
}

std::string blocks_constant(Per per) {
  switch (per) {
    case Per::body:
      return "kNbodies";
    case Per::frame:
      return "kNframes";
    case Per::mechanism:
      break;
  }
  throw InternalError("emit: a result for the whole mechanism has no blocks");
}

bool is_vector(const ResultArray& result) {
  return result.per == Per::mechanism && result.columns == Extent(1);
}

bool is_square(const ResultArray& result) {
  return result.per == Per::mechanism && result.rows == result.columns;
}

/// The type of one block.
std::string block_type(const ResultArray& result) {
  if (is_vector(result) && result.rows == kPerCoordinate) return "CoordinateVector";
  if (is_vector(result) && result.rows == kPerSpeed) return "SpeedVector";
  if (is_vector(result) && result.rows == kPerConstraintRow) return "ConstraintVector";
  if (result.rows == kPerSpeed && result.columns == kPerSpeed) return "SpeedMatrix";
  if (result.rows == kPerConstraintRow && result.columns == kPerSpeed) return "ConstraintMatrix";
  if (result.rows == Extent(3) && result.columns == Extent(4)) return "Pose";
  if (result.columns == kPerStandardParameter)
    return fmt::format("::alembert::SizedMatrix<S, {}, {}>", extent_constant(result.rows),
                       extent_constant(result.columns));
  return fmt::format("::Eigen::Matrix<S, {}, {}>", extent_constant(result.rows),
                     extent_constant(result.columns));
}

std::string result_type(const ResultArray& result) {
  if (result.per == Per::mechanism) return block_type(result);
  const std::string count = blocks_constant(result.per);
  switch (result.blocks) {
    case Blocks::in_array:
      return fmt::format("::std::array<{}, {}>", block_type(result), count);
    case Blocks::stacked:
      return fmt::format(
          "::alembert::SizedMatrix<S, {}, {}>",
          result.rows == Extent(1) ? count : fmt::format("{} * {}", extent_constant(result.rows), count),
          extent_constant(result.columns));
  }
  throw InternalError("emit: no such arrangement of blocks");
}

/// Entries row by row have Eigen's order by columns where there is one column, or the matrix is symmetric; in
/// a square matrix they are brought into it in place. Everything else is copied.
bool needs_copy(const ResultArray& result) {
  return !is_vector(result) && !is_square(result);
}

std::string entry_count(const ResultArray& result) {
  std::string count = result.per == Per::mechanism ? "" : blocks_constant(result.per) + " * ";
  if (result.rows != Extent(1)) count += extent_constant(result.rows) + " * ";
  return count + extent_constant(result.columns);
}

std::string argument_type(ArgumentKind kind) {
  return kind == ArgumentKind::q ? "const CoordinateVector&" : "const SpeedVector&";
}

struct MemberText {
  std::string type, parameters;
  std::string before, arguments, after;  // of the call
};

}  // namespace

std::string eigen_member(const OutputFunction& function, std::string_view name_space) {
  const bool returned = function.results.size() == 1;
  const std::string type = returned ? result_type(function.results[0]) : "void";
  const auto add = [](std::string& list, const std::string& item) {
    list += (list.empty() ? "" : ", ") + item;
  };
  MemberText of_matrices;
  of_matrices.type = type;
  for (const ArgumentKind kind : function.arguments) {
    add(of_matrices.parameters, fmt::format("{} {}", argument_type(kind), argument_name(kind)));
    add(of_matrices.arguments, fmt::format("{}.data()", argument_name(kind)));
  }
  if (function.takes_inputs) {
    add(of_matrices.parameters, returned ? "const Inputs& in = Inputs()" : "const Inputs& in");
    add(of_matrices.arguments, "in");
  }
  MemberText of_rows = of_matrices;
  bool turned = false;
  for (const ResultArray& result : function.results) {
    add(of_rows.parameters, fmt::format("S* {}", result.name));
    add(of_rows.arguments, std::string(result.name));
    if (returned) {
      of_matrices.before += fmt::format("{} {};\n", type, result.name);
    } else {
      add(of_matrices.parameters, fmt::format("{}& {}", result_type(result), result.name));
    }
    if (needs_copy(result)) {
      of_matrices.before +=
          fmt::format("::alembert::SizedMatrix<S, {}, 1> {}_rows;\n", entry_count(result), result.name);
      add(of_matrices.arguments, fmt::format("{}_rows.data()", result.name));
      of_matrices.after += fmt::format("::alembert::from_rows({0}_rows.data(), {0});\n", result.name);
    } else {
      add(of_matrices.arguments, fmt::format("{}.data()", result.name));
      if (!is_vector(result) && !result.symmetric) {
        of_matrices.after += fmt::format("{}.transposeInPlace();\n", result.name);
        turned = true;
      }
    }
  }
  if (returned) of_matrices.after += fmt::format("return {};\n", function.results[0].name);
  const auto member = [&](const std::string& summary, const MemberText& text) {
    const std::string start = fmt::format("static {} {}(", text.type, function.name);
    const std::string call = fmt::format("::{}::{}<S>(", name_space, function.name);
    return prefix_lines(summary, "/// ") + start + wrap_behind(start, text.parameters) + ") {\n" +
           prefix_lines(
               text.before + call + wrap_list(text.arguments, call.size() + 2, 4) + ");\n" + text.after,
               "  ") +
           "}\n";
  };
  std::string text = member(function_summary(function), of_matrices);
  // Who goes on by rows spares the turning.
  if (turned && !returned) text += "\n" + member("The same into arrays, row by row.\n", of_rows);
  return text;
}

}  // namespace alembert
