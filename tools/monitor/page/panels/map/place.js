// Dragging of what an action of a simulated world moves.

import { useRef, useSignal } from '../../lib/dom.js';
import { request } from '../../lib/connection.js';
import { applied, inverse } from '../../lib/frames.js';
import { cursor, notify, operate } from '../../lib/store.js';
import { mover, valuesAt, within } from '../actions.js';

/** Distance from the pointer at which something is taken, px. */
const REACH = 14;
/** Time between two requests while it is dragged. */
const REPEAT_MS = 50;

/** Sends a position; returns the error, or null. */
async function place(session, call, [x, y], item) {
  try {
    await request('operate', { session, request: call.request(valuesAt(call, ({ axis }) => ({ ...item, x, y })[axis])) });
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
      error = await place(session, drag.call, sent, drag.item);
    }
    if (!drag.done) await new Promise((resolve) => { setTimeout(resolve, REPEAT_MS); });
  }
  if (error) notify('error', error.text ?? String(error), error.help ?? '');
}

/** A position within the ranges of the arguments that take it. */
const inRange = (call, at) => ['x', 'y'].map((axis, index) => within(call.arguments.find(({ place: of }) => of?.axis === axis), at[index]));

/**
 * Dragging of what a world lets move. `shown` is the session, `mapOf(element)` the map as it is drawn, `toView(frame)` the place of a frame
 * in it or null, `visible` whether the truth is drawn. Returns the handlers of the canvas and where something is dragged, or null.
 */
export function useDrag({ shown, mapOf, toView, visible }) {
  const dragged = useSignal(null);
  const state = useRef(null);
  const near = (event) => {
    if (!visible || !shown?.info.value.can.operate) return undefined;
    const map = mapOf(event.currentTarget);
    const distance = ({ value, frame }) => {
      const [x, y] = value ? applied(toView(frame), [value.x, value.y]) : [];
      return Math.hypot(map.x(x) - event.offsetX, map.y(y) - event.offsetY);
    };
    const items = (shown.truth.value?.truth ?? []).filter((item) => toView(item.frame) && distance(item) < REACH && mover(shown, item));
    return items.sort((one, other) => distance(one) - distance(other))[0];
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
      const matrix = toView(item.frame);
      const at = applied(inverse(matrix), mapOf(event.currentTarget).at(event.offsetX, event.offsetY));
      // It keeps its distance from the pointer.
      state.current = { drag: { to: null, done: false, call: mover(shown, item), item: item.value }, matrix, offset: [item.value.x - at[0], item.value.y - at[1]] };
    },
    onPointerMove: (event) => {
      const moving = state.current;
      if (!moving) {
        event.currentTarget.style.cursor = near(event) ? 'grab' : '';
        return;
      }
      event.currentTarget.style.cursor = 'grabbing';
      const [x, y] = applied(inverse(moving.matrix), mapOf(event.currentTarget).at(event.offsetX, event.offsetY));
      const begins = moving.drag.to === null;
      moving.drag.to = inRange(moving.drag.call, [x + moving.offset[0], y + moving.offset[1]]);
      dragged.value = applied(moving.matrix, moving.drag.to);
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
