// Version of the runtime library. Generated headers compare the major number with the one that they were
// written for.
#pragma once

#define ALEMBERT_VERSION_MAJOR 0
#define ALEMBERT_VERSION_MINOR 1
#define ALEMBERT_VERSION_PATCH 0
