// Where frames on curves and surfaces may be singular. In: a mechanism. Out: for each such frame the vectors
// that its normal is made of, and what to tell who comes to a place where it has none.
#pragma once

#include <string>
#include <vector>

#include "dynamics/tree/contact_frames.hpp"
#include "mechanism/model.hpp"

namespace alembert {

/// One curve or surface frame, also inside mates and inverses.
struct FrameNormal {
  NormalFactors factors;                 ///< the frame is singular where their cross product is zero
  std::string owner;                     ///< as in messages: body 'bead'
  std::string frame;                     ///< likewise: the Frenet frame of a curve
  std::vector<std::string> coordinates;  ///< those that move along the curve or surface
  std::string cure;
  SourceLocation where;
};

/// All of them, bodies before frames, in the order of the description.
std::vector<FrameNormal> frame_normals(const Mechanism& mechanism);

}  // namespace alembert
