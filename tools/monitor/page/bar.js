// The bar at the top, one line: sessions, time, control, and one menu. In a wide window the two menus stand open in it.

import { html, useSignal } from './lib/dom.js';
import { link } from './lib/connection.js';
import { copyLink } from './lib/links.js';
import * as dock from './lib/dock.js';
import { bytes, duration, number, time, typedNumber } from './lib/format.js';
import { PANELS } from './lib/panels.js';
import { savePicture } from './lib/picture.js';
import { playOrPause } from './lib/playback.js';
import * as store from './lib/store.js';
import { besideColour, theme, toggleTheme } from './lib/theme.js';
import { Menu } from './lib/ui.js';
import { Layouts, useSaved } from './layouts.js';
import { helpShown } from './help.js';
import { paletteShown } from './palette.js';

const CONNECTION = { connecting: 'connecting', connected: '', lost: 'lost', ended: 'ended' };

function Sessions() {
  const all = [...store.sessions.value.values()];
  const shown = store.session.value?.info.value;
  // In a wide window two sessions stand in the bar.
  return html`<${Menu} inline=${all.length <= 2 && 'sessions'} label=${shown ? html`<${State} ...${shown} name=${store.session.value.title} />` : 'No session'} title="Sessions">
    ${all.map((one) => {
      const info = one.info.value;
      const chosen = one.id === store.current.value;
      return html`<span key=${one.id} class=${`session ${chosen ? 'chosen' : ''}`}>
        <button class="item" aria-pressed=${chosen} title=${info.note || info.name} onClick=${() => store.show(one.id)}><${State} ...${info} name=${one.title} /></button>
        ${!chosen && html`<${Beside} ...${{ one, name: one.title }} />`}
        ${chosen && all.length > 1 && html`<button class="close" aria-label=${`Close ${one.title}`} onClick=${() => store.act('close')}>×</button>`}
      </span>`;
    })}
    <${Add} />
  <//>`;
}

/** The name of a session, and its connection. */
const State = ({ name, result, connection }) => html`<span class="one"><i class=${`state ${result && connection === 'ended' ? '' : connection}`} aria-hidden="true"></i>${name}${CONNECTION[connection] && html` <em>${CONNECTION[connection]}</em>`}</span>`;

/** Shows a session on the map, the timeline and the plots of the chosen one. */
function Beside({ one, name }) {
  const companion = store.companions.value.find(({ of }) => of === one);
  const title = companion ? `Show ${name} no more beside the chosen session` : `Show ${name} beside the chosen session`;
  return html`<button class="beside" aria-label=${title} title=${`${title}: on one map, timeline and plot`} aria-pressed=${Boolean(companion)} disabled=${!one.description.value}
    ref=${(button) => { if (button) button.style.color = companion ? besideColour(companion.place) : ''; }} onClick=${() => store.putBeside(one.id)}>◫</button>`;
}

function Add() {
  const address = useSignal('tcp://127.0.0.1:7400');
  const world = useSignal(null);
  const seed = useSignal('0');
  const options = useSignal({});
  const worlds = store.hello.value?.worlds ?? [];
  const chosen = worlds.find(({ name }) => name === world.value) ?? worlds[0];
  const full = store.sessions.value.size >= (store.hello.value?.limits.sessions ?? Infinity);
  const open = (source) => store.ask('open', { source }).then((opened) => opened && store.show(opened.session));
  return html`<${Menu} label="+" title="Open another session">
    <form class="form" onSubmit=${(event) => { event.preventDefault(); open({ kind: 'robot', address: address.value }); }}>
      <label>Robot <input value=${address.value} onInput=${(event) => { address.value = event.target.value; }} aria-label="Address of the robot" /></label>
      <button disabled=${full}>Connect</button></form>
    <p class="hint">tcp://HOST:PORT, or serial:DEVICE@BAUD</p>
    <form class="form" onSubmit=${(event) => { event.preventDefault(); open({ kind: 'world', world: chosen.name, seed: typedNumber(seed.value) || 0, options: options.value }); }}>
      <label>World <select aria-label="World" onChange=${(event) => { world.value = event.target.value; }}>
        ${worlds.map(({ name }) => html`<option selected=${name === chosen?.name}>${name}</option>`)}</select></label>
      <label>Seed <input class="short" inputmode="numeric" value=${seed.value} onInput=${(event) => { seed.value = event.target.value; }} aria-label="Seed of the world" /></label>
      ${chosen?.options.map(({ name, doc, max }) => html`<label title=${doc}>${name} <input class="short" type="number" min="0" max=${max} value=${options.value[name] ?? 0} onInput=${(event) => { options.value = { ...options.value, [name]: event.target.value }; }} aria-label=${doc} /></label>`)}
      <button disabled=${!chosen || full}>Start</button></form>
    ${full && html`<p class="warn" role="alert">${store.sessions.value.size} sessions are open, and more are not possible: close one of them</p>`}
    <button class="item" onClick=${() => dock.open('recordings')}>Recordings…</button>
  <//>`;
}

function Clock() {
  const shown = store.session.value;
  const info = shown?.info.value;
  const at = store.cursor.value;
  const recording = info?.kind === 'recording';
  const moment = shown?.moment.value;
  const state = at !== null ? (store.playing.value ? 'playing' : 'paused') : info?.paused ? 'world paused' : 'live';
  const fresh = shown && info.connection === 'connected' && link.value === 'open';
  return html`<button class=${`chip clock ${fresh ? state.replace(' ', '-') : 'off'}`} aria-label=${`Time: ${state}. ${at === null ? 'Pause the view' : recording ? 'Play or pause' : 'Back to live'}`}
    title="Space pauses the view; the robot goes on" onClick=${playOrPause}>
    <i class="dot" aria-hidden="true"></i><span class="state-word">${fresh || !shown ? state : link.value === 'open' ? info.connection : 'lost'}</span> <b>${time(moment?.time_us ?? at)}</b></button>`;
}

function Costs() {
  const shown = store.session.value;
  const costs = shown?.costs.value;
  const budget = shown?.description.value?.budget_ms;
  if (!shown) return null;
  return html`<button class="chip" title="Mean duration of a cycle, from sensor values to command; opens Latency" onClick=${() => dock.open('latency')}>
      <span class="word">chain</span> ${costs ? duration(costs.chain_us[0]) : '–'}${budget ? html` <span class="dim">of ${number(budget)} ms</span>` : ''}</button>`;
}

function Late() {
  const late = store.cursor.value === null && store.session.value?.live.value?.overruns;
  return late > 0 && html`<span class="chip warn" title="Cycles that ended after the next one was due">${late} late</span>`;
}

const CONTROL = {
  free: 'operator: nobody',
  yours: 'operator: you',
  other_page: 'operator: another page',
  other_monitor: 'operator: another monitor',
  unavailable: 'watching only',
};
/** The same for people who are not engineers. */
const PLAIN_CONTROL = {
  free: 'Nobody operates the robot',
  yours: 'You operate the robot',
  other_page: 'Another page operates the robot',
  other_monitor: 'Another program operates the robot',
  unavailable: 'This page only watches',
};

function Control({ plain }) {
  const info = store.session.value?.info.value;
  if (!info) return null;
  const { control } = info;
  return html`<span class=${`chip control ${control}`} role="status" aria-label="Control"><span class="who">${(plain ? PLAIN_CONTROL : CONTROL)[control]}</span>
    ${control === 'free' && html`<button onClick=${() => store.act('acquire')} title="Key c">Take control</button>`}
    ${(control === 'other_page' || control === 'other_monitor') && html`<button onClick=${() => store.act('take', {}, 'control was taken')}>Take control</button>`}
    ${control === 'yours' && html`<button onClick=${() => store.act('release', {}, 'control was given back')} title="Key g: holds, rates and modulations end, parameters stay">Give back</button>`}
  </span>`;
}

function World() {
  const info = store.session.value?.info.value;
  if (!info?.can.pause) return null;
  return html`<span class="chip world" role="group" aria-label="Simulated world"><span class="dim">world</span>
    <button onClick=${() => store.act(info.paused ? 'resume' : 'pause')} title="Key ,">${info.paused ? 'Continue' : 'Pause'}</button>
    <button disabled=${!info.paused} onClick=${() => store.act('step', { cycles: 1 })} title="Key . — one cycle">Step</button>
    ${info.kind === 'world' && html`<button onClick=${() => store.act('restart', { seed: null }, 'the world begins again')} title="The same game from its beginning; changed parameters and control stay">Restart</button>`}</span>`;
}

function Recording() {
  const recording = store.session.value?.info.value.recording;
  if (!recording || (!recording.on && !recording.note)) return null;
  return html`<button class=${`chip rec ${recording.on ? 'runs' : 'warn'}`} title=${recording.note || 'The last minutes are recorded; click to keep them'} onClick=${() => dock.open('recordings')}>
    <i class="dot" aria-hidden="true"></i>${recording.on ? html`<span class="word">recording</span> ${bytes(recording.bytes)}` : 'not recorded'}</button>`;
}

function View() {
  const [saved, load] = useSaved();
  return html`<${Menu} label="View" title="View: layouts and panels" onOpen=${load}>
    <${Layouts} saved=${saved} />
    <h3>Panels</h3>
    <button class="item" onClick=${() => savePicture(dock.active())}>Picture of the panel<kbd>P</kbd></button>
    ${Object.entries(PANELS).map(([name, { title, many }]) => html`<button class="item" onClick=${() => dock.open(name)}>${many ? `New ${title.toLowerCase()}` : title}${dock.opened.value.has(name) ? html`<span class="dim">open</span>` : ''}</button>`)}
  <//>`;
}

/** The connection to the robot, in one word. */
function Connected() {
  const connection = link.value === 'open' && store.session.value?.info.value.connection;
  return connection && html`<span class="chip" role="status"><i class=${`state ${connection}`} aria-hidden="true"></i>${CONNECTION[connection] || 'connected'}</span>`;
}

export function Header() {
  const tree = store.session.value?.description.value?.name;
  const plain = dock.isPlain();
  return html`<header class="top">
    <b class="name" title="Activation tree">${tree ?? 'JManager'}</b>
    ${!plain && html`<${Sessions} />`}
    ${link.value !== 'open' && html`<span class="chip warn" role="status">${link.value === 'lost' ? 'program lost' : 'connecting'}</span>`}
    ${plain ? html`<${Connected} />` : html`<${Clock} /><${Late} />`}
    <span class="grow"></span>
    <${Control} plain=${plain} />
    <${Menu} inline="tools" label="Menu" title="Menu">${!plain && html`<${World} /><${Costs} /><${Recording} />
      <button class="find" title="Find anything (Ctrl+K)" aria-label="Find anything" onClick=${() => { paletteShown.value = true; }}>⌕<span class="word"> Find…</span></button>
      <button class="plain" aria-label="Copy a link to this moment" title="Copy a link to this moment, with the layout and its watches" onClick=${copyLink}>Link</button>`}
      <${View} />
      <button class="plain" aria-label=${`Change to the ${theme.value === 'dark' ? 'light' : 'dark'} theme`} title="Key t" onClick=${toggleTheme}>${theme.value === 'dark' ? '☀' : '☾'}<span class="narrow"> ${theme.value === 'dark' ? 'Light' : 'Dark'} theme</span></button>
      <button class="plain" aria-label="Keys" title="Keys (?)" onClick=${() => { helpShown.value = true; }}>?<span class="narrow"> Keys</span></button><//>
  </header>`;
}
