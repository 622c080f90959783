// What a person must know of the connection and of the shown session, in a line above the panels.

import { html } from './lib/dom.js';
import { link } from './lib/connection.js';
import * as dock from './lib/dock.js';
import { duration, time } from './lib/format.js';
import * as store from './lib/store.js';
import { alarm, draft, goOn, parts } from './lib/watches.js';

const lost = (text) => html`<div class="banner lost" role="alert">${text}</div>`;

export function Banner() {
  if (link.value === 'lost') return lost('The connection to the program is lost. It is being restored; what you operated has ended. If the program was started again, open the new address that it printed.');
  const shown = store.session.value;
  const own = shown && { ...shown.info.value, name: shown.title };
  if (!own || own.connection === 'connecting') return null;
  const { connection, note, result, kind } = own;
  const plain = dock.isPlain();
  const name = plain ? 'The robot' : own.name;
  if (connection === 'lost') return lost(`${name}: the connection is lost and is being restored. ${note}`);
  if (alarm.value) return html`<${Alarm} ...${alarm.value} />`;
  // A plain panel tells itself that its world is over.
  if (plain && kind === 'world' && connection === 'connected') return null;
  if (!plain && result && kind !== 'recording' && (note || connection === 'ended')) return html`<${Result} own=${own} />`;
  if (connection === 'ended') return lost(`${name}: it has ended. ${note}`);
  return kind !== 'recording' && note && html`<div class="banner" role="status">${name}: ${note}</div>`;
}

/** How a run has ended, and what can be done next. */
function Result({ own }) {
  const { name, connection, note, result, kind, paused, seed, can } = own;
  const following = BigInt(seed ?? 0) + 1n;
  const restart = (next, done) => store.act('restart', { seed: next }, done);
  return html`<div class="banner" role="status"><span>${name}: <b>${result}</b>${note && html`<span class="dim">; ${note}</span>`}</span><span class="grow"></span>
    ${kind === 'world' && html`<button class="primary" onClick=${() => restart(null, 'the world begins again')}>Again</button>
      <button onClick=${() => restart(following, `the world begins with seed ${following}`)}>Next seed, ${following}</button>`}
    ${can.pause && paused && connection === 'connected' && html`<button onClick=${() => store.act('resume')}>Go on</button>`}
    <button onClick=${() => dock.open('recordings')}>Keep the recording…</button></div>`;
}

/** The watch that fired last, and what can be done. */
function Alarm({ text, time: at, paused }) {
  const { condition, hold_us: hold } = parts(text);
  const edit = () => {
    draft.value = text;
    dock.open('watches');
  };
  return html`<div class="banner alarm" role="alert"><span><b class="blocks">Watch fired at ${time(at)}:</b> ${condition}${hold > 0 && ` for ${duration(hold)}`}.${paused && ` The world is paused; all panels show ${time(at)}.`}</span><span class="grow"></span>
    ${paused ? html`<button class="primary" onClick=${goOn}>Go on</button>` : html`<button class="primary" onClick=${() => store.seek(at)}>Show that moment</button>`}
    <button onClick=${edit}>Edit watch</button><button aria-label="Dismiss the alert" onClick=${() => { alarm.value = null; }}>×</button></div>`;
}
