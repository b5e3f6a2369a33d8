#include "symbolic/expr.hpp"
