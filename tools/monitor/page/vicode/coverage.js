// Coverage: what the selected session has visited of the shown machine, in numbers and on the drawing.

import { effect, html, signal } from '../lib/dom.js';
import { request } from '../lib/connection.js';
import { session } from '../lib/store.js';
import { Empty } from '../lib/ui.js';
import { focusOn } from './canvas/keys.js';
import { stateKey } from './machine.js';
import { mode } from './mode.js';
import { countText, paint } from './paint.js';
import { component, machine, openedFile, openedText, selection } from './sources.js';
import { place } from './stops.js';

/** The answer to `coverage`, or {error}; null while it is not known. */
const coverage = signal(null);
/** Time between two requests, ms. */
const BEAT = 1000;
const seconds = (us) => `${(us / 1e6).toFixed(2)} s`;

effect(() => {
  const [file, name, index, shown] = [openedFile.value, component.value, place.value, session.value];
  void openedText.value;
  coverage.value = null;
  if (mode.value !== 'coverage' || !file || index < 0 || !shown) return undefined;
  let last = null;
  const read = async () => {
    const until = shown.info.value.until_us;
    const now = shown.live.value?.time_us ?? until;
    if (now === last && coverage.peek()) return;
    last = now;
    const answer = await request('coverage', { session: shown.id, file, component: name, index }).catch((error) => ({ error }));
    if (mode.value === 'coverage' && component.value === name && session.value === shown) coverage.value = answer;
  };
  // Not within the effect, which would depend on what is read.
  queueMicrotask(read);
  const timer = setInterval(read, BEAT);
  return () => clearInterval(timer);
});

const takenBy = (now, arrow) => now.transitions.filter((one) => one.name === arrow.name && one.to === arrow.to && (arrow.any || one.from === arrow.from)).reduce((sum, one) => sum + one.taken, 0);

/** Whether states show that an arrow was taken: one to its own state changes none. */
const isSeen = ({ from, to, any }) => any || from !== to;

/** Writes the coverage onto the drawing. */
export function writeCoverage() {
  const now = coverage.value;
  if (!now || now.error) return paint();
  paint((state) => {
    const found = now.states.find(({ name }) => name === state.name);
    return found?.visits > 0 ? { flags: ['visited'], text: countText(found) } : { flags: ['unvisited'], text: '' };
  }, (arrow) => {
    if (!isSeen(arrow)) return { flags: [], count: 0, text: 'not known' };
    const count = takenBy(now, arrow);
    return { flags: [count > 0 ? 'visited' : 'unvisited'], count, text: '' };
  });
  return undefined;
}

/** The arrows of the machine, those of a bundle once: {key, name, to, taken, or}. */
function ways(now) {
  const found = new Map();
  for (const arrow of machine.value.arrows) {
    const key = `${arrow.name} ${arrow.to}`;
    const known = found.get(key) ?? { key: arrow.key, name: arrow.name, to: arrow.to, taken: isSeen(arrow) ? 0 : null, or: new Set() };
    for (const one of now.transitions.filter(({ name, from, to, taken }) => taken > 0 && name === arrow.name && to === arrow.to && (arrow.any || from === arrow.from))) one.or.forEach((name) => known.or.add(name));
    found.set(key, { ...known, taken: isSeen(arrow) ? known.taken + takenBy(now, arrow) : known.taken });
  }
  return [...found.values()];
}

export function CoverageSide() {
  const now = coverage.value;
  if (!session.value) return html`<${Empty} what="No session is selected" help="Open a world, a robot or a recording: what it visits is counted." />`;
  if (place.value < 0) return html`<${Empty} what=${`${session.value.title} does not run ${component.value ?? 'this component'}`} help="Select a session that runs it." />`;
  if (!now || !machine.value) return html`<${Empty} what="Counting…" help="What the session remembers is counted." />`;
  if (now.error) return html`<${Empty} what=${now.error.text ?? String(now.error)} help=${now.error.help ?? ''} />`;
  const all = ways(now);
  const missed = [...now.states.filter(({ visits }) => visits === 0).map(({ name }) => stateKey(name)), ...all.filter(({ taken }) => taken === 0).map(({ key }) => key)];
  const next = () => focusOn(missed[(missed.indexOf(selection.value.at(-1)) + 1) % missed.length]);
  return html`<p class="now" role="status"><b>${now.states.filter(({ visits }) => visits > 0).length} of ${now.states.length} states</b>, <b>${all.filter(({ taken }) => taken > 0).length} of ${all.filter(({ taken }) => taken !== null).length} transitions</b> <span class="dim">· ${seconds(now.us)} of ${session.value.title}</span></p>
    <div class="join"><button disabled=${missed.length === 0} onClick=${next}>Next not visited</button></div>
    <table class="counts"><thead><tr><th>State</th><th class="n">visits</th><th class="n">time</th><th class="n">longest</th></tr></thead><tbody>${now.states.map((one) => html`<tr class=${one.visits > 0 ? '' : 'missed'}><td><button class="name" onClick=${() => focusOn(stateKey(one.name))}>${one.name}</button></td><td class="n">${one.visits || '–'}</td><td class="n">${one.visits ? seconds(one.us) : ''}</td><td class="n">${one.visits ? seconds(one.longest_us) : ''}</td></tr>`)}</tbody></table>
    <table class="counts"><thead><tr><th>Transition</th><th class="n">taken</th></tr></thead><tbody>${all.map(({ key, name, to, taken, or }) => html`<tr class=${taken === 0 ? 'missed' : ''}><td><button class="name" onClick=${() => focusOn(key)}>${name}</button> <span class="dim">→ ${to}${or.size > 0 ? ` (or ${[...or].join(', ')})` : ''}</span></td><td class="n" title=${taken === null ? 'It leads to the state that it leaves: states do not show it' : ''}>${taken === null ? 'not known' : taken || '–'}</td></tr>`)}</tbody></table>
    ${now.unknown.length > 0 && html`<p class="warn">Not in this source: ${now.unknown.join(', ')}</p>`}`;
}

export const CoverageLegend = () => html`<p class="legend" role="note"><span class="visit-mark">■ visited, with count and time</span><span class="dim">dashed: not visited</span></p>`;
