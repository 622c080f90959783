// A span of time that a person chose: it is played, measured and exported.

import { effect, signal, untracked } from './dom.js';
import { request } from './connection.js';
import { minus } from './expression.js';
import { numbers } from './format.js';
import { newest, notify, session } from './store.js';

/** [begin, end], µs; null if none is chosen. */
export const span = signal(null);

/** Longest exported table: rows, and numbers of an output. */
const [ROWS, NUMBERS] = [20000, 64];

/** Chooses the span between two times of the session. */
export function choose(one, other) {
  const { from_us: from } = session.peek().info.peek();
  const within = (time) => Math.round(Math.min(Math.max(time, from), newest.peek()));
  const [begin, end] = [within(Math.min(one, other)), within(Math.max(one, other))];
  if (end > begin) span.value = [begin, end];
}

/** Moves the begin, 0, or the end, 1, of the span to a time. */
export function setEdge(edge, time) {
  if (!session.peek()) return;
  const [begin, end] = span.value ?? [session.peek().info.peek().from_us, newest.peek()];
  if (edge === 0) choose(time, Math.max(end, time));
  else choose(Math.min(begin, time), time);
}

// The span is one of the shown session and of its run.
effect(() => {
  void session.value?.description.value;
  untracked(() => { span.value = null; });
});

/** The note of a span as text; and the span and the text of a note that has one. */
export const noteOf = ([begin, end], text) => `${(begin / 1e6).toFixed(2)}–${(end / 1e6).toFixed(2)} s: ${text}`;

export function spanOf(note) {
  const [, begin, end, text] = note.match(/^(\d+\.\d+)–(\d+\.\d+) s: (.*)$/s) ?? [];
  return text === undefined ? null : { begin: begin * 1e6, end: end * 1e6, text };
}

/** What is measured of the samples of a span, Map from time to number or null: a value holds until the next one, or until null. */
export function statistics(samples, [begin, end]) {
  const known = [...samples].filter(([time]) => time <= end);
  const first = Math.max(0, known.findLastIndex(([time]) => time <= begin));
  const all = known.slice(first).map(([time, value], index, rest) => [value, Math.max(0, (rest[index + 1]?.[0] ?? end) - Math.max(time, begin))]);
  const base = all.find(([value]) => typeof value === 'bigint')?.[0] ?? 0;
  const parts = all.filter(([value]) => value !== null).map(([value, weight]) => [Number(minus(value, base)), weight]);
  if (parts.length === 0) return null;
  const total = parts.reduce((sum, [, weight]) => sum + weight, 0) || 1;
  const mean = parts.reduce((sum, [value, weight]) => sum + value * weight, 0) / total;
  const deviation = Math.sqrt(parts.reduce((sum, [value, weight]) => sum + (value - mean) ** 2 * weight, 0) / total);
  const values = parts.map(([value]) => value);
  const [min, max, middle] = [Math.min(...values), Math.max(...values), mean].map((one) => (base ? base + BigInt(Math.round(one)) : one));
  return { min, max, mean: middle, deviation, change: values.at(-1) - values[0] };
}

/** How a component spent a span: [[state, share]] of the time and the number of transitions; `row` is its bars. */
export function sharesOf(row, component, [begin, end]) {
  const shares = new Map();
  let transitions = 0;
  for (const [from, until, state] of row?.bars ?? []) {
    const time = Math.min(until, end) - Math.max(from, begin);
    if (time <= 0) continue;
    transitions += from > begin;
    const name = component.states[state]?.name ?? 'active';
    shares.set(name, (shares.get(name) ?? 0) + time / (end - begin));
  }
  return { shares: [...shares].sort((a, b) => b[1] - a[1]), transitions };
}

/** All numbers of the outputs in a span as a table: a row for each time at which one changed. Undefined if it is too long. */
export async function table(shown, [begin, end]) {
  const columns = [];
  const times = new Set();
  for (const [component, { name, info }] of shown.description.value.components.entries()) {
    for (const [index, one] of info.entries()) {
      const samples = await request('series', { session: shown.id, component, info: index, from_us: begin, until_us: end, points: ROWS });
      const paths = new Set(samples.flatMap(([, value]) => numbers(value).map(([path]) => path)));
      if (paths.size === 0 || paths.size > NUMBERS) continue;
      for (const [time] of samples) times.add(time);
      const rows = samples.map(([time, value]) => [time, new Map(numbers(value))]);
      columns.push(...[...paths].map((path) => ({ title: `${name}.${one.name}${path}`, rows, path, at: -1 })));
    }
  }
  if (times.size > ROWS) {
    notify('error', `the span has ${times.size} rows`, `choose one with at most ${ROWS}`);
    return undefined;
  }
  const cell = (column, time) => {
    while (column.rows[column.at + 1]?.[0] <= time) column.at += 1;
    return column.rows[column.at]?.[1].get(column.path) ?? '';
  };
  const lines = [...times].sort((a, b) => a - b).map((time) => [time / 1e6, ...columns.map((column) => cell(column, time))].join(','));
  return [['time_s', ...columns.map(({ title }) => title)].join(','), ...lines].join('\n');
}
