// Surfaces that paths of OpenSim wrap over. In: a force along a path, and the path's points. Out: obstacles between them.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "import/opensim/osim_description.hpp"

namespace alembert {

/// A point of a path as the file has it.
struct OsimPathPoint {
  pugi::xml_node element;
  std::size_t on = 0;                             ///< frame
  std::optional<std::array<double, 3>> location;  ///< in the frame, of points that do not move in it
  bool conditional = false;
};

/// Spheres, and cylinders, of which a quadrant may be the only side. Each stands between all points in its range, but where
/// the stretch never touches it. What else there is (ellipsoids, tori, spheres with a quadrant), what is beside points that
/// have conditions, and a second one on the same stretch are left out with a warning.
class OsimWraps {
 public:
  /// \param force   element with a <GeometryPath>
  OsimWraps(OsimDescription& out, pugi::xml_node force, std::span<const OsimPathPoint> points);

  /// What the path leads around between this point and the next one, or null.
  YamlNode* after(std::size_t point) const;

 private:
  struct Surface {
    pugi::xml_node element;
    std::size_t body = 0;
    bool cylinder = false;
    double radius = 0, length = 0;  ///< endless: 0
    OsimOffset offset;
    std::optional<std::array<double, 3>> side;  ///< a point outside, in the surface's axes
  };

  std::optional<Surface> find(const std::string& name) const;
  std::optional<Surface> read(pugi::xml_node element, std::size_t body) const;
  bool is_clear(const Surface& surface, std::size_t point) const;
  /// False where it cannot stand on a stretch that it may touch.
  bool add(pugi::xml_node wrap, const Surface& surface);
  YamlNode& node_of(const Surface& surface) const;

  OsimDescription& out_;
  std::span<const OsimPathPoint> points_;
  std::map<std::size_t, YamlNode*> nodes_;  // by the point before
};

}  // namespace alembert
