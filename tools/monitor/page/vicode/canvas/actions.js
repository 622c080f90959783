// What can be done to the machine, by mouse, keys and the inspector alike.

import { askForm, askName } from '../ask.js';
import { freeName, parsed, stateKey } from '../machine.js';
import { change, choose, chosen, chosenNote, chosenStates, component, list, held, machine, move, opened, selection, wish } from '../sources.js';
import { notify } from '../../lib/store.js';
import { editNote, moveNote, removeNote } from '../notes.js';
import { renameUsed } from '../rename.js';
import { stage } from './stage.js';

const GRID = 8;
export const snapped = ([x, y]) => [Math.round(x / GRID) * GRID, Math.round(y / GRID) * GRID];

/** Whether the machine can be changed; says why not. */
function editable() {
  if (!machine.value) return false;
  if (held.value) notify('error', held.value);
  return !held.value;
}

async function makeState(name, at, more = []) {
  const [x, y] = snapped(at);
  wish([stateKey(name)]);
  const done = await change({ edit: 'add_state', name, initial: machine.value.states.length === 0 }, ...more);
  if (done) await move({ [name]: { x, y } }, false);
  return done;
}

/** A new state at a point; its name is asked for there. */
export async function addState(at) {
  if (!editable()) return;
  if (machine.value.step) return notify('error', `${component.value} has a step and is no machine`, 'delete `step` in the code first');
  const name = await askName({ at, value: freeName(machine.value.component, 'new_state'), label: 'Name of the new state', fresh: true });
  if (name) await makeState(name, at);
}

/** A last state gets its first transition: it is last no more. */
const goOn = (from) => machine.value.states.filter(({ name, last }) => last && (from.includes(name) || from.includes('*'))).map(({ name }) => ({ edit: 'set_last', state: name, last: false }));

/** A new transition; to null: to a new state at the point. */
export async function addTransition(from, to, at) {
  if (!editable()) return;
  const own = machine.value.component;
  let target = to;
  if (target === null) {
    target = await askName({ at, value: freeName(own, 'new_state'), label: 'Name of the new state', fresh: true });
    if (!target) return;
    const name = freeName(own, `to_${target}`, [target]);
    await makeState(target, at, [...goOn(from), { edit: 'add_transition', name, from, to: target }]);
    return;
  }
  const name = await askName({ at, value: freeName(own, `to_${target}`), label: 'Name of the new transition', fresh: true });
  if (!name) return;
  wish([`t:${name}:0:${from[0]}`]);
  await change(...goOn(from), { edit: 'add_transition', name, from, to: target });
}

/** The same by keyboard: asks for name, target and timer. */
export async function askTransition() {
  if (!editable()) return;
  const own = machine.value;
  const from = chosenStates();
  const names = own.states.map((state) => [state.name, state.name]);
  if (names.length === 0) return;
  const first = from[0] ?? names[0][0];
  const values = await askForm({
    title: 'New transition',
    submit: 'Add',
    fields: [
      { name: 'to', label: 'To', kind: 'select', options: names, value: (names.find(([name]) => name !== first) ?? names[0])[0] },
      ...(from.length > 1 ? [] : [{ name: 'from', label: 'From', kind: 'select', options: [...names, ['*', 'any state']], value: first }]),
      { name: 'name', label: 'Name of the condition', value: '', hint: 'empty: to_ and the target' },
      { name: 'after', label: 'After, ms', kind: 'number', value: '', hint: 'least time in the state; empty: none' },
    ],
  });
  if (!values) return;
  const name = values.name || freeName(own.component, `to_${values.to}`);
  const after = Number.parseInt(values.after, 10);
  const sources = values.from ? [values.from] : from;
  wish([`t:${name}:0:${sources[0]}`]);
  await change(...goOn(sources), { edit: 'add_transition', name, from: sources, to: values.to, ...(Number.isFinite(after) ? { after_ms: after } : {}) });
}

/** A new name, typed at its place; a new text of a note. */
export async function rename() {
  if (chosenNote.value) return editNote();
  const one = chosen.value;
  // What has no function has no name.
  if (!one || one.bare || !editable()) return;
  const box = stage.boxes.get(one.name);
  const at = 'sources' in one ? stage.courses.get(one.key).label : [box.x, box.y - box.height / 2 + 17];
  const to = await askName({ at, value: one.name, label: `New name of ${one.name}` });
  if (!to || to === one.name) return;
  wish([one.key.replace(`:${one.name}`, `:${to}`)]);
  await renameUsed(one.name, to);
}

/** Edits that delete what is selected: arrows first, then states. */
function deletions() {
  const own = machine.value;
  const all = selection.value.map(parsed);
  const states = new Set(all.filter(({ kind }) => kind === 'state').map(({ name }) => name));
  const edits = [];
  for (const [name, group] of Map.groupBy(all.filter(({ kind }) => kind === 'arrow'), (one) => one.name)) {
    const state = own.component.states.find((one) => one.function.name.text === name);
    const parts = (state ?? own.component.transitions.find((one) => one.function.name.text === name))?.arrows ?? [];
    const gone = parts.map((part, index) => {
      const sources = part.from === 'any' ? ['*'] : part.from.these.map((one) => one.text);
      return { index, kept: sources.filter((from) => !group.some((one) => one.arrow === index && one.from === from)), sources };
    });
    if (!state && gone.every(({ kept }) => kept.length === 0)) {
      edits.push({ edit: 'delete', function: name });
      continue;
    }
    for (const { index, kept, sources } of gone.reverse()) {
      if (kept.length === 0) edits.push({ edit: 'remove_arrow', transition: name, arrow: index });
      else if (kept.length < sources.length) edits.push({ edit: 'set_sources', transition: name, arrow: index, from: kept });
    }
  }
  return [...edits, ...[...states].map((name) => ({ edit: 'delete', function: name }))];
}

export async function remove() {
  if (selection.value.length === 0 || !editable()) return;
  // What has the focus goes away.
  stage.view.svg.focus({ preventScroll: true });
  if (chosenNote.value) return removeNote();
  await change(...deletions());
}

/** Adds a child to a state: asks for what is not known. */
export async function addChild(state, child = '') {
  if (!state || !editable()) return;
  const files = list.value ?? [];
  const names = [...new Set(files.flatMap((file) => file.components.map((one) => one.name)))].sort();
  const own = opened.value;
  const values = await askForm({
    title: child ? `${child} as a child of ${state}` : `A child of ${state}`,
    submit: 'Add child',
    fields: [
      ...(child ? [] : [{ name: 'child', label: 'Component', options: names, value: '' }]),
      { name: 'kind', label: 'Link', kind: 'select', value: 'modulation', options: [['modulation', 'modulation: &mut, is written, runs after'], ['requirement', 'requirement: &, is read, runs before'], ['rate', 'rate: its rate is written']] },
      { name: 'import', label: 'Module to import it from', value: child ? moduleOf(child) : '', hint: 'empty: it is known in this file' },
    ],
  });
  const name = child || values?.child;
  if (!values || !name) return;
  const path = values.import || (child ? '' : moduleOf(name));
  const edit = { edit: 'add_child', function: state, child: name, kind: values.kind };
  await change(new RegExp(`\\b${name}\\b`).test(own.text) || !path ? edit : { ...edit, import: path });
}

/** The module from which the open file can import a component; empty if it knows it. Other folders export their components. */
function moduleOf(child) {
  const own = opened.value;
  if (new RegExp(`\\b${child}\\b`).test(own.text)) return '';
  const file = list.value?.find((one) => one.components.some(({ name }) => name === child))?.file;
  if (!file) return '';
  const folder = (path) => path.split('/').slice(0, -1).join('/');
  // In a module of the file `super` is the file.
  const up = 'super::'.repeat(machine.value?.component.module.split('::').filter(Boolean).length ?? 0);
  const stem = (path) => path.split('/').at(-1).replace(/\.rs$/, '');
  const isRoot = (path) => ['lib', 'main', 'mod'].includes(stem(path));
  if (folder(file) === folder(own.file)) return `${up}${[...(isRoot(own.file) ? (up ? [] : ['self']) : ['super']), ...(isRoot(file) ? [] : [stem(file)])].join('::')}`.replace(/::$/, '');
  const parts = folder(file).split('/');
  return ['crate', ...parts.slice(parts.lastIndexOf('src') + 1)].filter(Boolean).join('::');
}

/** Lines states up, or spreads them: 'x', 'y', 'across' or 'down'. */
export function align(how) {
  const boxes = chosenStates().map((name) => stage.boxes.get(name)).filter(Boolean);
  if (boxes.length < 2) return;
  const mean = (key) => boxes.reduce((sum, box) => sum + box[key], 0) / boxes.length;
  const places = {};
  if (how === 'x' || how === 'y') {
    const value = Math.round(mean(how));
    for (const box of boxes) places[box.name] = { x: box.x, y: box.y, [how]: value };
  } else {
    const key = how === 'across' ? 'x' : 'y';
    const size = (box) => (key === 'x' ? box.width : box.height);
    const sorted = [...boxes].sort((a, b) => a[key] - b[key]);
    const least = sorted.reduce((sum, box) => sum + size(box) + 60, -60);
    const [first, last] = [sorted[0], sorted.at(-1)];
    const span = Math.max(least - size(first) / 2 - size(last) / 2, last[key] - first[key]);
    sorted.forEach((box, index) => { places[box.name] = { x: box.x, y: box.y, [key]: Math.round(first[key] + (span * index) / (sorted.length - 1)) }; });
  }
  move(places);
}

/** Moves the selected states, or a note, by keys. */
export function nudge(dx, dy) {
  const note = stage.notes.find(({ key }) => key === chosenNote.value?.key);
  if (note) return moveNote(note, dx, dy);
  const places = {};
  for (const name of chosenStates()) {
    const { x, y } = stage.boxes.get(name);
    places[name] = { x: x + dx, y: y + dy };
  }
  if (Object.keys(places).length > 0) move(places);
}

export const chooseAll = () => choose(machine.value?.states.map((state) => state.key) ?? []);
