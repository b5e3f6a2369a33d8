#include "import/opensim/osim_path_forces.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "import/common/snapped_angle.hpp"
#include "import/opensim/osim_forces.hpp"
#include "import/opensim/osim_paths.hpp"

namespace alembert {
namespace {

/// Of a Ligament that says none, over its length in resting lengths.
constexpr const char* kLigamentCurve =
    "[-5, 0.998, 0.999, 1, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.601, 1.602, 5]; "
    "[0, 0, 0, 0, 0.035, 0.12, 0.26, 0.55, 1.17, 2, 2, 2, 2]";

/// A force of a tension along a path.
bool put_on_path(OsimDescription& out, pugi::xml_node element, const std::string& tension) {
  const SourceLocation at = out.xml.where(element);
  YamlNode& force = out.add_force(OsimXml::name_of(element), at);
  if (!add_osim_path(out, force, element)) {
    out.sections["forces"]->items.pop_back();
    return false;
  }
  out.put(force, "tension", tension, at);
  return true;
}

}  // namespace

bool add_path_actuator(OsimDescription& out, pugi::xml_node element) {
  return put_on_path(out, element,
                     times_text(out.xml.number(element, "optimal_force", 1), osim_control(out, element)));
}

bool add_path_spring(OsimDescription& out, pugi::xml_node element) {
  const double rest = out.xml.number(element, "resting_length", 0),
               k = out.xml.number(element, "stiffness", 0),
               dissipation = out.xml.number(element, "dissipation", 0);
  return put_on_path(out, element,
                     fmt::format("{}*max(0, {})*(1 + {}*rate)", number_text(k),
                                 sum_text({"length", number_text(-rest)}), number_text(dissipation)));
}

/// A curve of the length in resting lengths, and nothing below.
bool add_ligament(OsimDescription& out, pugi::xml_node element) {
  const double rest = out.xml.positive_number(element, "resting_length", 0),
               force = out.xml.number(element, "pcsa_force", 0);
  const std::string length = fmt::format("(length/{})", number_text(rest));
  const pugi::xml_node curve = find_osim_function(element, "force_length_curve");
  const std::string tension =
      curve ? scaled_text(force, read_osim_function(out.xml, curve, {length}))
            : times_text(force, fmt::format("simm_spline({}; {})", length, kLigamentCurve));
  return put_on_path(out, element, fmt::format("select(length - {}, {}, 0)", number_text(rest), tension));
}

/// Quadratic in the strain up to that of the transition, then straight; damped where it is stretched and lengthens, which
/// sets in over a strain of 0.01 by 10 s^3 - 15 s^4 + 6 s^5. Source: Blankevoort and Huiskes, Ligament-Bone Interaction
/// in a Three-Dimensional Model of the Knee, Journal of Biomechanical Engineering 113 (1991), 263-269.
bool add_blankevoort_ligament(OsimDescription& out, pugi::xml_node element) {
  const double slack = out.xml.positive_number(element, "slack_length", 0),
               stiffness = out.xml.number(element, "linear_stiffness", 1),
               transition = out.xml.number(element, "transition_strain", 0.06),
               damping = out.xml.number(element, "damping_coefficient", 0.003);
  const std::string strain = fmt::format("(length/{} - 1)", number_text(slack));
  std::vector<std::string> terms;
  if (transition > 0)
    terms.push_back(fmt::format("{}*clamp({}, 0, {})^2", number_text(stiffness / (2 * transition)), strain,
                                number_text(transition)));
  terms.push_back(fmt::format("{}*max(0, length/{} - {})", number_text(stiffness), number_text(slack),
                              number_text(1 + std::max(0.0, transition))));
  if (damping > 0) {
    const std::string onset = fmt::format("clamp(100*{}, 0, 1)", strain);
    terms.push_back(
        fmt::format("{0}*max(0, rate)*{1}^3*(10 - 15*{1} + 6*{1}^2)", number_text(damping / slack), onset));
  }
  return put_on_path(out, element, sum_text(terms));
}

}  // namespace alembert
