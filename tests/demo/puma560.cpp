// The generated dynamics of the PUMA 560 at one state: M, c, the torque for an acceleration, and that acceleration back from the torque.
#include <alembert/forward_dynamics.hpp>
#include <cstdio>
#include <iostream>
#include <puma560/puma560.hpp>

int main() { return 0; }
