// The store of VICODE: the open file, what is selected in it, and the requests that change it.

import { stage } from './canvas/stage.js';
import { batch, computed, effect, signal } from '../lib/dom.js';
import { link, listen, request } from '../lib/connection.js';
import { hello, notify } from '../lib/store.js';
import { stored } from '../lib/stored.js';
import { machineOf, parsed } from './machine.js';
import { heldBy, mode } from './mode.js';
import { Offsets, spliced } from './offsets.js';

/** Files of the folder: [{file, components: [{name, machine}], trees, problem}]. */
export const list = signal(null);
/** The open file as the server has it: {file, version, text, model, positions, saved, readonly, deleted, problem, conflict}. */
export const opened = signal(null);
/** Key of the component that is shown: no other one of the file has it. */
export const component = signal(null);
/** Keys of what is selected, the last one at the end. */
export const selection = signal([]);
/** The last refusal of an edit: {text, help}. */
export const refusal = signal(null);
/** Time of the last change of the file by another program, ms; null if there was none. */
export const editedOutside = signal(null);

// Parts of the open file. A message that changes one part, as when the file was saved, leaves what depends on the others as it is.
export const openedFile = computed(() => opened.value?.file ?? null);
export const openedText = computed(() => opened.value?.text ?? '');
export const model = computed(() => opened.value?.model ?? null);
/** Centres of all states of the file: [{component, state, x, y, placed}]. */
export const positions = computed(() => opened.value?.positions ?? []);

/** Whether the text is no Rust at present. */
export const isBroken = computed(() => model.value?.problems.some(({ from }) => from === 'syntax') ?? false);

const NONE = [];
const allNotes = computed(() => opened.value?.notes ?? NONE);
const noteKey = ({ at, text }) => `n:${at ? `${at.x} ${at.y}` : ''}:${text}`;
/** Notes of the component: [{key, at: {x, y} or null, text}]. */
export const notes = computed(() => allNotes.value.filter((one) => one.component === component.value).map(({ at, text }) => ({ key: noteKey({ at, text }), at, text })));

export const offsets = computed(() => new Offsets(openedText.value));
export const machine = computed(() => machineOf(model.value, component.value));
/** What is selected last, as in the machine. */
export const chosen = computed(() => machine.value?.byKey.get(selection.value.at(-1)) ?? null);
/** The note that is selected last. */
export const chosenNote = computed(() => notes.value.find(({ key }) => key === selection.value.at(-1)) ?? null);
const isHere = (key) => machine.value?.byKey.has(key) || notes.value.some((note) => note.key === key);
/** Whether the file can be edited, and if not, why. */
export const locked = computed(() => {
  if (hello.value?.read_only) return 'This program lets pages only watch: start it without --read-only.';
  if (opened.value?.conflict) return 'The file was changed on both sides: choose what to keep.';
  if (opened.value?.readonly) return 'The file is read-only: change its permissions.';
  return null;
});

/** Whether the drawing can be edited, and if not, why. */
export const held = computed(() => locked.value ?? heldBy[mode.value] ?? null);

/** Shows the refusal of an edit: in the inspector, or as a notice if none is visible. */
export function refuse(text, help = '') {
  refusal.value = { text, help };
  if (!document.querySelector('.inspector')?.checkVisibility()) notify('error', text, help);
}

/** Sends a request about sources. An error is shown. */
export async function ask(type, fields = {}) {
  try {
    return (await request('source', { request: { type, ...fields } })) ?? null;
  } catch (error) {
    const { text = String(error), help = '' } = error;
    if (type === 'edit_file') refuse(text, help);
    else notify('error', text, help);
    return undefined;
  }
}

export async function readList() {
  if (!hello.value?.source) return;
  const files = await ask('sources');
  if (files) list.value = files;
}

// ---- opening

/** Opens a file and shows one of its components. */
export async function open(file, name) {
  await running;
  await code.settle();
  const before = opened.value;
  component.value = name ?? component.value;
  if (before?.file === file) {
    choose([]);
    return true;
  }
  if (before) ask('close_file', { file: before.file });
  batch(() => {
    opened.value = null;
    selection.value = [];
    steps = [];
    undone = [];
    editedOutside.value = null;
  });
  return (await ask('open_file', { file })) !== undefined;
}

/** Opens the file that has a component; says so if there is none. */
export async function openByName(name) {
  if (!list.value) await readList();
  // A tree has `Filter<3>`, a file `Filter<N>`.
  const isIt = (each) => each.name.split('<')[0] === name.split('<')[0];
  const file = list.value?.find((one) => one.components.some(isIt));
  if (!file) {
    notify('error', `no source of ${name} was found`, hello.value?.source ? 'it is not below the folder of --source' : 'start the program with --source FOLDER');
    return false;
  }
  return open(file.file, file.components.find(isIt).key);
}

const memory = stored('sessionStorage', 'vicode-open');

/** Opens again what this tab of the browser showed before it was loaded anew. */
function restore() {
  const { file, name } = memory.read() ?? {};
  if (file && list.value?.some((one) => one.file === file)) open(file, name);
}

effect(() => { if (openedFile.value) memory.write({ file: openedFile.value, name: component.value }); });

/** Selects; what does not exist is left out. */
export function choose(keys, add = false) {
  forget();
  const wished = add ? [...selection.value.filter((key) => !keys.includes(key)), ...keys] : keys;
  const next = wished.filter(isHere);
  if (next.join() !== selection.value.join()) selection.value = next;
}

let wished = null;
/** Selects as soon as it exists: what an edit is about to make. */
export const wish = (keys) => { wished = keys; };
/** Selects nothing later: what the person has turned to meanwhile stays selected. */
export const forget = () => { wished = null; };

export const chosenStates = () => selection.value.map(parsed).filter(({ kind }) => kind === 'state').map(({ name }) => name);

// ---- editing

/** The code panel sets these: `settle` sends what was typed, `hold` keeps what is typed from now on until its result is called. */
let code = { settle: async () => {}, hold: () => () => {} };
export const setCode = (functions) => { code = functions; };

/** Changes of the file that have no answer yet. An undo waits for them: until then the history does not have them. */
let changes = Promise.resolve();
const tracked = (change) => (...values) => {
  const done = change(...values);
  changes = Promise.allSettled([changes, done]);
  return done;
};

/** Applies edits as one step. Resolves to whether they were applied. */
export const edit = tracked(async (edits) => {
  if (held.value) {
    refusal.value = { text: held.value, help: '' };
    notify('error', held.value);
    return false;
  }
  await code.settle();
  const { file, version } = opened.value;
  refusal.value = null;
  return (await ask('edit_file', { file, version, edits })) !== undefined;
});

/** Applies edits of the shown component, without its name in each. */
export const change = (...edits) => edit(edits.map((one) => ({ component: component.value, ...one })));

/** Replaces a part of the text; for the code panel. Rejects if it is refused. */
export const replace = (file, version, edits) => request('source', { request: { type: 'edit_file', file, version, edits } });

// ---- one history of text and places

/** Steps of this page: {kind: 'text', typed, at}, {kind: 'move', before, after} or {kind: 'note', before, after}. */
let steps = [];
let undone = [];
/** Steps of typing that follow each other faster are undone together, ms. */
const BURST = 700;

function remember(step) {
  steps = [...steps.slice(-999), step];
  undone = [];
}

const rememberText = (typed) => remember({ kind: 'text', typed, at: Date.now() });

/** The text here was kept in a conflict: the history leads to the text of the file and back, though nothing changes now. */
export const kept = () => [false, false].forEach(rememberText);

/** Typing goes on: the next change of the text is part of it. */
let typing = false;
export const setTyping = (on) => { typing = on; };

const belongs = (step, before) => step.kind === 'text' && before?.kind === 'text' && step.typed && before.typed && step.at - before.at < BURST;

/** Undoes a step, or makes it again. */
function replay(step, file, type, side) {
  const { kind, component: name } = step;
  if (kind === 'text') return ask(type, { file });
  if (kind === 'note') return ask('change_note', { file, component: name, from: step[side === 'before' ? 'after' : 'before'], to: step[side] });
  return step[side] ? ask('move_states', { file, positions: step[side] }) : ask('arrange_states', { file, component: name });
}

async function back(from, to, type, side) {
  const { file } = opened.value ?? {};
  if (!file || locked.value) return;
  let step = from.at(-1);
  if (!step) return ask(type, { file });
  for (;;) {
    from.pop();
    to.push(step);
    const done = await replay(step, file, type, side);
    const next = from.at(-1);
    const goesOn = next && (side === 'before' ? belongs(step, next) : belongs(next, step));
    if (done === undefined || !goesOn) return;
    step = next;
  }
}

/** Keys that are pressed fast wait for each other, and for all changes before them: these add steps to the history. Typing waits for them. */
let running = Promise.resolve();
const inTurn = (work) => {
  const turn = async () => {
    const release = code.hold();
    try {
      await code.settle();
      await changes;
      await work();
    } finally {
      release();
    }
  };
  return () => { running = running.then(turn, turn); };
};

export const undo = inTurn(() => back(steps, undone, 'undo_file', 'before'));
export const redo = inTurn(() => back(undone, steps, 'redo_file', 'after'));

const placesOf = (all, name) => all.filter((one) => one.component === name).map(({ state, x, y }) => ({ component: name, state, x, y }));

/** Whether somebody has placed a state of a component. */
const isPlaced = (all, name) => all.some((one) => one.component === name && one.placed);

/** Moves states: {name: {x, y}}. Places of new ones can be undone with the edit that made them. */
export const move = tracked(async (places, own = true) => {
  const { file, positions: all } = opened.value;
  const name = component.value;
  const automatic = !isPlaced(all, name);
  // An automatic drawing places a new state itself.
  if (automatic && !own) return;
  const moved = automatic ? stage.fixed(places) : places;
  const after = Object.entries(moved).map(([state, { x, y }]) => ({ component: name, state, x: Math.round(x), y: Math.round(y) }));
  const before = automatic ? null : placesOf(all, name).filter(({ state }) => places[state]);
  const known = new Map(after.map((one) => [one.state, one]));
  // Shown at once; the answer has the same.
  opened.value = { ...opened.value, positions: all.map((one) => (one.component === name && known.has(one.state) ? { ...one, ...known.get(one.state), placed: true } : one)) };
  const done = await ask('move_states', { file, positions: after });
  if (done !== undefined && own) remember({ kind: 'move', component: name, before, after });
});

/** Replaces a note {at, text} of the component; null instead of one adds or removes it. */
export const changeNote = tracked(async (before, after) => {
  if (held.value) return notify('error', held.value);
  const name = component.value;
  wish(after ? [noteKey(after)] : []);
  if ((await ask('change_note', { file: opened.value.file, component: name, from: before, to: after })) !== undefined) remember({ kind: 'note', component: name, before, after });
});

/** Places all states of the component automatically. */
export const arrange = tracked(async () => {
  const { file, positions: before } = opened.value;
  const name = component.value;
  const answer = await ask('arrange_states', { file, component: name });
  if (answer && isPlaced(before, name)) remember({ kind: 'move', component: name, before: placesOf(before, name), after: null });
});

// ---- messages

const watchers = [];
/** Registers a receiver of changes of the text: ({message, before, text}). */
export const onChange = (watcher) => watchers.push(watcher);

/** Parts of a message that are no part of the open file. */
const OF_MESSAGE = ['type', 'from_version', 'splices', 'by', 'page'];
const stateIn = (message) => Object.fromEntries(Object.entries(message).filter(([key]) => !OF_MESSAGE.includes(key)));

function show(message) {
  const state = stateIn(message);
  batch(() => {
    opened.value = state;
    if (!machineOf(state.model, component.value)) component.value = state.model.components[0]?.key ?? null;
    selection.value = selection.value.filter(isHere);
    // Before any panel draws: places are those of the new text.
    watchers.forEach((watcher) => watcher({ message, before: null, text: state.text }));
  });
}

const samePlaces = (a, b) => a.length === b.length && a.every((one, index) => {
  const other = b[index];
  return one.x === other.x && one.y === other.y && one.state === other.state && one.component === other.component && one.placed === other.placed;
});

function changed(message) {
  const before = opened.value;
  if (before?.file !== message.file) return;
  if (before.version !== message.from_version) return ask('open_file', { file: message.file });
  const { splices, by, page } = message;
  const state = stateIn(message);
  const text = spliced(before.text, splices);
  const mine = page === hello.value?.page;
  batch(() => {
    const places = samePlaces(before.positions, state.positions) ? before.positions : state.positions;
    const noted = JSON.stringify(before.notes) === JSON.stringify(state.notes) ? before.notes : state.notes;
    opened.value = { ...before, ...state, text, model: state.model ?? before.model, positions: places, notes: noted };
    follow(before);
    if (wished?.every(isHere)) {
      selection.value = wished;
      wished = null;
    }
    if (splices.length > 0) watchers.forEach((watcher) => watcher({ message, before: before.text, text }));
  });
  if (by === 'file' && splices.length > 0) {
    editedOutside.value = Date.now();
    if (!message.conflict) notify('done', `${message.file} was edited outside; its changes are shown`);
  }
  if (splices.length > 0 && by !== 'undo') rememberText(typing && mine);
}

/** Keeps the selection; what was renamed elsewhere is found at its place in the list. */
function follow(before) {
  const [old, now] = [machineOf(before.model, component.value), machine.value];
  if (!now) {
    // A missing brace hides it for a while.
    if (isBroken.value) return;
    const at = before.model.components.findIndex((one) => one.key === component.value);
    component.value = opened.value.model.components[at]?.key ?? opened.value.model.components[0]?.key ?? null;
    return;
  }
  const find = (key) => {
    if (isHere(key)) return key;
    const was = old?.byKey.get(key);
    const which = was && 'sources' in was ? 'arrows' : 'states';
    return old && old[which].length === now[which].length ? now[which][old[which].indexOf(was)]?.key : undefined;
  };
  const kept = selection.value.map(find).filter(Boolean);
  if (kept.join() !== selection.value.join()) selection.value = kept;
}

listen((message) => {
  if (message?.type === 'source') show(message);
  else if (message?.type === 'source_changed') changed(message);
  else if (message?.type === 'hello' && message.source) {
    // After a lost connection the server does not know this page any more.
    if (opened.value) ask('open_file', { file: opened.value.file });
    readList().then(() => opened.value ?? restore());
  }
});
