// Curves of a plot: outputs, and expressions over outputs and parameters.

import { expression } from './expression.js';
import { numberAt } from './format.js';

/** An output by its name `Component.information.path`: {place, path, unit}; null if there is none. */
function output(shown, name) {
  if (!/^[\w.[\]]+$/.test(name)) return null;
  const [component, rest] = [name.slice(0, name.indexOf('.')), name.slice(name.indexOf('.') + 1)];
  const info = rest.split(/[.[]/)[0];
  const place = shown?.findInfo(component, info);
  return place ? { place, path: rest.slice(info.length), unit: shown.description.value.components[place[0]].info[place[1]].unit } : null;
}

/** Reads a parameter `Component.parameter`; null if there is none. */
function parameter(shown, name) {
  const [component, param] = name.split('.');
  const index = shown.find(component);
  const number = shown.description.value?.components[index]?.params.findIndex((one) => one.name === param) ?? -1;
  return number < 0 ? null : () => Number(shown.params.peek()[index][number]);
}

/**
 * A curve by its name: {name, unit, inputs: [{place, path}], begin}. `begin()` returns a function of the time, s, and the numbers of the
 * inputs. That of one output has its `place` and `path`, too. Throws an error that says what is wrong with a name.
 */
export function resolve(shown, name) {
  const own = output(shown, name);
  if (own) return { name, ...own, inputs: [own], begin: () => (time, [value]) => value };
  const { names, begin } = expression(name);
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

/** The newest or shown value of a curve; null if it is not known. A rate needs two samples. */
export function valueNow(shown, { inputs, begin }) {
  const values = inputs.map(({ place, path }) => numberAt(shown.info_of(...place).now.value?.value, path));
  const value = values.includes(null) ? NaN : begin()(0, values);
  return Number.isFinite(value) ? value : null;
}

/** Samples of a curve within an interval, µs: Map from time to number. Inputs of other rates keep their last value. */
export function samples(shown, { inputs, begin }, [from, until]) {
  const all = inputs.map(({ place }) => shown.info_of(...place));
  const step = Math.max(1, Math.floor(all[0].times.length / 4000));
  const times = new Set();
  for (const { times: own } of all) for (let index = 0; index < own.length; index += step) if (own[index] >= from && own[index] <= until) times.add(own[index]);
  const [column, evaluate] = [new Map(), begin()];
  for (const time of all.length === 1 ? times : [...times].sort((a, b) => a - b)) {
    const values = inputs.map(({ path }, index) => numberAt(all[index].at(time), path));
    const value = values.includes(null) ? null : evaluate(time / 1e6, values);
    column.set(time, Number.isFinite(value) ? value : null);
  }
  return column;
}
