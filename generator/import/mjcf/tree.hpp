// <worldbody> in; bodies, joints and sites out, in MuJoCo's order.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "import/mjcf/mjcf_model.hpp"
#include "import/mjcf/model_file.hpp"

namespace alembert {

/// With those that are copied or attached, as often as they are.
inline constexpr std::size_t kMaximumMjcfElements = 200000;

using MjcfNames = std::map<std::string, std::size_t, std::less<>>;

class MjcfTree {
 public:
  MjcfTree(MjcfFiles& files, MjcfModel& model);
  void read();

  MjcfNames bodies, joints, sites, geoms, cameras;  ///< by name; geoms and cameras are places
  std::vector<MjcfPlace> geom_places, camera_places;
  /// What bodies come from, in the order in which MuJoCo has what acts on them: the model's own file first.
  const std::vector<MjcfPart>& parts() const { return parts_; }

 private:
  /// Where elements stand: in a part of a file, in a body, behind frames, with a class around them.
  struct Scope {
    MjcfPart part;
    std::size_t body = 0;
    RigidPose frame;
    std::string childclass;

    const MjcfText& text() const { return part.file->text; }
    const MjcfCompiler& compiler() const { return part.file->compiler; }
    MjcfElement element(pugi::xml_node node) const { return part.file->defaults.element(node, childclass); }
  };
  /// A body or frame of a file, and the class around it.
  struct Found {
    pugi::xml_node element;
    std::string childclass;
  };
  /// Of a file, by name.
  struct Attachables {
    std::map<std::string, Found, std::less<>> bodies, frames;
  };
  void read_worlds(Scope scope);
  void read_attached(pugi::xml_node element, const Scope& scope);
  const Attachables& attachables(const MjcfFile& file);
  static void find(const MjcfText& text, pugi::xml_node parent, const std::string& childclass,
                   Attachables& to);
  void read_children(pugi::xml_node parent, const Scope& scope);
  void read_frame(pugi::xml_node element, Scope scope);
  void read_replicate(pugi::xml_node element, Scope scope);
  void read_body(pugi::xml_node element, const Scope& scope);
  /// Where the body is in the world, of a file with global coordinates.
  RigidPose global_pose(const MjcfElement& body, const Scope& inside) const;
  void read_inertial_of(pugi::xml_node element, const Scope& scope);
  void finish_body(std::size_t index, const MjcfElement& element, const Scope& scope);
  void read_joint(pugi::xml_node element, const Scope& scope);
  void read_free_joint(pugi::xml_node element, const Scope& scope);
  static void read_ranges(const MjcfElement& of, const MjcfCompiler& compiler, MjcfJoint& joint, bool single);
  void add_joint(pugi::xml_node element, const Scope& scope, MjcfJoint joint);
  void sort_joints();
  void read_place(pugi::xml_node element, const Scope& scope, std::vector<MjcfPlace>& places,
                  MjcfNames& names);
  void read_geom(pugi::xml_node element, const Scope& scope);
  void set_total_mass();
  static std::string add_name(pugi::xml_node element, const Scope& scope, MjcfNames& names,
                              std::size_t index);

  MjcfFiles& files_;
  MjcfModel& model_;
  std::vector<MjcfPart> parts_;
  std::map<const MjcfFile*, Attachables> attachables_;
  std::vector<pugi::xml_node> open_;          ///< <attach> elements that are being read
  std::vector<std::vector<MjcfGeom>> geoms_;  ///< by body
  struct Inertial {
    pugi::xml_node element;
    const MjcfText* text;
    RigidPose frame;
  };
  std::map<std::size_t, Inertial> inertials_;  ///< likewise
  std::size_t depth_ = 0;                      ///< of the elements that are being read
  std::size_t count_ = 0;                      ///< of elements, copies too
};

}  // namespace alembert
