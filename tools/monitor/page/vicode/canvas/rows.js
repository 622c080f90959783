// The automatic places of states and courses of arrows: the server lays a machine out for the shape of the panel.

import { request } from '../../lib/connection.js';
import { boxOf } from './boxes.js';
import { labelWidth } from './labels.js';

/** What is drawn: all, names and conditions, names. */
export const [ALL, CONDITIONS, NAMES] = [1, 2, 3];
const LEVELS = [ALL, CONDITIONS, NAMES];

/** By machine and shape: {answer: promise, layouts: by level, once they are there}. */
const asked = new WeakMap();
const entry = (machine, shape) => asked.get(machine)?.get(shape);

/** Whether the server has laid a machine out for a shape. */
export const isLaidOut = (machine, shape) => Boolean(entry(machine, shape)?.layouts);

/** The layout of a machine, {boxes: Map by name, courses: Map by key, area}; null if the server has not sent it. */
export function layoutOf(machine, level, shape) {
  const layout = entry(machine, shape)?.layouts?.[level - ALL];
  // Boxes are moved while they are dragged.
  return layout ? { ...layout, boxes: new Map([...layout.boxes].map(([name, box]) => [name, { ...box }])), courses: new Map(layout.courses) } : null;
}

/** Asks for the layouts of a machine, once; `shape` is width by height of the panel. */
export function arrange(machine, shape) {
  if (!asked.has(machine)) asked.set(machine, new Map());
  const known = asked.get(machine);
  if (!known.has(shape)) {
    known.set(shape, { layouts: null, answer: laidOut(machine, shape) });
    known.get(shape).answer.then((layouts) => { known.get(shape).layouts = layouts; }, () => known.delete(shape));
  }
  return known.get(shape).answer;
}

async function laidOut({ states, arrows }, shape) {
  const index = new Map(states.map(({ name }, at) => [name, at]));
  const all = LEVELS.map((level) => states.map((state) => boxOf(state, level)));
  const drawing = {
    kind: 'machine',
    shape,
    initial: Math.max(0, states.findIndex(({ initial }) => initial)),
    looks: all.map((boxes) => boxes.map(({ width, height }) => [width, height])),
    arrows: arrows.map((arrow) => ({ name: arrow.name, from: arrow.any ? null : index.get(arrow.from), to: index.get(arrow.to), width: labelWidth(arrow) })),
  };
  const layouts = await request('arrange', { drawing });
  return layouts.map(({ boxes, courses, area }, look) => ({
    boxes: new Map(states.map(({ name }, at) => [name, { name, ...boxes[at], box: all[look][at] }])),
    courses: new Map(arrows.map(({ key, any }, at) => {
      const { owner, start, end, ...course } = courses[at];
      const ends = any ? { start: [start[0], course.label[1]] } : { start, end };
      return [key, { ...course, ...ends, anchor: 'middle', owner: arrows[owner].key }];
    })),
    area: { x: area.x - area.width / 2, y: area.y - area.height / 2, width: area.width, height: area.height },
  }));
}
