#include "import/common/known_elements.hpp"

#include <algorithm>

namespace alembert {

void check_known(const XmlText& text, pugi::xml_node element, std::string_view what,
                 std::span<const KnownElement> table) {
  const auto known = std::ranges::find(table, std::string_view(element.name()), &KnownElement::name);
  if (known != table.end()) text.check_spelling(element, what, known->children, known->attributes);
}

}  // namespace alembert
