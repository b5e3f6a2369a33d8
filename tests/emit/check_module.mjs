// A module of JavaScript against numbers that the interpreter gave: 1e-12 of the largest entry of each array.
//   node check_module.mjs MODULE.mjs CALLS.json
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [path, calls] = process.argv.slice(2);
const module = await import(pathToFileURL(path));
const { names, functions } = JSON.parse(readFileSync(calls, "utf8"));
const wrong = [];
const check = (good, what) => good || wrong.push(what);

check(JSON.stringify(module.coordinate_names) === JSON.stringify(names), `coordinates ${module.coordinate_names}`);
const present = functions.filter((f) => module.function_names.includes(f.name));
check(present.length === functions.length, `functions ${module.function_names}`);
let worst = 0;
// One function after the other at each state: none must find what another has left.
for (let state = 0; state < Math.max(...functions.map(({ states }) => states.length)); ++state) {
  for (const { name, takes_inputs, states } of functions) {
    const { args, inputs, results, by_default } = states[state];
    const given = takes_inputs ? [inputs] : [];
    const compare = (found, what) => {
      const arrays = results.length === 1 ? [found] : results.map((result) => found[result.name]);
      arrays.forEach((array, k) => {
        const { values } = results[k];
        check(array instanceof Float64Array && array.length === values.length, `${what}: ${results[k].name} has ${array?.length} entries`);
        const largest = values.reduce((most, x) => Math.max(most, Math.abs(x ?? 0)), 0);
        values.forEach((x, i) => {
          if (x === null) return check(!Number.isFinite(array[i]), `${what}: ${results[k].name}[${i}] is ${array[i]}`);
          const error = array[i] === x ? 0 : Math.abs(array[i] - x) / largest;
          worst = Math.max(worst, error);
          return check(error <= 1e-12, `${what}: ${results[k].name}[${i}] is ${array[i]}, not ${x}`);
        });
      });
    };
    const out = results.map(({ values }) => new Float64Array(values.length).fill(NaN));
    const held = out.length === 1 ? out[0] : Object.fromEntries(results.map((result, k) => [result.name, out[k]]));
    compare(module[name](...args, ...given), name);
    compare(module[name](...args, ...given, held), `${name} into arrays`);
    compare(held, `arrays of ${name}`);
    if (args.some((array) => array.length > 0)) {
      let refused = false;
      try {
        module[name](...args.map((array) => array.map(String)), ...given);
      } catch (error) {
        refused = error instanceof TypeError;
      }
      check(refused, `${name} takes texts`);
    }
    if (!takes_inputs) continue;
    const named = Object.fromEntries(module.parameter_names.map((key, i) => [key, inputs.parameters[i]]));
    const wrenches = Object.fromEntries(module.wrench_body_names.map((key, i) => [key, inputs.wrenches.slice(6 * i, 6 * i + 6)]));
    compare(module[name](...args, { t: inputs.t, parameters: named, wrenches }), `${name} by names`);
    if (by_default) compare(module[name](...args), `${name} without inputs`);
    const texts = inputs.parameters.map(String);
    for (const bad of [{ no_such_name: 1 }, { t: "1" }, { parameters: [1, 2, 3, ...inputs.parameters] }, ...(texts.length > 0 ? [{ parameters: texts }] : [])]) {
      let refused = false;
      try {
        module[name](...args, bad);
      } catch (error) {
        refused = error instanceof TypeError;
      }
      check(refused, `${name} takes ${JSON.stringify(bad)}`);
    }
  }
}
console.log(`worst ${worst.toExponential(1)} of an array's largest entry`);
if (wrong.length > 0) {
  console.error(wrong.slice(0, 10).join("\n"));
  process.exit(1);
}
