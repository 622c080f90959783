// What the colours of a map mean: lines at the lower border. The menu Layers has them, too.

import { css } from '../../lib/theme.js';

/** Largest share of the map that the lines may take. */
const SHARE = 0.2;

/** Draws entries, [text, colour], where they leave enough of the map. Returns the height that they take. */
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
  const taken = used > 0 ? lines.length * 17 + 4 : 0;
  if (taken > height * SHARE) return 0;
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
  return taken;
}
