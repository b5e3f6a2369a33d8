// Writes the files of batches from templates.
#include "emit/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "emit/literals.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

constexpr std::array<std::string_view, 2> kInstructionSets = {"avx512", "avx2"};

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

std::string cpp_batch_parameters(const FunctionSignature& signature, bool defaults) {
  std::string out = "::std::size_t n, ::std::size_t stride, ";
  for (const ArgumentKind kind : signature.arguments)
    out += fmt::format("const double* {}, ", array_name(kind));
  out += "const BatchInputs& in, ";
  for (const ResultArray& result : signature.results) out += fmt::format("double* {}, ", result.name);
  return out + "const ::alembert::BatchOptions& options" + (defaults ? " = {}" : "");
}

std::string c_batch_parameters(const FunctionSignature& signature) {
  std::string out = "size_t n, size_t stride, ";
  for (const ArgumentKind kind : signature.arguments)
    out += fmt::format("const double* {}, ", array_name(kind));
  out += "double t, const double* parameters, const double* wrenches, ";
  for (const ResultArray& result : signature.results) out += fmt::format("double* {}, ", result.name);
  return out + "int threads";
}

std::string c_batch_call(const FunctionSignature& signature) {
  std::string out = "n, stride, ";
  for (const ArgumentKind kind : signature.arguments) out += fmt::format("{}, ", array_name(kind));
  out += "in, ";
  for (const ResultArray& result : signature.results) out += fmt::format("{}, ", result.name);
  return out + "options";
}

/// The function over a range of states, for one set of instructions.
std::string lanes_function(const Mechanism& mechanism, const FunctionSignature& signature, bool solved) {
  const auto size_of = [&](ArgumentKind kind) {
    return kind == ArgumentKind::q ? mechanism.nq : mechanism.nv;
  };
  std::string arrays, loads, stores, call;
  for (std::size_t i = 0; i < signature.arguments.size(); ++i) {
    const std::string_view name = array_name(signature.arguments[i]);
    const int size = size_of(signature.arguments[i]);
    arrays += fmt::format("Pack {}[{}];\n", name, size);
    loads += fmt::format("window.load({}, call.arguments[{}], call.stride, {});\n", size, i, name);
    if (!solved || signature.arguments[i] != ArgumentKind::tau) call += fmt::format("{}, ", name);
  }
  if (signature.takes_inputs) {
    loads += "take_own(call, window, in);\n";
    call += "in, ";
  }
  std::string finite;
  for (std::size_t i = 0; i < signature.results.size(); ++i) {
    const ResultArray& result = signature.results[i];
    const std::size_t size = array_size(result.size, mechanism);
    finite += fmt::format("{}pack::zero_if_finite({}, {})", i == 0 ? "" : " + ", size, result.name);
    arrays += fmt::format("Pack {}[{}];\n", result.name, size);
    stores += fmt::format("window.store({}, {}, call.results[{}], call.stride);\n", size, result.name, i);
    call += fmt::format("{}{}", result.name, i + 1 == signature.results.size() ? "" : ", ");
  }
  std::string calls = fmt::format("{}<Pack>({});\n", signature.name, call);
  if (solved) {
    arrays += fmt::format("Pack M[{}];\n", mechanism.nv * mechanism.nv);
    calls = fmt::format(
        "mass_matrix_and_bias<Pack>(q, qd, in, M, qdd);\n"
        "for (int i = 0; i < {0}; ++i) qdd[i] = tau[i] - qdd[i];\n"
        "pack::solve_positive_definite<{0}>(M, qdd);\n",
        mechanism.nv);
  }
  return fill_template(
      "batch_lanes.cpp",
      {{"function", std::string(signature.name)},
       {"inputs", signature.takes_inputs ? "Inputs<Pack> in;\ntake_common(call, in);\n" : ""},
       {"arrays", arrays},
       {"loads", loads},
       {"calls", calls},
       {"stores", stores},
       {"finite", finite}});
}

std::string lanes_file(const Mechanism& mechanism, const std::vector<const FunctionSignature*>& functions,
                       bool solve, const std::string& set, const Slots& common) {
  std::string definitions, table;
  for (const FunctionSignature* signature : functions) {
    definitions += (definitions.empty() ? "" : "\n") +
                   lanes_function(mechanism, *signature, solve && signature->name == "forward_dynamics");
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
      "if (call.{0}_of_state != nullptr) window.load({1}, call.{0}_of_state, call.stride, in.{0}.data());\n";
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

std::vector<const FunctionSignature*> batch_signatures(const Mechanism& mechanism,
                                                       std::span<const Program> programs,
                                                       const EmitOptions& options) {
  std::vector<const FunctionSignature*> signatures;
  std::vector<std::string> known;
  for (const FunctionSignature& signature : function_signatures()) {
    known.emplace_back(signature.name);
    if (std::ranges::count(options.batch, signature.name) > 1)
      throw InputError(mechanism.where, fmt::format("batch: {} is given twice", signature.name));
    if (std::ranges::find(options.batch, signature.name) == options.batch.end()) continue;
    const std::string_view needed =
        signature.name == "forward_dynamics" && !has_program(programs, signature.name)
            ? std::string_view("mass_matrix_and_bias")
            : signature.name;
    if (!has_program(programs, needed))
      throw InputError(mechanism.where, fmt::format("batch: {} needs {}, which is not among the functions",
                                                    signature.name, needed));
    for (const ResultArray& result : signature.results)
      if (array_size(result.size, mechanism) == 0)
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
                                 fmt::format("src/{}_batch.cpp", name)};
  for (const std::string& set : sets_of(options))
    paths.push_back(fmt::format("src/{}_batch_{}.cpp", name, set));
  return paths;
}

std::string batch_c_declarations(const Mechanism& mechanism, std::span<const Program> programs,
                                 const EmitOptions& options, const Slots& common) {
  std::string declarations;
  for (const FunctionSignature* signature : batch_signatures(mechanism, programs, options)) {
    const std::string start = fmt::format("int {}_{}_batch(", mechanism.name, signature->name);
    declarations +=
        "\n" + fill_template("batch_c_declaration.h",
                             {{"function", std::string(signature->name)},
                              {"arguments", wrap_list(c_batch_parameters(*signature), start.size(),
                                                      std::min<std::size_t>(start.size(), 40))}},
                             common);
  }
  return declarations;
}

std::vector<EmittedFile> batch_files(const Mechanism& mechanism, std::span<const Program> programs,
                                     const EmitOptions& options, const Slots& common) {
  const std::vector<const FunctionSignature*> functions = batch_signatures(mechanism, programs, options);
  const std::vector<std::string> sets = sets_of(options);
  std::string declarations, definitions, c_definitions, tables, choices;
  for (std::size_t k = 0; k < functions.size(); ++k) {
    const FunctionSignature& signature = *functions[k];
    const std::string name(signature.name);
    const std::size_t start = fmt::format("::std::size_t {}_batch(", name).size();
    const auto wrapped = [&](const std::string& list, std::size_t at) {
      return wrap_list(list, at, std::min<std::size_t>(at, 40));
    };
    const std::string_view gap = k == 0 ? "" : "\n";
    declarations += fmt::format(
        "{}{}", gap,
        fill_template(
            "batch_declaration.hpp",
            {{"function", name}, {"arguments", wrapped(cpp_batch_parameters(signature, true), start)}}));
    std::string assignments;
    for (std::size_t i = 0; i < signature.arguments.size(); ++i)
      assignments += fmt::format("call.arguments[{}] = {};\n", i, array_name(signature.arguments[i]));
    for (std::size_t i = 0; i < signature.results.size(); ++i)
      assignments += fmt::format("call.results[{}] = {};\n", i, signature.results[i].name);
    definitions +=
        fmt::format("{}{}", gap,
                    fill_template("batch_definition.cpp",
                                  {{"function", name},
                                   {"arguments", wrapped(cpp_batch_parameters(signature, false), start)},
                                   {"assignments", assignments},
                                   {"index", std::to_string(k)}}));
    const std::size_t c_start = fmt::format("int {}_{}_batch(", mechanism.name, name).size();
    c_definitions +=
        fmt::format("{}{}", gap,
                    fill_template("batch_c_definition.cpp",
                                  {{"function", name},
                                   {"arguments", wrapped(c_batch_parameters(signature), c_start)},
                                   {"null_check", c_null_check(signature)},
                                   {"call", c_batch_call(signature)}},
                                  common));
  }
  for (const std::string& set : sets) {
    tables += fmt::format("const ::alembert::BatchFunction* batch_{}();\n", set);
    if (set != "baseline") choices += fill_template("batch_choice.cpp", {{"instructions", set}});
  }
  std::vector<std::string> texts{
      fill_template("mechanism_batch.hpp", {{"declarations", declarations}}, common),
      fill_template("mechanism_batch.cpp",
                    {{"table_declarations", tables},
                     {"choices", choices},
                     {"definitions", definitions},
                     {"c_definitions", c_definitions}},
                    common)};
  const bool solve = !has_program(programs, "forward_dynamics");
  for (const std::string& set : sets) texts.push_back(lanes_file(mechanism, functions, solve, set, common));
  const std::vector<std::string> paths = batch_paths(mechanism.name, options);
  std::vector<EmittedFile> files;
  for (std::size_t i = 0; i < paths.size(); ++i) files.push_back({paths[i], std::move(texts[i])});
  return files;
}

}  // namespace alembert
