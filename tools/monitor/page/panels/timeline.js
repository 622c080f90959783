// The activation timeline: a row for each component, a bar for each time in which it was active.

import { effect, html, useEffect, useRef, useSignal } from '../lib/dom.js';
import { request } from '../lib/connection.js';
import { Canvas, line as stroke, rounded, within } from '../lib/canvas.js';
import { openComponent } from '../lib/dock.js';
import { duration, time as timeText } from '../lib/format.js';
import { drawCursor, marks, pan, showRange, shownTime, visibleRange, zoomAt } from '../lib/axis.js';
import { act, cursor, hovered, range, seek, session } from '../lib/store.js';
import { css, kindColour } from '../lib/theme.js';
import { Bar, Empty, Toggle } from '../lib/ui.js';

const LABELS = 118;
const AXIS = 22;
const EVENTS = 18;
/** Time between two readings of the rows while time goes on. */
const READ_MS = 500;

export function Timeline({ visible }) {
  const shown = session.value;
  const description = shown?.description.value;
  const all = useSignal(false);
  const filter = useSignal('');
  const note = useSignal('');
  const rows = useSignal([]);
  const pointer = useSignal(null);
  const selection = useSignal(null);
  const scroll = useSignal(0);
  const place = useRef(null);
  const press = useRef(null);
  useReading(shown, rows, visible, place);

  if (!description) return html`<${Empty} what="Nothing has happened yet" help="Rows appear when a robot, a world or a recording is connected." />`;
  const listed = () => list(rows.value, description, all.value, filter.value);
  const reads = () => {
    void [rows.value, visibleRange.value, cursor.value, all.value, filter.value, pointer.value, selection.value, scroll.value, shown.linesVersion.value, shown.info.value.gaps, hovered.value];
  };
  const draw = (context, width, height) => {
    const view = viewOf(width, height, listed(), scroll.value);
    drawRows(context, view, shown, pointer.value);
    for (const gap of shown.info.value.gaps) drawGap(context, view, gap);
    drawEvents(context, view, shown);
    drawAxis(context, view);
    if (selection.value) drawSelection(context, view, selection.value);
    drawCursor(context, view.x(shownTime.value), height);
    if (pointer.value) drawPointer(context, view, shown, pointer.value);
  };
  const handlers = pointers({ place, press, pointer, selection, scroll, listed, description });
  const addNote = async (event) => {
    event.preventDefault();
    const text = note.value.trim();
    if (!text) return;
    if ((await act('note', { text }, 'the note is in the log, the timeline and the recording')) !== undefined) note.value = '';
  };
  return html`<${Bar} label="Timeline">
      <input type="search" placeholder="Rows" aria-label="Filter rows" value=${filter.value} onInput=${(event) => { filter.value = event.target.value; }} />
      <${Toggle} on=${all.value} label="All rows" title="Show components that were never active in this interval, too" onChange=${(on) => { all.value = on; }} />
      <button aria-label="Zoom in on time" onClick=${() => zoomAt(shownTime.value, 0.5)}>+</button><button aria-label="Zoom out of time" onClick=${() => zoomAt(shownTime.value, 2)}>−</button>
      ${[[2e6, '2 s'], [20e6, '20 s'], [120e6, '2 min']].map(([span, text]) => html`<button class=${range.value.span === span ? 'on' : ''} onClick=${() => { range.value = { span, end: range.value.end }; }}>${text}</button>`)}
      <button onClick=${() => showRange(shown.info.value.from_us, Math.max(shown.info.value.until_us, shownTime.value))}>Whole</button>
      ${shown.info.value.kind !== 'recording' && (cursor.value !== null || range.value.end !== null) && html`<button class="live" onClick=${() => seek(null)}>Live</button>`}
      <span class="grow"></span>
      <span class="dim hint wide">click: show that moment · drag: zoom · wheel: zoom · Shift+wheel: move</span>
      <form class="note" onSubmit=${addNote}><input placeholder="Note…" aria-label="Note" maxlength="500" value=${note.value} onInput=${(event) => { note.value = event.target.value; }} /><button>Add note</button></form>
    <//>
    <div class="fill" ref=${place}><${Canvas} reads=${reads} draw=${draw} visible=${visible} label="Activation timeline" ...${handlers} /></div>`;
}

/** Reads the rows of the visible interval: at once when another one is shown, else twice a second. */
function useReading(shown, rows, visible, place) {
  useEffect(() => {
    if (!shown) return undefined;
    let [busy, again, stopped, lastEnd] = [false, false, false, null];
    const read = async () => {
      if (busy || !visible.peek() || stopped || !shown.description.peek()) {
        again = busy;
        return;
      }
      busy = true;
      const [from, until] = visibleRange.peek().map((time) => Math.max(0, Math.round(time)));
      const width = Math.max((place.current?.clientWidth ?? 1000) - LABELS, 100);
      try {
        const answer = await request('timeline', { session: shown.id, from_us: from, until_us: until, resolution_us: Math.round((until - from) / width) });
        if (!stopped) rows.value = answer;
      } catch {
        // The next reading follows.
      }
      busy = false;
      if (again) {
        again = false;
        read();
      }
    };
    const stop = effect(() => {
      const { span, end } = range.value;
      void [shown.description.value, visible.value];
      const key = `${span} ${end}`;
      if (key !== lastEnd || end === null) {
        lastEnd = key;
        setTimeout(read);
      }
    });
    const timer = setInterval(() => range.peek().end === null && read(), READ_MS);
    return () => {
      stopped = true;
      stop();
      clearInterval(timer);
    };
  }, [shown]);
}

function list(rows, description, all, filter) {
  const known = new Map(rows.map((row) => [row.component, row]));
  const text = filter.trim().toLowerCase();
  return description.components
    .map((component, index) => ({ component, index, bars: known.get(index)?.bars ?? [], overruns: known.get(index)?.overruns ?? [] }))
    .filter(({ component, bars }) => (all || text !== '' || bars.length > 0) && component.name.toLowerCase().includes(text));
}

function viewOf(width, height, rows, scroll) {
  const [from, until] = visibleRange.value;
  const room = height - AXIS - EVENTS;
  const row = Math.max(13, Math.min(22, room / Math.max(rows.length, 1)));
  const offset = Math.min(scroll, Math.max(0, rows.length * row - room));
  const scale = (width - LABELS) / (until - from);
  return {
    width, height, rows, row, room, offset, from, until,
    x: (time) => LABELS + (time - from) * scale,
    time: (x) => from + (x - LABELS) / scale,
    y: (index) => index * row - offset,
    rowAt: (y) => (y < room ? Math.floor((y + offset) / row) : -1),
  };
}

function drawRows(context, view, shown, pointer) {
  const { rows, row, room, width } = view;
  const drawing = shown.drawing.value;
  const live = shown.live.value;
  context.font = `${Math.min(11.5, row - 2)}px ${css('--font')}`;
  context.textBaseline = 'middle';
  within(context, 0, 0, width, room, () => rows.forEach(({ component, index, bars, overruns }, line) => {
    const y = view.y(line);
    if (y + row < 0 || y > room) return;
    const colour = kindColour(drawing?.boxes[index]?.kind);
    const marked = hovered.value === index || (pointer && view.rowAt(pointer.y) === line);
    if (marked) {
      context.fillStyle = css('--hover');
      context.fillRect(0, y, width, row);
    }
    const now = shown.moment.value?.components?.[index];
    context.fillStyle = css(now?.[0] ? '--text' : '--dim');
    context.fillText(component.name, 8, y + row / 2, LABELS - 14);
    within(context, LABELS, y, width - LABELS, row, () => {
      drawBars(context, view, { bars, component, colour, y, now: live?.components?.[index], last: live?.time_us });
      context.fillStyle = css('--error');
      for (const time of overruns) context.fillRect(view.x(time) - 1, y + row - 4, 2, 4);
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
    rounded(context, left, y + 1.5, width, row - 3, Math.min(3, width / 2));
    context.globalAlpha = 1;
    if (view.x(begin) > LABELS) context.fillRect(left, y + 1.5, 1.5, row - 3);
    const name = state === null ? null : component.states[state]?.name;
    if (name && context.measureText(name).width < width - 9) {
      context.fillStyle = css('--on-bar');
      context.fillText(name, left + 6, y + row / 2);
    }
  });
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

const events = (shown) => shown.lines.filter(({ kind }) => kind === 'referee' || kind === 'note');

function textStyle(context, colour) {
  context.font = `11px ${css('--font')}`;
  context.fillStyle = css(colour);
  context.textBaseline = 'middle';
}

function drawEvents(context, view, shown) {
  const { height, room } = view;
  const y = height - AXIS - EVENTS / 2;
  let free = LABELS;
  textStyle(context, '--dim');
  context.fillText('Events', 8, y);
  for (const { time_us, kind, text } of events(shown)) {
    const x = view.x(time_us);
    if (x < LABELS || x > view.width) continue;
    const colour = css(kind === 'note' ? '--control' : '--warn');
    context.strokeStyle = colour;
    context.setLineDash([2, 3]);
    stroke(context, x, 0, x, room + EVENTS);
    context.setLineDash([]);
    if (x >= free) {
      context.fillStyle = colour;
      context.fillText(text, x + 4, y);
      free = x + 12 + context.measureText(text).width;
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
  for (const time of times) {
    const x = view.x(time);
    context.fillRect(x, y, 1, 4);
    context.fillText(timeText(time, digits), x + 4, y + AXIS / 2 + 1);
  }
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
  const near = events(shown).find((event) => Math.abs(view.x(event.time_us) - x) < 5);
  const gap = shown.info.value.gaps.find(([begin, end]) => begin < time && time < end);
  const text = [timeText(time, 3), near?.text, gap ? 'not received: the connection was lost' : line && (bar ? `${line.component.name}${state ? `: ${state}` : ''}, ${duration(bar[1] - bar[0])}` : `${line.component.name}: latent`)].filter(Boolean).join(' · ');
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

/** `press.current` is {x, row, scrubs} while the pointer is down, else null. It is kept over renderings. */
function pointers({ place, press, pointer, selection, scroll, listed, description }) {
  const view = () => viewOf(place.current.clientWidth, place.current.clientHeight, listed(), scroll.value);
  const release = () => { [press.current, selection.value] = [null, null]; };
  return {
    tabindex: '0',
    onPointerDown(event) {
      if (event.button !== 0) return;
      event.currentTarget.setPointerCapture(event.pointerId);
      const now = view();
      press.current = { x: event.offsetX, row: now.rows[now.rowAt(event.offsetY)], scrubs: event.offsetY > now.height - AXIS };
      if (press.current.scrubs) seek(now.time(event.offsetX));
    },
    onPointerMove(event) {
      pointer.value = { x: event.offsetX, y: event.offsetY };
      const [now, pressed] = [view(), press.current];
      hovered.value = now.rows[now.rowAt(event.offsetY)]?.index ?? null;
      if (!pressed) return;
      if (pressed.scrubs) seek(now.time(event.offsetX));
      else if (Math.abs(event.offsetX - pressed.x) > 4 && pressed.x > LABELS) selection.value = [pressed.x, event.offsetX];
    },
    onPointerUp(event) {
      const [chosen, pressed] = [selection.value, press.current];
      if (chosen) showRange(...chosen.map((x) => view().time(x)).sort((a, b) => a - b));
      else if (pressed && !pressed.scrubs) {
        if (pressed.x >= LABELS) seek(view().time(event.offsetX));
        else if (pressed.row) openComponent(description.components[pressed.row.index].name, event.shiftKey);
      }
      release();
    },
    onPointerCancel: release,
    onPointerLeave: () => { [pointer.value, hovered.value] = [null, null]; },
    onDblClick: () => zoomAt(shownTime.value, 4),
    onWheel(event) {
      event.preventDefault();
      if (event.offsetX < LABELS) scroll.value = Math.max(0, Math.min(scroll.value + event.deltaY, view().rows.length * view().row - view().room));
      else if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) pan(((event.deltaX || event.deltaY) / (view().width - LABELS)) * range.value.span);
      else zoomAt(range.value.end === null && cursor.value === null ? visibleRange.value[1] : view().time(event.offsetX), event.deltaY > 0 ? 1.25 : 0.8);
    },
  };
}
