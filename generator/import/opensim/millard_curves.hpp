// The curves of Millard's muscle as splines of the language: chains of quintic Bezier curves between points of given
// slope. Source: Millard, Uchida, Seth and Delp, Flexing Computational Muscle, Journal of Biomechanical Engineering 135
// (2013), 021005, and the default parameters of OpenSim.
#pragma once

#include <string>
#include <vector>

#include "import/opensim/osim_xml.hpp"

namespace alembert {

class MillardCurves {
 public:
  /// From <ActiveForceLengthCurve>, <FiberForceLengthCurve>, <TendonForceLengthCurve> and <ForceVelocityCurve> of a muscle, where
  /// it has them. `steep`: as OpenSim takes them for elastic tendons and fibres without damping, the active force never 0 and the
  /// force over speed nowhere flat.
  MillardCurves(const OsimXml& xml, pugi::xml_node muscle, bool steep);

  // Of the largest isometric force, as expressions; within kTolerance of the Bezier curves.
  std::string active(const std::string& length) const { return active_.text(length); }
  std::string passive(const std::string& length) const { return passive_.text(length); }
  std::string over_speed(const std::string& speed) const { return over_speed_.text(speed); }
  std::string tendon(const std::string& strain) const { return tendon_.text(strain); }
  /// The inverse of over_speed, where `steep`.
  std::string over_load(const std::string& load) const { return over_load_.text(load); }
  /// Else the speed v at which active over_speed(v) + damping v = load. Here over_speed is made of hyperbolas, for which that equation is
  /// quadratic. damping > 0.
  std::string speed(const std::string& load, const std::string& active, double damping) const;

  /// Fibres below this have no force, in optimal lengths.
  double shortest() const { return shortest_; }

  static constexpr double kTolerance = 0.004;

 private:
  /// Constant beyond both ends; before the first knot; or straight lines.
  enum class Ends { flat, grow, straight };
  /// A natural spline.
  struct Spline {
    std::string points;
    double first = 0, last = 0;
    Ends ends = Ends::flat;
    std::string text(const std::string& argument) const;
  };
  struct Corner {
    double x, y, slope;
    double curviness;  ///< of the piece to the next
  };
  static Spline spline(const std::vector<Corner>& corners, Ends ends, bool inverse = false);
  /// y + slope w/(1 + bend w) at w after x, up to the next one.
  struct Hyperbola {
    double x, y, slope, bend;
  };
  static std::vector<Hyperbola> hyperbolas(const std::vector<Corner>& corners);

  Spline active_, passive_, over_speed_, over_load_, tendon_;
  std::vector<Hyperbola> speeds_;  ///< the last one is where they end
  double shortest_ = 0;
};

}  // namespace alembert
