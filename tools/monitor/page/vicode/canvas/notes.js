// Notes on the drawing: where they stand and how they look. Those without a place stand in rows below the machine, as do all of a machine
// that is drawn automatically.

import { html } from '../../lib/dom.js';
import { cut, widthOf } from './boxes.js';
import { stage } from './stage.js';

/** Longest line, height of a line, white around the text and between notes, points. */
const [WIDE, LINE, PAD, GAP] = [240, 15, 8, 20];

/** The lines of a text. */
function lines(text) {
  const all = [];
  for (const paragraph of text.split('\n')) {
    let line = '';
    for (const word of paragraph.split(' ')) {
      const longer = line ? `${line} ${word}` : word;
      if (line && widthOf(longer) > WIDE) all.push(line);
      line = line && widthOf(longer) > WIDE ? word : longer;
    }
    all.push(line);
  }
  return all.map((line) => cut(line, WIDE));
}

/** Notes with their lines, centres and sizes, and the area of a machine together with those below it. */
export function laidOut(notes, area, isAutomatic) {
  let [x, y, tall, wide] = [area.x + GAP, area.y + area.height, 0, area.width];
  const placed = notes.map((note) => {
    const all = lines(note.text);
    const box = { ...note, lines: all, width: Math.max(...all.map((line) => widthOf(line))) * 1.04 + 2 * PAD, height: all.length * LINE + 2 * PAD };
    if (note.at && !isAutomatic) return { ...box, ...note.at };
    if (x > area.x + GAP && x + box.width + GAP > area.x + area.width) [x, y, tall] = [area.x + GAP, y + tall + GAP, 0];
    const at = { x: x + box.width / 2, y: y + box.height / 2 };
    x += box.width + GAP;
    [tall, wide] = [Math.max(tall, box.height), Math.max(wide, x - area.x)];
    return { ...box, ...at };
  });
  return { notes: placed, area: { ...area, width: wide, height: y + tall + (tall > 0 ? GAP : 0) - area.y } };
}

export const corner = ({ x, y, width, height }) => `translate(${x - width / 2} ${y - height / 2})`;

/** Elements stay while notes change, and so does the focus. */
export const Notes = ({ chosen }) => html`<g class="notes">${stage.notes.map((note, index) => html`<g key=${index} class=${`note ${chosen.has(note.key) ? 'chosen' : ''}`} data-key=${note.key} transform=${corner(note)}
    role="button" tabindex="0" aria-label=${`Note: ${note.text}`} aria-pressed=${chosen.has(note.key)}>
  <rect class="paper" width=${note.width} height=${note.height} rx="3" />${note.lines.map((line, at) => html`<text x=${PAD} y=${PAD + 11 + at * LINE}>${line}</text>`)}</g>`)}</g>`;
