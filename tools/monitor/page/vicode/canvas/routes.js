// Courses of transitions between rows of states: each has a lane of its own where it goes aside, with its name on it. So no line runs
// through a state, and no name covers a name or a state.

import { courseOf, gapsOf, rounded, spreadPasses } from '../../panels/tree/wires.js';
import { labelWidth } from './labels.js';

/** Height of a lane and distance of lines in a gap, by level, points. */
const LANE = { 1: 32, 2: 18, 3: 8 };
const APART = { 1: 10, 2: 9, 3: 6 };
/** White above the first and below the last lane, by level; of a corridor without any. */
const ABOVE = { 1: 16, 2: 11, 3: 16 };
const [EMPTY, BESIDE] = [34, 12];
/** Room at the left for the mark of the initial state. */
const INITIAL = 44;
/** Distance of two ends at a side of a state, and the room that an arrow head needs. */
const [PORT, TIP] = [18, 7];
/** Least width that is kept for what is written below a name. */
const LIVE = 96;
/** Largest distance of two lines between which no name stands. */
const NEAR = 40;
/** Room outside of all states, for lines. */
const OUTSIDE = 90;

/** The courses by key of the arrow, {d, label, anchor, start, end, owner: the arrow that has the name of the bundle}, and the area of all; writes the heights of the states. */
export function routed(arrows, { boxes, rows, width }, level) {
  const ways = arrows.map((arrow) => wayOf(arrow, boxes));
  const bundles = Map.groupBy(ways, ({ arrow }) => bundleOf(arrow));
  [...bundles.values()].forEach((all, number) => {
    const trunk = { number, passes: rows.map(() => []), spans: Array.from({ length: rows.length + 1 }, () => []) };
    all.forEach((way) => Object.assign(way, { trunk, all }));
  });
  placePorts(ways, boxes);
  const gaps = rows.map((row) => gapsOf(row, width + OUTSIDE, -OUTSIDE));
  for (const way of ways) way.xs = passing(way, gaps);
  spreadPasses(ways.filter(({ xs }) => xs.length > 2), gaps, ({ upper }) => upper.row, APART[level]);
  const { lanes, named } = lanesOf(bundles, level);
  const tops = heights(rows, lanes, level);
  const y = (corridor, lane) => tops[corridor] + ABOVE[level] + (lane + 0.5) * LANE[level];
  const all = [...lanes.values()];
  const [left, right] = [Math.min(0, ...all.map(({ low }) => low)) - INITIAL, Math.max(width, ...all.map(({ high }) => high)) + BESIDE];
  return { courses: new Map(ways.map((way) => [way.arrow.key, courseFor(way, { lanes, named, y })])), area: { x: left, y: 0, width: right - left, height: tops.at(-1) + Math.max(EMPTY, ABOVE[level] * 2 + LANE[level] * Math.max(0, ...all.filter(({ corridor }) => corridor === rows.length).map(({ count }) => count))) } };
}

/** What is one bundle: transitions of one name from different states to one state. */
const bundleOf = (arrow) => (arrow.any || arrow.from === arrow.to ? arrow.key : `${arrow.name}>${arrow.to}`);

/** The upper and the lower state of an arrow, and the corridors through which it goes; corridor n is above row n. */
function wayOf(arrow, boxes) {
  const [from, to] = [boxes.get(arrow.from), boxes.get(arrow.to)];
  if (arrow.any) return { arrow, upper: null, lower: to, first: to.row, down: true };
  if (from.row === to.row) {
    const above = from !== to && from.x < to.x;
    return { arrow, upper: from, lower: to, first: from.row + (above ? 0 : 1), same: above ? 'above' : 'below', down: true };
  }
  const down = from.row < to.row;
  const [upper, lower] = down ? [from, to] : [to, from];
  return { arrow, upper, lower, first: upper.row + 1, down };
}

/** Gives each end a place at its side of the state, in the order of the other ends. Ends of a bundle at one state are one. */
function placePorts(ways, boxes) {
  const sides = new Map([...boxes.values()].flatMap((box) => [[`${box.name} top`, { box, ends: new Map() }], [`${box.name} bottom`, { box, ends: new Map() }]]));
  const add = (way, box, side, other, end) => {
    const { ends } = sides.get(`${box.name} ${side}`);
    const key = `${way.trunk.number} ${end === (way.down ? 'lower' : 'upper') ? 'in' : way.arrow.key}`;
    if (!ends.has(key)) ends.set(key, { x: other, all: [] });
    ends.get(key).all.push([way, end]);
  };
  for (const way of ways) {
    const { upper, lower, same } = way;
    if (!upper) add(way, lower, 'top', lower.x + lower.width, 'lower');
    else {
      add(way, upper, same === 'above' ? 'top' : 'bottom', upper === lower ? upper.x + upper.width : lower.x, 'upper');
      add(way, lower, same === 'below' ? 'bottom' : 'top', upper.x, 'lower');
    }
  }
  for (const { box, ends } of sides.values()) {
    const sorted = [...ends.values()].sort((a, b) => a.x - b.x);
    const distance = Math.min(PORT, (box.width - 16) / Math.max(sorted.length - 1, 1));
    sorted.forEach(({ all }, at) => all.forEach(([way, end]) => { way[`${end}X`] = box.x + (at - (sorted.length - 1) / 2) * distance; }));
  }
}

function passing({ upper, lower, upperX, lowerX, same, trunk }, gaps) {
  if (!upper) return [lowerX];
  if (same) return [upperX, lowerX];
  return courseOf({ x: upperX, row: upper.row }, { x: lowerX, row: lower.row }, gaps, trunk);
}

/** A lane in each corridor for each bundle, `lanes` by `corridor bundle`, and the lane that has its name, `named` by bundle: {corridor, lane, count, label}. */
function lanesOf(bundles, level) {
  const slots = [];
  const named = new Map();
  const ups = level < 3 && uprights([...bundles.values()].flat());
  for (const [name, all] of bundles) {
    const own = new Map();
    for (const { xs, first } of all) {
      const parts = xs.length === 1 ? [[xs[0], xs[0]]] : xs.slice(1).map((x, at) => [xs[at], x]);
      parts.forEach((part, at) => {
        const slot = own.get(first + at) ?? own.set(first + at, { corridor: first + at, name, low: Infinity, high: -Infinity, label: 0 }).get(first + at);
        slot.low = Math.min(slot.low, ...part);
        slot.high = Math.max(slot.high, ...part);
      });
    }
    const longest = [...own.values()].reduce((best, slot) => (slot.high - slot.low > best.high - best.low ? slot : best));
    const middle = (longest.low + longest.high) / 2;
    longest.label = middle;
    if (level < 3) {
      const own = labelWidth(all[0].arrow) / 2;
      const half = Math.max(own, level === 1 ? LIVE / 2 : 0);
      if (all[0].upper) aside(longest, [half, own], ups.get(longest.corridor), all[0].upper === all[0].lower);
      [longest.low, longest.high] = [Math.min(longest.low, longest.label - half), Math.max(longest.high, longest.label + half)];
    }
    named.set(name, longest);
    slots.push(...own.values());
  }
  const lanes = new Map(slots.map((slot) => [`${slot.corridor} ${slot.name}`, slot]));
  for (const all of Map.groupBy(slots, ({ corridor }) => corridor).values()) {
    const ends = [];
    for (const slot of all.sort((a, b) => a.low - b.low)) {
      const free = ends.findIndex((end) => end < slot.low - BESIDE);
      slot.lane = free < 0 ? ends.length : free;
      ends[slot.lane] = slot.high;
    }
    for (const slot of all) slot.count = ends.length;
  }
  return { lanes, named };
}

/** Where lines go up and down in each corridor, from left to right. */
function uprights(ways) {
  const found = new Map();
  for (const { xs, first } of ways) {
    for (let at = 0; at < Math.max(1, xs.length - 1); at += 1) found.set(first + at, found.get(first + at) ?? []).get(first + at).push(...xs.slice(at, at + 2));
  }
  found.forEach((all) => all.sort((a, b) => a - b));
  return found;
}

/** A name that is wider than its part of the lane, and would cover lines of others or its own loop, stands beside all of them, with a line to it. */
function aside(slot, [half, own], ups, isLoop) {
  const { low, high, label: middle } = slot;
  const covered = ups.some((x) => Math.abs(x - middle) < half && (x < low || x > high));
  if (high - low >= 2 * half || !(covered || isLoop)) return;
  const end = (from, step, sorted) => sorted.reduce((x, next) => ((next - x) * step > 0 && (next - x) * step < NEAR ? next : x), from);
  const [left, right] = [end(low, -1, ups.toReversed()), end(high, 1, ups)];
  const toRight = right - high <= low - left;
  slot.label = toRight ? right + BESIDE + half : left - BESIDE - half;
  slot.leader = toRight ? [high, slot.label - own] : [low, slot.label + own];
}

/** Puts the rows below each other, and returns the upper edge of each corridor. */
function heights(rows, lanes, level) {
  const counts = new Array(rows.length + 1).fill(0);
  for (const { corridor, count } of lanes.values()) counts[corridor] = count;
  const tops = [];
  let y = 0;
  counts.forEach((count, corridor) => {
    tops.push(y);
    y += count > 0 ? count * LANE[level] + 2 * ABOVE[level] : EMPTY;
    const row = rows[corridor] ?? [];
    const tallest = Math.max(0, ...row.map(({ height }) => height));
    for (const box of row) box.y = y + tallest / 2;
    y += tallest;
  });
  return tops;
}

function courseFor(way, { lanes, named, y }) {
  const { arrow, all, upper, lower, xs, first, down, same } = way;
  const bundle = bundleOf(arrow);
  const laneY = (corridor) => y(corridor, lanes.get(`${corridor} ${bundle}`).lane);
  const { label: middle, corridor, leader } = named.get(bundle);
  const label = [middle, laneY(corridor)];
  const owner = all[0].arrow.key;
  if (!upper) {
    const top = lower.y - lower.height / 2;
    return { d: `M${xs[0].toFixed(1)} ${(label[1] + 8).toFixed(1)}L${xs[0].toFixed(1)} ${(top - TIP).toFixed(1)}`, label, anchor: 'middle', start: [xs[0], label[1]], owner };
  }
  const edge = (box, below, tip) => box.y + (below ? 1 : -1) * (box.height / 2 + (tip ? TIP : 1));
  const begin = edge(upper, same !== 'above', !down);
  const end = edge(lower, same === 'below', down);
  const points = [[xs[0], begin]];
  xs.slice(1).forEach((x, at) => points.push([xs[at], laneY(first + at)], [x, laneY(first + at)]));
  points.push([xs.at(-1), end]);
  if (!down) points.reverse();
  const branch = leader && arrow.key === owner ? `M${leader[0].toFixed(1)} ${label[1].toFixed(1)}L${leader[1].toFixed(1)} ${label[1].toFixed(1)}` : '';
  return { d: branch + rounded(points), label, anchor: 'middle', start: points[0], end: points.at(-1), owner };
}
