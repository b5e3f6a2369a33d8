// <worldbody> in; bodies, joints and sites out, in MuJoCo's order.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "import/mjcf/mjcf_model.hpp"

namespace alembert {

using MjcfNames = std::map<std::string, std::size_t, std::less<>>;

class MjcfTree {
 public:
  MjcfTree(const MjcfText& text, const MjcfDefaults& defaults, const MjcfCompiler& compiler,
           MjcfModel& model);
  void read();

  MjcfNames bodies, joints, sites, geoms, cameras;  ///< by name; geoms and cameras are places
  std::vector<MjcfPlace> geom_places, camera_places;

 private:
  /// Where elements stand: in a body, behind frames, with a class around them and a suffix of copies.
  struct Scope {
    std::size_t body = 0;
    RigidPose frame;
    std::string childclass, suffix;
  };
  void read_children(pugi::xml_node parent, const Scope& scope);
  void read_frame(pugi::xml_node element, Scope scope);
  void read_replicate(pugi::xml_node element, Scope scope);
  void read_body(pugi::xml_node element, const Scope& scope);
  void read_inertial_of(pugi::xml_node element, const Scope& scope);
  void finish_body(std::size_t index, const MjcfElement& element);
  void read_joint(pugi::xml_node element, const Scope& scope);
  void read_free_joint(pugi::xml_node element, const Scope& scope);
  void read_ranges(const MjcfElement& of, MjcfJoint& joint, bool single);
  void add_joint(pugi::xml_node element, const Scope& scope, MjcfJoint joint);
  void sort_joints();
  void read_place(pugi::xml_node element, const Scope& scope, std::vector<MjcfPlace>& places,
                  MjcfNames& names);
  void read_geom(pugi::xml_node element, const Scope& scope);
  void set_total_mass();
  std::string add_name(pugi::xml_node element, const Scope& scope, MjcfNames& names, std::size_t index) const;

  const MjcfText& text_;
  const MjcfDefaults& defaults_;
  const MjcfCompiler& compiler_;
  MjcfAssets assets_;
  MjcfModel& model_;
  std::vector<std::vector<MjcfGeom>> geoms_;  ///< by body
  struct Inertial {
    pugi::xml_node element;
    RigidPose frame;
  };
  std::map<std::size_t, Inertial> inertials_;  ///< likewise
  std::size_t count_ = 0;                      ///< of elements, copies too
};

}  // namespace alembert
