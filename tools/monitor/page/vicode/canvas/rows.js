// The automatic places of states: rows that fill the shape of the panel. The corridors between them hold a lane for each transition.

import { columns, sortRows } from '../../panels/tree/places.js';
import { boxOf } from './boxes.js';
import { routed } from './routes.js';

/** What is drawn: all, names and conditions, names. */
export const [ALL, CONDITIONS, NAMES] = [1, 2, 3];
/** White between two states of a row, and the usual size of a state with its surroundings, by level, points. */
const GAP = { [ALL]: 70, [CONDITIONS]: 60, [NAMES]: 34 };
const CELL = { [ALL]: [260, 230], [CONDITIONS]: [220, 140], [NAMES]: [150, 86] };

/** Places of all states and courses of all arrows: {boxes: Map by name, courses: Map by key, area}. `shape` is width by height of the panel. */
export function arranged({ states, arrows }, level, shape) {
  const boxes = states.map((state) => {
    const box = boxOf(state, level);
    return { name: state.name, width: box.width, height: box.height, box };
  });
  const index = new Map(states.map(({ name }, at) => [name, at]));
  const links = states.map(() => []);
  for (const { from, to, any } of arrows) if (!any && from !== to) links[index.get(from)].push({ to: index.get(to) });
  const [wide, tall] = CELL[level];
  const usual = Math.max(1, Math.round(Math.sqrt(states.length * shape * (tall / wide))));
  const sequence = order(states, links);
  // The scale of a drawing in a panel of this shape.
  const scale = ({ area }) => Math.min(shape / area.width, 1 / area.height);
  const tries = states.length > FEW ? [usual] : [usual, usual + 1, usual + 2, usual - 1].filter((columns) => columns > 0);
  return tries.map((count) => placed(chunked(sequence, count), { arrows, boxes: boxes.map((box) => ({ ...box })), links }, level)).reduce((best, one) => (scale(one) > scale(best) ? one : best));
}

/** Number of states above which only one number of columns is tried. */
const FEW = 40;

function placed(rows, { arrows, boxes, links }, level) {
  const components = links.map((all) => ({ links: all }));
  sortRows(rows, components);
  const widths = boxes.map(({ width }) => width);
  const width = Math.max(0, ...rows.map((row) => row.reduce((sum, at) => sum + widths[at] + GAP[level], 0)));
  const x = columns(rows, components, widths, { width, gap: GAP[level] });
  rows.forEach((row, number) => row.forEach((at) => Object.assign(boxes[at], { row: number, x: x[at], y: 0 })));
  const named = new Map(boxes.map((box) => [box.name, box]));
  return { boxes: named, ...routed(arrows, { boxes: named, rows: rows.map((row) => row.map((at) => boxes[at])), width }, level) };
}

/** States by their distance from the initial one; those that it does not reach last. */
function order(states, links) {
  const initial = Math.max(0, states.findIndex((state) => state.initial));
  const found = new Set();
  for (const start of [initial, ...states.keys()]) {
    if (start >= states.length) continue;
    found.add(start);
    // A set that grows is gone through to its end.
    for (const at of found) links[at].forEach(({ to }) => found.add(to));
  }
  return [...found];
}

const chunked = (all, size) => Array.from({ length: Math.ceil(all.length / size) }, (_, at) => all.slice(at * size, (at + 1) * size));
