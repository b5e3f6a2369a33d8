// Tables of the elements of a format: what may stand in each.
#pragma once

#include <initializer_list>
#include <span>
#include <string_view>

#include "import/common/xml_text.hpp"

namespace alembert {

struct KnownElement {
  std::string_view name;
  std::initializer_list<std::string_view> children, attributes;
};

/// Warns of what nobody knows in an element, and throws InputError at what is nearly a name that makes the equations.
/// Elements that are not in the table are passed over.
/// \param what  the element in messages
void check_known(const XmlText& text, pugi::xml_node element, std::string_view what,
                 std::span<const KnownElement> table);

}  // namespace alembert
