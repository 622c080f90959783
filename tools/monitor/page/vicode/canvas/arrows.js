// Courses of transitions: curves between boxes that stay apart from each other and do not run through other boxes.

/** Distance of neighbouring curves between the same states, points. */
const APART = 46;
const LOOP = 30;
/** Places on a curve where its name may stand, the best first, and their distances below it, points. */
const ALONG = [0.5, 0.42, 0.58, 0.34, 0.66, 0.27, 0.73, 0.2, 0.8, 0.14, 0.86];
const BELOW = [0, -12, 12, -24, 24, -36, 36];

/** Groups of arrows between the same two states, whatever their direction. */
export function lanes(arrows) {
  const groups = new Map();
  for (const arrow of arrows) {
    const pair = arrow.any ? `*>${arrow.to}` : arrow.from === arrow.to ? `=${arrow.to}` : [arrow.from, arrow.to].sort().join('>');
    if (!groups.has(pair)) groups.set(pair, []);
    groups.get(pair).push(arrow);
  }
  const found = new Map();
  for (const group of groups.values()) {
    const there = group.filter((arrow) => arrow.from === group[0].from);
    const back = group.filter((arrow) => arrow.from !== group[0].from);
    const put = (side) => side.forEach((arrow, index) => found.set(arrow.key, { index, count: side.length, other: group.length - side.length }));
    put(there);
    put(back);
  }
  return found;
}

/** Where a line from the centre of a box to a point leaves it. */
function border({ x, y, width, height }, [px, py], gap = 0) {
  const [dx, dy] = [px - x, py - y];
  if (dx === 0 && dy === 0) return [x + width / 2, y];
  const [halfX, halfY] = [width / 2 + gap, height / 2 + gap];
  const scale = Math.min(halfX / Math.abs(dx || 1e-9), halfY / Math.abs(dy || 1e-9));
  return [x + dx * scale, y + dy * scale];
}

const at = (a, c, b, t) => [(1 - t) ** 2 * a[0] + 2 * t * (1 - t) * c[0] + t * t * b[0], (1 - t) ** 2 * a[1] + 2 * t * (1 - t) * c[1] + t * t * b[1]];

/** Where the name of a course may stand, the best first. */
export const placesOf = ({ start, control, end, label, others = [] }) => (!control ? [label, ...others] : BELOW.flatMap((below) => ALONG.map((t) => {
  const [x, y] = at(start, control, end, t);
  return [x, y + below];
})));

/** How many points of a curve lie in boxes that it does not join. */
function hits(a, c, b, boxes, from, to) {
  let count = 0;
  let points = null;
  // A curve stays within its three points.
  const [left, right] = [Math.min(a[0], c[0], b[0]) - 6, Math.max(a[0], c[0], b[0]) + 6];
  const [top, bottom] = [Math.min(a[1], c[1], b[1]) - 6, Math.max(a[1], c[1], b[1]) + 6];
  for (const box of boxes) {
    if (box === from || box === to) continue;
    if (box.x + box.width / 2 < left || box.x - box.width / 2 > right || box.y + box.height / 2 < top || box.y - box.height / 2 > bottom) continue;
    points ??= Array.from({ length: 11 }, (_, index) => at(a, c, b, (index + 1) / 12));
    for (const [x, y] of points) {
      if (Math.abs(x - box.x) < box.width / 2 + 6 && Math.abs(y - box.y) < box.height / 2 + 6) count += 1;
    }
  }
  return count;
}

const round = (value) => Math.round(value * 10) / 10;
const path = (a, c, b) => `M${round(a[0])} ${round(a[1])}Q${round(c[0])} ${round(c[1])} ${round(b[0])} ${round(b[1])}`;

function curve(from, to, bend, boxes) {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const length = Math.hypot(dx, dy) || 1;
  // To the right of the way, so that there and back are two curves.
  const c = [from.x + dx / 2 - (dy / length) * bend * 2, from.y + dy / 2 + (dx / length) * bend * 2];
  const [a, b] = [border(from, c, 1), border(to, c, 7)];
  return { a, b, c, hits: hits(a, c, b, boxes, from, to) };
}

/**
 * The course of an arrow: {d, label: [x, y], anchor, tip, angle}. `boxes` are all boxes, `box` finds one by its name. Curves through
 * boxes are bent more, as far as that helps.
 */
export function courseOf(arrow, lane, box, boxes) {
  const to = box(arrow.to);
  if (arrow.any) {
    const x = to.x + to.width / 2 - 26 - lane.index * 26;
    const top = to.y - to.height / 2;
    const rise = 30 + lane.index * 27;
    return { d: `M${round(x)} ${round(top - rise)}L${round(x)} ${round(top - 7)}`, label: [x + 6, top - rise - 5], others: [-70, 70].flatMap((aside) => [[x + aside, top - rise], [x + aside, top - rise - 20]]), anchor: 'middle', start: [x, top - rise] };
  }
  if (arrow.from === arrow.to) {
    const [x, y] = [to.x + to.width / 2, to.y];
    const reach = LOOP + lane.index * 26;
    const half = 9 + lane.index * 6;
    return { d: `M${x + 1} ${y - half}C${x + reach * 1.4} ${y - half - 12} ${x + reach * 1.4} ${y + half + 12} ${x + 7} ${y + half}`, label: [x + reach + 8, y - 2 + lane.index * 30], others: [-23, 12].map((away) => [x - 20, y + Math.sign(away) * to.height / 2 + away]), anchor: 'start', start: [x, y - half] };
  }
  const from = box(arrow.from);
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const own = lane.other > 0 || lane.count > 1;
  const first = (own ? 16 + length * 0.05 : 0) + lane.index * APART;
  const tries = [first, first + 40, first + 80, -first - 44, first + 130, -first - 90, first + 190];
  let best = null;
  for (const bend of tries) {
    const found = curve(from, to, bend, boxes);
    if (!best || found.hits < best.hits) best = found;
    if (best.hits === 0) break;
  }
  const { a, b, c } = best;
  return { d: path(a, c, b), anchor: 'middle', start: a, control: c, end: b };
}

/** A curve from a box to a free point, while a transition is drawn. */
export function courseTo(from, point, target) {
  const a = border(from, point, 1);
  const end = target ? border(target, [from.x, from.y], 7) : point;
  return `M${round(a[0])} ${round(a[1])}L${round(end[0])} ${round(end[1])}`;
}
