// Names of arrows where only names of states are drawn: those that a person looks for, on their arrows, where they cover nothing.

import { boxRect, overlap } from './boxes.js';
import { labelWidth } from './labels.js';

const SHOWN = '.chosen, .near, .added, .removed, .changed, .holds, .leaves:not(.any)';
/** Shares of an arrow's length where its name may stand, the best first. */
const SHARES = Array.from({ length: 47 }, (_, at) => 0.5 + (at % 2 ? 1 : -1) * Math.ceil(at / 2) / 48);
const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');

/** The arrows whose names are shown, one of each bundle, the chosen ones first. */
export function wanted(arrows, labels, courses) {
  const rank = ({ key }) => ['chosen', 'near'].findIndex((name) => labels.get(key).classList.contains(name)) >>> 0;
  const shown = arrows.filter(({ key }) => labels.get(key)?.matches(SHOWN)).sort((a, b) => rank(a) - rank(b));
  return [...Map.groupBy(shown, ({ key }) => courses.get(key).owner ?? key).values()].map(([first]) => first);
}

/** The places of names by key, clear of `taken` and within the area; a name without room has none. */
export function apart(arrows, { courses, taken, area }, scale) {
  const rects = [...taken];
  const places = new Map();
  for (const arrow of arrows) {
    const { d, label, anchor, owner = arrow.key } = courses.get(arrow.key);
    // Names of what is chosen have bold letters.
    const [width, height] = [1.08 * labelWidth(arrow) * scale, 17 * scale];
    path.setAttribute('d', d);
    const length = path.getTotalLength();
    // The place that the layout found for the name of a bundle is on its owner's arrow.
    for (const share of owner === arrow.key ? [null, ...SHARES] : SHARES) {
      const { x, y } = share === null ? { x: label[0], y: label[1] } : path.getPointAtLength(share * length);
      const rect = boxRect({ x, y, width, height });
      const isOutside = area && (rect.left < area.x || rect.right > area.x + area.width || rect.top < area.y || rect.bottom > area.y + area.height);
      if (isOutside || rects.some((one) => overlap(one, rect) > 0)) continue;
      rects.push(rect);
      places.set(arrow.key, [anchor === 'start' ? x - width / 2 + 4 * scale : x, y]);
      break;
    }
  }
  return places;
}
