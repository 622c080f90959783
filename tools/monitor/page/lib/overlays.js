// What components found in an image: outputs of the image's visual types, drawn on the picture.

import { colourOf, flat, visuals } from './frames.js';
import { css, curveColour } from './theme.js';

/** The outputs of a tree that can be drawn on an image, by component: [{component, place, infos, colour}]. */
export function drawable(description) {
  const found = new Map();
  for (const { component, name, info, index } of visuals(description, true)) {
    if (!SHAPES[info.shape]) continue;
    if (!found.has(component)) found.set(component, { component: name, place: component, infos: [], colour: curveColour(colourOf(description, component)) });
    found.get(component).infos.push({ ...info, index });
  }
  return [...found.values()];
}

/** Least height of an image with names, px; the colours of a smaller one are in the menu Findings. */
const NAMED = 200;

/** Longest time from the cycle that takes an image in to the last component that has used it, µs. */
const USED = 33e3;

/** Reads the values that belong to an image: the last ones before the next image. */
function valueAt(shown, place, index, time, live) {
  const output = shown.output(place, index);
  return live ? output.at(time) : output.now.value?.value;
}

/** Each shape as its lines, [{x, y}], and its circles; `label` is where its name stands, none without one. */
const SHAPES = {
  ImagePoint: (at) => ({ dots: [at], label: at }),
  ImageCircle: (at) => ({ circles: [at], label: at }),
  ImageSegment: ({ start, end }) => ({ line: [start, end], dots: [start], label: start }),
  ImagePolyline: ({ points }) => ({ line: points, label: points.at(0) }),
};

/** Draws one component's findings. `at` maps columns and rows to the panel; `taken` are the places of earlier names. */
export function drawOverlay(context, shown, overlay, image, { at, live, taken }) {
  const { colour } = overlay;
  [context.strokeStyle, context.fillStyle, context.lineWidth] = [colour, colour, 2];
  context.font = `12px ${css('--font')}`;
  const values = overlay.infos.flatMap(({ shape, index }) => flat(valueAt(shown, overlay.place, index, image.findings_us ?? image.time_us + USED, live)).map((value) => SHAPES[shape](value)));
  for (const { line = [], dots = [], circles = [] } of values) {
    context.beginPath();
    for (const { x, y } of line) context.lineTo(at.x(x), at.y(y));
    context.stroke();
    for (const { x, y, radius } of [...dots, ...circles]) {
      context.beginPath();
      context.arc(at.x(x), at.y(y), radius === undefined ? 4 : Math.max(radius * at.scale, 4) + 2, 0, 2 * Math.PI);
      if (radius === undefined) context.fill();
      else context.stroke();
    }
  }
  const first = values.find(({ label }) => label)?.label;
  if (first && image.height * at.scale >= NAMED) label(context, overlay.component, at.x(first.x) + Math.max((first.radius ?? 0) * at.scale, 4) + 7, at.y(first.y), { colour, taken, right: at.left + image.width * at.scale, top: at.top });
}

/** Height of a name, px. */
const TALL = 18;

/** Writes a name within the image and the panel, below names that were there. */
function label(context, text, wantedX, wantedY, { colour, taken, right, top }) {
  const width = context.measureText(text).width + 10;
  const { clientWidth, clientHeight } = context.canvas;
  const x = Math.max(2, Math.min(wantedX, right - width - 2, clientWidth - width - 2));
  let y = Math.max(2, top + 2, Math.min(wantedY - TALL / 2, clientHeight - TALL - 2));
  const covers = (one) => one.x < x + width && x < one.x + one.width && one.y < y + TALL && y < one.y + TALL;
  for (let one = taken.find(covers); one; one = taken.find(covers)) y = one.y + TALL + 1;
  taken.push({ x, y, width });
  context.fillStyle = css('--shade');
  context.beginPath();
  context.roundRect(x, y, width, TALL, 4);
  context.fill();
  context.fillStyle = colour;
  context.textBaseline = 'middle';
  context.fillText(text, x + 5, y + TALL / 2);
}
