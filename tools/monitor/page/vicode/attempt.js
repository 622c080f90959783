// Trying a machine without building it: conditions are switches, timers run. The server evaluates the steps.

import { computed, effect, html, signal } from '../lib/dom.js';
import { duration } from '../lib/format.js';
import { notify } from '../lib/store.js';
import { download, Empty } from '../lib/ui.js';
import { mode } from './mode.js';
import { countText, paint } from './paint.js';
import { ask, component, machine, openedFile, openedText } from './sources.js';

/** Steps so far: {switch: {condition, on}} or {run: ms}. */
const steps = signal([]);
/** The answer of the server: {trial, test}. */
const result = signal(null);
/** Whether time runs by itself. */
const runs = signal(false);
/** Time that passes between two requests while it runs, ms. */
const BEAT = 200;

const trial = computed(() => result.value?.trial ?? null);
const seconds = (us) => `${(us / 1e6).toFixed(2)} s`;

// Another machine begins anew; a changed text is tried with the same steps.
let shown = null;
effect(() => {
  const key = `${openedFile.value} ${component.value}`;
  if (key === shown) return;
  shown = key;
  [steps.value, result.value, runs.value] = [[], null, false];
});
let asked = 0;
effect(() => {
  const [file, name, all] = [openedFile.value, component.value, steps.value];
  void openedText.value;
  if (mode.value !== 'try' || !file || !machine.value?.states.length) return;
  const number = (asked += 1);
  ask('try_machine', { file, component: name, steps: all }).then((answer) => {
    if (number !== asked) return;
    if (answer) result.value = answer;
    else runs.value = false;
  });
});
effect(() => {
  if (mode.value !== 'try') runs.value = false;
  if (!runs.value) return undefined;
  const timer = setInterval(() => run(BEAT), BEAT);
  return () => clearInterval(timer);
});

/** Adds steps; time that passes after time is one step. */
function add(...more) {
  const next = [...steps.value];
  for (const one of more) {
    if (one.run && next.at(-1)?.run) next[next.length - 1] = { run: next.at(-1).run + one.run };
    else next.push(one);
  }
  steps.value = next;
}

const run = (ms) => add({ run: Math.max(1, Math.ceil(ms)) });
const period = () => (trial.value?.period_us ?? 10_000) / 1000;

/** Time to just after the next run, ms. */
const toRun = () => (trial.value ? Math.floor(trial.value.next_run_us / 1000) + 1 - Math.ceil(trial.value.now_us / 1000) : 10);

/** Switches a condition and lets the machine run once. */
export function toggle(condition) {
  const now = trial.value;
  if (!now || !(condition in now.switches)) return;
  add({ switch: { condition, on: !now.switches[condition] } }, ...(runs.value ? [] : [{ run: toRun() }]));
}

/** Goes back to the moment after a state was entered. */
function back({ step, from_us }) {
  const before = steps.value.slice(0, step);
  const begun = before.reduce((sum, one) => sum + (one.run ?? 0), 0);
  runs.value = false;
  steps.value = from_us === 0 ? [] : [...before, { run: Math.max(1, Math.floor(from_us / 1000) + 1 - begun) }];
}

/** Number of visits and time by state, and number of times that each way was taken. */
const counts = computed(() => {
  const [states, ways] = [new Map(), new Map()];
  (trial.value?.visits ?? []).forEach(({ state, us, by }, index, all) => {
    const known = states.get(state) ?? { visits: 0, us: 0 };
    states.set(state, { visits: known.visits + 1, us: known.us + us });
    const way = `${by} ${all[index - 1]?.state} ${state}`;
    if (by) ways.set(way, (ways.get(way) ?? 0) + 1);
  });
  return { states, ways };
});

/** Writes the trial onto the drawing. */
export function writeTrial() {
  const now = trial.value;
  if (!now || !machine.value) return paint();
  const { states, ways } = counts.value;
  const current = now.visits.at(-1);
  paint((state) => {
    const found = states.get(state.name);
    if (state.name === current.state) return { flags: ['lit', 'visited'], text: seconds(current.us) };
    return found ? { flags: ['visited'], text: countText(found) } : { flags: ['unvisited'], text: '' };
  }, (arrow) => {
    const way = now.ways.find(({ condition, to }) => condition === arrow.name && to === arrow.to && (arrow.any || arrow.from === current.state));
    const count = [...ways].filter(([key]) => (arrow.any ? key.startsWith(`${arrow.name} `) && key.endsWith(` ${arrow.to}`) : key === `${arrow.name} ${arrow.from} ${arrow.to}`)).reduce((sum, [, number]) => sum + number, 0);
    const flags = [count > 0 ? 'visited' : 'unvisited', way && 'leaves', way?.on && 'holds'].filter(Boolean);
    return { flags, count, text: way?.on && way.remaining_us > 0 ? `${seconds(way.remaining_us)} left` : way?.on ? 'true' : '' };
  });
  return undefined;
}

const Switch = ({ name, on, children }) => html`<li><button class=${`switch ${on ? 'on' : ''}`} role="switch" aria-checked=${on} aria-label=${`Condition ${name}`} onClick=${() => toggle(name)}><i></i></button>${children}</li>`;

function Ways({ now }) {
  const current = now.visits.at(-1).state;
  const leaving = new Set(now.ways.map(({ condition }) => condition));
  const others = Object.entries(now.switches).filter(([name]) => !leaving.has(name));
  return html`<h3>Ways out of ${current}, tried from top to bottom</h3>
    <ol class="switches" role="group" aria-label="Ways out">${now.ways.map(({ condition, to, on, remaining_us: left }) => html`<${Switch} name=${condition} on=${on}><b>${condition}</b> → ${to}<span class="grow"></span><span class=${on ? 'yes' : 'dim'}>${left > 0 ? `${seconds(left)} left` : on ? 'true' : 'false'}</span><//>`)}
    ${now.ways.length === 0 && html`<li class="dim">No transition leaves it.</li>`}</ol>
    ${others.length > 0 && html`<details><summary>${others.length} other condition${others.length === 1 ? '' : 's'}${others.some(([, on]) => on) ? `, ${others.filter(([, on]) => on).length} true` : ''}</summary><ul class="switches">${others.map(([name, on]) => html`<${Switch} name=${name} on=${on}>${name}<//>`)}</ul></details>`}`;
}

function Time({ now }) {
  const next = now.ways.filter(({ on, remaining_us: left }) => on && left > 0).map(({ remaining_us: left }) => left);
  const waiting = now.ways.map(({ remaining_us: left }) => left).filter((left) => left > 0);
  const least = Math.min(...(next.length > 0 ? next : waiting));
  return html`<div class="join time-row"><b class="clock-text">${seconds(now.now_us)}</b>
    <button class=${runs.value ? 'on' : 'primary'} onClick=${() => { runs.value = !runs.value; }}>${runs.value ? 'Stop' : 'Run'}</button>
    <button onClick=${() => run(toRun())} title="One run of the component">Step ${duration(now.period_us)}</button><button onClick=${() => run(1000)}>+1 s</button>
    <button disabled=${!Number.isFinite(least)} title="Until the next timer has expired" onClick=${() => run(least / 1000 + period())}>To timer</button></div>`;
}

/** Most states that the trail shows. */
const SHOWN = 60;

function Tried({ now }) {
  const visits = now.visits.slice(-SHOWN);
  return html`<h3>What was tried</h3><div class="tried" role="group" aria-label="Back to">${now.visits.length > SHOWN && html`<span class="dim">…</span>`}${visits.map((visit) => html`<button class=${visit === visits.at(-1) ? 'on' : ''} title=${`Back to ${seconds(visit.from_us)}${visit.by ? `, when ${visit.by} was true` : ''}`} onClick=${() => back(visit)}>${visit.state} <span class="dim">${seconds(visit.us)}</span></button>`)}</div>
    <div class="join"><button disabled=${steps.value.length === 0} onClick=${() => { steps.value = steps.value.slice(0, -1); }}>Undo last</button><button disabled=${steps.value.length === 0} onClick=${() => { [steps.value, runs.value] = [[], false]; }}>Start over</button></div>`;
}

function Test() {
  const { test } = result.value;
  const copy = () => navigator.clipboard.writeText(test).then(() => notify('done', 'the test was copied'), () => notify('error', 'the browser does not allow copying', 'save it instead'));
  return html`<details class="test"><summary>As a test in Rust</summary><div class="join"><button onClick=${copy}>Copy</button><button onClick=${() => download(`${component.value.split('<')[0].toLowerCase()}_tried.rs`, new Blob([test], { type: 'text/plain' }))}>Save</button></div><pre>${test}</pre></details>`;
}

export function TrySide() {
  const now = trial.value;
  if (!machine.value?.states.length) return html`<${Empty} what="There is nothing to try" help="Open a component with states." />`;
  if (!now) return html`<${Empty} what="Starting…" help="The server evaluates the machine." />`;
  const { states } = counts.value;
  return html`<p class="now" role="status"><b>${now.visits.at(-1).state}</b> for ${seconds(now.visits.at(-1).us)} <span class="dim">· ${states.size} of ${machine.value.states.length} states</span></p>
    <${Time} now=${now} /><${Ways} now=${now} /><${Tried} now=${now} /><${Test} />`;
}

export const TryLegend = () => html`<p class="legend" role="note"><span class="live-mark">■ present state, its ways out</span><span class="visit-mark">■ visited, with count and time</span><span class="dim">dashed: not visited</span><span class="dim">bodies and children do not run</span></p>`;
