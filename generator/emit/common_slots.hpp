// Names and constants of a mechanism as text of C++, C, Python and JavaScript: what interfaces show of it besides functions.
#pragma once

#include <string>
#include <string_view>

#include "emit/text_template.hpp"
#include "mechanism/model.hpp"

namespace alembert {

/// `{{a, b}}`, or `{}` if empty: initialiser of a std::array.
std::string cpp_array(const std::vector<std::string>& items);

/// Slots that are the same in every template: name, namespace, sizes and lists for comments.
Slots common_slots(const Mechanism& mechanism, const std::string& full_namespace);

/// What the named indices of C++ are for; `frame_poses`: whether that function is written.
std::string index_doc(const Mechanism& mechanism, bool frame_poses);

/// Initialisers of the constants in C++ and in C, there with literals for double or float.
Slots cpp_constant_slots(const Mechanism& mechanism);
Slots c_constant_slots(const Mechanism& mechanism, std::string_view number, const std::string& null);

/// Tuples and lists of Python; arrays of JavaScript.
Slots python_constant_slots(const Mechanism& mechanism);
Slots javascript_constant_slots(const Mechanism& mechanism);

}  // namespace alembert
