#!/usr/bin/env python3
"""Registers, spills and stack of the kernels of robots, as nvcc compiles them: a table for src/cuda/README.md.

    cuda_registers.py ALEMBERT ROBOT[:floating][:FUNCTION,...]... [--arch sm_80] [--nvcc nvcc]

In: descriptions or robots in other formats, with the functions to compile (default: those of FUNCTIONS). Out: a row a kernel, and
the seconds that compiling took: registers, bytes spilled (stored and loaded) and bytes of stack a thread, for float and double.
"""
import argparse
import pathlib
import re
import subprocess
import tempfile
import time

FUNCTIONS = ["inverse_dynamics", "mass_matrix", "forward_dynamics", "forward_dynamics_derivatives"]


def instances(header, number):
    """Explicit instances of the launchers of all functions, and of the rollouts where there are any."""
    text = header.read_text()
    name = re.search(r"namespace ([\w:]+)::cuda \{", text).group(1)
    out = f'#include "{header}"\nnamespace m = {name}::cuda;\n'
    for found in re.finditer(r"template <class S[^>]*>\s*(?:inline )?cudaError_t (?P<name>\w+_batch)\((?P<arguments>[^)]*)\)", text):
        arguments = re.sub(r"\s+", " ", found["arguments"])
        types = [re.sub(r"( = [^,]*)?$", "", each).strip() for each in arguments.split(",")]
        types = [re.sub(r"\s*\b\w+$", "", each) if not each.endswith(("*", "&")) else each for each in types]
        types = [re.sub(r"\bS\b", number, each) for each in types]
        types = [re.sub(r"\b(BatchInputs|Rollout|Policy|NoPolicy)\b", r"m::\1", each).replace("m::Policy", "m::NoPolicy") for each in types]
        methods = ["semi_implicit_euler", "rk4"] if found["name"] == "rollout_batch" else [""]
        for method in methods:
            given = number + (f", m::Method::{method}" if method else "")
            out += f"template cudaError_t m::{found['name']}<{given}>({', '.join(types)});\n"
    return out


def kernel_name(mangled):
    found = re.search(r"(\w+?)_kernel", re.sub(r"^.*6detail\d+", "", mangled))
    name = found.group(1) if found else mangled
    if name == "rollout":
        name += ", Runge-Kutta" if "MethodE1E" in mangled else ", semi-implicit Euler"
    return name


def compiled(header, number, options):
    """{kernel: (registers, stored, loaded, stack)} and seconds."""
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "kernels.cu")
        source.write_text(instances(header, number))
        begin = time.time()
        done = subprocess.run([options.nvcc, "-std=c++17", f"-arch={options.arch}", "-Xptxas", "-v", "-c", str(source), "-o",
                               str(source.with_suffix(".o"))], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise SystemExit(done.stderr)
        seconds = time.time() - begin
    rows = {}
    for said in done.stderr.split("Compiling entry function '")[1:]:
        mangled = said.split("'")[0]
        # Of the kernel itself, and then of the functions that it calls.
        stacks = re.findall(r"(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads", said)
        stored, loaded = (sum(int(each[i]) for each in stacks) for i in (1, 2))
        rows[kernel_name(mangled)] = (int(re.search(r"Used (\d+) registers", said).group(1)), stored, loaded, int(stacks[0][0]))
    return rows, seconds


def main():
    parser = argparse.ArgumentParser(description="Registers, spills and stack of kernels as nvcc compiles them.")
    parser.add_argument("alembert")
    parser.add_argument("robots", nargs="+", metavar="ROBOT[:floating][:FUNCTION,...]")
    parser.add_argument("--arch", default="sm_80")
    parser.add_argument("--nvcc", default="nvcc")
    options = parser.parse_args()
    print("| robot | kernel | float: registers, spilled, stack | double: registers, spilled, stack |\n| --- | --- | --- | --- |")
    for robot in options.robots:
        path, *more = robot.split(":")
        functions = next((each.split(",") for each in more if each not in ("floating", "fixed")), FUNCTIONS)
        with tempfile.TemporaryDirectory() as folder:
            root = ["--root", "floating"] if "floating" in more else []
            rates = ["coordinate_rates"] if "forward_dynamics" in functions else []
            subprocess.run([options.alembert, "generate", path, *root, "--language", "cuda", "--functions", ",".join(functions + rates),
                            "--out-dir", folder], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            header = next(pathlib.Path(folder, "cuda").glob("*.cuh"))
            columns, seconds = zip(*(compiled(header, number, options) for number in ("float", "double")))
            # As asked for, then the rollouts.
            order = functions + sorted((kernel for kernel in columns[0] if kernel.startswith("rollout")), reverse=True)
            for kernel in order:
                entries = [f"{r:,}, {s:,} + {l:,}, {k:,}" for r, s, l, k in (column[kernel] for column in columns)]
                print(f"| {header.stem} | {kernel} | {entries[0]} | {entries[1]} |", flush=True)
            print(f"{header.stem}: {seconds[0]:.0f} s for float, {seconds[1]:.0f} s for double", flush=True)


if __name__ == "__main__":
    main()
