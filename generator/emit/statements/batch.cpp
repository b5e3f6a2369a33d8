// Writes the files of batches from templates.
#include "emit/statements/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

#include "emit/statements/distinct_results.hpp"
#include "emit/statements/literals.hpp"
#include "emit/statements/statements.hpp"
#include "functions/array_shape.hpp"
#include "program/count.hpp"
#include "program/loops/dot_products.hpp"
#include "program/schedule.hpp"
#include "registers/register_order.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

constexpr std::array<std::string_view, 2> kInstructionSets = {"avx512", "avx2"};

/// What forward dynamics of many states is solved from, unless it has a program.
constexpr std::string_view kSolvedFrom = "mass_matrix_and_bias";

/// When a file is compiled for a set, in terms of the compiler's macros.
std::string_view condition(std::string_view instructions) {
  if (instructions == "avx512")
    return "defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__) && defined(__FMA__)";
  if (instructions == "avx2") return "defined(__AVX2__) && defined(__FMA__)";
  return "1";
}

/// The sets to be compiled, widest first, the baseline last.
std::vector<std::string> sets_of(const EmitOptions& options) {
  std::vector<std::string> sets;
  for (const std::string_view set : kInstructionSets)
    if (std::ranges::find(options.batch_instructions, set) != options.batch_instructions.end())
      sets.emplace_back(set);
  sets.emplace_back("baseline");
  return sets;
}

bool has_program(std::span<const Program> programs, std::string_view function) {
  return std::ranges::find(programs, function, &Program::function) != programs.end();
}

std::string cpp_batch_parameters(const OutputFunction& signature, bool defaults) {
  return fmt::format("::std::size_t n, ::std::size_t stride, {}, const ::alembert::BatchOptions& options{}",
                     argument_list(signature, "const double* {}", "const BatchInputs& in", "double* {}"),
                     defaults ? " = {}" : "");
}

std::string c_batch_parameters(const OutputFunction& signature) {
  return fmt::format(
      "size_t n, size_t stride, {}, int threads",
      argument_list(signature, "const double* {}",
                    "double t, const double* parameters, const double* wrenches", "double* {}"));
}

std::string c_batch_call(const OutputFunction& signature) {
  return fmt::format("n, stride, {}, options", argument_list(signature, "{}", "in", "{}"));
}

/// Longer programs are cut into such blocks, of operations: what is longer does not fit the nearest cache of
/// code, and blocks hand over values. Each operation takes some 14 bytes with AVX2.
constexpr BlockSizes kBatchBlocks = {2000, 1200};

/// An array of a function over packs.
struct PackArray {
  std::string_view name;
  std::size_t size;  ///< elements a pack
  bool result;
  std::string rows;  ///< of a result: which of them each entry is, an array's name or something like one
  std::size_t entries = 0;  ///< of a result
};

constexpr std::string_view kSameRows = "pack::SameRows()";

std::vector<PackArray> pack_arrays(const Mechanism& mechanism, const OutputFunction& signature) {
  std::vector<PackArray> arrays;
  for (const ArgumentKind kind : signature.arguments)
    arrays.push_back({argument_name(kind),
                      static_cast<std::size_t>(kind == ArgumentKind::q ? mechanism.nq : mechanism.nv), false,
                      ""});
  for (const ResultArray& result : signature.results) {
    const std::size_t size = array_shape(result, mechanism).size();
    arrays.push_back({result.name, size, true, std::string(kSameRows), size});
  }
  return arrays;
}

/// The same arrays where equal results of a program stand once, and the definitions of what says which.
std::string keep_distinct(const DistinctResults& distinct, std::vector<PackArray>& arrays) {
  std::string definitions;
  std::size_t k = 0;
  for (PackArray& array : arrays) {
    if (!array.result) continue;
    const std::size_t size = distinct.program.outputs[k].values.size();
    const std::vector<std::uint32_t>& rows = distinct.rows[k++];
    if (rows.empty()) continue;
    array.size = size;
    const std::string name = fmt::format("{}_{}_rows", distinct.program.function, array.name);
    array.rows = "detail::" + name;
    definitions += fmt::format(
        "/// Which of the {} values of a pack the entries of {} are.\n"
        "constexpr ::std::uint{}_t {}[] = {{\n    {}}};\n",
        size, array.name, size <= 0x10000 ? 16 : 32, name,
        wrap_list(fmt::format("{}", fmt::join(rows, ", ")), 4, 4));
  }
  return definitions;
}

/// A program with equal results in all their places again.
Program with_all_results(Program program, const DistinctResults& distinct) {
  for (std::size_t k = 0; k < distinct.rows.size(); ++k) {
    if (distinct.rows[k].empty()) continue;
    const std::vector<std::uint32_t> values = std::move(program.outputs[k].values);
    program.outputs[k].values.clear();
    for (const std::uint32_t row : distinct.rows[k]) program.outputs[k].values.push_back(values[row]);
  }
  return program;
}

/// A program over packs: its blocks, and a function that calls them.
struct PackFunction {
  std::string definition;
  std::vector<PackArray> arrays;
  std::size_t crossing;  ///< elements of kept
  bool of_all;  ///< kept serves all packs, one after the other, since there is one block; or each has its own
};

PackFunction pack_function(const Mechanism& mechanism, const Program& program, const EmitOptions& options) {
  const OutputFunction& signature = *find_function(program.function);
  const std::size_t products = dot_products(program);
  const bool straight = products > 0 && products < options.batch_dot_products;
  const DistinctResults distinct = distinct_results(straight ? schedule(program) : program);
  const Program ordered = order_for_registers(distinct.program, States::many);
  expect_same_values(program, with_all_results(ordered, distinct));
  const FunctionBody body = function_body(ordered, signature, kBatchBlocks, Registers::planned);
  std::vector<PackArray> arrays = pack_arrays(mechanism, signature);
  const std::string rows = keep_distinct(distinct, arrays);
  const std::size_t crossing = std::max<std::size_t>(body.crossing, 1);
  const bool of_all = body.blocks.size() == 1;
  std::string one, all = "int packs, ", arguments;  // parameters of a block, of the function; arguments
  const auto add = [&](std::string_view type, std::string_view name, std::size_t size) {
    one += fmt::format("[[maybe_unused]] {}* ALEMBERT_RESTRICT {}, ", type, name);
    all += fmt::format("{}* {}, ", type, name);
    arguments += size == 0 ? fmt::format("{}, ", name) : fmt::format("{} + {} * k, ", name, size);
  };
  for (const PackArray& array : arrays) add(array.result ? "S" : "const S", array.name, array.size);
  add("S", "kept", of_all ? 0 : crossing);
  if (signature.takes_inputs) {
    one += "[[maybe_unused]] const Inputs<S>& in";
    all += "const Inputs<S>* inputs";
    arguments += "inputs[k]";
  } else {
    for (std::string* list : {&one, &all, &arguments}) list->resize(list->size() - 2);
  }
  std::string blocks, calls;
  for (std::size_t i = 0; i < body.blocks.size(); ++i) {
    const std::string name = fmt::format("{}_pack_block{}", program.function, i + 1);
    const std::string start = fmt::format("ALEMBERT_NOINLINE void {}(", name);
    blocks += (i == 0 ? "" : "\n") +
              fill_template("batch_block.hpp", {{"start", start},
                                                {"arguments", wrap_behind(start, one, 4)},
                                                {"using", body.blocks[i].using_lines},
                                                {"statements", body.blocks[i].statement_lines}});
    calls += fmt::format("for (int k = 0; k < packs; ++k)\n  {}<S>({});\n", name,
                         wrap_list(arguments, name.size() + 8, 8));
  }
  const std::string start = fmt::format("inline void {}_packs(", program.function);
  return {
      fill_template("batch_function.hpp",
                    {{"function", program.function},
                     {"block_count",
                      body.blocks.size() == 1 ? "one block" : fmt::format("{} blocks", body.blocks.size())},
                     {"rows", rows},
                     {"blocks", blocks},
                     {"arguments", wrap_behind(start, all, 4)},
                     {"crossing_count",
                      fmt::format("{} {}", of_all ? "All packs together have" : "A pack has", crossing)},
                     {"calls", calls}}),
      std::move(arrays), crossing, of_all};
}

/// Larger arrays, in packs of up to 64 bytes, are no longer on the stack: a thread has a few MiB of it.
constexpr std::size_t kLargestOnStack = 4096;

std::string array_of_packs(std::string_view name, const std::string& count, std::size_t size) {
  if (size <= kLargestOnStack) return fmt::format("Pack {}[{}];\n", name, count);
  return fmt::format("pack::HeapArray {0}_on_heap({1});\nPack* const {0} = {0}_on_heap.data();\n", name,
                     count);
}

/// From M and c, as the function over packs leaves them.
std::string solve_for_rates(const Mechanism& mechanism, const PackFunction& packs) {
  std::string body;
  for (const PackArray& array : packs.arrays) {
    if (!array.result) continue;
    const std::string entry = fmt::format("{}[{} * k + {}[i]]", array.name, array.size, array.rows);
    body += fmt::format("  for (int i = 0; i < {}; ++i) ", array.entries);
    body += array.name == "M"
                ? fmt::format("square[i] = {};\n", entry)
                : fmt::format("qdd[{0} * k + i] = tau[{0} * k + i] - {1};\n", array.entries, entry);
  }
  return fmt::format(
      "for (int k = 0; k < window.packs; ++k) {{\n"
      "{1}"
      "  pack::solve_positive_definite<{0}>(square, qdd + {0} * k);\n"
      "}}\n",
      mechanism.nv, body);
}

/// The function over a range of states, for one set of instructions. `solved`: forward dynamics from the
/// program of M and c. `packs`: the function that is called.
std::string lanes_function(const Mechanism& mechanism, const OutputFunction& signature, bool solved,
                           const PackFunction& packs) {
  const std::string_view called = solved ? kSolvedFrom : signature.name;
  std::string arrays, loads, stores, call = "window.packs", finite;
  std::size_t size = 0, results = 0, argument = 0, result = 0;
  const auto add = [&](const PackArray& array) {
    arrays += array_of_packs(array.name, fmt::format("kPacks * {}", array.size), array.size);
    size += array.size;
  };
  for (const PackArray& array : solved ? pack_arrays(mechanism, signature) : packs.arrays) {
    add(array);
    if (array.result) {
      stores += fmt::format("window.store({0}, {1}, {2}, {3}, call.results[{4}], call.stride);\n",
                            array.entries, array.rows, array.size, array.name, result++);
      finite += fmt::format("{0}pack::zero_if_finite({1}, {2} + {1} * k)", finite.empty() ? "" : " + ",
                            array.size, array.name);
      results += array.entries;
    } else {
      loads += fmt::format("window.load({0}, call.arguments[{1}], call.stride, {2});\n", array.size,
                           argument++, array.name);
    }
  }
  for (const PackArray& array : packs.arrays) {
    if (solved && array.result) add(array);
    call += fmt::format(", {}", array.name);
  }
  call += ", kept";
  if (signature.takes_inputs) {
    arrays += "Inputs<Pack> inputs[kPacks];\nfor (Inputs<Pack>& in : inputs) take_common(call, in);\n";
    loads += "take_own(call, window, inputs);\n";
    call += ", inputs";
  }
  if (packs.of_all) {
    arrays += array_of_packs("kept", std::to_string(packs.crossing), packs.crossing);
  } else {
    add({"kept", packs.crossing, false, ""});
  }
  std::string calls = fmt::format("detail::{}_packs<Pack>({});\n", called, call);
  if (solved) {
    const std::size_t square =
        static_cast<std::size_t>(mechanism.nv) * static_cast<std::size_t>(mechanism.nv);
    arrays += array_of_packs("square", std::to_string(square), square);
    calls += solve_for_rates(mechanism, packs);
  }
  return fill_template("batch_lanes.cpp", {{"function", std::string(signature.name)},
                                           {"pack_size", std::to_string(size)},
                                           {"result_size", std::to_string(results)},
                                           {"arrays", arrays},
                                           {"loads", loads},
                                           {"calls", calls},
                                           {"stores", stores},
                                           {"finite", finite}});
}

std::string lanes_file(const Mechanism& mechanism, const std::vector<const OutputFunction*>& functions,
                       const std::map<std::string, PackFunction, std::less<>>& pack_functions,
                       const std::string& set, const Slots& common) {
  std::string definitions, table;
  for (const OutputFunction* signature : functions) {
    const bool solved = !pack_functions.contains(signature->name);
    definitions += (definitions.empty() ? "" : "\n") +
                   lanes_function(mechanism, *signature, solved,
                                  pack_functions.find(solved ? kSolvedFrom : signature->name)->second);
    table += fmt::format("{}{}_lanes", table.empty() ? "" : ", ", signature->name);
  }
  const std::string parameters = common.at("parameter_count");
  const int wrenches = 6 * std::stoi(common.at("wrench_count"));
  const auto filled = [](std::string_view array, int size, std::string_view text) {
    return size == 0 ? std::string() : fmt::format(fmt::runtime(text), array, size);
  };
  constexpr std::string_view kCommon =
      "for (::std::size_t i = 0; i < {1}; ++i) in.{0}[i] = Pack(call.{0}[i]);\n";
  constexpr std::string_view kOwn =
      "if (call.{0}_of_state != nullptr)\n"
      "  for (::std::size_t i = 0; i < {1}; ++i) {{\n"
      "    window.load(call.{0}_of_state + i * call.stride, row, 1);\n"
      "    for (int k = 0; k < window.packs; ++k) in[k].{0}[i] = row[k];\n"
      "  }}\n";
  return fill_template("mechanism_batch_lanes.cpp",
                       {{"instructions", set},
                        {"condition", std::string(condition(set))},
                        {"header", mechanism.name},
                        {"common_parameters", filled("parameters", std::stoi(parameters), kCommon)},
                        {"common_wrenches", filled("wrenches", wrenches, kCommon)},
                        {"own_parameters", filled("parameters", std::stoi(parameters), kOwn)},
                        {"own_wrenches", filled("wrenches", wrenches, kOwn)},
                        {"definitions", definitions},
                        {"table", wrap_list(table, 52, 4)}},
                       common);
}

}  // namespace

std::span<const std::string_view> batch_instruction_sets() {
  return kInstructionSets;
}

std::vector<std::string> default_batch_functions() {
  return {"inverse_dynamics", "mass_matrix_and_bias", "forward_dynamics"};
}

std::vector<const OutputFunction*> batch_signatures(const Mechanism& mechanism,
                                                    std::span<const Program> programs,
                                                    const EmitOptions& options) {
  std::vector<const OutputFunction*> signatures;
  std::vector<std::string> known;
  for (const OutputFunction& signature : kOutputFunctions) {
    known.emplace_back(signature.name);
    if (std::ranges::count(options.batch, signature.name) > 1)
      throw InputError(mechanism.where, fmt::format("batch: {} is given twice", signature.name));
    if (std::ranges::find(options.batch, signature.name) == options.batch.end()) continue;
    const std::string_view needed =
        signature.name == "forward_dynamics" && !has_program(programs, signature.name) ? kSolvedFrom
                                                                                       : signature.name;
    if (!has_program(programs, needed))
      throw InputError(mechanism.where, fmt::format("batch: {} needs {}, which is not among the functions",
                                                    signature.name, needed));
    for (const ResultArray& result : signature.results)
      if (array_shape(result, mechanism).size() == 0)
        throw InputError(mechanism.where,
                         fmt::format("batch: {} of this mechanism has no results", signature.name));
    signatures.push_back(&signature);
  }
  for (const std::string& name : options.batch)
    if (std::ranges::find(known, name) == known.end())
      throw InputError(mechanism.where, fmt::format("batch: there is no function '{}'", printable(name)) +
                                            did_you_mean(name, known));
  for (const std::string& set : options.batch_instructions)
    if (std::ranges::find(kInstructionSets, set) == kInstructionSets.end())
      throw InputError(
          mechanism.where,
          fmt::format("batch: there are no instructions '{}': expected avx2 or avx512", printable(set)));
  return signatures;
}

std::vector<std::string> batch_paths(const std::string& name, const EmitOptions& options) {
  std::vector<std::string> paths{fmt::format("include/{0}/{0}_batch.hpp", name),
                                 fmt::format("include/{0}/{0}_batch_impl.hpp", name),
                                 fmt::format("src/{}_batch.cpp", name)};
  for (const std::string& set : sets_of(options))
    paths.push_back(fmt::format("src/{}_batch_{}.cpp", name, set));
  return paths;
}

std::string batch_c_declarations(const Mechanism& mechanism, std::span<const Program> programs,
                                 const EmitOptions& options, const Slots& common) {
  std::string declarations;
  for (const OutputFunction* signature : batch_signatures(mechanism, programs, options)) {
    const std::string start = fmt::format("int {}_{}_batch(", mechanism.name, signature->name);
    declarations += "\n" + fill_template("batch_c_declaration.h",
                                         {{"function", std::string(signature->name)},
                                          {"arguments", wrap_behind(start, c_batch_parameters(*signature))}},
                                         common);
  }
  return declarations;
}

std::vector<EmittedFile> batch_files(const Mechanism& mechanism, std::span<const Program> programs,
                                     const EmitOptions& options, const Slots& common) {
  const std::vector<const OutputFunction*> functions = batch_signatures(mechanism, programs, options);
  const std::vector<std::string> sets = sets_of(options);
  std::string declarations, definitions, c_definitions, tables, choices;
  for (std::size_t k = 0; k < functions.size(); ++k) {
    const OutputFunction& signature = *functions[k];
    const std::string name(signature.name);
    const std::string start = fmt::format("::std::size_t {}_batch(", name);
    const std::string_view gap = k == 0 ? "" : "\n";
    declarations += fmt::format(
        "{}{}", gap,
        fill_template(
            "batch_declaration.hpp",
            {{"function", name}, {"arguments", wrap_behind(start, cpp_batch_parameters(signature, true))}}));
    std::string assignments;
    for (std::size_t i = 0; i < signature.arguments.size(); ++i)
      assignments += fmt::format("call.arguments[{}] = {};\n", i, argument_name(signature.arguments[i]));
    for (std::size_t i = 0; i < signature.results.size(); ++i)
      assignments += fmt::format("call.results[{}] = {};\n", i, signature.results[i].name);
    definitions +=
        fmt::format("{}{}", gap,
                    fill_template("batch_definition.cpp",
                                  {{"function", name},
                                   {"arguments", wrap_behind(start, cpp_batch_parameters(signature, false))},
                                   {"assignments", assignments},
                                   {"index", std::to_string(k)}}));
    const std::string c_start = fmt::format("int {}_{}_batch(", mechanism.name, name);
    c_definitions +=
        fmt::format("{}{}", gap,
                    fill_template("batch_c_definition.cpp",
                                  {{"function", name},
                                   {"arguments", wrap_behind(c_start, c_batch_parameters(signature))},
                                   {"null_check", c_null_check(signature)},
                                   {"call", c_batch_call(signature)}},
                                  common));
  }
  for (const std::string& set : sets) {
    tables += fmt::format("const ::alembert::BatchFunction* batch_{}();\n", set);
    if (set != "baseline") choices += fill_template("batch_choice.cpp", {{"instructions", set}});
  }
  std::string packs;
  std::map<std::string, PackFunction, std::less<>> pack_functions;
  for (const Program& program : programs) {
    const auto needs = [&](const OutputFunction* f) {
      return f->name == program.function ||
             (f->name == "forward_dynamics" && program.function == kSolvedFrom &&
              !has_program(programs, "forward_dynamics"));
    };
    if (!std::ranges::any_of(functions, needs)) continue;
    PackFunction function = pack_function(mechanism, program, options);
    packs += (packs.empty() ? "" : "\n") + function.definition;
    pack_functions.emplace(program.function, std::move(function));
  }
  std::vector<std::string> texts{
      fill_template("mechanism_batch.hpp", {{"declarations", declarations}}, common),
      fill_template("mechanism_batch_impl.hpp", {{"definitions", packs}}, common),
      fill_template("mechanism_batch.cpp",
                    {{"table_declarations", tables},
                     {"choices", choices},
                     {"definitions", definitions},
                     {"c_definitions", c_definitions}},
                    common)};
  for (const std::string& set : sets)
    texts.push_back(lanes_file(mechanism, functions, pack_functions, set, common));
  const std::vector<std::string> paths = batch_paths(mechanism.name, options);
  std::vector<EmittedFile> files;
  for (std::size_t i = 0; i < paths.size(); ++i) files.push_back({paths[i], std::move(texts[i])});
  return files;
}

}  // namespace alembert
