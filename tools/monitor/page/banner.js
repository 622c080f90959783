// What a person must know of the connection and of the shown session, in a line above the panels.

import { html } from './lib/dom.js';
import { link } from './lib/connection.js';
import * as dock from './lib/dock.js';
import * as store from './lib/store.js';

const lost = (text) => html`<div class="banner lost" role="alert">${text}</div>`;

export function Banner() {
  if (link.value === 'lost') return lost('The connection to the program is lost. It is being restored; what you operated has ended. If the program was started again, open the new address that it printed.');
  const own = store.session.value?.info.value;
  if (!own || own.connection === 'connecting') return null;
  const { name, connection, note, result, kind } = own;
  if (connection === 'lost') return lost(`${name}: the connection is lost and is being restored. ${note}`);
  if (result && kind !== 'recording' && (note || connection === 'ended')) return html`<${Result} own=${own} />`;
  if (connection === 'ended') return lost(`${name}: it has ended. ${note}`);
  return kind !== 'recording' && note && html`<div class="banner" role="status">${name}: ${note}</div>`;
}

/** How a run has ended, and what can be done next. */
function Result({ own }) {
  const { name, connection, note, result, kind, paused, seed, can } = own;
  const restart = (next, done) => store.act('restart', { seed: next }, done);
  return html`<div class="banner" role="status"><span>${name}: <b>${result}</b>${note && html`<span class="dim">; ${note}</span>`}</span><span class="grow"></span>
    ${kind === 'world' && html`<button class="primary" onClick=${() => restart(null, 'the world begins again')}>Again</button>
      <button onClick=${() => restart(seed + 1, `the world begins with seed ${seed + 1}`)}>Next seed, ${seed + 1}</button>`}
    ${can.pause && paused && connection === 'connected' && html`<button onClick=${() => store.act('resume')}>Go on</button>`}
    <button onClick=${() => dock.open('recordings')}>Keep the recording…</button></div>`;
}
