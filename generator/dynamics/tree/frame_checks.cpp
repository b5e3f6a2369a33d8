// Transforms at the initial state (see the header).
#include "dynamics/tree/frame_checks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "dynamics/tree/motion.hpp"
#include "dynamics/tree/state_values.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/to_string.hpp"

namespace alembert {

void check_transforms(const Mechanism& mechanism, ExprGraph& graph) {
  const auto check = [&](const Transform& transform, const std::string& owner) {
    for (const Factor& factor : transform.factors) {
      Pose pose = identity_pose(graph);
      for (const Motion& motion : elementary_motions(Transform{{factor}}, mechanism, graph))
        pose = moved(std::move(pose), motion);
      std::vector<Expr> entries(pose.rotation.entries.begin(), pose.rotation.entries.end());
      entries.insert(entries.end(), pose.origin.entries.begin(), pose.origin.entries.end());
      const std::vector<double> values = evaluate(entries, state_values(mechanism, graph, 0));
      if (std::ranges::all_of(values, [](double v) { return std::isfinite(v); })) continue;
      const CurveFrame* curve = std::get_if<CurveFrame>(&factor.value);
      if (curve != nullptr && !curve->reference) {
        throw InputError(factor.where, "the Frenet frame of the curve of " + owner +
                                           " is undefined at the initial value of '" +
                                           to_string(curve->along) +
                                           "' (an inflection or a straight part); use `frame: {reference: "
                                           "[x, y, z]}`, or another initial value");
      }
      throw InputError(factor.where,
                       "the transform of " + owner +
                           " has no value at the initial state (a frame that is singular there, "
                           "or a division by zero); choose another initial value");
    }
  };
  for (const Body& body : mechanism.bodies) check(body.transform, "body '" + body.name + "'");
  for (const Frame& frame : mechanism.frames) check(frame.transform, "frame '" + frame.name + "'");
}

}  // namespace alembert
