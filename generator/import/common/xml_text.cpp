// XML by pugixml, which parses in place: where a name or value stands in the buffer is its place in the text.
#include "import/common/xml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>

#include "mechanism/document.hpp"

namespace alembert {
namespace {

bool is_among(std::string_view name, std::initializer_list<std::string_view> known) {
  return std::ranges::find(known, name) != known.end();
}

std::string nearest(std::string_view name, std::initializer_list<std::string_view> known) {
  const std::vector<std::string> names(known.begin(), known.end());
  return nearest_name(name, names);
}

/// A message without what it quotes: alike for warnings that say the same of different names.
std::string without_quotes(std::string_view message) {
  std::string out;
  bool inside = false;
  for (const char c : message) {
    if (c == '\'') inside = !inside;
    if (!inside) out += c;
  }
  return out;
}

}  // namespace

std::string text_of_element(pugi::xml_node element) {
  constexpr std::string_view kBlank = " \t\r\n";
  std::string out;
  for (const pugi::xml_node part : element.children())
    if (part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata) out += part.value();
  const std::size_t first = out.find_first_not_of(kBlank);
  if (first == std::string::npos) return {};
  return out.substr(first, out.find_last_not_of(kBlank) - first + 1);
}

XmlText::XmlText(std::shared_ptr<const SourceText> source, Warnings& warnings, const XmlFormat& format)
    : format_(format),
      source_(std::move(source)),
      line_starts_(line_starts(source_->text)),
      buffer_(source_->text),
      warnings_(&warnings) {
  blank_strange_bytes();
  mend_markup();
  const pugi::xml_parse_result result =
      document_.load_buffer_inplace(buffer_.data(), buffer_.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result)
    throw InputError(place(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0))),
                     fmt::format("not well-formed XML: {}", result.description()));
  const pugi::xml_node first = root();
  if (!first) throw InputError({source_, 1, 1}, fmt::format("no XML element; expected a <{}>", format_.root));
  for (pugi::xml_node other = first.next_sibling(); other; other = other.next_sibling())
    if (other.type() == pugi::node_element)
      throw InputError(where(other),
                       fmt::format("a second root element; a file holds one <{}>", format_.root));
  check_duplicate_attributes();
}

void XmlText::blank_strange_bytes() {
  for (std::optional<std::size_t> at = strange_byte(buffer_, 0); at; at = strange_byte(buffer_, *at)) {
    warn({place(*at), objection_to_byte(buffer_, *at) + "; it is taken for a question mark", {}, "byte"});
    buffer_[*at] = '?';
  }
}

void XmlText::mend_markup() {
  struct Section {
    std::string_view begin, end;
  };
  constexpr Section kSections[] = {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}};
  std::vector<std::size_t> blanks;
  std::size_t at = 0;
  while ((at = buffer_.find('<', at)) != std::string::npos) {
    const std::string_view rest = std::string_view(buffer_).substr(at);
    const auto* const section =
        std::ranges::find_if(kSections, [&](const Section& known) { return rest.starts_with(known.begin); });
    if (section != std::end(kSections)) {
      at = buffer_.find(section->end, at + section->begin.size());
    } else if (!rest.starts_with("<!")) {
      at = end_of_tag(at, blanks);
    } else {
      const std::size_t end = buffer_.find('>', at);
      if (end == std::string::npos || rest.starts_with("<!DOCTYPE")) break;
      warn({place(at), "'<!' begins no comment; it is passed over as far as '>'", {}, "markup"});
      std::replace_if(
          buffer_.begin() + static_cast<std::ptrdiff_t>(at),
          buffer_.begin() + static_cast<std::ptrdiff_t>(end) + 1, [](char c) { return c != '\n'; }, ' ');
    }
  }
  insert_blanks(blanks);
}

/// Of a tag that begins here; and where it needs blanks before attributes.
std::size_t XmlText::end_of_tag(std::size_t begin, std::vector<std::size_t>& blanks) const {
  constexpr std::string_view kAfterValue = " \t\r\n/>?<=\"'";
  char quote = '\0';
  for (std::size_t at = begin + 1; at < buffer_.size(); ++at) {
    const char c = buffer_[at];
    if (c == '<') return quote == '\0' ? at : std::string::npos;
    if (quote == '\0') {
      if (c == '>') return at;
      if (c == '"' || c == '\'') quote = c;
    } else if (c == quote) {
      quote = '\0';
      if (at + 1 == buffer_.size() || kAfterValue.find(buffer_[at + 1]) != std::string_view::npos) continue;
      blanks.push_back(at + 1);
    }
  }
  return std::string::npos;
}

void XmlText::insert_blanks(const std::vector<std::size_t>& before) {
  if (before.empty()) return;
  std::string mended;
  std::size_t done = 0;
  std::vector<std::size_t> inserted;
  for (const std::size_t at : before) {
    warn({place(at), "no blank between two attributes", {}, "blank"});
    mended.append(buffer_, done, at - done);
    inserted.push_back(mended.size());
    mended += ' ';
    done = at;
  }
  mended.append(buffer_, done);
  buffer_ = std::move(mended);
  inserted_ = std::move(inserted);
}

void XmlText::check_duplicate_attributes() const {
  pugi::xml_node at = root();
  while (at) {
    std::map<std::string_view, std::string_view> values;
    for (const pugi::xml_attribute attribute : at.attributes()) {
      const auto [first, inserted] = values.emplace(attribute.name(), attribute.value());
      if (inserted) continue;
      const std::string message =
          fmt::format("a second attribute '{}' of <{}>", printable(attribute.name()), printable(at.name()));
      if (first->second != attribute.value()) throw InputError(where(attribute), message);
      warn({where(attribute), message + ", which says the same", {}, "attribute twice"});
    }
    // The next node of the tree: no recursion, since anyone may nest elements.
    pugi::xml_node next = at.first_child();
    for (; !next && at; at = at.parent()) {
      if (at == root()) break;
      next = at.next_sibling();
    }
    at = next;
  }
}

void XmlText::warn_instead(const InputError& error, const std::string& consequence) const {
  warn({error.where(), error.message() + "; " + consequence, error.note(), without_quotes(error.message())});
}

SourceLocation XmlText::place(std::size_t offset) const {
  offset -= static_cast<std::size_t>(std::ranges::lower_bound(inserted_, offset) - inserted_.begin());
  return place_in(source_, line_starts_, std::min(offset, source_->text.size()));
}

/// Of a string that pugixml left in the buffer, `before` characters ahead of it.
SourceLocation XmlText::place_of(const char* in_buffer, std::size_t before) const {
  const char* const begin = buffer_.data();
  const std::less<> less;
  if (less(in_buffer, begin + before) || !less(in_buffer, begin + buffer_.size())) return {source_, 1, 1};
  return place(static_cast<std::size_t>(in_buffer - begin) - before);
}

bool XmlText::holds(const char* name) const {
  const std::less<> less;
  return !less(name, buffer_.data()) && less(name, buffer_.data() + buffer_.size());
}

SourceLocation XmlText::where(pugi::xml_node element) const {
  return place_of(element.name(), 1);
}

SourceLocation XmlText::where(pugi::xml_attribute attribute) const {
  return place_of(attribute.value()[0] == '\0' ? attribute.name() : attribute.value(), 0);
}

/// What adds to the inertia of a joint.
constexpr std::string_view kOfDrake[] = {"drake:rotor_inertia", "drake:gear_ratio"};

/// Whether a name is of xacro or Drake, of which a warning tells, or has another prefix.
bool XmlText::passed_over(std::string_view name, SourceLocation where) const {
  if (name.starts_with(kXacroPrefix))
    warn({std::move(where), fmt::format("<{}> is of xacro, not of URDF; it is passed over", printable(name)),
          kExpandXacro, std::string(name)});
  if (std::ranges::find(kOfDrake, name) != std::end(kOfDrake))
    warn({std::move(where),
          fmt::format("<{}> is of Drake alone; it is passed over", printable(name)),
          {},
          std::string(name)});
  return name.find(':') != std::string_view::npos;
}

void XmlText::check_spelling(pugi::xml_node element, std::string_view what,
                             std::initializer_list<std::string_view> children,
                             std::initializer_list<std::string_view> attributes) const {
  const auto unknown = [&](SourceLocation place, std::string_view name, bool is_element,
                           std::initializer_list<std::string_view> known) {
    const std::string near = nearest(name, known);
    const std::string shown = printable(name);
    std::string message = is_element ? fmt::format("unknown element <{}> in {}", shown, what)
                                     : fmt::format("unknown attribute '{}' of {}", shown, what);
    if (!near.empty())
      message += is_element ? fmt::format(" (did you mean <{}>?)", near)
                            : fmt::format(" (did you mean '{}'?)", near);
    if (std::ranges::find(format_.vital, near) != format_.vital.end())
      throw InputError(std::move(place), message);
    warn({std::move(place),
          message + "; it is passed over",
          {},
          (is_element ? "element " : "attribute ") + shown});
  };
  for (const pugi::xml_node child : element.children()) {
    std::string_view name = child.name();
    if (format_.called_by_name && is_among(child.attribute("name").value(), children)) continue;
    if (!format_.older_end.empty() && name.ends_with(format_.older_end))
      name.remove_suffix(format_.older_end.size());
    if (child.type() != pugi::node_element || is_among(name, children) || passed_over(name, where(child)))
      continue;
    unknown(where(child), name, true, children);
  }
  for (const pugi::xml_attribute attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (is_among(name, attributes) || name.starts_with("xmlns") || name.find(':') != std::string_view::npos)
      continue;
    unknown(where(attribute), name, false, attributes);
  }
}

pugi::xml_node XmlText::find(pugi::xml_node element, const char* child, std::string_view what) const {
  const pugi::xml_node found = element.child(child);
  if (const pugi::xml_node second = found.next_sibling(child))
    warn({where(second), fmt::format("a second <{}> in {}; the first one is used", child, what)});
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

SourceLocation XmlText::where_text(pugi::xml_node element) const {
  const std::string_view text = element.child_value();
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? where(element) : place_of(text.data() + first, 0);
}

std::vector<double> XmlText::number_list(pugi::xml_attribute attribute, std::string_view what,
                                         std::size_t least, std::size_t most) const {
  return number_list(attribute.value(), where(attribute), what, least, most);
}

std::vector<double> XmlText::number_list(pugi::xml_node element, std::string_view what, std::size_t least,
                                         std::size_t most) const {
  return number_list(text_of_element(element), where_text(element), what, least, most);
}

std::vector<double> XmlText::number_list(std::string_view text, const SourceLocation& where,
                                         std::string_view what, std::size_t least, std::size_t most) const {
  const auto fail = [&] {
    if (text.find("${") != std::string_view::npos || text.find("$(") != std::string_view::npos)
      return InputError(where, fmt::format("'{}' is of xacro, not of URDF", printable(text)), kExpandXacro);
    return InputError(where, fmt::format("expected {} as {}, found '{}'",
                                         most == 1       ? "a number"
                                         : least == most ? fmt::format("{} numbers", most)
                                                         : fmt::format("{} to {} numbers", least, most),
                                         what, printable(text)));
  };
  const auto skip_space = [&](std::size_t at) {
    while (at < text.size() && is_space(text[at])) ++at;
    return at;
  };
  std::vector<double> out;
  bool split = false;  // a sign and its number
  for (std::size_t i = skip_space(0); i < text.size(); i = skip_space(i)) {
    const bool minus = text[i] == '-';
    std::size_t begin = i;
    if (minus || text[i] == '+') {
      begin = skip_space(i + 1);
      split = split || begin > i + 1;
    }
    std::size_t end = begin;
    while (end < text.size() && !is_space(text[end])) ++end;
    if (out.size() == most || begin == end || text[begin] == '-' || text[begin] == '+') throw fail();
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, value);
    if (error != std::errc() || stop != text.data() + end || !std::isfinite(value)) throw fail();
    out.push_back(minus ? -value : value);
    i = end;
  }
  if (out.size() < least) throw fail();
  if (split) warn({where, fmt::format("a blank after a sign in {}", what), {}, "split sign"});
  return out;
}

}  // namespace alembert
