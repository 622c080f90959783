// Names of transitions as they are written on the canvas.

import { widthOf } from './boxes.js';

/** A timer as it is written at an arrow. */
export const timerText = (ms) => (ms === null ? '' : ms % 1000 === 0 ? `after ${ms / 1000} s` : `after ${ms} ms`);

/** Width of an arrow's name with its timer. */
export function labelWidth({ name, any, after_ms: after, sign }) {
  const timer = timerText(after);
  return (sign ? widthOf(`${sign} `, 11.5) + 3 : 0) + widthOf(name, 11.5) + (timer ? widthOf(` ${timer}`, 11) + 4 : 0) + (any ? widthOf('any · ', 11) : 0) + 10;
}
