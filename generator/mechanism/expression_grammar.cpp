#include "mechanism/expression_grammar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/limit_depth.hpp>

#include "mechanism/names.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

namespace pegtl = tao::pegtl;

/// What the actions fill.
struct ParseState {
  std::vector<PostfixToken> postfix;
  struct OpenCall {
    std::size_t begin, end;
    int arguments;
    int knots = 0;
  };
  std::vector<OpenCall> calls;
  PostfixToken reference{};
};

namespace grammar {
// clang-format off
struct blank : pegtl::star<pegtl::one<' ', '\t', '\n', '\r'>> {};
template <char C> struct symbol : pegtl::seq<pegtl::one<C>, blank> {};

struct digits : pegtl::plus<pegtl::digit> {};
struct fraction : pegtl::seq<pegtl::one<'.'>, pegtl::star<pegtl::digit>> {};
struct exponent : pegtl::seq<pegtl::one<'e', 'E'>, pegtl::opt<pegtl::one<'+', '-'>>, digits> {};
struct numeral : pegtl::seq<pegtl::sor<pegtl::seq<digits, pegtl::opt<fraction>>, pegtl::seq<pegtl::one<'.'>, digits>>, pegtl::opt<exponent>> {};
struct end_of_number : pegtl::not_at<pegtl::sor<pegtl::identifier_other, pegtl::one<'.'>>> {};
struct number : pegtl::if_must<numeral, end_of_number> {};

struct expression;
struct operand;
struct argument : pegtl::seq<expression> {};
struct function_name : pegtl::identifier {};
struct open_call : pegtl::seq<function_name, blank, pegtl::one<'('>> {};
struct close_call : pegtl::one<')'> {};
struct call : pegtl::if_must<open_call, blank, argument, pegtl::star<pegtl::if_must<symbol<','>, argument>>, close_call> {};
struct table_name : pegtl::sor<TAO_PEGTL_STRING("spline"), TAO_PEGTL_STRING("simm_spline"), TAO_PEGTL_STRING("linear")> {};
struct open_spline : pegtl::seq<table_name, blank, pegtl::one<'('>> {};
struct items : pegtl::list_must<argument, symbol<','>> {};
struct close_list : symbol<']'> {};
struct bracketed : pegtl::if_must<symbol<'['>, items, close_list> {};
struct knots : pegtl::sor<bracketed, items> {};
struct values : pegtl::sor<bracketed, items> {};
struct semicolon : symbol<';'> {};
struct close_spline : pegtl::one<')'> {};
struct spline : pegtl::if_must<open_spline, blank, argument, semicolon, knots, semicolon, values, close_spline> {};
struct referring_word : pegtl::sor<TAO_PEGTL_STRING("position"), TAO_PEGTL_STRING("velocity"), TAO_PEGTL_STRING("rotation"), TAO_PEGTL_STRING("angular_velocity"), TAO_PEGTL_STRING("length"), TAO_PEGTL_STRING("rate"), TAO_PEGTL_STRING("tension"), TAO_PEGTL_STRING("distance"), pegtl::one<'d'>> {};
struct referring : pegtl::seq<referring_word, pegtl::not_at<pegtl::identifier_other>> {};
struct open_reference : pegtl::seq<referring, blank, pegtl::one<'('>> {};
struct referent : pegtl::identifier {};
struct close_reference : pegtl::one<')'> {};
struct part : pegtl::identifier {};
struct second_referent : pegtl::identifier {};
struct reference : pegtl::seq<pegtl::if_must<open_reference, blank, referent, blank, pegtl::opt<pegtl::if_must<symbol<','>, second_referent, blank>>, close_reference>, pegtl::opt<pegtl::if_must<pegtl::seq<blank, pegtl::one<'.'>>, blank, part>>> {};
struct name : pegtl::identifier {};
struct close_group : pegtl::one<')'> {};
struct group : pegtl::if_must<symbol<'('>, expression, close_group> {};
struct primary : pegtl::seq<pegtl::sor<number, reference, spline, call, name, group>, blank> {};

struct raise : pegtl::if_must<symbol<'^'>, operand> {};
struct power : pegtl::seq<primary, pegtl::opt<raise>> {};
struct negation : pegtl::if_must<symbol<'-'>, operand> {};
struct identity : pegtl::if_must<symbol<'+'>, operand> {};
struct operand : pegtl::sor<negation, identity, power> {};
struct times : pegtl::if_must<symbol<'*'>, operand> {};
struct over : pegtl::if_must<symbol<'/'>, operand> {};
struct term : pegtl::seq<operand, pegtl::star<pegtl::sor<times, over>>> {};
struct plus : pegtl::if_must<symbol<'+'>, term> {};
struct minus : pegtl::if_must<symbol<'-'>, term> {};
struct expression : pegtl::seq<term, pegtl::star<pegtl::sor<plus, minus>>> {};
struct whole : pegtl::seq<blank, pegtl::must<expression>, pegtl::must<pegtl::eof>> {};
// clang-format on
}  // namespace grammar

constexpr const char* kExpectedOperand = "a number, a name or '('";

/// Messages by the rule that failed; `expected ...`, to which what was found is added.
struct Expected {
  template <typename Rule>
  static constexpr const char* message = nullptr;
};
template <>
constexpr const char* Expected::message<grammar::end_of_number> = "an operator after the number";
template <>
constexpr const char* Expected::message<grammar::argument> = kExpectedOperand;
template <>
constexpr const char* Expected::message<grammar::expression> = kExpectedOperand;
template <>
constexpr const char* Expected::message<grammar::operand> = kExpectedOperand;
template <>
constexpr const char* Expected::message<grammar::term> = kExpectedOperand;
template <>
constexpr const char* Expected::message<grammar::close_call> = "an operator, ',' or ')'";
template <>
constexpr const char* Expected::message<grammar::close_group> = "an operator or ')'";
template <>
constexpr const char* Expected::message<grammar::knots> = "the knots of the spline";
template <>
constexpr const char* Expected::message<grammar::values> = "the values of the spline";
template <>
constexpr const char* Expected::message<grammar::items> = kExpectedOperand;
template <>
constexpr const char* Expected::message<grammar::semicolon> = "an operator or ';'";
template <>
constexpr const char* Expected::message<grammar::close_list> = "an operator, ',' or ']'";
template <>
constexpr const char* Expected::message<grammar::close_spline> = "an operator, ',' or ')'";
template <>
constexpr const char* Expected::message<grammar::referent> = "a name";
template <>
constexpr const char* Expected::message<grammar::second_referent> = "a name";
template <>
constexpr const char* Expected::message<grammar::close_reference> = "')' after the name";
template <>
constexpr const char* Expected::message<grammar::part> = "a part such as x after the point";
template <>
constexpr const char* Expected::message<pegtl::eof> = "an operator or the end of the expression";

/// Rules inside must<> throw with their message; all others fail as usual and let alternatives be tried.
template <typename Rule>
struct Control : pegtl::normal<Rule> {
  template <typename Input, typename... States>
  [[noreturn]] static void raise(const Input& in, States&&...) {
    if constexpr (Expected::message<Rule> != nullptr)
      throw pegtl::parse_error(Expected::message<Rule>, in);
    else
      throw pegtl::parse_error("an expression", in);
  }
};

template <typename Rule>
struct Action {};

template <PostfixToken::Kind kKind>
struct Push {
  template <typename Input>
  static void apply(const Input& in, ParseState& state) {
    const std::size_t begin = in.iterator().byte;
    state.postfix.push_back({kKind, begin, begin + in.size()});
  }
};
/// A binary operator is pushed after its right operand was; its own place is its first character.
template <PostfixToken::Kind kKind>
struct PushOperator {
  template <typename Input>
  static void apply(const Input& in, ParseState& state) {
    const std::size_t begin = in.iterator().byte;
    state.postfix.push_back({kKind, begin, begin + 1});
  }
};
using Nesting = pegtl::limit_depth<kMaximumExpressionDepth>;

template <>
struct Action<grammar::number> : Push<PostfixToken::Kind::number> {};
template <>
struct Action<grammar::name> : Push<PostfixToken::Kind::name> {};
template <>
struct Action<grammar::times> : PushOperator<PostfixToken::Kind::multiply> {};
template <>
struct Action<grammar::over> : PushOperator<PostfixToken::Kind::divide> {};
template <>
struct Action<grammar::plus> : PushOperator<PostfixToken::Kind::add> {};
template <>
struct Action<grammar::minus> : PushOperator<PostfixToken::Kind::subtract> {};
template <>
struct Action<grammar::identity> : Nesting {};
template <>
struct Action<grammar::negation> : Nesting, PushOperator<PostfixToken::Kind::negate> {};
template <>
struct Action<grammar::raise> : Nesting, PushOperator<PostfixToken::Kind::power> {};
template <>
struct Action<grammar::group> : Nesting, Push<PostfixToken::Kind::group> {};
template <>
struct Action<grammar::referring> {
  template <typename Input>
  static void apply(const Input& in, ParseState& state) {
    const std::size_t begin = in.iterator().byte;
    state.reference = {PostfixToken::Kind::reference, begin, begin + in.size()};
  }
};
template <>
struct Action<grammar::referent> {
  template <typename Input>
  static void apply(const Input& in, ParseState& state) {
    state.reference.referent = in.iterator().byte;
    state.reference.referent_end = state.reference.referent + in.size();
  }
};
template <>
struct Action<grammar::second_referent> {
  template <typename Input>
  static void apply(const Input& in, ParseState& state) {
    state.reference.second = in.iterator().byte;
    state.reference.second_end = state.reference.second + in.size();
  }
};
template <>
struct Action<grammar::part> {
  template <typename Input>
  static void apply(const Input& in, ParseState& state) {
    state.reference.part = in.iterator().byte;
  }
};
template <>
struct Action<grammar::reference> {
  template <typename Input>
  static void apply(const Input& in, ParseState& state) {
    state.reference.close = in.iterator().byte + in.size();
    state.postfix.push_back(state.reference);
  }
};
template <>
struct Action<grammar::open_call> {
  template <typename Input>
  static void apply(const Input& in, ParseState& state) {
    const std::size_t begin = in.iterator().byte;
    const std::string_view text = in.string_view();
    const std::string_view called = text.substr(0, text.find_first_of(" \t\n\r("));
    state.calls.push_back({begin, begin + called.size(), 0});
  }
};
template <>
struct Action<grammar::argument> {
  static void apply0(ParseState& state) { ++state.calls.back().arguments; }
};
template <>
struct Action<grammar::call> : Nesting {
  template <typename Input>
  static void apply(const Input& in, ParseState& state) {
    const ParseState::OpenCall call = state.calls.back();
    state.calls.pop_back();
    state.postfix.push_back(
        {PostfixToken::Kind::call, call.begin, call.end, in.iterator().byte + in.size(), call.arguments});
  }
};

template <>
struct Action<grammar::open_spline> : Action<grammar::open_call> {};
template <>
struct Action<grammar::knots> {
  static void apply0(ParseState& state) { state.calls.back().knots = state.calls.back().arguments - 1; }
};
template <>
struct Action<grammar::spline> : Nesting {
  template <typename Input>
  static void apply(const Input& in, ParseState& state) {
    const ParseState::OpenCall call = state.calls.back();
    state.calls.pop_back();
    state.postfix.push_back({PostfixToken::Kind::spline, call.begin, call.end, in.iterator().byte + in.size(),
                             call.arguments, call.knots});
  }
};

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

std::string found_at(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) return "the end of the expression";
  // A whole UTF-8 character, or a whole word.
  std::size_t end = offset + 1;
  if (is_word_character(text[offset]))
    while (end < text.size() && is_word_character(text[end])) ++end;
  else
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) ++end;
  return fmt::format("'{}'", printable(text.substr(offset, end - offset)));
}

std::string note_for(std::string_view text, std::size_t offset) {
  const char c = offset < text.size() ? text[offset] : '\0';
  if (c == ',' && offset > 0 && is_digit(text[offset - 1]) && offset + 1 < text.size() &&
      is_digit(text[offset + 1]))
    return "decimals are written with a point: 1.5";
  if (c == '*' && offset > 0 && text[offset - 1] == '*') return "a power is written x^n";
  if (c == '.' && text.substr(0, offset).find_first_not_of(" \t\n\r") == std::string_view::npos)
    return "infinity and NaN are not values here";
  if (c == '.' && offset > 0 && text[offset - 1] == ')')
    return "only references such as d(NAME) and position(NAME) have parts";
  std::size_t end = offset;
  while (end > 0 && is_blank(text[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_word_character(text[begin - 1])) --begin;
  if (const std::string_view before = text.substr(begin, end - begin); function_arity(before) > 0)
    return fmt::format("a function takes its argument in parentheses: {}(x)", before);
  return {};
}

}  // namespace

std::vector<PostfixToken> parse_expression(std::string_view text) {
  if (text.size() > kMaximumExpressionLength)
    throw SyntaxError{
        0,
        fmt::format("expression of {} characters; the limit is {}", text.size(), kMaximumExpressionLength),
        {}};
  ParseState state;
  pegtl::memory_input<> input(text.data(), text.data() + text.size(), "expression");
  try {
    pegtl::parse<grammar::whole, Action, Control>(input, state);
  } catch (const pegtl::parse_error& error) {
    const std::size_t offset = error.positions().front().byte;
    if (error.message() == std::string_view("maximum parser rule nesting depth exceeded"))
      throw SyntaxError{
          offset, fmt::format("expression nested more than {} levels deep", kMaximumExpressionDepth), {}};
    throw SyntaxError{offset, fmt::format("expected {}, found {}", error.message(), found_at(text, offset)),
                      note_for(text, offset)};
  }
  return std::move(state.postfix);
}

std::optional<Operation> function_called(std::string_view name) {
  for (const OperationFacts& row : kOperationFacts)
    if (row.in_language && row.name == name) return row.operation;
  return std::nullopt;
}

int function_arity(std::string_view name) {
  if (const std::optional<Operation> function = function_called(name)) return operand_count(*function);
  const auto* const choosing = std::ranges::find(kChoosingFunctions, name, &ChoosingFunction::name);
  return choosing == std::end(kChoosingFunctions) ? 0 : choosing->arguments;
}

const std::vector<std::string>& reserved_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const OperationFacts& row : kOperationFacts)
      if (row.in_language) all.emplace_back(row.name);
    all.insert(all.end(), {"spline", "pi", "t"});
    return all;
  }();
  return names;
}

}  // namespace alembert
