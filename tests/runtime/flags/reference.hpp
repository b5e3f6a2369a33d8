// What the programs of this folder need of a compiler that was told nothing: values that are right, and
// numbers that are not finite.
#pragma once

long double exact_sine(double x);
long double exact_cosine(double x);
bool is_a_nan(double x);
/// |found - exact| in units in the last place of a double near `exact`; infinite if `found` is a NaN.
double error_in_ulp(double found, long double exact);
double not_a_number();
double infinity();
