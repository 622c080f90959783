// Names of robots on the map, and of frames in space.

import { css } from '../../lib/theme.js';

/** Height of a label, px. */
const HIGH = 16;
/** Area of a map for each label, px², below which labels are short. */
const ROOM = 30e3;

/** Labels, {full, short}, with the `text` for which a map of this area has room. */
export const written = (labels, area) => labels.map(({ full, short, ...rest }) => ({ ...rest, text: area < ROOM * labels.length ? short : full }));

/** Writes labels, {text, colour, at}, below points of the canvas, each within the canvas and below those that it would cover. */
export function drawLabels(context, labels, width, height) {
  context.font = `11.5px ${css('--font')}`;
  context.textBaseline = 'middle';
  const taken = [];
  for (const { text, colour, at: [x, y] } of labels) {
    const wide = context.measureText(text).width + 12;
    const left = Math.min(Math.max(x - wide / 2, 2), width - wide - 2);
    // Whole numbers: a label that was moved below another one no longer covers it.
    let top = Math.round(Math.min(y + 14, height - HIGH));
    const covered = () => taken.find((other) => Math.abs(other.top - top) < HIGH && left < other.right && other.left < left + wide);
    for (let over = covered(); over; over = covered()) top = over.top + HIGH;
    taken.push({ left, right: left + wide, top });
    context.fillStyle = css('--shade');
    context.fillRect(left, top, wide, HIGH);
    context.fillStyle = colour;
    context.fillRect(left, top, 3, HIGH);
    context.fillStyle = css('--shade-text');
    context.fillText(text, left + 8, top + HIGH / 2 + 0.5);
  }
}
