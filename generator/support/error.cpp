#include "support/error.hpp"
