// The page: bar, docked panels, notices, keys.

// The first: its listener comes before all others.
import './lib/keys.js';
import { Fragment, effect, html, render } from './lib/dom.js';
import { shownTime, toTransition } from './lib/axis.js';
import { connect } from './lib/connection.js';
import * as dock from './lib/dock.js';
import { bind, restrict } from './lib/keys.js';
import { follow, parametersOf, writeAddress } from './lib/links.js';
import './lib/messages.js';
import './lib/names.js';
import { savePicture } from './lib/picture.js';
import { playOrPause } from './lib/playback.js';
import { PRESETS } from './lib/presets.js';
import { setEdge, span } from './lib/span.js';
import * as store from './lib/store.js';
import { toggleTheme } from './lib/theme.js';
import { Banner } from './banner.js';
import { Header } from './bar.js';
import { Help, helpShown } from './help.js';
import { Palette, paletteShown } from './palette.js';
import { Form } from './vicode/ask.js';
import { Carried } from './vicode/carry.js';
import * as stop from './stop.js';

/** The last error, or else the last message, in one line under the bar: it covers tabs at the most, and moves nothing. */
function Notices() {
  const all = store.notices.value;
  const notice = all.findLast(({ level }) => level === 'error') ?? all.at(-1);
  return html`<div class=${`notices ${dock.isPlain() ? 'plain' : ''}`} role="log" aria-live="polite" aria-label="Messages">
    ${notice && html`<div key=${notice.id} class=${`notice ${notice.level}`} role=${notice.level === 'error' ? 'alert' : 'status'}>
      <span><strong>${notice.text}</strong>${notice.count > 1 && html` <span class="dim">${notice.count} times</span>`}${notice.help && html`: ${notice.help}`}</span>
      ${all.length > 1 && html`<span class="dim more">${all.length - 1} more</span>`}
      ${notice.action && html`<button onClick=${notice.action.run}>${notice.action.label}</button>`}
      <button class="plain" aria-label="Dismiss message" onClick=${() => store.dismiss(notice.id)}>×</button></div>`}
  </div>`;
}

function App() {
  return html`<${Fragment}><${Header} /><${Banner} /><${Notices} /><div id="dock" ref=${startDock}></div><${Help} /><${Palette} /><${Form} /><${Carried} /></${Fragment}>`;
}

/** What the page was opened with. */
const wanted = parametersOf(location);
let started = false;

function startDock(element) {
  if (!element || started) return;
  started = true;
  dock.start(element);
  if (PRESETS[wanted.layout]) dock.preset(wanted.layout);
  else first(dock.restore());
}

/** The layout of a first visit to a tree, which an extension may choose. `before` is the tree of the last visit; null without one. */
function first(before) {
  if (before === null) dock.preset(dock.firstPreset(0) ?? 'overview');
  // An address with a session is that of a page that was loaded again.
  else if (wanted.session) return;
  const name = dock.layoutName.value;
  const end = effect(() => {
    const tree = store.session.value?.description.value?.name;
    if (tree === undefined) return;
    setTimeout(() => {
      end();
      const chosen = dock.firstPreset(store.sessions.value.size);
      if (dock.layoutName.value !== name || tree === before) return;
      if (chosen) dock.preset(chosen);
      else if (before === null) dock.refit(name);
    });
  });
}

// ---- keys

const { seek, step, cycle_us, range, visibleRange } = store;
const zoom = (factor) => {
  const [from, until] = visibleRange.value;
  range.value = { span: Math.min(Math.max((until - from) * factor, 20e3), 4 * 3600e6), end: range.value.end };
};

/** Keys that a plain layout has, too: none of them changes what it shows, or who operates the robot. */
const PLAIN = ['?', 't'];

const KEYS = [
  ['?', 'this list', 'Page', () => { helpShown.value = !helpShown.value; }],
  ['Ctrl+k', 'find anything', 'Page', () => { paletteShown.value = true; }],
  ['t', 'dark or light', 'Page', toggleTheme],
  ['F6', 'next panel', 'Page', () => dock.focusNext(1)],
  ['Shift+F6', 'previous panel', 'Page', () => dock.focusNext(-1)],
  ['m', 'panel as large as the page, and back', 'Page', dock.maximize],
  ['P', 'picture of the panel, as PNG', 'Page', () => savePicture(dock.active())],
  ['x', 'close the panel', 'Page', dock.closeActive],
  ['p', 'new plot', 'Page', () => dock.open('plot')],
  ...Object.entries(PRESETS).map(([name, { title }], index) => [`${index + 1}`, `layout “${title}”`, 'Page', () => dock.preset(name)]),
  [' ', 'pause the view, or live; play a recording', 'Time', playOrPause],
  ['l', 'live', 'Time', () => seek(null)],
  ['ArrowLeft', 'one cycle back', 'Time', () => step(-cycle_us.value)],
  ['ArrowRight', 'one cycle on', 'Time', () => step(cycle_us.value)],
  ['Shift+ArrowLeft', 'one second back', 'Time', () => step(-1e6)],
  ['Shift+ArrowRight', 'one second on', 'Time', () => step(1e6)],
  ['[', 'previous transition of the shown component', 'Time', () => toTransition(-1)],
  [']', 'next transition of the shown component', 'Time', () => toTransition(1)],
  ['i', 'the span begins at the shown moment', 'Time', () => setEdge(0, shownTime.value)],
  ['o', 'the span ends at the shown moment', 'Time', () => setEdge(1, shownTime.value)],
  ['\\', 'no span', 'Time', () => { span.value = null; }],
  ['Home', 'first moment', 'Time', () => seek(store.session.value?.info.value.from_us ?? 0)],
  ['End', 'last moment', 'Time', () => seek(store.session.value?.info.value.until_us ?? 0)],
  ['+', 'zoom in', 'Time', () => zoom(0.6)],
  ['-', 'zoom out', 'Time', () => zoom(1 / 0.6)],
  ['c', 'take control if nobody has it', 'Operate', store.operate],
  ['g', 'give control back', 'Operate', () => store.act('release', {}, 'control was given back')],
  ['u', 'undo the last change of a parameter', 'Operate', store.undoParams],
  ['U', 'redo the change that was undone', 'Operate', store.redoParams],
  [',', 'pause or continue a simulated world', 'Operate', () => store.act(store.session.value?.info.value.paused ? 'resume' : 'pause')],
  ['.', 'one cycle of a paused world', 'Operate', () => store.act('step', { cycles: 1 })],
];
for (const [key, text, group, run] of KEYS) bind({ key, text, group, run, plain: PLAIN.includes(key) });
restrict(() => dock.isPlain());
bind({ key: 'Escape', text: 'close this list', group: 'Page', run: () => { helpShown.value = false; }, plain: true });

// A plain layout has no clock: it shows the present.
effect(() => {
  if (dock.isPlain() && store.cursor.value !== null && store.session.value?.info.value.kind !== 'recording') store.seek(null);
});

window.addEventListener('hashchange', follow);
follow();
effect(writeAddress);

effect(() => {
  const name = store.session.value?.title;
  document.title = name ? `${name} · JManager` : 'JManager';
});

// Gives the page's modules to drivers of browsers that run scripts apart from it.
window.load = (name) => import(name);

const place = document.getElementById('app');
place.replaceChildren();
render(html`<${App} />`, place);
stop.start();
connect();
