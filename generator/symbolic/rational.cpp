#include "symbolic/rational.hpp"
