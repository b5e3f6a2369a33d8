#include "import/opensim/osim_spelling.hpp"

#include <algorithm>

namespace alembert {
namespace {

using PropertyNames = std::initializer_list<std::string_view>;

const PropertyNames kModelProperties = {"Ground",
                                        "gravity",
                                        "credits",
                                        "publications",
                                        "length_units",
                                        "force_units",
                                        "assembly_accuracy",
                                        "components",
                                        "defaults",
                                        "ModelVisualPreferences",
                                        "ModelVisualizer",
                                        "BodySet",
                                        "JointSet",
                                        "ConstraintSet",
                                        "ForceSet",
                                        "MarkerSet",
                                        "ControllerSet",
                                        "ContactGeometrySet",
                                        "ProbeSet",
                                        "ComponentSet",
                                        "FrameSet",
                                        "MiscModelComponentSet",
                                        "validationLog",
                                        "frames",
                                        "FrameGeometry",
                                        "attached_geometry",
                                        "WrapObjectSet",
                                        "ground"};
const PropertyNames kBodyProperties = {
    "mass",          "mass_center",    "inertia",           "inertia_xx",    "inertia_yy",    "inertia_zz",
    "inertia_xy",    "inertia_xz",     "inertia_yz",        "Joint",         "components",    "frames",
    "FrameGeometry", "frame_geometry", "attached_geometry", "WrapObjectSet", "VisibleObject", "Appearance"};
const PropertyNames kJointProperties = {"socket_parent_frame",
                                        "socket_child_frame",
                                        "socket_parent_body",
                                        "socket_child_body",
                                        "connectors",
                                        "parent_body",
                                        "child_body",
                                        "location_in_parent",
                                        "orientation_in_parent",
                                        "location",
                                        "orientation",
                                        "location_in_child",
                                        "orientation_in_child",
                                        "coordinates",
                                        "CoordinateSet",
                                        "frames",
                                        "components",
                                        "reverse",
                                        "SpatialTransform",
                                        "radii_x_y_z",
                                        "thoracic_ellipsoid_radii_x_y_z",
                                        "scapula_winging_axis_origin",
                                        "scapula_winging_axis_direction",
                                        "is_free_to_satisfy_constraints",
                                        "EllipsoidJoint"};
const PropertyNames kCoordinateProperties = {"motion_type",
                                             "default_value",
                                             "default_speed_value",
                                             "initial_value",
                                             "range",
                                             "clamped",
                                             "locked",
                                             "prescribed",
                                             "prescribed_function",
                                             "is_free_to_satisfy_constraints"};
const PropertyNames kAxisProperties = {"coordinates", "coordinate", "axis", "function"};
/// Of all forces that are taken; and of muscles what has no part in the equations.
const PropertyNames kForceProperties = {"appliesForce",
                                        "isDisabled",
                                        "min_control",
                                        "max_control",
                                        "optimal_force",
                                        "coordinate",
                                        "socket_coordinate",
                                        "stiffness",
                                        "rest_length",
                                        "viscosity",
                                        "upper_limit",
                                        "upper_stiffness",
                                        "lower_limit",
                                        "lower_stiffness",
                                        "damping",
                                        "transition",
                                        "compute_dissipation_energy",
                                        "socket_body1",
                                        "socket_body2",
                                        "body1",
                                        "body2",
                                        "point1",
                                        "point2",
                                        "socket_frame1",
                                        "socket_frame2",
                                        "body_1",
                                        "body_2",
                                        "frames",
                                        "components",
                                        "location_body_1",
                                        "location_body_2",
                                        "orientation_body_1",
                                        "orientation_body_2",
                                        "rotational_stiffness",
                                        "translational_stiffness",
                                        "rotational_damping",
                                        "translational_damping",
                                        "GeometryPath",
                                        "bodyA",
                                        "bodyB",
                                        "torque_is_global",
                                        "axis",
                                        "body",
                                        "point",
                                        "point_is_global",
                                        "direction",
                                        "force_is_global",
                                        "resting_length",
                                        "dissipation",
                                        "pcsa_force",
                                        "force_length_curve",
                                        "slack_length",
                                        "linear_stiffness",
                                        "transition_strain",
                                        "damping_coefficient",
                                        "max_isometric_force",
                                        "optimal_fiber_length",
                                        "tendon_slack_length",
                                        "pennation_angle_at_optimal",
                                        "pennation_angle",
                                        "max_contraction_velocity",
                                        "ignore_tendon_compliance",
                                        "ignore_activation_dynamics",
                                        "FmaxTendonStrain",
                                        "FmaxMuscleStrain",
                                        "KshapeActive",
                                        "KshapePassive",
                                        "Af",
                                        "Flen",
                                        "fv_linear_extrap_threshold",
                                        "maximum_pennation_angle",
                                        "activation_time_constant",
                                        "deactivation_time_constant",
                                        "minimum_activation",
                                        "default_activation",
                                        "default_fiber_length",
                                        "fiber_damping",
                                        "ActiveForceLengthCurve",
                                        "ForceVelocityCurve",
                                        "ForceVelocityInverseCurve",
                                        "FiberForceLengthCurve",
                                        "TendonForceLengthCurve",
                                        "Appearance",
                                        "color",
                                        "opacity",
                                        "frame_geometry",
                                        "use_fiber_damping",
                                        "HuntCrossleyForce::ContactParametersSet",
                                        "transition_velocity",
                                        "socket_sphere",
                                        "socket_half_space",
                                        "static_friction",
                                        "dynamic_friction",
                                        "viscous_friction",
                                        "constant_contact_force",
                                        "derivative_smoothing",
                                        "hertz_smoothing",
                                        "hunt_crossley_smoothing",
                                        "force_visualization_radius",
                                        "force_visualization_scale_factor",
                                        "activation_dynamics_smoothing",
                                        "default_normalized_tendon_force",
                                        "active_force_width_scale",
                                        "passive_fiber_strain_at_one_norm_force",
                                        "tendon_strain_at_one_norm_force",
                                        "ignore_passive_fiber_force",
                                        "tendon_compliance_dynamics_mode",
                                        "display_preference",
                                        "MuscleFirstOrderActivationDynamicModel",
                                        "MuscleFixedWidthPennationModel"};

}  // namespace

void check_osim_spelling(const XmlText& xml, const OsimModel& model,
                         const std::vector<pugi::xml_node>& forces) {
  const auto check = [&](pugi::xml_node element, PropertyNames known) {
    // Anything may be the function of an axis, and any function names itself.
    if (element) xml.check_spelling(element, OsimXml::title(element), known, {"name", "file", "Version"});
  };
  check(model.element, kModelProperties);
  for (const OsimBody& body : model.bodies) check(body.element, kBodyProperties);
  for (const OsimJoint& joint : model.joints) {
    check(joint.element, kJointProperties);
    for (const pugi::xml_node coordinate : joint.element.child("coordinates").children("Coordinate"))
      check(coordinate, kCoordinateProperties);
    for (const pugi::xml_node coordinate :
         joint.element.child("CoordinateSet").child("objects").children("Coordinate"))
      check(coordinate, kCoordinateProperties);
    for (const pugi::xml_node axis : joint.element.child("SpatialTransform").children("TransformAxis"))
      for (const pugi::xml_node child : OsimXml::elements(axis))
        if (child.attribute("name").value() != std::string_view("function") &&
            std::ranges::find(kAxisProperties, std::string_view(child.name())) == kAxisProperties.end())
          xml.warn({xml.where(child),
                    "unknown element <" + printable(child.name()) + "> in a TransformAxis; it is passed over",
                    {},
                    std::string(child.name())});
  }
  for (const pugi::xml_node force : forces) check(force, kForceProperties);
}

}  // namespace alembert
