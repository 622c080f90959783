// The ball of a simulated world: the operator drags it on the map, or places it by numbers.

import { html, useRef, useSignal } from '../../lib/dom.js';
import { request } from '../../lib/connection.js';
import { command, cursor, notify, operate } from '../../lib/store.js';
import { Menu } from '../../lib/ui.js';

/** Distance from the pointer at which the ball is taken, px. */
const REACH = 14;
/** Time between two requests while it is dragged. */
const REPEAT_MS = 50;

const metres = (value) => Math.round(value * 1000) / 1000;

/** Sends a position; returns the error, or null. */
async function place(session, [x, y]) {
  try {
    await request('place_ball', { session, x, y });
    return null;
  } catch (error) {
    return error;
  }
}

/** Lets the world follow a drag until it has ended. Only the last position has to be possible: on its way the ball may pass a robot. */
async function follow(session, drag) {
  if (!(await operate())) return;
  let [sent, error] = [null, null];
  while (!drag.done || sent !== drag.to) {
    if (sent !== drag.to) {
      sent = drag.to;
      error = await place(session, sent);
    }
    if (!drag.done) await new Promise((resolve) => { setTimeout(resolve, REPEAT_MS); });
  }
  if (error) notify('error', error.text ?? String(error), error.help ?? '');
}

/**
 * Dragging of the true ball. `shown` is the session, `mapOf(element)` the map as it is drawn, `visible` whether the truth is drawn, `reach`
 * half the length and width of the field. Returns the handlers of the canvas and where the ball is dragged, or null.
 */
export function useDrag({ shown, mapOf, visible, reach }) {
  const dragged = useSignal(null);
  const state = useRef(null);
  const ball = () => shown.truth.value?.truth.ball;
  const isNear = (event) => {
    if (!visible || !ball() || !shown.info.value.can.ball) return false;
    const map = mapOf(event.currentTarget);
    return Math.hypot(map.x(ball()[0]) - event.offsetX, map.y(ball()[1]) - event.offsetY) < REACH;
  };
  const end = () => {
    if (!state.current) return;
    state.current.drag.done = true;
    state.current = null;
  };
  const handlers = {
    onPointerDown: (event) => {
      if (event.button !== 0 || !isNear(event)) return;
      if (cursor.value !== null) {
        notify('error', 'the map shows the past, where the ball cannot be moved', 'press “l” to show the present');
        return;
      }
      event.currentTarget.setPointerCapture(event.pointerId);
      const at = mapOf(event.currentTarget).at(event.offsetX, event.offsetY);
      // The ball keeps its distance from the pointer.
      state.current = { drag: { to: null, done: false }, offset: [ball()[0] - at[0], ball()[1] - at[1]] };
    },
    onPointerMove: (event) => {
      const moving = state.current;
      if (!moving) {
        event.currentTarget.style.cursor = isNear(event) ? 'grab' : '';
        return;
      }
      event.currentTarget.style.cursor = 'grabbing';
      const at = mapOf(event.currentTarget).at(event.offsetX, event.offsetY);
      const begins = moving.drag.to === null;
      moving.drag.to = at.map((value, axis) => metres(Math.min(Math.max(value + moving.offset[axis], -reach[axis]), reach[axis])));
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

/** The menu in which the ball is placed by numbers. */
export function BallMenu({ shown, reach }) {
  const x = useSignal('');
  const y = useSignal('');
  const read = () => {
    const ball = shown.truth.value?.truth.ball;
    if (ball) [x.value, y.value] = ball.map((value) => value.toFixed(3));
  };
  const submit = (event) => {
    event.preventDefault();
    const at = [x.value, y.value].map((text) => (text.trim() === '' ? NaN : Number(text.trim().replace('−', '-'))));
    if (!at.every(Number.isFinite)) {
      notify('error', `“${x.value}” and “${y.value}” are no position`, 'give two numbers of metres, as -1.5');
      return;
    }
    command('place_ball', { x: at[0], y: at[1] }, `the ball lies at ${at[0]}, ${at[1]} m`);
  };
  const field = (label, value) => html`<label>${label} <input class="short" inputmode="decimal" autocomplete="off" aria-label=${`Ball ${label}`} value=${value.value} onInput=${(event) => { value.value = event.target.value; }} /></label>`;
  return html`<${Menu} label="Ball" title="Place the ball" onOpen=${read}>
    <form class="form" onSubmit=${submit}>${field('x', x)}${field('y', y)}<button>Place</button></form>
    <p class="hint">Metres: x to the attacked goal, −${reach[0]} to ${reach[0]}; y to the left, −${reach[1]} to ${reach[1]}. The ball lies still there. It can also be dragged on the map.</p>
  <//>`;
}
