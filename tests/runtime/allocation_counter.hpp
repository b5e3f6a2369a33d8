// Counts calls of every replaceable operator new and of malloc through Eigen in this program.
#pragma once

#include <cstddef>

/// Number of allocations since the program started.
std::size_t allocation_count();
