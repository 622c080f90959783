// Curves of a plot: outputs, and expressions over outputs and parameters.

import { expression } from './expression.js';
import { numberAt } from './format.js';

/** A name in its parts: the index of the component, the name of its output or parameter, and the path to a part of the value. */
function partsOf(shown, name) {
  const components = shown?.description.value?.components ?? [];
  const index = components.findIndex((one) => name.startsWith(`${one.name}.`));
  const [, own, path] = name.slice((components[index]?.name.length ?? 0) + 1).match(/^([^.[]*)((?:[.[].*)?)$/su);
  return { index, own, path, component: components[index] };
}

/** An output by its name `Component.output.path`: {place, path, unit}; null if there is none. */
function output(shown, name) {
  const { index, own, path, component } = partsOf(shown, name);
  const info = component?.info.findIndex((one) => one.name === own) ?? -1;
  return info < 0 || !/^(\.\p{XID_Continue}+|\[\d+\])*$/u.test(path) ? null : { place: [index, info], path, unit: component.info[info].unit };
}

/** Reads a parameter `Component.parameter`; null if there is none. */
function parameter(shown, name) {
  const { index, own, path, component } = partsOf(shown, name);
  const number = component?.params.findIndex((one) => one.name === own) ?? -1;
  return number < 0 || path ? null : () => Number(shown.params.peek()[index][number]);
}

/**
 * A curve by its name: {name, unit, inputs: [{place, path}], begin}. `begin()` returns a function of the time, s, and the numbers of the
 * inputs. That of one output has its `place` and `path`, too. Throws an error that says what is wrong with a name.
 */
export function resolve(shown, typed) {
  // As the compiler writes names.
  const name = typed.normalize('NFC');
  const own = output(shown, name);
  if (own) return { name, ...own, inputs: [own], begin: () => (time, [value]) => value };
  const { names, begin } = expression(name, shown?.description.value?.components.map((one) => one.name));
  const parts = names.map((one) => {
    const [input, fixed] = [output(shown, one), parameter(shown, one)];
    if (!input && fixed === null) throw new Error(`there is no output or parameter “${one}”`);
    return { input, fixed };
  });
  const inputs = parts.filter(({ input }) => input).map(({ input }) => input);
  if (inputs.length === 0) throw new Error(`“${name}” has no output that changes`);
  return {
    name, inputs, unit: '',
    begin() {
      const evaluate = begin();
      return (time, values) => {
        let at = 0;
        return evaluate(time, parts.map(({ input, fixed }) => (input ? values[at++] : fixed())));
      };
    },
  };
}

/** The same; null if it is none. */
export function resolved(shown, name) {
  try {
    return resolve(shown, name);
  } catch {
    return null;
  }
}

/** The newest or shown value of a curve; null if it is not known. A rate is that of the last two samples. */
export function valueNow(shown, { inputs, begin }) {
  const all = inputs.map(({ place }) => shown.output(...place));
  const values = inputs.map(({ path }, index) => numberAt(all[index].now.value?.value, path));
  if (values.includes(null)) return null;
  const [time, evaluate] = [Math.max(...all.map(({ now, times }) => now.value.time ?? times.at(-1) ?? 0)), begin()];
  const before = Math.max(...all.map((one) => one.times[one.count(time - 1) - 1] ?? -1));
  const earlier = inputs.map(({ path }, index) => numberAt(all[index].held(before), path));
  if (!earlier.includes(null)) evaluate(before / 1e6, earlier);
  return finite(evaluate(time / 1e6, values));
}

/** A number, or a BigInt that no number holds; null for anything else. */
function finite(value) {
  if (typeof value === 'bigint') return Number.isSafeInteger(Number(value)) ? Number(value) : value;
  return Number.isFinite(value) ? value : null;
}

/** Samples of a curve within an interval, µs: Map from time to number. A value holds until the next one, or until its component is latent: null. */
export function samples(shown, { inputs, begin }, [from, until]) {
  const all = inputs.map(({ place }) => shown.output(...place));
  const step = Math.max(1, Math.floor(all[0].times.length / 4000));
  const times = new Set();
  for (const { times: own } of all) for (let index = 0; index < own.length; index += step) if (own[index] >= from && own[index] <= until) times.add(own[index]);
  for (const { activity: { ends } } of all) for (const end of ends) if (end >= from && end <= until) times.add(end);
  const [column, evaluate] = [new Map(), begin()];
  for (const time of [...times].sort((a, b) => a - b)) {
    const values = inputs.map(({ path }, index) => numberAt(all[index].held(time), path));
    column.set(time, values.includes(null) ? null : finite(evaluate(time / 1e6, values)));
  }
  return column;
}
