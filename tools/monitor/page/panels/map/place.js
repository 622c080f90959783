// What the operator may place in a simulated world: it is dragged on the map, or placed by numbers.

import { html, useRef, useSignal } from '../../lib/dom.js';
import { request } from '../../lib/connection.js';
import { command, cursor, notify, operate } from '../../lib/store.js';
import { Menu } from '../../lib/ui.js';

/** Distance from the pointer at which something is taken, px. */
const REACH = 14;
/** Time between two requests while it is dragged. */
const REPEAT_MS = 50;

const metres = (value) => Math.round(value * 1000) / 1000;

/** Sends a position; returns the error, or null. */
async function place(session, name, [x, y]) {
  try {
    await request(name, { session, x, y });
    return null;
  } catch (error) {
    return error;
  }
}

/** Lets the world follow a drag until it has ended. Only the last position has to be possible: on the way may be a robot. */
async function follow(session, drag) {
  if (!(await operate())) return;
  let [sent, error] = [null, null];
  while (!drag.done || sent !== drag.to) {
    if (sent !== drag.to) {
      sent = drag.to;
      error = await place(session, drag.action, sent);
    }
    if (!drag.done) await new Promise((resolve) => { setTimeout(resolve, REPEAT_MS); });
  }
  if (error) notify('error', error.text ?? String(error), error.help ?? '');
}

/**
 * Dragging of what a world lets place. `shown` is the session, `mapOf(element)` the map as it is drawn, `visible` whether the truth is drawn.
 * Returns the handlers of the canvas and where something is dragged, or null.
 */
export function useDrag({ shown, mapOf, visible }) {
  const dragged = useSignal(null);
  const state = useRef(null);
  const near = (event) => {
    if (!visible || !shown?.info.value.can.ball) return undefined;
    const map = mapOf(event.currentTarget);
    return shown.truth.value?.truth.find(({ moved_by: action, value }) => action && value && Math.hypot(map.x(value.x) - event.offsetX, map.y(value.y) - event.offsetY) < REACH);
  };
  const end = () => {
    if (!state.current) return;
    state.current.drag.done = true;
    state.current = null;
  };
  const handlers = {
    onPointerDown: (event) => {
      const item = near(event);
      if (event.button !== 0 || !item) return;
      if (cursor.value !== null) {
        notify('error', `the map shows the past, where the ${item.name} cannot be moved`, 'press “l” to show the present');
        return;
      }
      event.currentTarget.setPointerCapture(event.pointerId);
      const at = mapOf(event.currentTarget).at(event.offsetX, event.offsetY);
      // It keeps its distance from the pointer.
      state.current = { drag: { to: null, done: false, action: item.moved_by }, offset: [item.value.x - at[0], item.value.y - at[1]] };
    },
    onPointerMove: (event) => {
      const moving = state.current;
      if (!moving) {
        event.currentTarget.style.cursor = near(event) ? 'grab' : '';
        return;
      }
      event.currentTarget.style.cursor = 'grabbing';
      const at = mapOf(event.currentTarget).at(event.offsetX, event.offsetY);
      const begins = moving.drag.to === null;
      moving.drag.to = at.map((value, axis) => metres(value + moving.offset[axis]));
      dragged.value = moving.drag.to;
      if (!begins) return;
      follow(shown.id, moving.drag).finally(() => {
        dragged.value = null;
        if (state.current === moving) state.current = null;
      });
    },
    onPointerUp: end,
    onPointerCancel: end,
    onLostPointerCapture: end,
  };
  return { dragged, handlers };
}

/** The menu in which something is placed by numbers. */
export function PlaceMenu({ shown, item }) {
  const { name, moved_by: type } = item;
  const title = name[0].toUpperCase() + name.slice(1);
  const x = useSignal('');
  const y = useSignal('');
  const read = () => {
    const at = shown.truth.value?.truth.find((one) => one.name === name)?.value;
    if (at) [x.value, y.value] = [at.x, at.y].map((value) => value.toFixed(3));
  };
  const submit = (event) => {
    event.preventDefault();
    const at = [x.value, y.value].map((text) => (text.trim() === '' ? NaN : Number(text.trim().replace('−', '-'))));
    if (!at.every(Number.isFinite)) {
      notify('error', `“${x.value}” and “${y.value}” are no position`, 'give two numbers of metres, as -1.5');
      return;
    }
    command(type, { x: at[0], y: at[1] }, `the ${name} lies at ${at[0]}, ${at[1]} m`);
  };
  const field = (label, value) => html`<label>${label} <input class="short" inputmode="decimal" autocomplete="off" aria-label=${`${title} ${label}`} value=${value.value} onInput=${(event) => { value.value = event.target.value; }} /></label>`;
  return html`<${Menu} label=${title} title=${`Place the ${name}`} onOpen=${read}>
    <form class="form" onSubmit=${submit}>${field('x', x)}${field('y', y)}<button>Place</button></form>
    <p class="hint">Metres in the frame of the world. It can also be dragged on the map.</p>
  <//>`;
}
