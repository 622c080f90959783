// STOP, for a robot that declares one: it has a strip of the page of its own, lies above everything else, and needs no control.

import { computed, effect, html, render, signal } from './lib/dom.js';
import { link, request } from './lib/connection.js';
import * as dock from './lib/dock.js';
import { leaving, session, sessions } from './lib/store.js';

/** Time after which a robot that has not answered may not have been reached, ms. */
const ANSWER_MS = 1000;

/** Whether the shown session can be stopped. A recording and a run that has ended do nothing any more. */
const isStoppable = computed(() => {
  const { kind, connection } = session.value?.info.value ?? {};
  const components = session.value?.description.value?.components ?? [];
  return kind !== 'recording' && connection !== 'ended' && components.some(({ modulations }) => modulations.some(({ stops }) => stops));
});

/** What has become of the last press: {of, text, state}; the state is `sent`, `done` or `failed`. */
const pressed = signal(null);

async function press() {
  const of = session.value;
  const tell = (state, text) => { pressed.value = { of, text, state }; };
  if (of.info.value.control === 'yours') leaving.add(of.id);
  tell('sent', 'stopping …');
  const late = setTimeout(() => tell('failed', 'no answer: it may not have stopped. Hold the robot'), ANSWER_MS);
  try {
    await request('stop', { session: of.id });
    tell('done', 'stopped; nobody operates it now');
  } catch ({ text }) {
    leaving.delete(of.id);
    tell('failed', `not stopped: ${text}. Hold the robot`);
  }
  clearTimeout(late);
}

/** What a person must know before pressing. */
function warning() {
  if (link.value !== 'open') return 'No connection to the program: STOP reaches nobody. Hold the robot';
  return session.value.info.value.connection === 'connected' ? null : 'No connection to the robot: STOP does not reach it. Hold the robot';
}

// The press counts, not its end: nothing that moves under the pointer makes it another one. Keys have no pointer.
const presses = { onPointerDown: (event) => event.button === 0 && press(), onClick: (event) => event.detail === 0 && press() };

function Stop() {
  if (!isStoppable.value) return null;
  const { title, info: { value: { control } } } = session.value;
  const isNews = pressed.value?.of === session.value && (pressed.value.state !== 'done' || !['yours', 'other_page', 'other_monitor'].includes(control));
  const last = isNews ? pressed.value : null;
  const lost = warning();
  const text = lost ?? (last?.text || (sessions.value.size > 1 ? `stops ${title}` : ''));
  return html`<button class=${lost ? 'lost' : ''} aria-label="STOP" title="Stops the robot, whoever operates it" ...${presses}>STOP</button>
    <span role=${lost || last?.state === 'failed' ? 'alert' : 'status'}>${text}</span>`;
}

const strip = document.createElement('div');
strip.id = 'stop';
strip.popover = 'manual';
strip.role = 'region';
strip.ariaLabel = 'Stop';

/** Puts the strip above what was opened last. While a dialog is modal, only what is in it can be pressed. */
function raise() {
  const place = [...document.querySelectorAll('dialog:modal')].at(-1) ?? document.body;
  if (strip.parentNode !== place) place.append(strip);
  strip.hidePopover();
  strip.showPopover();
}

/** Shows the strip for as long as the page lives. */
export function start() {
  document.body.append(strip);
  render(html`<${Stop} />`, strip);
  effect(() => {
    const { classList } = document.documentElement;
    classList.toggle('stoppable', isStoppable.value);
    classList.toggle('plain-page', dock.isPlain());
    raise();
  });
  for (const event of ['toggle', 'close', 'fullscreenchange']) document.addEventListener(event, ({ target }) => target !== strip && raise(), true);
  // A dialog that was removed with the strip in it sends no event.
  new MutationObserver(() => strip.isConnected || raise()).observe(document.body, { childList: true, subtree: true });
}
