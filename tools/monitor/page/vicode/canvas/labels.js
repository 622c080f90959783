// Names of transitions as they are written on the canvas.

import { widthOf } from './boxes.js';

/** A timer as it is written at an arrow. */
const timerText = (ms) => (ms === null ? '' : ms % 1000 === 0 ? `after ${ms / 1000} s` : `after ${ms} ms`);

/** What an arrow waits for beside its condition, and for what it asks: `after pause 3 times (age of Marker)`. */
export function waitText({ bare, after_ms: ms, after, when, times, asks = [] }) {
  const result = bare ? null : when;
  const timer = after === null ? timerText(ms) : `after ${after.split('::').at(-1)}`;
  return [result, timer, times !== null && `${times} times`, asks.length > 0 && `(${asks.join(', ')})`].filter(Boolean).join(' ');
}

/** Width of an arrow's name with what it waits for. */
export function labelWidth({ name, any, sign, ...arrow }) {
  const timer = waitText(arrow);
  return (sign ? widthOf(`${sign} `, 11.5) + 3 : 0) + widthOf(name, 11.5) + (timer ? widthOf(` ${timer}`, 11) + 4 : 0) + (any ? widthOf('any · ', 11) : 0) + 10;
}
