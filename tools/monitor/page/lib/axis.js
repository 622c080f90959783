// The time axis that timeline and plots share.

import { line } from './canvas.js';
import { computed } from './dom.js';
import { css } from './theme.js';
import { request } from './connection.js';
import { cursor, newest, range, seek, selected, session, visibleRange } from './store.js';

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
  const [from, until] = visibleRange.value;
  const span = until - from;
  const end = Math.min(until + us, newest.value + span * 0.05);
  range.value = { span, end: cursor.value === null && end >= newest.value ? null : end };
}

/** Shows all of a session. A short run grows. */
export function showWhole() {
  const { kind, from_us: from } = session.value.info.value;
  if (kind !== 'recording' && newest.value - from < 60e6) range.value = { span: 20e6, end: null, grows: true };
  else showRange(from, newest.value);
}

/** Goes to the next transition of the shown component, or, with −1, to the previous one; also to the begin and end of its activity. */
export async function toTransition(direction) {
  const shown = session.value;
  const description = shown?.description.value;
  if (!description) return;
  const component = selected.value ? shown.find(selected.value) : -1;
  const { from_us: from } = shown.info.value;
  const rows = await request('timeline', { session: shown.id, from_us: from, until_us: newest.value, resolution_us: 1 });
  const bars = rows.find((row) => row.component === (component < 0 ? description.root : component))?.bars ?? [];
  const times = [...new Set(bars.flatMap(([begin, end]) => [begin, end]))].sort((a, b) => a - b);
  const at = shownTime.value;
  // The newest time is the end of a bar that goes on, and no transition.
  const next = direction > 0 ? times.find((time) => time > at && time < newest.value) : times.findLast((time) => time < at);
  if (next !== undefined) seek(next);
}

/** Draws the cursor as a line. */
export function drawCursor(context, x, height) {
  context.strokeStyle = css('--cursor');
  context.lineWidth = 1.5;
  line(context, x, 0, x, height);
}
