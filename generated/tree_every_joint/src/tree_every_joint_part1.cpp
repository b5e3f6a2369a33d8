// tree_every_joint: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "tree_every_joint". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Part 1 of 1, compiled for double and float.
#include <tree_every_joint/tree_every_joint_part1.hpp>

namespace alembert::mechanisms::tree_every_joint {

template void inverse_dynamics<double>(const double*, const double*, const double*, const Inputs<double>&, double*);
template void inverse_dynamics<float>(const float*, const float*, const float*, const Inputs<float>&, float*);
template void mass_matrix<double>(const double*, const Inputs<double>&, double*);
template void mass_matrix<float>(const float*, const Inputs<float>&, float*);
template void bias<double>(const double*, const double*, const Inputs<double>&, double*);
template void bias<float>(const float*, const float*, const Inputs<float>&, float*);
template void mass_matrix_and_bias<double>(const double*, const double*, const Inputs<double>&, double*, double*);
template void mass_matrix_and_bias<float>(const float*, const float*, const Inputs<float>&, float*, float*);
template void coordinate_rates<double>(const double*, const double*, double*);
template void coordinate_rates<float>(const float*, const float*, float*);
template void energy<double>(const double*, const double*, const Inputs<double>&, double*);
template void energy<float>(const float*, const float*, const Inputs<float>&, float*);
template void body_poses<double>(const double*, const Inputs<double>&, double*);
template void body_poses<float>(const float*, const Inputs<float>&, float*);
template void frame_poses<double>(const double*, const Inputs<double>&, double*);
template void frame_poses<float>(const float*, const Inputs<float>&, float*);
template void frame_jacobians<double>(const double*, const Inputs<double>&, double*);
template void frame_jacobians<float>(const float*, const Inputs<float>&, float*);

}  // namespace alembert::mechanisms::tree_every_joint
