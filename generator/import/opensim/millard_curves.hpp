// The curves of Millard's muscle as splines of the language: chains of quintic Bezier curves between points of given
// slope. Source: Millard, Uchida, Seth and Delp, Flexing Computational Muscle, Journal of Biomechanical Engineering 135
// (2013), 021005, and the default parameters of OpenSim.
#pragma once

#include <string>

#include "import/opensim/osim_xml.hpp"

namespace alembert {

class MillardCurves {
 public:
  /// From <ActiveForceLengthCurve>, <FiberForceLengthCurve> and <ForceVelocityCurve> of a muscle, where it has them.
  MillardCurves(const OsimXml& xml, pugi::xml_node muscle);

  // Of the largest isometric force, as expressions; within kTolerance of the Bezier curves.
  std::string active(const std::string& length) const { return active_.text(length); }
  std::string passive(const std::string& length) const { return passive_.text(length); }
  std::string over_speed(const std::string& speed) const { return over_speed_.text(speed); }

  /// Fibres below this have no force, in optimal lengths.
  double shortest() const { return shortest_; }

  static constexpr double kTolerance = 0.004;

 private:
  /// A natural spline; constant before its first knot, and after the last if `flat`.
  struct Spline {
    std::string points;
    double first = 0, last = 0;
    bool flat = false;
    std::string text(const std::string& argument) const;
  };
  struct Corner {
    double x, y, slope;
    double curviness;  ///< of the piece to the next
  };
  static Spline spline(const std::vector<Corner>& corners, bool flat);

  Spline active_, passive_, over_speed_;
  double shortest_ = 0;
};

}  // namespace alembert
