#include "import/mjcf/spelling.hpp"

#include <fmt/format.h>

#include "import/common/known_elements.hpp"

namespace alembert {

const std::initializer_list<std::string_view> kTendonAttributes = {"name",
                                                                   "class",
                                                                   "group",
                                                                   "limited",
                                                                   "actuatorfrclimited",
                                                                   "range",
                                                                   "actuatorfrcrange",
                                                                   "solreflimit",
                                                                   "solimplimit",
                                                                   "solreffriction",
                                                                   "solimpfriction",
                                                                   "frictionloss",
                                                                   "springlength",
                                                                   "width",
                                                                   "material",
                                                                   "margin",
                                                                   "stiffness",
                                                                   "damping",
                                                                   "armature",
                                                                   "rgba",
                                                                   "user"};

namespace {

using Attributes = std::initializer_list<std::string_view>;

const Attributes kOfJoint = {"name",
                             "class",
                             "type",
                             "group",
                             "pos",
                             "axis",
                             "springdamper",
                             "limited",
                             "actuatorfrclimited",
                             "solreflimit",
                             "solimplimit",
                             "solreffriction",
                             "solimpfriction",
                             "stiffness",
                             "range",
                             "actuatorfrcrange",
                             "actuatorgravcomp",
                             "margin",
                             "ref",
                             "springref",
                             "armature",
                             "damping",
                             "frictionloss",
                             "user"};
const Attributes kOfGeom = {
    "name",     "class",    "type", "contype",    "conaffinity",  "condim", "group",  "priority", "size",
    "material", "friction", "mass", "density",    "shellinertia", "solmix", "solref", "solimp",   "margin",
    "gap",      "fromto",   "pos",  "quat",       "axisangle",    "xyaxes", "zaxis",  "euler",    "hfield",
    "mesh",     "fitscale", "rgba", "fluidshape", "fluidcoef",    "user"};
const Attributes kOfSite = {"name",   "class",     "type",   "group", "pos",   "quat", "material", "size",
                            "fromto", "axisangle", "xyaxes", "zaxis", "euler", "rgba", "user"};
const Attributes kOfActuator = {
    "name",         "class",        "group",         "nsample",    "interp",     "delay",       "ctrllimited",
    "forcelimited", "actlimited",   "ctrlrange",     "forcerange", "actrange",   "lengthrange", "gear",
    "cranklength",  "joint",        "jointinparent", "tendon",     "slidersite", "cranksite",   "site",
    "refsite",      "body",         "user",          "actdim",     "dyntype",    "gaintype",    "biastype",
    "dynprm",       "gainprm",      "biasprm",       "actearly",   "kp",         "kv",          "dampratio",
    "timeconst",    "inheritrange", "area",          "diameter",   "bias",       "armature",    "damping"};
const Attributes kOfOption = {"timestep",
                              "apirate",
                              "impratio",
                              "tolerance",
                              "ls_tolerance",
                              "noslip_tolerance",
                              "ccd_tolerance",
                              "mpr_tolerance",
                              "sleep_tolerance",
                              "gravity",
                              "wind",
                              "magnetic",
                              "density",
                              "viscosity",
                              "o_margin",
                              "o_solref",
                              "o_solimp",
                              "o_friction",
                              "integrator",
                              "cone",
                              "jacobian",
                              "solver",
                              "iterations",
                              "ls_iterations",
                              "noslip_iterations",
                              "mpr_iterations",
                              "ccd_iterations",
                              "sdf_iterations",
                              "sdf_initpoints",
                              "actuatorgroupdisable",
                              "collision"};

const Attributes kOfMesh = {"name",    "class",       "content_type",   "file",     "vertex",
                            "normal",  "texcoord",    "face",           "refpos",   "refquat",
                            "scale",   "builtin",     "params",         "material", "smoothnormal",
                            "inertia", "maxhullvert", "octree_maxdepth"};
const Attributes kOfEquality = {"class", "active", "solref", "solimp"};

const Attributes kOthers = {"plugin", "flag", "include"};  // within any of them

const KnownElement kElements[] = {{"joint", kOthers, kOfJoint},
                                  {"geom", kOthers, kOfGeom},
                                  {"site", kOthers, kOfSite},
                                  {"general", kOthers, kOfActuator},
                                  {"motor", kOthers, kOfActuator},
                                  {"position", kOthers, kOfActuator},
                                  {"velocity", kOthers, kOfActuator},
                                  {"intvelocity", kOthers, kOfActuator},
                                  {"damper", kOthers, kOfActuator},
                                  {"cylinder", kOthers, kOfActuator},
                                  {"option", kOthers, kOfOption},
                                  {"mesh", kOthers, kOfMesh},
                                  {"tendon", kOthers, kTendonAttributes},
                                  {"equality", kOthers, kOfEquality}};

}  // namespace

void check_attributes(const MjcfText& text, pugi::xml_node element) {
  const char* name = element.attribute("name").value();
  check_known(text.of(element), element,
              *name == '\0' ? fmt::format("a {}", element.name())
                            : fmt::format("{} '{}'", element.name(), printable(name)),
              kElements);
}

}  // namespace alembert
