// Keys of the canvas; `?` lists them.

import { bind } from '../../lib/keys.js';
import { open as openPanel } from '../../lib/dock.js';
import { parsed } from '../machine.js';
import { choose, chosenNote, chosenStates, machine, redo, selection, undo } from '../sources.js';
import { copy, paste } from '../clipboard.js';
import { focusCode } from '../focus.js';
import { goTo, toggleStop } from '../stops.js';
import { addNote, editNote } from '../notes.js';
import { descendFirst } from '../trail.js';
import { addChild, addState, askTransition, chooseAll, nudge, remove, rename } from './actions.js';
import { stage } from './stage.js';

const { view } = stage;
const WHERE = '.machine-canvas';

/** Gives an element of the drawing the focus, and brings its state into view. */
export function focusOn(key) {
  choose([key]);
  const { kind, name } = parsed(key);
  const box = kind === 'state' ? stage.boxes.get(name) : stage.notes.find((note) => note.key === key);
  if (box) view.reveal(box);
  stage.elements.get(key)?.focus({ preventScroll: true });
}

const focused = (event) => event?.target.closest?.('[data-key]')?.dataset.key ?? selection.value.at(-1);

function walk(event) {
  const own = machine.value;
  const key = focused(event);
  if (!own || own.states.length === 0) return;
  if (!key || key.startsWith('n:')) return focusOn((own.states.find(({ initial }) => initial) ?? own.states[0]).key);
  const { kind, name, from } = parsed(key);
  if (kind === 'arrow') {
    const { to } = own.byKey.get(key);
    const forward = event.key === 'ArrowRight' || event.key === 'ArrowDown';
    focusOn(`s:${forward || from === '*' ? to : from}`);
    return;
  }
  const next = stage.next(name, event.key);
  if (next) focusOn(`s:${next}`);
}

/** The state whose transitions are gone through. */
let walked = null;

/** The transitions of the state that has the focus, one after the other. */
function around(by) {
  return (event) => {
    const key = focused(event);
    if (!key) return;
    const own = machine.value;
    const { kind, name } = parsed(key);
    if (kind === 'state') walked = name;
    const state = walked ?? own.byKey.get(key).from;
    // Its own ones first, then those from any state.
    const all = [...own.arrows.filter((arrow) => arrow.from === state), ...own.arrows.filter((arrow) => arrow.any && state !== '*' && arrow.to !== state)];
    if (all.length === 0) return;
    const index = all.findIndex((arrow) => arrow.key === key);
    focusOn(all[(index + by + all.length) % all.length].key);
  };
}

/** The first place from there downwards that no state covers. */
function free([x, y]) {
  const taken = stage.all().some((box) => Math.abs(box.x - x) < 210 && Math.abs(box.y - y) < box.height / 2 + 50);
  return taken ? free([x, y + 24]) : [x, y];
}

export const middle = () => {
  const state = chosenStates().at(-1);
  const box = state && stage.boxes.get(state);
  return free(box ? [box.x + 270, box.y] : view.point({ clientX: view.svg.getBoundingClientRect().x + view.svg.clientWidth / 2, clientY: view.svg.getBoundingClientRect().y + view.svg.clientHeight / 2 }));
};

/** What has the focus is what a key is for. */
const on = (run) => (event) => {
  const key = focused(event);
  if (key && !selection.value.includes(key)) choose([key]);
  run(event);
};

const KEYS = [
  ['ArrowLeft', 'next state to the left', walk], ['ArrowRight', 'next state to the right', walk], ['ArrowUp', 'next state above', walk], ['ArrowDown', 'next state below', walk],
  ['n', 'next transition of the state', around(1)], ['N', 'previous transition of the state', around(-1)],
  ['a', 'add a state', () => addState(middle())],
  ['r', 'add a transition from the selected states', on(askTransition)],
  ['w', 'write a note', () => addNote(middle())],
  ['k', 'add a child to the state', on(() => addChild(chosenStates().at(-1)))],
  ['o', 'open the first child that is a machine', on(() => descendFirst(chosenStates().at(-1)))],
  ['F2', 'rename', on(rename)],
  ['Enter', 'edit the code', on(() => { if (chosenNote.value) return editNote(); openPanel('code'); focusCode(); })],
  ['e', 'edit its properties', on(() => { openPanel('inspector'); setTimeout(() => document.querySelector('.inspector input, .inspector textarea')?.focus(), 60); })],
  ['Delete', 'delete what is selected', on(remove)],
  ['b', 'breakpoint at the state or transition', on(() => selection.value.forEach(toggleStop))],
  ['G', 'the running machine goes to the state', on(() => goTo(selection.value.at(-1) ?? ''))],
  ['Shift+ArrowLeft', 'move to the left', on(() => nudge(-24, 0))], ['Shift+ArrowRight', 'move to the right', on(() => nudge(24, 0))],
  ['Shift+ArrowUp', 'move up', on(() => nudge(0, -24))], ['Shift+ArrowDown', 'move down', on(() => nudge(0, 24))],
  ['Ctrl+a', 'select all states', chooseAll],
  ['Ctrl+c', 'copy states and transitions', on(copy)], ['Ctrl+v', 'paste, also into another component', paste],
  ['Ctrl+z', 'undo', undo], ['Ctrl+Z', 'make it again', redo], ['Ctrl+y', 'make it again', redo],
  ['f', 'show the whole machine', () => stage.fit()],
  ['+', 'zoom in', () => view.zoom(1.25)], ['-', 'zoom out', () => view.zoom(0.8)],
  ['/', 'search a state or transition', () => document.querySelector('.machine-search')?.focus()],
  [' ', 'select, or not', (event) => { const key = focused(event); if (key) choose(selection.value.includes(key) ? selection.value.filter((one) => one !== key) : [...selection.value, key]); }],
  ['Escape', 'select nothing', () => { choose([]); view.svg.focus({ preventScroll: true }); }],
];

/** Adds the keys while the canvas is shown. */
export function bindCanvasKeys() {
  const ends = KEYS.map(([key, text, run]) => bind({ key, text, group: 'Designer (in the canvas)', where: WHERE, run }));
  return () => ends.forEach((end) => end());
}

