// A component that is carried with the mouse from a list or the activation tree onto a state.

import { html, signal } from '../lib/dom.js';
import { on } from '../lib/listen.js';
import { addChild } from './canvas/actions.js';
import { target } from './canvas/pointer.js';

const START = 6;

/** What is carried: {name, x, y}, or null. */
export const carried = signal(null);

const stateUnder = ({ clientX, clientY }) => document.elementFromPoint(clientX, clientY)?.closest('.machine-canvas [data-state]')?.dataset.state ?? null;

/** Begins at a press on a component; a click stays a click. */
export function carry(event, name) {
  if (event.button !== 0 || event.shiftKey) return;
  const begin = [event.clientX, event.clientY];
  const step = (one) => {
    if (!carried.value && Math.hypot(one.clientX - begin[0], one.clientY - begin[1]) < START) return;
    one.preventDefault();
    carried.value = { name, x: one.clientX, y: one.clientY };
    target.value = stateUnder(one);
  };
  const end = (one) => {
    stop();
    const dropped = carried.value && one.type === 'pointerup' ? stateUnder(one) : null;
    if (carried.value) window.addEventListener('click', swallow, { capture: true, once: true });
    setTimeout(() => window.removeEventListener('click', swallow, true), 50);
    carried.value = null;
    target.value = null;
    if (dropped) addChild(dropped, name);
  };
  const stop = on(window, { pointermove: step, pointerup: end, pointercancel: end });
}

/** What is carried, at the pointer. */
export function Carried() {
  const one = carried.value;
  const place = (element) => {
    if (!element) return;
    element.style.left = `${one.x + 12}px`;
    element.style.top = `${one.y + 8}px`;
  };
  return one && html`<div class="carried" ref=${place}>${one.name}</div>`;
}

function swallow(event) {
  event.stopPropagation();
  event.preventDefault();
}
