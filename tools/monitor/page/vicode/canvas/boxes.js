// Sizes of what is drawn of a state, in points of the drawing.

export const WIDTH = 184;
const [HEAD, DOCS, HOOK, ROW, END] = [30, 15, 16, 25, 8];
const [PAD, GAP, CHIP] = [10, 5, 20];

const measure = document.createElement('canvas').getContext('2d');
const known = new Map();

/** Width of a text at a size of letters. */
export function widthOf(text, size = 11) {
  const key = `${size}${text}`;
  let width = known.get(key);
  if (width === undefined) {
    measure.font = `${size}px Inter, "Segoe UI", system-ui, "DejaVu Sans", sans-serif`;
    known.set(key, (width = measure.measureText(text).width));
  }
  return width;
}

/** A text that is cut at a width. */
export function cut(text, width, size = 11) {
  if (widthOf(text, size) <= width) return text;
  let length = text.length;
  while (length > 1 && widthOf(`${text.slice(0, length)}…`, size) > width) length -= Math.max(1, length >> 4);
  return `${text.slice(0, length).trimEnd()}…`;
}

/** Room for the time of the state that runs, or for the number of visits, beside the name, by level. */
const LIVE = { 2: 56, 3: 54 };

/** The parts of a state's box: {width, height, takes, docs: y, hooks: [{y, …}], chips: [{x, y, width, …}]}. Above the first level it has a name only. */
export function boxOf(state, level = 1) {
  if (level > 1) return { docs: null, takes: '', hooks: [], chips: [], width: widthOf(state.name, 13) * 1.08 + 34 + LIVE[level], height: 28 };
  let y = HEAD;
  const docs = state.docs.split('\n')[0];
  const takes = state.takes ? cut(` ← ${state.takes}`, WIDTH - 24 - PAD - (state.initial || state.last ? 34 : 0) - widthOf(state.name, 13) * 1.08, 11) : '';
  const box = { takes, docs: docs ? { y: y + 7, text: cut(docs, WIDTH - 2 * PAD, 11) } : null, hooks: [], chips: [] };
  if (docs) y += DOCS;
  for (const line of [...state.hooks.map(({ role, name }) => `${role} / ${name}`), ...state.asks.map((one) => `? ${one}`)]) {
    box.hooks.push({ y: y + 9, text: cut(line, WIDTH - 2 * PAD, 11) });
    y += HOOK;
  }
  let x = PAD;
  if (state.children.length > 0) y += 4;
  for (const child of state.children) {
    const text = cut(child.child, WIDTH - 2 * PAD - 18, 11);
    const width = Math.min(WIDTH - 2 * PAD, widthOf(text, 11) + 18);
    if (x > PAD && x + width > WIDTH - PAD) {
      x = PAD;
      y += ROW;
    }
    box.chips.push({ ...child, text, x, y, width, height: CHIP });
    x += width + GAP;
  }
  if (state.children.length > 0) y += CHIP;
  return { ...box, width: WIDTH, height: Math.max(46, y + END) };
}

export const boxRect = ({ x, y, width, height }) => ({ left: x - width / 2, right: x + width / 2, top: y - height / 2, bottom: y + height / 2 });
/** The area that two rectangles share. */
export const overlap = (a, b) => Math.max(0, Math.min(a.right, b.right) - Math.max(a.left, b.left)) * Math.max(0, Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));

/** Smallest rectangle around boxes {x, y, height} with centres; with a margin. */
export function bounds(boxes, margin = 52) {
  if (boxes.length === 0) return { x: -200, y: -120, width: 400, height: 240 };
  const left = Math.min(...boxes.map(({ x, width }) => x - width / 2)) - margin;
  const right = Math.max(...boxes.map(({ x, width }) => x + width / 2)) + margin;
  const top = Math.min(...boxes.map(({ y, height }) => y - height / 2)) - margin;
  const bottom = Math.max(...boxes.map(({ y, height }) => y + height / 2)) + margin;
  return { x: left, y: top, width: right - left, height: bottom - top };
}
