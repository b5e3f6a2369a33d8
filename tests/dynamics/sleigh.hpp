// The description of a sleigh in the plane, free of constraints: tests add theirs.
#pragma once

namespace alembert::test {

inline constexpr const char* kSleigh = R"(alembert: 1
name: sleigh
coordinates: [x, y, th]
bodies:
  - name: sleigh
    transform: [{translate: [x, y, 0]}, {rotate: {axis: z, angle: th}}]
    mass: 1
    com: [0.3, 0, 0]
    inertia: {xx: 1, yy: 1, zz: 1}
)";

}  // namespace alembert::test
