// The time axis that timeline and plots share.

import { line } from './canvas.js';
import { computed } from './dom.js';
import { css } from './theme.js';
import { cursor, range, session } from './store.js';

/** Newest time of the session, µs. */
export const newest = computed(() => {
  const shown = session.value;
  return Math.max(shown?.live.value?.time_us ?? 0, shown?.info.value.until_us ?? 0);
});

/** Visible interval: [from, until], µs. */
export const visibleRange = computed(() => {
  const { span, end } = range.value;
  // A session shorter than the interval begins at the left.
  const until = end ?? Math.max(newest.value, (session.value?.info.value.from_us ?? 0) + span);
  return [until - span, until];
});

/** Time of the cursor, or the newest. */
export const shownTime = computed(() => cursor.value ?? newest.value);

const STEPS = [1, 2, 5];

/** Times of marks on the axis, and the number of digits of their text. */
export function marks(from, until, width) {
  const wanted = ((until - from) / Math.max(width / 90, 1));
  let step = 10 ** Math.floor(Math.log10(Math.max(wanted, 1)));
  step *= STEPS.find((factor) => step * factor >= wanted) ?? 10;
  if (step >= 10e6) step = [10e6, 15e6, 30e6, 60e6, 120e6, 300e6, 600e6, 1800e6, 3600e6].find((one) => one >= wanted) ?? step;
  const times = [];
  for (let time = Math.max(0, Math.ceil(from / step) * step); time <= until; time += step) times.push(time);
  return { times, digits: step >= 1e6 ? 0 : Math.min(6, Math.ceil(6 - Math.log10(step))) };
}

/** Zooms around a time. */
export function zoomAt(time, factor) {
  const [from, until] = visibleRange.value;
  const span = Math.min(Math.max((until - from) * factor, 20e3), 4 * 3600e6);
  const follows = range.value.end === null && cursor.value === null;
  const end = time + (until - time) * (span / (until - from));
  range.value = { span, end: follows ? null : end };
}

/** Shows an interval. */
export function showRange(from, until) {
  range.value = { span: Math.max(until - from, 20e3), end: until };
}

export function pan(us) {
  const [, until] = visibleRange.value;
  const span = range.value.span;
  const end = Math.min(until + us, newest.value + span * 0.05);
  range.value = { span, end: cursor.value === null && end >= newest.value ? null : end };
}

/** Draws the cursor as a line. */
export function drawCursor(context, x, height) {
  context.strokeStyle = css('--cursor');
  context.lineWidth = 1.5;
  line(context, x, 0, x, height);
}
