// What the colours of a map mean: lines at the lower border.

import { css } from '../../lib/theme.js';

/** Draws entries, [text, colour]. Returns the height that they take. */
export function drawLegend(context, width, height, entries) {
  context.font = `11px ${css('--font')}`;
  context.textBaseline = 'middle';
  const lines = [[]];
  let used = 0;
  for (const [text, colour] of entries) {
    const wide = context.measureText(text).width + 22;
    if (used > 0 && used + wide > width - 10) {
      lines.push([]);
      used = 0;
    }
    lines.at(-1).push({ text, colour, x: 8 + used, wide });
    used += wide;
  }
  lines.forEach((line, number) => {
    const y = height - 12 - (lines.length - 1 - number) * 17;
    for (const { text, colour, x, wide } of line) {
      context.fillStyle = css('--panel');
      context.fillRect(x - 3, y - 8, wide, 17);
      context.fillStyle = colour;
      context.fillRect(x, y - 4, 8, 8);
      context.fillStyle = css('--text');
      context.fillText(text, x + 12, y + 0.5);
    }
  });
  return used > 0 ? lines.length * 17 + 4 : 0;
}
