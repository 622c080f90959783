// The designer: a component's states and transitions, drawn and edited.

import { effect, html, useEffect, useLayoutEffect, useMemo, useRef, useSignal, useState } from '../lib/dom.js';
import { on } from '../lib/listen.js';
import { hello, session, watch } from '../lib/store.js';
import { Empty } from '../lib/ui.js';
import { NameField, naming } from '../vicode/ask.js';
import { Drawn, Tips } from '../vicode/canvas/drawn.js';
import { bindCanvasKeys } from '../vicode/canvas/keys.js';
import { Minimap } from '../vicode/canvas/minimap.js';
import { Notes } from '../vicode/canvas/notes.js';
import { band, doubleClick, press, sketch, target, wheel } from '../vicode/canvas/pointer.js';
import { ALL, NAMES, arrange, isLaidOut } from '../vicode/canvas/rows.js';
import { stage } from '../vicode/canvas/stage.js';
import { Conflict } from '../vicode/conflict.js';
import { Footer, Tools } from '../vicode/frame.js';
import { TryLegend, writeTrial } from '../vicode/attempt.js';
import { CoverageLegend, writeCoverage } from '../vicode/coverage.js';
import { DiffLegend, bothVersions } from '../vicode/diff.js';
import { writeLive } from '../vicode/live.js';
import { mode } from '../vicode/mode.js';
import { paint } from '../vicode/paint.js';
import { marked } from '../vicode/problems.js';
import { component, forget, isBroken, list, machine, notes, opened, openedFile, positions, selection } from '../vicode/sources.js';
import { place, stopKeys } from '../vicode/stops.js';

const { view } = stage;
/** Number of arrows above which those of other states fade while something is selected. */
const MANY = 24;

/** What each use of the drawing shows below it and on it. */
const USES = {
  design: { write: writeLive },
  diff: { Legend: DiffLegend, write: () => paint() },
  try: { Legend: TryLegend, write: writeTrial },
  coverage: { Legend: CoverageLegend, write: writeCoverage },
};
const write = () => {
  USES[mode.value].write();
  stage.placeNames();
};

export function Designer({ visible, retitle }) {
  const valid = useRef(null);
  const search = useSignal('');
  const name = component.value;
  useEffect(() => {
    if (name && opened.value) retitle(name);
  }, [name, opened.value?.file]);
  // Each component has its own search.
  useEffect(() => { search.value = ''; }, [name, opened.value?.file]);
  useEffect(() => (visible.value ? bindCanvasKeys() : undefined), [visible.value]);
  if (hello.value && !hello.value.source) return html`<${Empty} what="No folder of sources is open" help="Start the program with --source FOLDER to draw and edit the state machines in it." />`;
  // While the text is no Rust, what it hides stays drawn, in grey.
  const own = machine.value;
  const isHidden = isBroken.value && valid.current?.file === openedFile.value && valid.current.own.name === name && !(own?.states.length >= valid.current.own.states.length);
  if (own && !isHidden) valid.current = { own, file: openedFile.value };
  const drawn = isHidden ? valid.current.own : (mode.value === 'diff' && bothVersions.value) || own;
  const ready = useLaidOut(drawn);
  const { Legend } = USES[mode.value];
  return html`<${Tools} search=${search} />
    ${opened.value?.conflict ? html`<${Conflict} />` : drawn ? ready && html`<${Canvas} machine=${ready} isStale=${isHidden} search=${search} visible=${visible} />${Legend && html`<${Legend} />`}`
      : html`<${Empty} what=${opened.value ? `${opened.value.file} has no component` : 'No component is open'} help=${opened.value ? opened.value.model.trees ? 'Its trees are in the inspector; the text is in the code panel.' : 'Its mistakes are listed below; the text is in the code panel.' : list.value?.length === 0 ? 'There is none below the folder of --source. Press “New…” for the first one.' : 'Choose one in Sources, or press “New…”.'} />`}
    <${Footer} />`;
}

/** A machine if it can be drawn; until the server has laid it out, as it was before. */
function useLaidOut(own) {
  const [, draw] = useState(null);
  const last = useRef(null);
  const { shape } = stage.look.value;
  const isPlaced = positions.value.some(({ component: of, placed }) => placed && of === own?.name);
  const isReady = own !== null && (isPlaced || isLaidOut(own, shape));
  useEffect(() => { if (own && !isReady) arrange(own, shape).then(draw, () => {}); }, [own, shape, isReady]);
  if (isReady) last.current = { own, file: openedFile.value };
  return last.current?.file === openedFile.value && last.current.own.name === own?.name ? last.current.own : null;
}

function Canvas({ machine: own, isStale, search, visible }) {
  const svg = useRef(null);
  const layer = useRef(null);
  /** Whether the focus is moved by the page, and not by a person. */
  const follows = useRef(false);
  const before = useRef(mode.value);
  const shown = `${openedFile.value} ${own.name}`;
  const [isReady, setReady] = useState(false);
  useMemo(() => stage.begin(own), [shown, isReady]);
  // Drawn from the machine and the places, once the size is known; kept while only the selection changes.
  const look = stage.look.value;
  useMemo(() => isReady && stage.take(own, positions.value, notes.value), [own, positions.value, notes.value, look, isReady, isLaidOut(own, look.shape)]);
  const chosen = new Set(selection.value);
  const text = search.value.trim().toLowerCase();
  const found = (name) => (text === '' ? null : name.toLowerCase().includes(text));

  useLayoutEffect(() => {
    view.attach(svg.current, layer.current);
    setReady(true);
    const observer = new ResizeObserver(() => {
      if (!view.resize()) return;
      if (view.whole) stage.fit();
      else view.apply();
    });
    observer.observe(svg.current.parentElement);
    const ends = [on(svg.current, { wheel }, { passive: false }), () => observer.disconnect()];
    return () => ends.forEach((end) => end());
  }, []);
  useLayoutEffect(() => { if (isReady) stage.fit(); }, [shown, isReady]);
  // The drawing of both versions comes after its legend, with which the panel gets another size.
  useLayoutEffect(() => { if (view.whole) stage.fit(); }, [stage.notes.length, mode.value === 'diff' && own.states.length]);
  // So may a machine that was laid out; one whose places were just fixed by a drag stays where it is.
  useLayoutEffect(() => { if (view.whole && view.isAutomatic) stage.fit(); }, [view.isAutomatic && own]);
  useLayoutEffect(() => stage.settle(), [look]);
  useLayoutEffect(() => {
    stage.collect(layer.current);
    svg.current.classList.toggle('small', view.small);
    svg.current.classList.toggle('names', view.isAutomatic && look.level === NAMES);
    svg.current.classList.toggle('brief', view.isAutomatic && look.level > ALL);
    write();
    for (const [key, element] of [...stage.elements, ...stage.labels]) {
      element.classList.toggle('wrong', marked.value.get(key) === 'error');
      element.classList.toggle('warned', marked.value.get(key) === 'warning');
    }
  });
  // The focus goes with the selection: keys are for what has the focus.
  useEffect(() => {
    const active = document.activeElement;
    const key = selection.value.at(-1);
    if (!key || !svg.current.contains(active) || chosen.has(active.dataset.key)) return;
    follows.current = true;
    stage.elements.get(key)?.focus({ preventScroll: true });
    follows.current = false;
  }, [selection.value]);
  const focused = (event) => {
    if (event.target.dataset.key && !follows.current) forget();
  };
  useEffect(() => effect(() => {
    if (!visible.value) return;
    if (mode.value !== before.current) paint();
    before.current = mode.value;
    write();
  }), []);
  useEffect(() => effect(() => {
    for (const [key, element] of stage.elements) element.classList.toggle('target', key === `s:${target.value}`);
  }), []);
  const index = place.value;
  useEffect(() => (visible.value && index >= 0 ? watch({ conditions: own.arrows.length > 0 ? [index] : [] }) : undefined), [visible.value, index, session.value?.id]);

  return html`<div class="machine-canvas fill">
    <svg class=${`machine use-${mode.value} ${own.arrows.length > MANY && selection.value.length > 0 ? 'many' : ''} ${isStale ? 'stale' : ''}`} ref=${svg} tabindex="0" role="group" aria-label=${`States of ${own.name}`} onPointerDown=${press} onDblClick=${doubleClick} onFocusIn=${focused}>
      <${Tips} /><rect class="grid" width="100%" height="100%" fill="url(#grid)" />
      <g ref=${layer} data-layer="1">${isReady && html`<${Drawn} ...${{ machine: own, chosen, found, stops: stopKeys.value }} />`}<${Notes} chosen=${chosen} /><${Sketch} /></g>
    </svg>
    ${own.states.length === 0 && html`<${Blank} machine=${own} />`}
    <${NameField} view=${view} /><${Minimap} chosen=${chosen} />
    ${(own.start.length > 0 || own.stop.length > 0) && html`<p class="whole-hooks">${[...own.start, ...own.stop].map((hook) => html`<span><em>${hook.role}</em> / ${hook.function.name.text}</span>`)}</p>`}
    <div class="zoom" role="group" aria-label="Zoom"><button aria-label="Zoom in" onClick=${() => view.zoom(1.25)}>+</button><button aria-label="Zoom out" onClick=${() => view.zoom(0.8)}>−</button><button title="Show the whole machine (f)" onClick=${() => stage.fit()}>Fit</button></div>
  </div>`;
}

const Blank = ({ machine: own }) => (naming.value ? null : html`<p class="blank dim">${own.step
  ? html`<b>${own.name}</b> has no states: its function <code>step</code> runs in each of its cycles. The code is in the code panel.`
  : html`<b>${own.name}</b> has no states yet. Double-click here, or press <kbd>a</kbd>, to add the first one.`}</p>`);

function Sketch() {
  return html`${sketch.value && html`<path class="sketch" d=${sketch.value} marker-end="url(#tip-chosen)" />`}${band.value && html`<rect class="band" ...${band.value} />`}`;
}
