// XML by pugixml, which parses in place: where a name or value stands in the buffer is its place in the text.
#include "urdf/xml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <set>

#include "mechanism/document.hpp"

namespace alembert {
namespace {

constexpr std::string_view kXacro = "xacro:";

std::string slip(std::string_view name, std::initializer_list<std::string_view> known) {
  const std::vector<std::string> names(known.begin(), known.end());
  if (std::ranges::find(names, name) != names.end()) return {};
  return nearest_name(name, names);
}

}  // namespace

XmlText::XmlText(std::shared_ptr<const SourceText> source)
    : source_(std::move(source)), line_starts_(line_starts(source_->text)), buffer_(source_->text) {
  check_characters(source_);
  const pugi::xml_parse_result result =
      document_.load_buffer_inplace(buffer_.data(), buffer_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result)
    throw InputError(place(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0))),
                     fmt::format("not well-formed XML: {}", result.description()));
  const pugi::xml_node first = root();
  if (!first) throw InputError({source_, 1, 1}, "no XML element; expected a <robot>");
  for (pugi::xml_node other = first.next_sibling(); other; other = other.next_sibling())
    if (other.type() == pugi::node_element)
      throw InputError(where(other), "a second root element; a file holds one robot");
  refuse_duplicate_attributes();
}

void XmlText::refuse_duplicate_attributes() const {
  pugi::xml_node at = root();
  while (at) {
    std::set<std::string_view> names;
    for (const pugi::xml_attribute attribute : at.attributes())
      if (!names.insert(attribute.name()).second)
        throw InputError(where(attribute), fmt::format("a second attribute '{}' of <{}>",
                                                       printable(attribute.name()), printable(at.name())));
    // The next node of the tree: no recursion, since anyone may nest elements.
    pugi::xml_node next = at.first_child();
    for (; !next && at; at = at.parent()) {
      if (at == root()) break;
      next = at.next_sibling();
    }
    at = next;
  }
}

SourceLocation XmlText::place(std::size_t offset) const {
  return place_in(source_, line_starts_, std::min(offset, source_->text.size()));
}

/// Of a string that pugixml left in the buffer, `before` characters ahead of it.
SourceLocation XmlText::place_of(const char* in_buffer, std::size_t before) const {
  const char* const begin = buffer_.data();
  const std::less<> less;
  if (less(in_buffer, begin + before) || !less(in_buffer, begin + buffer_.size())) return {source_, 1, 1};
  return place(static_cast<std::size_t>(in_buffer - begin) - before);
}

SourceLocation XmlText::where(pugi::xml_node element) const {
  return place_of(element.name(), 1);
}

SourceLocation XmlText::where(pugi::xml_attribute attribute) const {
  return place_of(attribute.value()[0] == '\0' ? attribute.name() : attribute.value(), 0);
}

void XmlText::check_spelling(pugi::xml_node element, std::string_view what,
                             std::initializer_list<std::string_view> children,
                             std::initializer_list<std::string_view> attributes) const {
  for (const pugi::xml_node child : element.children()) {
    if (child.type() != pugi::node_element) continue;
    const std::string_view name = child.name();
    if (name.starts_with(kXacro))
      throw InputError(where(child), fmt::format("<{}> is of xacro, not of URDF", printable(name)),
                       "expand it first: xacro FILE > robot.urdf");
    if (const std::string near = slip(name, children); !near.empty())
      throw InputError(where(child), fmt::format("unknown element <{}> in {} (did you mean <{}>?)",
                                                 printable(name), what, near));
  }
  for (const pugi::xml_attribute attribute : element.attributes()) {
    if (const std::string near = slip(attribute.name(), attributes); !near.empty())
      throw InputError(where(attribute), fmt::format("unknown attribute '{}' of {} (did you mean '{}'?)",
                                                     printable(attribute.name()), what, near));
    if (std::string_view(attribute.value()).find("${") != std::string_view::npos)
      throw InputError(where(attribute),
                       fmt::format("'{}' is of xacro, not of URDF", printable(attribute.value())),
                       "expand it first: xacro FILE > robot.urdf");
  }
}

pugi::xml_node XmlText::find(pugi::xml_node element, const char* child, std::string_view what) const {
  const pugi::xml_node found = element.child(child);
  if (found && found.next_sibling(child))
    throw InputError(where(found.next_sibling(child)), fmt::format("a second <{}> in {}", child, what));
  return found;
}

pugi::xml_node XmlText::require(pugi::xml_node element, const char* child, std::string_view what) const {
  const pugi::xml_node found = find(element, child, what);
  if (!found) throw InputError(where(element), fmt::format("no <{}> in {}", child, what));
  return found;
}

pugi::xml_attribute XmlText::require_attribute(pugi::xml_node element, const char* name,
                                               std::string_view what) const {
  const pugi::xml_attribute found = element.attribute(name);
  if (!found) throw InputError(where(element), fmt::format("no attribute '{}' of {}", name, what));
  if (found.value()[0] == '\0')
    throw InputError(where(found), fmt::format("the attribute '{}' of {} is empty", name, what));
  return found;
}

void XmlText::read_numbers(pugi::xml_attribute attribute, std::string_view what, double* out,
                           std::size_t count) const {
  const std::string_view text = attribute.value();
  const auto fail = [&] {
    return InputError(
        where(attribute),
        fmt::format("expected {} as {}, found '{}'",
                    count == 1 ? "a number" : fmt::format("{} numbers", count), what, printable(text)));
  };
  std::size_t found = 0, i = 0;
  for (;;) {
    while (i < text.size() && is_space(text[i])) ++i;
    if (i == text.size()) break;
    std::size_t end = i;
    while (end < text.size() && !is_space(text[end])) ++end;
    const std::size_t begin = text[i] == '+' && end > i + 1 && text[i + 1] != '-' ? i + 1 : i;
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, value);
    if (found == count || error != std::errc() || stop != text.data() + end || !std::isfinite(value))
      throw fail();
    out[found++] = value;
    i = end;
  }
  if (found != count) throw fail();
}

}  // namespace alembert
