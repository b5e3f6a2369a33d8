#include "import/sdf/sdf_spelling.hpp"

#include "import/common/known_elements.hpp"

namespace alembert {
namespace {

const KnownElement kSdfElements[] = {
    {"sdf", {"world", "model", "light", "actor", "include"}, {"version"}},
    {"world",
     {"audio", "wind", "include", "gravity", "magnetic_field", "atmosphere", "gui", "physics", "scene",
      "light", "frame", "model", "actor", "plugin", "road", "spherical_coordinates", "state", "population",
      "joint"},
     {"name"}},
    {"model",
     {"static", "self_collide", "allow_auto_disable", "enable_wind", "frame", "pose", "link", "joint",
      "plugin", "gripper", "include", "model"},
     {"name", "canonical_link", "placement_frame", "namespace"}},
    {"include", {"uri", "pose", "name", "static", "placement_frame", "plugin", "namespace"}, {"merge"}},
    {"frame", {"pose"}, {"name", "attached_to"}},
    {"link",
     {"gravity", "enable_wind", "self_collide", "kinematic", "must_be_base_link", "velocity_decay", "frame",
      "pose", "inertial", "collision", "visual", "sensor", "projector", "audio_sink", "audio_source",
      "battery", "light", "particle_emitter", "plugin"},
     {"name"}},
    {"inertial",
     {"mass", "density", "auto_inertia_params", "pose", "frame", "inertia", "fluid_added_mass"},
     {"auto"}},
    {"inertia", {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"}, {}},
    {"joint",
     {"parent", "child", "gearbox_ratio", "gearbox_reference_body", "thread_pitch", "screw_thread_pitch",
      "axis", "axis2", "physics", "frame", "pose", "sensor", "plugin"},
     {"name", "type"}},
    {"axis", {"xyz", "use_parent_model_frame", "dynamics", "limit", "initial_position", "mimic"}, {}},
    {"axis2", {"xyz", "use_parent_model_frame", "dynamics", "limit", "initial_position", "mimic"}, {}},
    {"xyz", {}, {"expressed_in"}},
    {"dynamics", {"damping", "friction", "spring_reference", "spring_stiffness"}, {}},
    {"limit", {"lower", "upper", "effort", "velocity", "stiffness", "dissipation"}, {}},
    {"mimic", {"multiplier", "offset", "reference"}, {"joint", "axis"}},
    {"pose", {}, {"relative_to", "degrees", "rotation_format", "frame"}},
    {"geometry",
     {"empty", "box", "capsule", "cone", "cylinder", "ellipsoid", "heightmap", "image", "mesh", "plane",
      "polyline", "sphere"},
     {}}};

}  // namespace

void check_sdf_spelling(const SdfFiles& files, pugi::xml_node element) {
  check_known(files.of(element), element, sdf_title(element), kSdfElements);
}

}  // namespace alembert
