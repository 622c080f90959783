// The drawing of the timeline: rows of bars, events, late cycles, and the axis.

import { line as stroke, rounded, within } from '../../lib/canvas.js';
import { duration, time as timeText } from '../../lib/format.js';
import { drawCursor, marks, shownTime } from '../../lib/axis.js';
import { hovered, newest, visibleRange } from '../../lib/store.js';
import { besideColour, css, kindColour } from '../../lib/theme.js';
import { span, spanOf } from '../../lib/span.js';
import { findings, watches } from '../../lib/watches.js';

/** Width of the names, and heights of the rows below the bars, px. */
export const [LABELS, AXIS] = [118, 22];
const [EVENTS, OVERRUNS, ALERTS] = [18, 16, 18];
/** White above the first row, and the least height of a row that can be read, px. */
const [TOP, LEAST] = [3, 14];
/** Width of a column of late cycles, px. */
const COLUMN = 4;
/** Height of a job, px. */
const JOB = 4;

export function drawTimeline(context, view, { shown, pointer, selection }) {
  drawRows(context, view, shown, pointer);
  for (const gap of shown.info.value.gaps) drawGap(context, view, gap);
  drawFuture(context, view);
  drawEvents(context, view, shown);
  drawAlerts(context, view);
  drawOverruns(context, view);
  drawCursor(context, view.x(shownTime.value), view.height - AXIS);
  drawAxis(context, view);
  if (span.value) drawSpan(context, view, span.value.map(view.x));
  if (selection) drawSelection(context, view, selection);
  if (pointer) drawPointer(context, view, shown, pointer);
}

export function viewOf(width, height, rows, scroll) {
  const [from, until] = visibleRange.value;
  const alerts = watches.value.length > 0 ? ALERTS : 0;
  const most = height - AXIS - EVENTS - OVERRUNS - alerts - TOP;
  const row = Math.max(LEAST, Math.min(22, most / Math.max(rows.length, 1)));
  // Only whole rows are shown.
  const room = TOP + Math.max(1, Math.floor(most / row + 0.01)) * row;
  const last = Math.max(0, TOP + rows.length * row - room);
  const offset = Math.min(scroll, last);
  const scale = (width - LABELS) / (until - from);
  return {
    width, height, rows, row, room, last, offset, from, until, alerts,
    x: (time) => LABELS + (time - from) * scale,
    time: (x) => from + (x - LABELS) / scale,
    y: (index) => TOP + index * row - offset,
    rowAt: (y) => (y < room ? Math.floor((y - TOP + offset) / row) : -1),
  };
}

function drawRows(context, view, shown, pointer) {
  const { rows, row, room, width } = view;
  const kinds = shown.kinds.value;
  context.font = `${Math.min(11.5, row - 2)}px ${css('--font')}`;
  context.textBaseline = 'middle';
  within(context, 0, TOP, width, room - TOP, () => rows.forEach(({ component, index, own, of = shown, place, bars, jobs }, line) => {
    const y = view.y(line);
    if (y + row < 0 || y > room) return;
    const colour = kindColour(kinds[index]);
    const marked = hovered.value === index || (pointer && view.rowAt(pointer.y) === line);
    if (marked) {
      context.fillStyle = css('--hover');
      context.fillRect(0, y, width, row);
    }
    const now = of.moment.value?.components?.[own];
    context.fillStyle = place === undefined ? css(now?.[0] ? '--text' : '--dim') : besideColour(place);
    context.fillText(place === undefined ? component.name : of.title, place === undefined ? 8 : 18, y + row / 2, LABELS - (place === undefined ? 14 : 24));
    if (place !== undefined) context.fillRect(9, y + 3, 3, row - 6);
    const live = place === undefined ? of.live.value : null;
    within(context, LABELS, y, width - LABELS, row, () => {
      drawBars(context, view, { bars, component, colour, y, now: live?.components?.[own], last: live?.time_us });
      drawJobs(context, view, jobs, y);
    });
  }));
  context.strokeStyle = css('--line');
  stroke(context, LABELS - 0.5, 0, LABELS - 0.5, room);
}

function drawBars(context, view, { bars, component, colour, y, now, last }) {
  const { row } = view;
  bars.forEach(([begin, end, state], index) => {
    // The last bar grows between two readings, as long as nothing changed.
    const grows = index === bars.length - 1 && now?.[0] && now[2] === state && now[4] <= end;
    const [left, right] = [Math.max(view.x(begin), LABELS), Math.min(view.x(grows ? Math.max(end, last) : end), view.width)];
    if (right < LABELS || left > view.width) return;
    const width = Math.max(right - left - 1, 1);
    context.globalAlpha = state === null ? 0.42 : 0.5 + 0.32 * ((state * 0.618) % 1);
    context.fillStyle = colour;
    rounded(context, left, y + 1, width, row - 2, Math.min(3, width / 2));
    context.globalAlpha = 1;
    if (view.x(begin) > LABELS) context.fillRect(left, y + 1, 1.5, row - 2);
    const name = state === null ? null : component.states[state]?.name;
    const text = name && shortened(context, name, width - 9);
    if (text) {
      context.fillStyle = css('--on-bar');
      context.fillText(text, left + 6, y + row / 2);
    }
  });
}

/** End of a job that is in progress or was dropped: at the latest now. */
const endOf = ([, due, end]) => end ?? Math.min(due, newest.value);

/** Draws jobs beside the loop at the lower edge of a row: what is later than due, and what has failed, has another colour. */
function drawJobs(context, view, jobs, y) {
  const bar = (from, until, colour) => {
    const [left, right] = [Math.max(view.x(from), LABELS), Math.min(view.x(until), view.width)];
    if (right < LABELS || left > view.width) return;
    context.fillStyle = css(colour);
    context.fillRect(left, y + view.row - JOB - 1, Math.max(right - left - 1, 1.5), JOB);
  };
  for (const job of jobs) {
    const [begin, due, , how] = job;
    bar(begin, Math.min(due, endOf(job)), how === 'failed' ? '--error' : '--text');
    if (endOf(job) > due) bar(due, endOf(job), how === 'failed' ? '--error' : '--warn');
  }
}

const ENDS = { on_time: '', late: ', late', failed: ', failed' };

/** Words for the job of a row at a time. */
function jobAt({ component, jobs }, time) {
  const job = jobs.findLast((one) => one[0] <= time && time <= endOf(one));
  return job && `job ${component.work?.name ?? ''} of ${duration(job[1] - job[0])}: ${duration(endOf(job) - job[0])}${ENDS[job[3]] ?? (job[2] ? ', dropped' : ', in progress')}`;
}

/** As much of a name as fits; nothing below three letters. */
function shortened(context, name, width) {
  if (context.measureText(name).width <= width) return name;
  for (let count = name.length - 1; count >= 3; count -= 1) {
    const text = `${name.slice(0, count)}…`;
    if (context.measureText(text).width <= width) return text;
  }
  return '';
}

/** Hatches a time in which nothing was received. */
function drawGap(context, view, [from, until]) {
  const [left, right] = [Math.max(view.x(from), LABELS), Math.min(view.x(until), view.width)];
  if (right <= left) return;
  within(context, left, 0, right - left, view.room, () => {
    context.fillStyle = css('--hover');
    context.fillRect(left, 0, right - left, view.room);
    context.strokeStyle = css('--line');
    for (let x = left - view.room; x < right; x += 9) stroke(context, x, view.room, x + view.room, 0);
    textStyle(context, '--dim');
    if (context.measureText('not received').width < right - left - 8) context.fillText('not received', left + 5, view.room / 2);
  });
}

const events = (shown) => shown.lines.filter(({ source }) => source === 'world' || source === 'note');

function textStyle(context, colour) {
  context.font = `11px ${css('--font')}`;
  context.fillStyle = css(colour);
  context.textBaseline = 'middle';
}

/** How many cycles of components were late, in columns. */
function drawOverruns(context, view) {
  const { room, rows, width } = view;
  const top = room + EVENTS + view.alerts;
  const low = top + OVERRUNS - 3;
  textStyle(context, '--dim');
  context.fillText('Late', 8, top + OVERRUNS / 2);
  const columns = new Map();
  for (const time of rows.flatMap(({ overruns }) => overruns)) {
    const column = Math.floor((view.x(time) - LABELS) / COLUMN);
    columns.set(column, (columns.get(column) ?? 0) + 1);
  }
  context.fillStyle = css('--dim');
  for (const [column, count] of columns) {
    const x = LABELS + column * COLUMN;
    const height = Math.min(OVERRUNS - 5, 3 + 2 * count);
    if (x >= LABELS && x < width) context.fillRect(x, low - height, COLUMN - 1, height);
  }
}

/** When watches fired, as triangles with their texts, and when their conditions held. */
function drawAlerts(context, view) {
  if (view.alerts === 0) return;
  const top = view.room + EVENTS;
  const y = top + ALERTS / 2;
  textStyle(context, '--dim');
  context.fillText('Alerts', 8, y);
  [context.fillStyle, context.strokeStyle] = [css('--attn'), css('--attn')];
  const fired = [];
  within(context, LABELS, 0, view.width - LABELS, view.height, () => {
    for (const [text, found] of findings.value) {
      context.globalAlpha = 0.3;
      for (const [begin, end] of found.spans) context.fillRect(view.x(begin), top + ALERTS - 4, Math.max(view.x(end ?? newest.value) - view.x(begin), 1), 3);
      context.globalAlpha = 1;
      fired.push(...found.fired.map((at) => ({ text, x: view.x(at) })).filter(({ x }) => x >= LABELS && x <= view.width));
    }
    fired.sort((a, b) => a.x - b.x);
    fired.forEach(({ text, x }, index) => {
      context.setLineDash([2, 3]);
      stroke(context, x, 0, x, top);
      context.setLineDash([]);
      triangle(context, x, y);
      // A text stands at the side that has room for it.
      const width = context.measureText(text).width + 10;
      const [before, after] = [fired[index - 1]?.x + 8 || LABELS, fired[index + 1]?.x - 8 || view.width];
      if (x + width < after) context.fillText(text, x + 9, y);
      else if (index === 0 && x - width > before) context.fillText(text, x - width + 1, y);
    });
  });
}

function triangle(context, x, y) {
  context.beginPath();
  for (const [dx, dy] of [[0, -5], [6, 5], [-6, 5]]) context.lineTo(x + dx, y + dy);
  context.fill();
}

/** Darkens what has not happened yet. */
function drawFuture(context, view) {
  const x = Math.max(LABELS, view.x(newest.value));
  context.fillStyle = css('--future');
  if (x < view.width) context.fillRect(x, 0, view.width - x, view.height - AXIS);
}

function drawEvents(context, view, shown) {
  const { room } = view;
  const y = room + EVENTS / 2;
  let free = LABELS;
  textStyle(context, '--dim');
  context.fillText('Events', 8, y);
  const all = events(shown);
  for (const [index, { time_us, source, text: full }] of all.entries()) {
    const noted = source === 'note' ? spanOf(full) : null;
    const text = noted?.text ?? full;
    const x = noted ? Math.max(view.x(noted.begin), LABELS) : view.x(time_us);
    const right = noted ? Math.min(view.x(noted.end), view.width) : x;
    if (x < LABELS || x > view.width || right < x) continue;
    const colour = css(source === 'note' ? '--control' : '--warn');
    [context.strokeStyle, context.fillStyle] = [colour, colour];
    context.setLineDash([2, 3]);
    for (const edge of new Set([x, right])) stroke(context, edge, 0, edge, room + EVENTS);
    context.setLineDash([]);
    context.fillRect(x, room + EVENTS - 2, right - x, 2);
    if (x >= free) {
      context.fillStyle = colour;
      // It ends before the next line.
      const fits = shortened(context, text, Math.min(view.x(all[index + 1]?.time_us ?? Infinity), view.width) - x - 8);
      context.fillText(fits, x + 4, y);
      free = x + 12 + context.measureText(fits).width;
    }
  }
}

function drawAxis(context, view) {
  const { width, height, from, until } = view;
  const y = height - AXIS;
  context.strokeStyle = css('--line');
  stroke(context, 0, y + 0.5, width, y + 0.5);
  textStyle(context, '--dim');
  const { times, digits } = marks(from, until, width - LABELS);
  const label = timeText(shownTime.value, 2);
  const wide = context.measureText(label).width + 10;
  const at = view.x(shownTime.value);
  const left = at < LABELS || at > width ? width : Math.max(LABELS, Math.min(at - wide / 2, width - wide));
  const right = left + wide;
  for (const time of times) {
    const x = view.x(time);
    context.fillRect(x, y, 1, 4);
    const text = timeText(time, digits);
    // The label of the cursor hides one that is near it.
    if (x + 8 + context.measureText(text).width < left || x > right) context.fillText(text, x + 4, y + AXIS / 2 + 1);
  }
  context.fillStyle = css('--cursor');
  rounded(context, left, y + 2, right - left, AXIS - 4, 3);
  context.fillStyle = css('--panel');
  context.fillText(label, left + 5, y + AXIS / 2 + 1);
}

/** The chosen span, with its edges. */
function drawSpan(context, view, [begin, end]) {
  const [left, right] = [Math.max(begin, LABELS), Math.min(end, view.width)];
  if (right <= left) return;
  context.fillStyle = css('--selection');
  context.fillRect(left, 0, right - left, view.height - AXIS);
  context.fillStyle = css('--control');
  for (const x of [begin, end]) if (x >= LABELS && x <= view.width) context.fillRect(x - 1, 0, 2, view.height - AXIS + 6);
}

function drawSelection(context, view, [a, b]) {
  context.fillStyle = css('--selection');
  context.fillRect(Math.min(a, b), 0, Math.abs(b - a), view.height - AXIS);
}

function drawPointer(context, view, shown, { x, y }) {
  if (x < LABELS) return;
  const line = view.rows[view.rowAt(y)];
  const time = view.time(x);
  const bar = line?.bars.find(([begin, end]) => begin <= time && time <= end);
  const state = bar && bar[2] !== null ? line.component.states[bar[2]]?.name : null;
  const within = (noted) => noted && noted.begin <= time && time <= noted.end;
  const near = events(shown).find((event) => Math.abs(view.x(event.time_us) - x) < 5 || (y > view.room && within(spanOf(event.text))));
  const alert = [...findings.value].find(([, { fired }]) => fired.some((at) => Math.abs(view.x(at) - x) < 5))?.[0];
  const gap = shown.info.value.gaps.find(([begin, end]) => begin < time && time < end);
  const text = [timeText(time, 3), alert && `watch fired: ${alert}`, near?.text, gap ? 'not received: the connection was lost' : line && (bar ? `${line.of ? `${line.of.title}, ` : ''}${line.component.name}${state ? `: ${state}` : ''}, ${duration(bar[1] - bar[0])}` : `${line.of ? `${line.of.title}, ` : ''}${line.component.name}: latent`), line && jobAt(line, time)].filter(Boolean).join(' · ');
  context.font = `11.5px ${css('--font')}`;
  const width = context.measureText(text).width + 14;
  const left = Math.min(x + 10, view.width - width - 4);
  const top = Math.max(2, Math.min(y - 26, view.height - 26));
  context.fillStyle = css('--tip');
  rounded(context, left, top, width, 20, 4);
  context.fillStyle = css('--text');
  context.textBaseline = 'middle';
  context.fillText(text, left + 7, top + 10.5);
}
