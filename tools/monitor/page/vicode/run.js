// Build and run: the button, the progress, and what came of it.

import { effect, html, signal, useSignal } from '../lib/dom.js';
import { listen } from '../lib/connection.js';
import { typedNumber } from '../lib/format.js';
import { hello, notify, sessions, show } from '../lib/store.js';
import { Menu } from '../lib/ui.js';
import { ask } from './sources.js';
import { check } from './problems.js';

/** The last message about the program: {state, done, total, text, session, messages}; null before the first. */
export const build = signal(null);
/** Session of the program that was just started, until the page knows and shows it; null otherwise. */
const awaited = signal(null);

listen((message) => {
  if (message?.type !== 'build') return;
  const before = build.value;
  build.value = message;
  if (message.messages.length > 0) check.value = { state: 'done', seconds: check.value?.seconds ?? 0, messages: message.messages };
  if (message.state === 'running' && before?.state !== 'running' && message.session !== null) awaited.value = message.session;
  if (message.state === 'failed' && before?.state !== 'failed') notify('error', 'the program was not built or did not start', message.session === null ? message.text : 'the last one that worked goes on');
});

effect(() => {
  const id = awaited.value;
  if (id === null || !sessions.value.has(id)) return;
  awaited.value = null;
  show(id);
});

const BUSY = new Set(['building', 'starting']);
const TITLES = { building: 'building', starting: 'starting', running: 'runs', failed: 'failed', ended: 'ended' };

export function Run() {
  const seed = useSignal('0');
  const robots = useSignal('0');
  if (!hello.value?.build) return html`<button class="chip" disabled title="Start the program with --build to build and run from here">Run</button>`;
  const now = build.value;
  const busy = BUSY.has(now?.state);
  const run = () => ask('run', { seed: typedNumber(seed.value) || 0, robots: Number(robots.value) || 0 });
  const part = now?.total > 0 ? now.done / now.total : null;
  return html`<span class=${`chip run ${now?.state ?? ''}`} role="group" aria-label="Program">
    ${now && html`<span role="status" title=${now.text}>${TITLES[now.state]}${busy && part !== null ? ` ${now.done} of ${now.total}` : ''}</span>`}
    ${busy && html`<progress aria-label="Progress of the build" max="1" value=${part ?? undefined}></progress>`}
    <button class=${busy ? '' : 'live'} onClick=${run} title="Builds the program and runs it in the built-in world; it becomes a session">${now?.state === 'running' || busy ? 'Run again' : '▶ Run'}</button>
    ${(busy || now?.state === 'running') && html`<button onClick=${() => ask('stop_run')} title="Ends the build and the program">Stop</button>`}
    <${Menu} label="…" title="What is run">
      <div class="form"><label>Seed <input class="short" inputmode="numeric" value=${seed.value} onInput=${(event) => { seed.value = event.target.value; }} aria-label="Seed of the program" /></label>
      <label>Other robots <input class="short" inputmode="numeric" value=${robots.value} onInput=${(event) => { robots.value = event.target.value; }} aria-label="Other robots of the program" /></label></div>
      ${now?.text && html`<p class="hint">${now.text}</p>`}
    <//></span>`;
}
