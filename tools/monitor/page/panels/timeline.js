// The activation timeline: a row for each component, a bar for each time in which it was active.

import { effect, html, useEffect, useRef, useSignal } from '../lib/dom.js';
import { request } from '../lib/connection.js';
import { Canvas } from '../lib/canvas.js';
import { openComponent } from '../lib/dock.js';
import { pan, showRange, showWhole, shownTime, toTransition, zoomAt } from '../lib/axis.js';
import { act, companions, cursor, cycle_us, hello, hovered, range, seek, session, visibleRange } from '../lib/store.js';
import { choose, span } from '../lib/span.js';
import { Bar, Empty, Toggle, TooLong, excess } from '../lib/ui.js';
import { findings, watches } from '../lib/watches.js';
import { AXIS, LABELS, drawTimeline, viewOf } from './timeline/draw.js';
import { SpanBar, Speed } from './timeline/span.js';

/** Time between two readings of the rows while time goes on. */
const READ_MS = 500;

export function Timeline({ visible }) {
  const shown = session.value;
  const description = shown?.description.value;
  const all = useSignal(false);
  const filter = useSignal('');
  const note = useSignal('');
  const rows = useSignal([]);
  const others = useSignal([]);
  const differing = useSignal(false);
  const pointer = useSignal(null);
  const selection = useSignal(null);
  const scroll = useSignal(0);
  const place = useRef(null);
  const press = useRef(null);
  useReading(shown, rows, others, visible, place);

  if (!description) return html`<${Empty} what="Nothing has happened yet" help="Rows appear when a robot, a world or a recording is connected." />`;
  const listed = () => {
    const own = list(rows.value, description, all.value || others.value.length > 0, filter.value);
    return others.value.length === 0 ? own : sideBySide(own, others.value, { all: all.value || filter.value.trim() !== '', differing: differing.value });
  };
  const reads = () => {
    void [rows.value, others.value, differing.value, visibleRange.value, cursor.value, all.value, filter.value, pointer.value, selection.value, scroll.value, shown.linesVersion.value, shown.info.value.gaps, hovered.value, watches.value, findings.value, span.value];
  };
  const draw = (context, width, height) => {
    drawTimeline(context, viewOf(width, height, listed(), scroll.value), { shown, pointer: pointer.value, selection: selection.value });
  };
  const handlers = pointers({ place, press, pointer, selection, scroll, listed });
  const addNote = async (event) => {
    event.preventDefault();
    const text = note.value.trim();
    if (!text || excess(text, hello.value.limits.note)) return;
    if ((await act('note', { text }, 'the note is in the log, the timeline and the recording')) !== undefined) note.value = '';
  };
  return html`<${Bar} label="Timeline">
      <input type="search" placeholder="Rows" aria-label="Filter rows" value=${filter.value} onInput=${(event) => { filter.value = event.target.value; }} />
      <${Toggle} on=${all.value} label="All rows" title="Show components that were never active in this interval, too" onChange=${(on) => { all.value = on; }} />
      ${companions.value.length > 0 && html`<${Toggle} on=${differing.value} label="Different" title="Show only components that the sessions activate differently" onChange=${(on) => { differing.value = on; }} />`}
      <button aria-label="Zoom in on time" onClick=${() => zoomAt(shownTime.value, 0.5)}>+</button><button aria-label="Zoom out of time" onClick=${() => zoomAt(shownTime.value, 2)}>−</button>
      ${[[2e6, '2 s'], [20e6, '20 s'], [120e6, '2 min']].map(([span, text]) => html`<button class=${range.value.span === span && !range.value.grows ? 'on' : ''} onClick=${() => { range.value = { span, end: range.value.end }; }}>${text}</button>`)}
      <button class=${range.value.grows && range.value.end === null ? 'on' : ''} onClick=${showWhole}>Whole</button>
      <button aria-label="Previous transition" title="Previous transition of the shown component, key [" onClick=${() => toTransition(-1)}>⟨</button><button aria-label="Next transition" title="Next transition of the shown component, key ]" onClick=${() => toTransition(1)}>⟩</button>
      ${shown.info.value.kind !== 'recording' && (cursor.value !== null || range.value.end !== null) && html`<button class="live" onClick=${() => seek(null)}>Live</button>`}
      ${shown.info.value.kind === 'recording' && !span.value && html`<${Speed} />`}
      <span class="grow"></span>
      <span class="dim hint wide">click: moment · drag: zoom · Shift+drag: span · wheel: zoom</span>
      <form class="note" onSubmit=${addNote}><input placeholder="Note…" aria-label="Note" value=${note.value} onInput=${(event) => { note.value = event.target.value; }} /><button>Add note</button><${TooLong} text=${note.value} max=${hello.value.limits.note} /></form>
    <//>
    <${SpanBar} rows=${rows.value} />
    <div class="fill" ref=${place}><${Canvas} reads=${reads} draw=${draw} visible=${visible} label="Activation timeline" ...${handlers} /></div>`;
}

/** Reads the rows of the visible interval: at once when another one is shown or a component changes, else twice a second. */
function useReading(shown, rows, others, visible, place) {
  useEffect(() => {
    if (!shown) return undefined;
    let [busy, again, stopped, lastKey, known] = [false, false, false, null, null];
    const read = async () => {
      if (busy || !visible.peek() || stopped || !shown.description.peek()) {
        again = busy;
        return;
      }
      busy = true;
      const [from, until] = visibleRange.peek().map((time) => Math.max(0, Math.round(time)));
      const width = Math.max((place.current?.clientWidth ?? 1000) - LABELS, 100);
      try {
        const rowsOf = (of, shift) => request('timeline', { session: of.id, from_us: Math.max(0, Math.round(from + shift)), until_us: Math.max(0, Math.round(until + shift)), resolution_us: Math.round((until - from) / width) });
        const beside = companions.peek();
        const [answer, ...more] = await Promise.all([rowsOf(shown, 0), ...beside.map(({ of, shift }) => rowsOf(of, shift))]);
        if (!stopped) [rows.value, others.value] = [answer, beside.map((one, index) => ({ ...one, rows: more[index] }))];
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
      const now = end === null && shown.live.value?.components?.map(([active, , state]) => `${active}:${state}`);
      const key = `${span} ${end} ${visible.value} ${companions.value.map(({ of, shift }) => `${of.id}+${shift}`)} ${now}`;
      if (key === lastKey && known === shown.description.value) return;
      [lastKey, known] = [key, shown.description.value];
      setTimeout(read);
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
    .map((component, index) => ({ component, index, own: index, bars: known.get(index)?.bars ?? [], overruns: known.get(index)?.overruns ?? [], jobs: known.get(index)?.jobs ?? [] }))
    .filter(({ component, bars }) => (all || text !== '' || bars.length > 0) && component.name.toLowerCase().includes(text));
}

/** Puts the rows of other sessions below those of the same components, at the times of the chosen session. */
function sideBySide(own, others, { all, differing }) {
  const beside = (line) => others.flatMap(({ of, shift, place, rows }) => {
    const index = of.find(line.component.name);
    const { bars = [], jobs = [] } = rows.find((row) => row.component === index) ?? {};
    const moved = (time) => time && time - shift;
    return index < 0 ? [] : [{ ...line, component: of.description.value.components[index], own: index, of, place, overruns: [], jobs: jobs.map(([begin, due, end, how]) => [moved(begin), moved(due), moved(end), how]), bars: bars.map(([begin, end, state]) => [moved(begin), moved(end), state]) }];
  });
  const groups = own.map((line) => [line, ...beside(line)]);
  return groups.filter((group) => (all || group.some(({ bars }) => bars.length > 0)) && (!differing || group.some((one) => !isSame(group[0], one)))).flat();
}

/** Whether two rows have the same bars, as far as their cycles can be told apart. */
function isSame({ component, bars }, other) {
  const name = (of, state) => of.states[state]?.name;
  return bars.length === other.bars.length && bars.every(([begin, , state], index) => Math.abs(begin - other.bars[index][0]) < cycle_us.peek() && name(component, state) === name(other.component, other.bars[index][2]));
}

/** `press.current` is {x, row, scrubs, spans} while the pointer is down, else null. It is kept over renderings. */
function pointers({ place, press, pointer, selection, scroll, listed }) {
  const view = () => viewOf(place.current.clientWidth, place.current.clientHeight, listed(), scroll.value);
  const release = () => { [press.current, selection.value] = [null, null]; };
  return {
    tabindex: '0',
    onPointerDown(event) {
      if (event.button !== 0) return;
      event.currentTarget.setPointerCapture(event.pointerId);
      const now = view();
      press.current = { x: event.offsetX, row: now.rows[now.rowAt(event.offsetY)], scrubs: event.offsetY > now.height - AXIS, spans: event.shiftKey };
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
      if (chosen) (pressed.spans ? choose : showRange)(...chosen.map((x) => view().time(x)).sort((a, b) => a - b));
      else if (pressed && !pressed.scrubs) {
        if (pressed.x >= LABELS) seek(view().time(event.offsetX));
        else if (pressed.row) openComponent(pressed.row.component.name, event.shiftKey);
      }
      release();
    },
    onPointerCancel: release,
    onPointerLeave: () => { [pointer.value, hovered.value] = [null, null]; },
    onDblClick: () => zoomAt(shownTime.value, 4),
    onWheel(event) {
      event.preventDefault();
      if (event.offsetX < LABELS) scroll.value = Math.max(0, Math.min(scroll.value + event.deltaY, view().last));
      else if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) pan(((event.deltaX || event.deltaY) / (view().width - LABELS)) * (visibleRange.value[1] - visibleRange.value[0]));
      else zoomAt(range.value.end === null && cursor.value === null ? visibleRange.value[1] : view().time(event.offsetX), event.deltaY > 0 ? 1.25 : 0.8);
    },
  };
}
