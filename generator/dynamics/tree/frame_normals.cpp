// Collects the frames on curves and surfaces (see the header).
#include "dynamics/tree/frame_normals.hpp"

#include <utility>

#include "support/overloaded.hpp"
#include "symbolic/to_string.hpp"

namespace alembert {

namespace {

void add(const CurveFrame& curve, FrameNormal entry, std::vector<FrameNormal>& out) {
  entry.factors = normal_factors(curve);
  entry.coordinates = {to_string(curve.along)};
  entry.frame =
      curve.reference ? "the frame of a curve with a reference direction" : "the Frenet frame of a curve";
  entry.cure = curve.reference
                   ? "the curve's tangent is along the reference direction there: choose another one"
                   : "the curve is straight or bends the other way there: use `frame: {reference: [x, "
                     "y, z]}` with a direction that is nowhere along its tangent";
  out.push_back(std::move(entry));
}

void add(const SurfaceFrame& surface, FrameNormal entry, std::vector<FrameNormal>& out) {
  entry.factors = normal_factors(surface);
  entry.coordinates = {to_string(surface.u), to_string(surface.v)};
  entry.frame = "the frame of a surface";
  entry.cure =
      "the surface has a pole or an edge there: write it down so that its poles are where the motion does "
      "not "
      "come";
  out.push_back(std::move(entry));
}

void add(const Transform& transform, const std::string& owner, std::vector<FrameNormal>& out) {
  for (const Factor& factor : transform.factors) {
    FrameNormal entry;
    entry.owner = owner;
    entry.where = factor.where;
    std::visit(Overloaded{[&](const CurveFrame& curve) { add(curve, std::move(entry), out); },
                          [&](const SurfaceFrame& surface) { add(surface, std::move(entry), out); },
                          [](const OneOf<Translation, AxisRotation, VectorRotation, QuaternionRotation,
                                         RigidMatrix> auto&) {}},
               factor.value);
  }
}

}  // namespace

std::vector<FrameNormal> frame_normals(const Mechanism& mechanism) {
  std::vector<FrameNormal> out;
  for (const Body& body : mechanism.bodies) add(body.transform, "body '" + body.name + "'", out);
  for (const Frame& frame : mechanism.frames) add(frame.transform, "frame '" + frame.name + "'", out);
  return out;
}

}  // namespace alembert
