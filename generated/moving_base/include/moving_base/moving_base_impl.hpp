// moving_base: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "moving_base". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The definitions, for scalar types that they were not compiled for: derivatives, intervals, SIMD packs.
#pragma once

#include "moving_base_part1.hpp"
