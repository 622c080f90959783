// The mouse on the canvas. Nothing is sent before a drag ends.

import { signal } from '../../lib/dom.js';
import { on } from '../../lib/listen.js';
import { toggle } from '../attempt.js';
import { parsed, stateKey } from '../machine.js';
import { mode } from '../mode.js';
import { moveNote } from '../notes.js';
import { change, choose, chosenStates, held, machine, move, selection, wish } from '../sources.js';
import { toggleStop } from '../stops.js';
import { descend } from '../trail.js';
import { addState, addTransition, rename, snapped } from './actions.js';
import { courseTo } from './arrows.js';
import { corner } from './notes.js';
import { stage } from './stage.js';

/** Distance from an edge within which a drag draws a transition, points; least length of a drag. */
const [EDGE, START] = [7, 4];

/** The curve that is being drawn, and the rectangle that selects: attributes of an element, or null. */
export const sketch = signal(null);
export const band = signal(null);
/** The state on which something would be dropped. */
export const target = signal(null);

const { view } = stage;

function follow(event, { onMove, onEnd }) {
  const { svg } = view;
  const begin = [event.clientX, event.clientY];
  let moved = false;
  svg.setPointerCapture(event.pointerId);
  const step = (one) => {
    if (!moved && Math.hypot(one.clientX - begin[0], one.clientY - begin[1]) < START) return;
    moved = true;
    onMove(one);
  };
  const end = (one) => {
    stops.forEach((stop) => stop());
    onEnd(one, moved && one.type === 'pointerup');
  };
  const cancel = (key) => {
    if (key.key !== 'Escape') return;
    key.stopPropagation();
    end(key);
  };
  const stops = [on(svg, { pointermove: step, pointerup: end, pointercancel: end }), on(window, { keydown: cancel }, true)];
}

function pan(event) {
  let [x, y] = [event.clientX, event.clientY];
  follow(event, {
    onMove(one) {
      view.pan(one.clientX - x, one.clientY - y);
      [x, y] = [one.clientX, one.clientY];
    },
    onEnd(one, moved) {
      if (!moved && event.button === 0) choose([]);
    },
  });
}

function selectArea(event) {
  const begin = view.point(event);
  const before = selection.value;
  follow(event, {
    onMove(one) {
      const end = view.point(one);
      band.value = { x: Math.min(begin[0], end[0]), y: Math.min(begin[1], end[1]), width: Math.abs(end[0] - begin[0]), height: Math.abs(end[1] - begin[1]) };
      choose([...before, ...stage.within(begin, end).map(stateKey).filter((key) => !before.includes(key))]);
    },
    onEnd() { band.value = null; },
  });
}

function moveStates(event, names) {
  const begin = view.point(event);
  const before = Object.fromEntries(names.map((name) => [name, [stage.boxes.get(name).x, stage.boxes.get(name).y]]));
  const courses = new Map(stage.courses);
  let frame = 0;
  let places = before;
  const write = () => {
    frame = 0;
    stage.drag(places);
  };
  follow(event, {
    onMove(one) {
      if (held.value) return;
      const [x, y] = view.point(one);
      places = Object.fromEntries(names.map((name) => [name, [before[name][0] + x - begin[0], before[name][1] + y - begin[1]]]));
      if (!stage.lifted) stage.lift(names);
      frame ||= requestAnimationFrame(write);
    },
    onEnd(one, moved) {
      cancelAnimationFrame(frame);
      stage.drop();
      if (!moved || held.value) stage.drag(before, courses);
      else {
        places = Object.fromEntries(names.map((name) => [name, snapped(places[name])]));
        stage.drag(places);
        move(Object.fromEntries(names.map((name) => [name, { x: places[name][0], y: places[name][1] }])));
      }
    },
  });
}

function dragNote(event, key) {
  const note = stage.notes.find((one) => one.key === key);
  const begin = view.point(event);
  const way = (one) => view.point(one).map((value, axis) => value - begin[axis]);
  const show = ([dx, dy]) => stage.elements.get(key)?.setAttribute('transform', corner({ ...note, x: note.x + dx, y: note.y + dy }));
  follow(event, {
    onMove(one) { if (!held.value) show(way(one)); },
    onEnd(one, moved) {
      if (moved && !held.value) moveNote(note, ...way(one));
      else show([0, 0]);
    },
  });
}

function drawTransition(event, from) {
  const names = chosenStates().includes(from) ? chosenStates() : [from];
  let point = null;
  follow(event, {
    onMove(one) {
      point = view.point(one);
      const over = stage.at(point, 6);
      target.value = over?.name ?? null;
      sketch.value = courseTo(stage.boxes.get(from), point, over && over.name !== from ? over : null);
    },
    onEnd(one, moved) {
      sketch.value = null;
      target.value = null;
      if (!moved) return choose([stateKey(from)]);
      const over = stage.at(point, 6);
      const [a, b] = [stage.boxes.get(from), over ?? { x: point[0], y: point[1] }];
      const middle = over ? (over.name === from ? [a.x + a.width / 2 + 60, a.y] : [(a.x + b.x) / 2, (a.y + b.y) / 2]) : point;
      addTransition(names, over?.name ?? null, middle);
    },
  });
}

/** Drags the nearer end of an arrow to another state. */
function bendArrow(event, key) {
  const arrow = machine.value.byKey.get(key);
  const { start, end = start } = stage.courses.get(key);
  const near = ([x, y], [px, py]) => Math.hypot(x - px, y - py);
  const begin = view.point(event);
  const atEnd = arrow.any || near(begin, end) <= near(begin, start);
  const fixed = stage.boxes.get(atEnd && !arrow.any ? arrow.from : arrow.to);
  let over = null;
  follow(event, {
    onMove(one) {
      const point = view.point(one);
      over = stage.at(point, 6);
      target.value = over?.name ?? null;
      sketch.value = courseTo(fixed, point, over && over !== fixed ? over : null);
    },
    onEnd(one, moved) {
      sketch.value = null;
      target.value = null;
      if (!moved || !over || over.name === (atEnd ? arrow.to : arrow.from)) return;
      if (atEnd) change({ edit: 'set_target', transition: arrow.owner, arrow: arrow.arrow, to: over.name });
      else {
        wish([`t:${arrow.owner}:${arrow.arrow}:${over.name}`]);
        change({ edit: 'set_sources', transition: arrow.owner, arrow: arrow.arrow, from: arrow.sources.map((from) => (from === arrow.from ? over.name : from)) });
      }
    },
  });
}

/** Whether a point lies at the edge of a box. */
function atEdge(box, [x, y]) {
  // Of a box that is drawn small the middle moves it, too.
  const [edgeX, edgeY] = [box.width, box.height].map((size) => Math.min(EDGE / Math.min(1, view.k), size / 4));
  return Math.abs(x - box.x) > box.width / 2 - edgeX || Math.abs(y - box.y) > box.height / 2 - edgeY;
}

export function press(event) {
  if (event.target.closest('input')) return;
  const key = event.target.closest('[data-key]')?.dataset.key;
  view.svg.focus({ preventScroll: true });
  if (event.button === 1 || (event.button === 0 && !key && !event.shiftKey)) {
    event.preventDefault();
    pan(event);
    return;
  }
  if (event.button !== 0) return;
  if (!key) return selectArea(event);
  if (event.target.closest('.stop')) return toggleStop(key);
  const state = event.target.closest('[data-state]')?.dataset.state;
  if (mode.value === 'try' && key.startsWith('t:')) toggle(machine.value?.byKey.get(key)?.name);
  if (state && !held.value && !event.shiftKey && (event.target.closest('.handle') || atEdge(stage.boxes.get(state), view.point(event)))) {
    drawTransition(event, state);
    return;
  }
  if (event.shiftKey) choose(selection.value.includes(key) ? selection.value.filter((one) => one !== key) : [...selection.value, key]);
  else if (!selection.value.includes(key)) choose([key]);
  else choose([key], true);
  if (key.startsWith('n:')) dragNote(event, key);
  else if (state && chosenStates().includes(state)) moveStates(event, chosenStates());
  else if (!state && !event.shiftKey) bendArrow(event, key);
}

export function doubleClick(event) {
  // The press has captured the pointer: the target of the event is the whole drawing.
  const over = document.elementFromPoint(event.clientX, event.clientY);
  const key = over?.closest('[data-key]')?.dataset.key;
  const child = over?.closest('.link-chip.opens')?.dataset.child;
  if (child) descend(parsed(key).name, child);
  else if (!key) addState(view.point(event));
  else {
    choose([key]);
    rename();
  }
}

export function wheel(event) {
  event.preventDefault();
  const { left, top } = view.svg.getBoundingClientRect();
  if (event.shiftKey) view.pan(-event.deltaY, 0);
  else view.zoom(Math.exp(-Math.max(-60, Math.min(60, event.deltaY)) * 0.0028), event.clientX - left, event.clientY - top);
}
