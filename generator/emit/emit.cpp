// Assembles the files of a mechanism from programs and templates.
#include "emit/emit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string_view>

#include "emit/argument_lists.hpp"
#include "emit/axis_members.hpp"
#include "emit/c99.hpp"
#include "emit/common_slots.hpp"
#include "emit/cuda.hpp"
#include "emit/eigen_members.hpp"
#include "emit/function_docs.hpp"
#include "emit/javascript.hpp"
#include "emit/python.hpp"
#include "emit/speed_parents.hpp"
#include "emit/statements/batch.hpp"
#include "emit/statements/literals.hpp"
#include "emit/statements/statements.hpp"
#include "emit/text_template.hpp"
#include "mechanism/names.hpp"
#include "program/count.hpp"
#include "program/loops/dot_products.hpp"
#include "program/loops/reroll.hpp"
#include "registers/register_order.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

// The compilers of browsers leave functions that are longer unoptimised.
constexpr BlockSizes kJavaScriptBlocks{.longest = 800, .size = 500};

// Calls between blocks move numbers through memory, of which each thread has its own.
constexpr BlockSizes kCudaBlocks{.longest = 12000, .size = 6000};

// With the number of parts left open: statements in one file, which a compiler takes a few seconds for.
constexpr std::size_t kStatementsPerPart = 6000;

/// What goes into one of the parts: a function, a block of one, or the function that calls its blocks.
struct Unit {
  std::string definition;
  std::string instantiations;
  std::size_t statements;
};

std::string plural(std::size_t n, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// Errors are measured in double; code for float alone says so.
std::string counts_text(const Program& program, bool float_only) {
  const OperationCount n = count(program);
  std::string text = fmt::format("{}, {}", plural(n.mul, "multiplication", "multiplications"),
                                 plural(n.add, "addition", "additions"));
  if (n.div > 0) text += ", " + plural(n.div, "division", "divisions");
  if (n.trig > 0) text += fmt::format(", {} sin/cos/tan", n.trig);
  if (n.other > 0) text += ", " + plural(n.other, "other function", "other functions");
  if (const std::size_t in_loops = dot_products(program); in_loops > 0)
    text += fmt::format(", {} dot products in loops", in_loops);
  if (const std::size_t in_loops = operations_in_loops(program); in_loops > 0)
    text += fmt::format(", {} operations in loops over steps", in_loops);
  if (!program.formulation.empty()) {
    const std::string error = program.error ? fmt::format("; relative error {:.2g}{} where it was measured",
                                                          *program.error, float_only ? " in double" : "")
                                            : "";
    text += fmt::format(" ({} formulation{})", comment_text(program.formulation), error);
  }
  return text;
}

/// dq/dt = qd where there are no quaternions.
Program identity_rates(const Mechanism& mechanism) {
  Program program;
  program.function = "coordinate_rates";
  program.outputs.push_back({"qdot", static_cast<std::uint32_t>(mechanism.nq), 1, {}});
  for (const Coordinate& c : mechanism.coordinates) {
    const auto i = static_cast<std::uint32_t>(c.first_q), speed = static_cast<std::uint32_t>(c.first_speed);
    program.inputs.push_back({ArgumentKind::qd, speed, "d(" + c.name + ")"});
    program.code.push_back({Operation::input, static_cast<std::uint32_t>(program.inputs.size() - 1), 0});
    program.outputs[0].values.resize(static_cast<std::size_t>(mechanism.nq));
    program.outputs[0].values[i] = static_cast<std::uint32_t>(program.code.size() - 1);
  }
  return program;
}

void check_options(const Mechanism& mechanism, const EmitOptions& options) {
  const auto fail = [&](const std::string& message) { throw InputError(mechanism.where, message); };
  if (!options.expected_name.empty() && mechanism.name != options.expected_name)
    fail(fmt::format("the mechanism is called '{}' where the build expects '{}': configure the build again",
                     printable(mechanism.name), printable(options.expected_name)));
  if (const std::string objection = objection_to_mechanism_name(mechanism.name); !objection.empty())
    fail(fmt::format("'{}' cannot name a mechanism: it {}", printable(mechanism.name), objection));
  if (mechanism.nq < 1 || mechanism.nv < 1)
    fail("a mechanism without coordinates has no equations of motion");
  if (const std::string objection = objection_to_outer_namespace(options.outer_namespace); !objection.empty())
    fail(fmt::format("'{}' is no namespace: {}; expected identifiers joined by ::",
                     printable(options.outer_namespace), objection));
  if (options.scalars.empty()) fail("no scalar type: expected double, float or both");
  for (const std::string& scalar : options.scalars) {
    if (scalar != "double" && scalar != "float")
      fail(fmt::format("'{}' is no scalar type to compile for: expected double or float", printable(scalar)));
    if (std::ranges::count(options.scalars, scalar) > 1)
      fail(fmt::format("the scalar type {} is given twice", scalar));
  }
  const bool over_c = options.language == Language::c || options.language == Language::python;
  if (over_c && options.scalars.size() > 1)
    fail(fmt::format("{} is written for one scalar type: expected double or float",
                     options.language == Language::c ? "C" : "Python"));
  if (options.language == Language::javascript && options.scalars != std::vector<std::string>{"double"})
    fail("JavaScript has one scalar type: double");
  if (options.language != Language::cpp && !options.batch.empty())
    fail("functions over many states are written in C++ only");
  if (options.parts < 0 || options.parts > kMaxParts)
    fail(fmt::format("the number of parts must be 1 to {}", kMaxParts));
}

std::vector<WrittenFunction> functions_of(const Mechanism& mechanism, std::span<const Program> programs,
                                          const Syntax& syntax, const BlockSizes& sizes = {},
                                          std::span<const ExtraFunction> extra = {}) {
  std::vector<WrittenFunction> functions;
  const auto add = [&](const Program& program, const OutputFunction& signature) {
    check_program(program, signature, mechanism);
    functions.push_back({&signature, counts_text(program, syntax.number == "float"),
                         function_body(order_for_registers(program, States::one), signature, sizes,
                                       Registers::compiled, syntax)});
  };
  for (const Program& program : programs) {
    if (find_function(program.function) == nullptr)
      throw InternalError(fmt::format("emit: there is no function {}", printable(program.function)));
    if (std::ranges::count(programs, program.function, &Program::function) > 1)
      throw InternalError(fmt::format("emit: two programs for {}", program.function));
  }
  const bool all_real = std::ranges::all_of(
      mechanism.coordinates, [](const Coordinate& c) { return c.type == CoordinateType::real; });
  for (const OutputFunction& signature : kOutputFunctions) {
    const auto program = std::ranges::find(programs, signature.name, &Program::function);
    if (program != programs.end())
      add(*program, signature);
    else if (signature.name == "coordinate_rates" && all_real)
      add(identity_rates(mechanism), signature);
  }
  for (const ExtraFunction& more : extra) add(more.program, more.signature);
  return functions;
}

std::string instantiation(std::string_view keyword, std::string_view function,
                          const OutputFunction& signature, const std::vector<std::string>& scalars,
                          bool block) {
  std::string out;
  for (const std::string& scalar : scalars)
    out += fmt::format("{} void {}<{}>({}{});\n", keyword, function, scalar,
                       cpp_parameter_types(signature, scalar), block ? fmt::format(", {}*", scalar) : "");
  return out;
}

std::vector<Unit> units_of(const WrittenFunction& function, const EmitOptions& options, const Slots& common) {
  const OutputFunction& signature = *function.signature;
  const std::string name(signature.name);
  const std::string parameters = wrap_behind("void " + name + "(", cpp_parameters(signature, true));
  const std::string instantiations = instantiation("template", name, signature, options.scalars, false);
  const std::vector<CodeBlock>& blocks = function.body.blocks;
  if (blocks.size() == 1) {
    const Slots slots{{"function", name},
                      {"counts", function.counts},
                      {"arguments", parameters},
                      {"using", blocks[0].using_lines},
                      {"statements", blocks[0].statement_lines}};
    return {{fill_template("function_definition.hpp", slots, common), instantiations, blocks[0].statements}};
  }
  std::vector<Unit> units;
  std::string declarations, calls;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::string block = fmt::format("{}_block{}", name, i + 1);
    const Slots slots{
        {"block", block},
        {"arguments", wrap_behind("ALEMBERT_NOINLINE void " + block + "(", cpp_parameters(signature, true))},
        {"using", blocks[i].using_lines},
        {"statements", blocks[i].statement_lines}};
    units.push_back({fill_template("function_block.hpp", slots, common),
                     instantiation("template", "detail::" + block, signature, options.scalars, true),
                     blocks[i].statements});
    declarations += fmt::format("template <class S>\nvoid {}({}, S* kept);\n", block,
                                wrap_behind("void " + block + "(", cpp_parameters(signature, false)));
    calls += fmt::format("detail::{}<S>({}, kept);\n", block, cpp_arguments(signature));
  }
  const Slots slots{{"function", name},
                    {"counts", function.counts},
                    {"arguments", parameters},
                    {"block_count", std::to_string(blocks.size())},
                    {"block_declarations", declarations},
                    {"crossing_count", std::to_string(std::max<std::size_t>(function.body.crossing, 1))},
                    {"block_calls", calls}};
  units.push_back({fill_template("function_driver.hpp", slots, common), instantiations, blocks.size()});
  return units;
}

/// All units in order, cut where the running number of statements passes a multiple of its mean.
std::vector<std::vector<Unit>> spread(std::vector<Unit> units, int parts) {
  std::size_t total = 0;
  for (const Unit& unit : units) total += unit.statements;
  const std::size_t count =
      parts > 0
          ? static_cast<std::size_t>(parts)
          : std::clamp<std::size_t>((total + kStatementsPerPart - 1) / kStatementsPerPart, 1, kMaxParts);
  std::vector<std::vector<Unit>> out(count);
  std::size_t before = 0;
  for (Unit& unit : units) {
    const std::size_t middle = before + unit.statements / 2;
    before += unit.statements;
    out[std::min(count - 1, total == 0 ? 0 : middle * count / total)].push_back(std::move(unit));
  }
  return out;
}

std::string joined(const std::vector<Unit>& units, std::string Unit::*text, std::string_view separator) {
  std::string out;
  for (const Unit& unit : units) out += (out.empty() ? "" : std::string(separator)) + unit.*text;
  return out;
}

std::string documented(const WrittenFunction& function, const Mechanism& mechanism, std::string_view prefix,
                       const std::optional<std::string>& c_prefix = std::nullopt) {
  return prefix_lines(function_doc(*function.signature, mechanism, function.counts, c_prefix), prefix);
}

bool has_function(const std::vector<WrittenFunction>& functions, std::string_view name) {
  return std::ranges::any_of(functions, [&](const WrittenFunction& f) { return f.signature->name == name; });
}

std::string raw_header(const Mechanism& mechanism, const std::vector<WrittenFunction>& functions,
                       const EmitOptions& options, const Slots& common) {
  std::string declarations, externs, helpers;
  std::set<std::string> called;
  // Over packs, angles are brought together that one state computes one by one.
  if (!options.batch.empty()) called.emplace("sines_and_cosines");
  for (const WrittenFunction& function : functions) {
    const std::string name(function.signature->name);
    declarations += fill_template(
        "function_declaration.hpp",
        {{"doc", documented(function, mechanism, "/// ")},
         {"function", name},
         {"arguments", wrap_behind("void " + name + "(", cpp_parameters(*function.signature, false))}});
    declarations += '\n';
    externs += instantiation("extern template", name, *function.signature, options.scalars, false);
    for (const CodeBlock& block : function.body.blocks)
      called.insert(block.helpers.begin(), block.helpers.end());
  }
  for (const std::string_view helper : kHelpers)
    if (called.contains(std::string(helper)))
      helpers += fill_template(fmt::format("{}.hpp", helper), {}, common) + "\n";
  if (declarations.ends_with("\n\n")) declarations.pop_back();
  std::string description;
  if (!mechanism.description.empty())
    description = "//\n" + prefix_lines(wrap_words(comment_text(mechanism.description), 3, 0, 110), "// ");
  Slots slots = cpp_constant_slots(mechanism);
  slots["description"] = description;
  slots["index_doc"] = prefix_lines(index_doc(mechanism, has_function(functions, "frame_poses")), "/// ");
  slots["state_arguments"] = prefix_lines(state_arguments(functions, common, 5, "[{}]"), "//   ");
  slots["declarations"] = helpers + declarations;
  slots["extern_templates"] = externs;
  return fill_template("mechanism_raw.hpp", slots, common);
}

/// What solvers with M leave out, where M is written.
std::string speed_parents_member(std::span<const Program> programs, int nv) {
  const auto program = std::ranges::find(programs, "mass_matrix_and_bias", &Program::function);
  if (program == programs.end()) return "";
  std::vector<std::string> parents;
  for (const int parent : speed_parents(*program, nv)) parents.push_back(std::to_string(parent));
  return fmt::format(
      "/// Of each speed the last one before it to which M(q), or L of M = L^T D L, ties it, or -1; and "
      "whose M.\n"
      "static constexpr ::std::array<int, kNv> kSpeedParents = {};\n"
      "using SpeedParentsOf = Mechanism;",
      cpp_array(parents));
}

std::string eigen_header(const std::vector<WrittenFunction>& functions, const std::string& parents,
                         const std::optional<AxisPrograms>& axes, const Slots& common) {
  std::string members;
  for (const WrittenFunction& function : functions)
    members += (members.empty() ? "" : "\n") + eigen_member(*function.signature, common.at("namespace"));
  if (axes) members += "\n" + axis_members(*axes, common.at("namespace"));
  const std::string_view version = generator_version();
  const std::string major(version.substr(0, version.find('.')));
  return fill_template(
      "mechanism.hpp",
      {{"members", prefix_lines(members, "  ")}, {"speed_parents", parents}, {"version_major", major}},
      common);
}

std::string c_header(const Mechanism& mechanism, const std::vector<WrittenFunction>& functions,
                     const std::string& batch, const std::string& number, const Slots& common) {
  std::string declarations;
  for (const WrittenFunction& function : functions) {
    const std::string start = fmt::format("int {}_{}(", common.at("name"), function.signature->name);
    const std::string doc =
        "/* " + prefix_lines(documented(function, mechanism, "", mechanism.name + "_"), "   ").substr(3) +
        " */";
    declarations +=
        (declarations.empty() ? "" : "\n") +
        fill_template("c_declaration.h",
                      {{"doc", doc},
                       {"function", std::string(function.signature->name)},
                       {"arguments", wrap_behind(start, c_parameters(*function.signature, number))}},
                      common);
  }
  return fill_template("mechanism.h",
                       {{"includes", batch.empty() ? "" : "#include <stddef.h>\n"},
                        {"number", number},
                        {"state_arguments", state_arguments(functions, common, 12, "[{}]")},
                        {"declarations", declarations + batch}},
                       common);
}

std::string c_source(const Mechanism& mechanism, const std::vector<WrittenFunction>& functions,
                     const EmitOptions& options, const Slots& common) {
  std::string definitions;
  for (const WrittenFunction& function : functions) {
    const std::string start = fmt::format("int {}_{}(", common.at("name"), function.signature->name);
    definitions += (definitions.empty() ? "" : "\n") +
                   fill_template("c_definition.cpp",
                                 {{"function", std::string(function.signature->name)},
                                  {"arguments", wrap_behind(start, c_parameters(*function.signature))},
                                  {"null_check", c_null_check(*function.signature)},
                                  {"call", c_arguments(*function.signature)}},
                                 common);
  }
  // Without code compiled for double, this file compiles its own.
  const bool has_double = std::ranges::count(options.scalars, "double") > 0;
  Slots slots = c_constant_slots(mechanism, "double", "nullptr");
  slots["definitions"] = definitions;
  slots["header"] = mechanism.name + (has_double ? "_raw" : "_impl");
  return fill_template("mechanism_c.cpp", slots, common);
}

std::string banner_of(const Mechanism& mechanism) {
  return fill_template("banner.txt",
                       {{"name", mechanism.name}, {"version", std::string(generator_version())}});
}

std::vector<EmittedFile> c_files(const Mechanism& mechanism, std::span<const Program> programs,
                                 const EmitOptions& options) {
  const std::string& number = options.scalars.front();
  const std::vector<WrittenFunction> functions =
      functions_of(mechanism, programs, c_syntax(number, mechanism.name + "_"));
  Slots common = common_slots(mechanism, "");
  const std::string guard = fmt::format("ALEMBERT_{}_H", mechanism.name);
  common.insert({{"banner", banner_of(mechanism)},
                 {"guard", fmt::format("#ifndef {0}\n#define {0}\n", guard)},
                 {"end_guard", "\n#endif\n"}});
  std::vector<EmittedFile> files = {
      {fmt::format("include/{0}/{0}.h", mechanism.name), c_header(mechanism, functions, "", number, common)},
      {fmt::format("src/{}.c", mechanism.name), c99_source(mechanism, functions, number, common)}};
  if (options.language == Language::python)
    std::ranges::move(python_files(mechanism, functions, files, number, common), std::back_inserter(files));
  return files;
}

std::vector<EmittedFile> javascript_files(const Mechanism& mechanism, std::span<const Program> programs,
                                          const EmitOptions& options) {
  Slots common = common_slots(mechanism, "");
  common["banner"] = banner_of(mechanism);
  common["version"] = generator_version();
  return {{fmt::format("javascript/{}.mjs", mechanism.name),
           javascript_module(
               mechanism,
               functions_of(mechanism, programs, javascript_syntax(), kJavaScriptBlocks, options.extra),
               common)}};
}

std::vector<EmittedFile> cuda_files(const Mechanism& mechanism, std::span<const Program> programs,
                                    const EmitOptions& options) {
  Slots common = common_slots(mechanism, options.outer_namespace + "::" + mechanism.name + "::cuda");
  common["banner"] = banner_of(mechanism);
  return {{fmt::format("cuda/{}.cuh", mechanism.name),
           cuda_header(mechanism, functions_of(mechanism, programs, cpp_syntax(), kCudaBlocks), common)}};
}

}  // namespace

std::string_view generator_version() {
  return ALEMBERT_VERSION;
}

std::vector<std::string> emitted_paths(const std::string& name, int parts) {
  const std::string include = fmt::format("include/{0}/{0}", name), source = fmt::format("src/{}", name);
  std::vector<std::string> paths{include + ".hpp", include + "_raw.hpp", include + "_impl.hpp"};
  for (int k = 1; k <= parts; ++k) paths.push_back(fmt::format("{}_part{}.hpp", include, k));
  paths.push_back(include + ".h");
  for (int k = 1; k <= parts; ++k) paths.push_back(fmt::format("{}_part{}.cpp", source, k));
  paths.push_back(source + "_c.cpp");
  return paths;
}

std::vector<EmittedFile> emit_mechanism(const Mechanism& mechanism, std::span<const Program> programs,
                                        const EmitOptions& options) {
  check_options(mechanism, options);
  if (options.language == Language::javascript) return javascript_files(mechanism, programs, options);
  if (options.language == Language::cuda) return cuda_files(mechanism, programs, options);
  if (options.language != Language::cpp) return c_files(mechanism, programs, options);
  const std::vector<ExtraFunction> extra =
      options.axes ? axis_functions(*options.axes) : std::vector<ExtraFunction>();
  const std::vector<WrittenFunction> all = functions_of(mechanism, programs, cpp_syntax(), {}, extra);
  const std::vector<WrittenFunction> functions(all.begin(), all.end() - std::ssize(extra));
  Slots common = common_slots(mechanism, options.outer_namespace + "::" + mechanism.name);
  common["scalar_list"] = fmt::format("{}", fmt::join(options.scalars, " and "));
  const std::string banner = banner_of(mechanism);
  common["banner"] = prefix_lines(banner, "// ");
  common["noinline"] = fill_template("noinline.hpp", {});

  std::vector<Unit> units;
  for (const WrittenFunction& function : all) {
    std::vector<Unit> more = units_of(function, options, common);
    std::ranges::move(more, std::back_inserter(units));
  }
  const std::vector<std::vector<Unit>> parts = spread(std::move(units), options.parts);
  const auto part_slots = [&](std::size_t k) {
    return Slots{{"part", std::to_string(k + 1)}, {"parts", std::to_string(parts.size())}};
  };

  std::vector<std::string> texts;
  texts.push_back(
      eigen_header(functions, speed_parents_member(programs, mechanism.nv), options.axes, common));
  texts.push_back(raw_header(mechanism, all, options, common));
  std::string includes;
  for (std::size_t k = 0; k < parts.size(); ++k)
    includes += fmt::format("#include \"{}_part{}.hpp\"\n", mechanism.name, k + 1);
  texts.push_back(fill_template("mechanism_impl.hpp", {{"includes", includes}}, common));
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Slots slots = part_slots(k);
    slots["definitions"] = joined(parts[k], &Unit::definition, "\n");
    texts.push_back(fill_template("mechanism_part.hpp", slots, common));
  }
  Slots c_common = common;
  c_common["banner"] = banner;
  c_common.insert({{"guard", "#pragma once\n"}, {"end_guard", ""}});
  const std::string batch =
      options.batch.empty() ? "" : batch_c_declarations(mechanism, programs, options, c_common);
  texts.push_back(c_header(mechanism, functions, batch, "double", c_common));
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Slots slots = part_slots(k);
    slots["instantiations"] = joined(parts[k], &Unit::instantiations, "");
    texts.push_back(fill_template("mechanism_part.cpp", slots, common));
  }
  texts.push_back(c_source(mechanism, functions, options, common));

  const std::vector<std::string> paths = emitted_paths(mechanism.name, static_cast<int>(parts.size()));
  std::vector<EmittedFile> files;
  for (std::size_t i = 0; i < paths.size(); ++i) files.push_back({paths[i], std::move(texts[i])});
  if (!options.batch.empty())
    std::ranges::move(batch_files(mechanism, programs, options, common), std::back_inserter(files));
  return files;
}

}  // namespace alembert
