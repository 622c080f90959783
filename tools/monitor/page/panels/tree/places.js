// Places of the components in the panel: rows by the longest path from the root, which share the panel's height.

/** White around all, usual and least distance of two boxes of a row, and of two rows, px. */
const [MARGIN, GAP, LEAST, CORRIDOR] = [8, 14, 5, 9];
/** Largest distance of two boxes of the longest row, and of two rows, px: the boxes of a small tree stay together. */
const [FAR, DISTANT] = [110, 64];
/** Least scale at which the names of a tree can be read. */
export const READABLE = 0.96;
/** Passes over the rows that sort them; each goes down, then up. */
const SWEEPS = 8;

/**
 * Places boxes of given widths: {boxes: [{x, y, width, height, row}], rows: [[index]], width, height}; x and y are the centre. `height` of a
 * box is at most `tall`. The drawing is as large as the panel, and larger if its boxes need more.
 */
export function placed(components, widths, [panelWidth, panelHeight], { low, tall }) {
  const deep = rowsOf(components, widths);
  sortRows(deep, components);
  // Names can be read: a row that is wider than the panel becomes several. What is higher than the panel is moved.
  const fits = deep.every((row) => (lengthOf(row, widths) + 2 * MARGIN) * READABLE <= panelWidth);
  const rows = fits ? deep : broken(deep, widths, panelWidth - 2 * MARGIN);
  const lengths = [LEAST, FAR].map((gap) => Math.max(...rows.map((row) => lengthOf(row, widths, gap))) + 2 * MARGIN);
  const width = Math.max(panelWidth, lengths[0]);
  const height = Math.max(panelHeight, rows.length * (low + CORRIDOR) - CORRIDOR + 2 * MARGIN);
  const pitch = (height - 2 * MARGIN) / rows.length;
  const boxHeight = Math.max(low, Math.min(tall, pitch - 3 * CORRIDOR));
  const step = rows.length > 1 ? Math.min((height - 2 * MARGIN - boxHeight) / (rows.length - 1), boxHeight + DISTANT) : 0;
  const x = columns(rows, components, widths, { width: Math.min(width, lengths[1]), gap: GAP });
  const [left, top] = [Math.max(0, width - lengths[1]) / 2, (height - (rows.length - 1) * step) / 2];
  const boxes = components.map((_, index) => ({ x: left + x[index], width: widths[index], height: boxHeight }));
  rows.forEach((row, number) => row.forEach((index) => Object.assign(boxes[index], { row: number, y: top + number * step })));
  return { boxes, rows, width, height };
}

/** The length of a row with a distance of its boxes. */
const lengthOf = (row, widths, gap = LEAST) => row.reduce((sum, index) => sum + widths[index] + gap, -gap);

/** The rows, broken where they are longer than the room; no link joins two boxes of one row. */
const broken = (rows, widths, room) => rows.flatMap((row) => row.reduce((parts, index) => {
  const part = parts.at(-1);
  if (part.length > 0 && lengthOf([...part, index], widths) > room) parts.push([index]);
  else part.push(index);
  return parts;
}, [[]]));

const targets = ({ links }) => [...new Set(links.map(({ to }) => to))];

/** The depth of each component: the length of the longest path to it, from one without a parent. */
function depths(count, next) {
  const depth = new Array(count).fill(0);
  // A path has no more parts than there are components, also if a description has a circle.
  for (let pass = 0, changed = true; changed && pass < count; pass += 1) {
    changed = false;
    for (let from = 0; from < count; from += 1) {
      for (const to of next(from)) {
        if (depth[to] <= depth[from] && depth[from] + 1 < count) [depth[to], changed] = [depth[from] + 1, true];
      }
    }
  }
  return depth;
}

/** Rows of indices. A component that may stand in several rows goes to the one with most room. */
function rowsOf(components, widths) {
  const count = components.length;
  const children = components.map(targets);
  const parents = components.map(() => []);
  children.forEach((all, from) => all.forEach((to) => parents[to].push(from)));
  const first = depths(count, (from) => children[from]);
  const below = depths(count, (from) => parents[from]);
  const rows = Array.from({ length: Math.max(...first) + 1 }, () => []);
  const used = rows.map(() => 0);
  const row = new Array(count);
  const put = (index, at) => {
    row[index] = at;
    rows[at].push(index);
    used[at] += widths[index] + GAP;
  };
  const last = (index) => rows.length - 1 - below[index];
  const order = [...components.keys()].sort((a, b) => first[a] - first[b]);
  order.filter((index) => first[index] >= last(index)).forEach((index) => put(index, first[index]));
  for (const index of order.filter((one) => row[one] === undefined)) {
    const from = Math.max(first[index], ...parents[index].map((one) => (row[one] ?? -1) + 1));
    let best = from;
    for (let at = from; at <= last(index); at += 1) if (used[at] < used[best]) best = at;
    put(index, best);
  }
  return rows;
}

/** Sorts each row by the mean place of the neighbours, so that few links cross. */
export function sortRows(rows, components) {
  const near = components.map((component) => targets(component));
  components.forEach((component, from) => targets(component).forEach((to) => near[to].push(from)));
  const place = new Array(components.length);
  const number = (row) => row.forEach((index, at) => { place[index] = (at + 0.5) / row.length; });
  rows.forEach(number);
  const mean = (index) => near[index].reduce((sum, one) => sum + place[one], 0) / Math.max(near[index].length, 1);
  for (let sweep = 0; sweep < SWEEPS; sweep += 1) {
    for (const row of sweep % 2 === 0 ? rows : rows.toReversed()) {
      const wanted = new Map(row.map((index) => [index, near[index].length > 0 ? mean(index) : place[index]]));
      row.sort((a, b) => wanted.get(a) - wanted.get(b));
      number(row);
    }
  }
}

/** The middles of all boxes: near those of their neighbours, and spread over the width. Boxes of a row have the gap between them, if there is room. */
export function columns(rows, components, widths, { width, gap }) {
  const near = components.map((component) => targets(component));
  components.forEach((component, from) => targets(component).forEach((to) => near[to].push(from)));
  const x = new Array(components.length).fill(width / 2);
  const [left, right] = [MARGIN, width - MARGIN];
  for (let sweep = 0; sweep < SWEEPS; sweep += 1) {
    for (const row of sweep % 2 === 0 ? rows : rows.toReversed()) {
      const even = (at) => left + ((at + 0.5) / row.length) * (right - left);
      const wanted = row.map((index, at) => (even(at) + near[index].reduce((sum, one) => sum + x[one], 0)) / (near[index].length + 1));
      const own = row.map((index) => widths[index]);
      const spare = (right - left - own.reduce((sum, one) => sum + one)) / Math.max(row.length - 1, 1);
      apart(wanted, own, left, right, Math.min(gap, spare)).forEach((place, at) => { x[row[at]] = place; });
    }
  }
  return stretched(x, widths, left, right);
}

/** Moves boxes apart so that they fill the width. */
function stretched(x, widths, left, right) {
  const [edge, end] = [(at) => x[at] - widths[at] / 2, (at) => x[at] + widths[at] / 2];
  const all = [...x.keys()];
  const first = all.reduce((best, at) => (edge(at) < edge(best) ? at : best), 0);
  const last = all.reduce((best, at) => (end(at) > end(best) ? at : best), 0);
  const begin = left + widths[first] / 2;
  const factor = x[last] > x[first] ? (right - widths[last] / 2 - begin) / (x[last] - x[first]) : 1;
  return x.map((place, at) => Math.max(left + widths[at] / 2, Math.min(begin + (place - x[first]) * factor, right - widths[at] / 2)));
}

/** The places next to the wanted ones at which boxes of a row do not touch: neighbours that would are moved together. */
export function apart(wanted, widths, left, right, gap) {
  const offsets = [];
  widths.reduce((sum, width, at) => {
    offsets.push(sum + width / 2);
    return sum + width + gap;
  }, 0);
  const room = right - (offsets.at(-1) ?? 0) - (widths.at(-1) ?? 0) / 2;
  const groups = [];
  wanted.forEach((place, at) => {
    groups.push({ sum: place - offsets[at], count: 1 });
    while (groups.length > 1 && groups.at(-2).sum / groups.at(-2).count > groups.at(-1).sum / groups.at(-1).count) {
      const { sum, count } = groups.pop();
      groups.at(-1).sum += sum;
      groups.at(-1).count += count;
    }
  });
  const starts = groups.flatMap(({ sum, count }) => new Array(count).fill(Math.max(left, Math.min(sum / count, room))));
  return starts.map((start, at) => start + offsets[at]);
}
