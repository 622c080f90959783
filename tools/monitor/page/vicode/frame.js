// Above and below the canvas: what is open, what can be done, mistakes, and the state of the file.

import { html, useEffect, useSignal } from '../lib/dom.js';
import { command, cursor, hello, session } from '../lib/store.js';
import { Bar, Menu } from '../lib/ui.js';
import { align } from './canvas/actions.js';
import { focusOn, middle } from './canvas/keys.js';
import { createComponent } from './create.js';
import { savePdf, saveSvg, savePng, saveText } from './export.js';
import { functionsOf } from './machine.js';
import { Modes } from './mode.js';
import { addNote } from './notes.js';
import { check, fixesOf, jump, mend, problems, startCheck } from './problems.js';
import { Run } from './run.js';
import { arrange, ask, choose, chosenStates, component, editedOutside, held, locked, machine, opened, redo, selection, undo } from './sources.js';
import { clearStops, hit, nextHit, stops, wordsOf } from './stops.js';
import { Trail } from './trail.js';

const counted = (number, word) => `${number} ${word}${number === 1 ? '' : 's'}`;

/** Number of transitions: those with a condition, and those on a state that only wait. */
const transitionsOf = ({ component: { states, transitions } }) => transitions.length + states.reduce((sum, { arrows }) => sum + arrows.length, 0);

/** All names of the machine that a text is found in. */
const matching = (text) => {
  const own = machine.value;
  const wanted = text.trim().toLowerCase();
  return own && wanted ? [...own.states, ...own.arrows].filter(({ name }) => name.toLowerCase().includes(wanted)).map(({ key }) => key) : [];
};

export function Tools({ search }) {
  const own = opened.value;
  const components = own?.model.components ?? [];
  const next = (event) => {
    if (event.key !== 'Enter') return;
    const keys = matching(search.value);
    if (keys.length === 0) return;
    focusOn(keys[(keys.indexOf(selection.value.at(-1)) + (event.shiftKey ? -1 : 1) + keys.length) % keys.length]);
    event.target.focus();
  };
  const several = chosenStates().length > 1;
  return html`<${Bar} label="Designer"><${Trail} />
    ${components.length > 1 && html`<select aria-label="Component of the file" onChange=${(event) => { component.value = event.target.value; choose([]); }}>${components.map(({ key }) => html`<option value=${key} selected=${key === component.value}>${key}</option>`)}</select>`}
    ${own && html`<span class="dim file wide" title=${own.file}>${own.file}</span>`}
    ${own && html`<button aria-label="Undo" title="Undo (Ctrl+Z)" onClick=${undo}>↶</button><button aria-label="Redo" title="Make it again (Ctrl+Shift+Z)" onClick=${redo}>↷</button>
    <input class="machine-search" type="search" placeholder="Search ( / )" aria-label="Search states and transitions" value=${search.value} onInput=${(event) => { search.value = event.target.value; }} onKeyDown=${next} />
    ${search.value && html`<span class="dim" role="status">${matching(search.value).length} found</span>`}
    <${Menu} label="More" title="More: notes, layout and pictures">
      <button class="item" onClick=${createComponent} disabled=${!hello.value?.source} title="A new component from a blank canvas">New component…</button>
      <button class="item" disabled=${Boolean(held.value)} onClick=${() => addNote(middle())}>Note…</button>
      ${several && html`<button class="item" title="Centres below each other" onClick=${() => align('x')}>Selected in one column</button><button class="item" title="Centres beside each other" onClick=${() => align('y')}>Selected in one row</button>
      <button class="item" title="Same distances from left to right" onClick=${() => align('across')}>Spread selected ↔</button><button class="item" title="Same distances from top to bottom" onClick=${() => align('down')}>Spread selected ↕</button>`}
      <button class="item" onClick=${arrange}>Arrange all states automatically</button>
      <button class="item" onClick=${saveSvg}>Picture as SVG</button><button class="item" onClick=${savePng}>Picture as PNG</button><button class="item" onClick=${savePdf}>Print, or PDF…</button>
      <button class="item" onClick=${() => saveText('mermaid', 'mmd')}>Mermaid</button><button class="item" onClick=${() => saveText('dot', 'dot')}>DOT (Graphviz)</button>
      <button class="item" onClick=${() => ask('save_file', { file: own.file })}>Save now</button>
    <//>`}
    <span class="grow"></span>${own && html`<${Modes} />`}<${Check} /><${Run} />
  <//>`;
}

function Stops() {
  const shown = session.value;
  if (!shown || stops.value.length === 0) return null;
  const info = shown.info.value;
  const simulated = info.can.pause;
  return html`<span class="chip stops" role="group" aria-label="Breakpoints">${stops.value.length} ${stops.value.length === 1 ? 'breakpoint' : 'breakpoints'}
    ${simulated && info.paused && html`<button onClick=${() => command('step', { cycles: 1 })} title="One cycle (.)">Step</button><button onClick=${() => command('resume')} title="Key ,">Continue</button>`}
    ${(cursor.value !== null || info.kind === 'recording') && html`<button onClick=${nextHit} title="The next moment at which one is reached">Next</button>`}
    <button onClick=${clearStops} aria-label="Remove all breakpoints" title="Remove all">×</button></span>`;
}

function Check() {
  const now = check.value;
  const errors = problems.value.filter(({ level }) => level === 'error').length;
  const since = useSignal(0);
  useEffect(() => {
    if (now?.state !== 'running') return undefined;
    const begin = Date.now();
    const timer = setInterval(() => { since.value = (Date.now() - begin) / 1000; }, 200);
    return () => clearInterval(timer);
  }, [now?.state]);
  if (!opened.value) return null;
  const wrong = errors > 0 ? `${errors} ${errors === 1 ? 'error' : 'errors'}` : '';
  const text = now?.state === 'running' ? `checking ${since.value.toFixed(0)} s` : wrong || (now?.state === 'done' ? `check ✓ ${now.seconds.toFixed(1)} s` : now?.state === 'failed' ? 'not checked' : 'check');
  return html`<button class=${`chip check ${wrong || now?.state === 'failed' ? 'warn' : now?.state === 'done' ? 'fine' : ''}`} role="status" aria-label=${`Check: ${text}`} disabled=${!hello.value?.build && !wrong}
    title=${hello.value?.build ? 'The compiler checks when typing pauses; click to check now' : 'Start the program with --build to check with the compiler'} onClick=${() => (hello.value?.build ? startCheck() : jump(problems.value[0]))}>${text}</button>`;
}

function stateOf(own) {
  if (own.problem) return html`<b class="error">${own.problem}</b>`;
  if (own.deleted) return html`<b class="error">The file was deleted.</b> <button class="small" onClick=${() => ask('save_file', { file: own.file })}>Make it again</button>`;
  if (own.conflict) return html`<b class="warn">not saved: conflict</b>`;
  if (own.readonly) return html`<b class="warn">read-only</b>`;
  return own.saved ? 'saved' : 'not saved yet';
}

export function Footer() {
  const own = opened.value;
  const open = useSignal(false);
  if (!own) return null;
  const list = problems.value;
  const shown = open.value ? list : list.slice(0, 1);
  const outside = editedOutside.value && `edited outside at ${new Date(editedOutside.value).toLocaleTimeString()}`;
  const size = machine.value ? `${counted(machine.value.states.length, 'state')}, ${counted(transitionsOf(machine.value), 'transition')}` : `${own.model.components.flatMap(functionsOf).length} functions`;
  return html`<footer class="frame-foot" aria-label="Mistakes and file" role="region">
    ${hit.value && hit.value.session === session.value?.id && html`<p class="hit-line" role="status"><b>Breakpoint</b> ${wordsOf(hit.value)} at ${(hit.value.time_us / 1e6).toFixed(2)} s${hit.value.paused ? ', the world is paused' : ''} <button class="small" aria-label="Dismiss the hit" onClick=${() => { hit.value = null; }}>×</button></p>`}
    <ul class=${open.value ? 'open' : ''}>${shown.map((one) => html`<li class=${one.level}><button class="name" onClick=${() => jump(one)}>${one.place ?? one.file ?? ''}${one.line ? `:${one.line}` : ''}</button> <span title=${one.help}>${one.text}</span>${fixesOf(one).map((fix) => html` <button class="small fix" disabled=${Boolean(held.value)} onClick=${() => mend(fix)}>${fix.label.replaceAll('`', '')}</button>`)}${one.help && open.value && html` <span class="dim">${one.help}</span>`}</li>`)}</ul>
    ${list.length > 1 && html`<button class="small" aria-expanded=${open.value} onClick=${() => { open.value = !open.value; }}>${open.value ? 'fewer' : `${list.length - 1} more`}</button>`}
    <${Stops} /><span class="grow"></span><span class="dim" role="status" aria-label="State of the file">${locked.value && !own.conflict ? html`${locked.value} · ` : ''}${stateOf(own)}${outside ? ` · ${outside}` : ''} · ${size}</span></footer>`;
}
