// Courses of links between the boxes of the tree: down through the gaps of rows, aside in the corridors between them. Components with
// the same children share one trunk, and so do the links of one component.

import { apart } from './places.js';

/** Cost of a part that another link of the trunk has taken, and of one more passage through a row, px. */
const [SHARED, PASSAGE] = [0.05, 14];
const [RADIUS, LANE] = [5, 4];
/** How far a course may lead away from both of its ends, px. */
const ASIDE = 260;

/** The path of each link, [{from, to}], in their order, and its trunk: [{d, trunk}]. */
export function wired(links, { boxes, rows, width }) {
  const gaps = rows.map((row) => gapsOf(row.map((index) => boxes[index]), width));
  const children = boxes.map(() => new Set());
  links.forEach(({ from, to }) => children[from].add(to));
  const trunkOf = (from) => [...children[from]].sort((a, b) => a - b).join();
  const trunks = new Map();
  const courses = new Map();
  // Short links first: long ones follow what is there.
  const order = [...links].sort((a, b) => boxes[a.to].row - boxes[a.from].row - (boxes[b.to].row - boxes[b.from].row));
  for (const { from, to } of order) {
    const key = `${from} ${to}`;
    // A link upward, which only a description with a circle has, is not drawn.
    if (courses.has(key) || boxes[to].row <= boxes[from].row) continue;
    const name = trunkOf(from);
    if (!trunks.has(name)) trunks.set(name, { number: trunks.size, passes: rows.map(() => []), spans: rows.map(() => []) });
    const trunk = trunks.get(name);
    const xs = courseOf(boxes[from], boxes[to], gaps, trunk);
    courses.set(key, { trunk, from, to, xs });
  }
  spreadPasses([...courses.values()], gaps, ({ from }) => boxes[from].row);
  const lanes = lanesOf([...courses.values()], boxes);
  const [edge, half] = [(row) => boxes[rows[row][0]].y, boxes[0].height / 2];
  const level = (corridor, trunk) => {
    const [top, bottom] = [edge(corridor) + half, edge(corridor + 1) - half];
    const { lane, count } = lanes.get(`${corridor} ${trunk.number}`);
    return top + ((lane + 1) / (count + 1)) * (bottom - top);
  };
  return links.map(({ from, to }) => {
    if (!courses.has(`${from} ${to}`)) return { d: '', trunk: -1 };
    const { trunk, xs } = courses.get(`${from} ${to}`);
    const points = [[xs[0], boxes[from].y + half]];
    xs.slice(1).forEach((x, at) => {
      const y = level(boxes[from].row + at, trunk);
      points.push([xs[at], y], [x, y]);
    });
    points.push([xs.at(-1), boxes[to].y - half]);
    return { d: rounded(points), trunk: trunk.number };
  });
}

/** The free intervals of a row. */
export function gapsOf(row, width, left = 2) {
  const sorted = [...row].sort((a, b) => a.x - b.x);
  const ends = [left, ...sorted.flatMap((box) => [box.x - box.width / 2 - 3, box.x + box.width / 2 + 3]), width - 2];
  return ends.flatMap((end, at) => (at % 2 === 0 && ends[at + 1] - end > 1 ? [[end, ends[at + 1]]] : []));
}

/** The cheapest course: x at the parent, in each row that is passed, and at the child. */
export function courseOf(from, to, gaps, trunk) {
  const [low, high] = [Math.min(from.x, to.x) - ASIDE, Math.max(from.x, to.x) + ASIDE];
  let layer = [{ x: from.x, cost: 0, before: null }];
  const step = (x, row, extra) => {
    let best = null;
    for (const one of layer) {
      const cost = one.cost + extra + aside(one.x, x, trunk.spans[row - 1]);
      if (!best || cost < best.cost) best = { x, cost, before: one };
    }
    return best;
  };
  for (let row = from.row + 1; row < to.row; row += 1) {
    const near = gaps[row].filter((gap) => gap[1] >= low && gap[0] <= high);
    const fresh = (near.length > 0 ? near : gaps[row]).flatMap((gap) => {
      const straight = [from.x, to.x].filter((x) => x >= gap[0] && x <= gap[1]);
      return straight.length > 0 ? straight : [(gap[0] + gap[1]) / 2];
    });
    const taken = trunk.passes[row];
    layer = [...new Set([...fresh, ...taken])].map((x) => step(x, row, taken.includes(x) ? 0 : PASSAGE));
  }
  const xs = [];
  for (let at = step(to.x, to.row, 0); at; at = at.before) xs.unshift(at.x);
  xs.slice(1).forEach((x, at) => trunk.spans[from.row + at].push([Math.min(xs[at], x), Math.max(xs[at], x)]));
  xs.slice(1, -1).forEach((x, at) => trunk.passes[from.row + 1 + at].push(x));
  return xs;
}

/** Cost of a way along a corridor, of which the trunk has taken some. */
function aside(a, b, spans) {
  const [low, high] = [Math.min(a, b), Math.max(a, b)];
  const shared = spans.reduce((most, [left, right]) => Math.max(most, Math.min(high, right) - Math.max(low, left)), 0);
  return high - low - (1 - SHARED) * shared;
}

/** Moves the passages of different trunks through one gap apart. */
export function spreadPasses(courses, gaps, rowOf, lane = LANE) {
  gaps.forEach((row, number) => row.forEach((gap) => {
    const passes = new Map();
    for (const course of courses) {
      const at = number - rowOf(course);
      const x = course.xs[at];
      if (at <= 0 || at >= course.xs.length - 1 || x < gap[0] || x > gap[1]) continue;
      const key = `${course.trunk.number} ${x}`;
      if (!passes.has(key)) passes.set(key, { x, all: [] });
      passes.get(key).all.push([course, at]);
    }
    const sorted = [...passes.values()].sort((a, b) => a.x - b.x);
    const distance = Math.min(lane, (gap[1] - gap[0]) / Math.max(sorted.length - 1, 1));
    const places = apart(sorted.map(({ x }) => x), sorted.map(() => 0), ...gap, distance);
    sorted.forEach(({ all }, at) => all.forEach(([course, place]) => { course.xs[place] = places[at]; }));
  }));
}

/** A height for each trunk in each corridor: trunks that meet there have different ones. */
function lanesOf(courses, boxes) {
  const spans = new Map();
  for (const { trunk, from, xs } of courses) {
    xs.slice(1).forEach((x, at) => {
      const key = `${boxes[from].row + at} ${trunk.number}`;
      const known = spans.get(key) ?? spans.set(key, { corridor: boxes[from].row + at, low: Infinity, high: -Infinity }).get(key);
      known.low = Math.min(known.low, xs[at], x);
      known.high = Math.max(known.high, xs[at], x);
    });
  }
  for (const all of Map.groupBy(spans.values(), ({ corridor }) => corridor).values()) {
    const ends = [];
    for (const span of all.sort((a, b) => a.low - b.low)) {
      const free = ends.findIndex((end) => end < span.low - LANE);
      span.lane = free < 0 ? ends.length : free;
      ends[span.lane] = span.high;
    }
    for (const span of all) span.count = ends.length;
  }
  return spans;
}

/** A path through points, with round corners. */
export function rounded(points) {
  const way = points.filter(([x, y], at) => at === 0 || Math.hypot(x - points[at - 1][0], y - points[at - 1][1]) > 0.01);
  const toward = ([x, y], [tx, ty], most) => {
    const length = Math.hypot(tx - x, ty - y);
    const part = Math.min(most, length / 2) / length;
    return [x + (tx - x) * part, y + (ty - y) * part];
  };
  const text = ([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`;
  const bends = way.slice(1, -1).map((corner, at) => `L${text(toward(corner, way[at], RADIUS))}Q${text(corner)} ${text(toward(corner, way[at + 2], RADIUS))}`);
  return `M${text(way[0])}${bends.join('')}L${text(way.at(-1))}`;
}
