// The store of the motion editor: the motions of the sources, and the one that is open as keyframes. Its text, history and conflicts
// are those of the designer.

import { batch, computed, effect, signal, untracked } from '../lib/dom.js';
import { request } from '../lib/connection.js';
import { session } from '../lib/store.js';
import { ask, edit, locked, model, offsets, open, openedFile } from '../vicode/sources.js';

/** How rows of numbers are postures; an extension of the program says it: [{name, ty, within, time, pace, linear, channels, row, …}]. */
export const forms = signal([]);
/** Motions of the folder: [{file, key, ty, form}]; null until it was read. */
export const motions = signal(null);
/** The open motion: {file, key}. */
export const chosen = signal(null);
/** Number of the chosen keyframe. */
export const row = signal(0);
/** Number of the channel that is drawn thick. */
export const channel = signal(0);
/** What is dragged and not written yet: {row, channel, value} or {row, seconds}. */
export const draft = signal(null);

/** Sends a message to the extension that knows the robot. */
export const tell = (type, fields = {}) => request('extension', { session: session.value?.id, name: 'motions', message: { type, ...fields } });

/** Reads forms and motions. */
export async function readMotions() {
  if (!session.value) return;
  forms.value = await tell('forms');
  const tables = await ask('tables', { types: [...new Set(forms.value.map(({ ty }) => ty))] });
  const formOf = ({ file, ty }) => forms.value.find((form) => form.ty === ty && file.includes(form.within));
  // Other constants of the type, such as the gains of all joints, are no posture.
  const fits = ({ form, cells }) => form && (form.pace || cells.length === 0 || form.channels.every(({ cell }) => cells.includes(cell.split('/')[0])));
  if (tables) motions.value = tables.map((one) => ({ ...one, form: formOf(one) })).filter(fits);
}

export async function openMotion(file, key) {
  batch(() => { [chosen.value, row.value, draft.value] = [{ file, key }, 0, null]; });
  await open(file);
}

export const form = computed(() => {
  const { file, key } = chosen.value ?? {};
  return motions.value?.find((one) => one.file === file && one.key === key)?.form ?? null;
});

/** The table of the open motion; null while another file is open, or the text lacks it. */
export const table = computed(() => (openedFile.value !== chosen.value?.file ? null : model.value?.tables?.find(({ key }) => key === chosen.value.key) ?? null));

/** The cell of a row by the name of a channel's cell: {table, row, cell}. With a `/` it is one of the constant that a cell names. */
function cellOf(index, name) {
  const of = table.value;
  const [own, inner] = name.split('/');
  const cell = of.rows[index].cells.find((one) => one.name === own);
  if (inner === undefined || !cell) return { table: of.key, row: index, cell, name: own };
  const named = offsets.value.slice(cell.span).split('::').at(-1);
  const other = model.value.tables.find(({ key, array }) => key === named && array === null);
  return { table: other?.key, row: 0, cell: other?.rows[0].cells.find((one) => one.name === inner), name: inner };
}

/** Duration that follows from the way of the joints. */
function paced({ speed, shortest }, from, to) {
  const longest = Math.max(...to.map((value, index) => Math.abs(value - from[index])));
  return Math.max((1.5 * longest) / speed, shortest);
}

/** The keyframes of the open motion with what is dragged: [{seconds, values, written}]; null if it cannot be read. */
export const keys = computed(() => {
  const [of, own, dragged] = [table.value, form.value, draft.value];
  if (!of || !own) return null;
  let before = own.channels.map(({ rest }) => rest);
  return of.rows.map((_, index) => {
    const cells = own.channels.map(({ cell }) => cellOf(index, cell).cell);
    const values = own.channels.map(({ rest }, at) => (dragged?.row === index && dragged.channel === at ? dragged.value : cells[at]?.value ?? rest));
    const time = own.time && cellOf(index, own.time[0]).cell?.value;
    const seconds = dragged?.row === index && dragged.seconds ? dragged.seconds : own.time ? (time ?? 100) * own.time[1] : own.pace ? paced(own.pace, before, values) : 1;
    before = values;
    return { seconds, values, written: cells.map(Boolean) };
  });
});

/** The keyframes as the extension takes them. */
export const sent = (list, of) => list.map(({ seconds, values, written }) => ({
  seconds, cells: Object.fromEntries(of.channels.flatMap(({ cell }, index) => (written[index] || !of.pace ? [[cell, values[index]]] : []))),
}));

/** Each keyframe in space, and what of the way to it is beyond the motors. */
export const shapes = signal([]);
/** Whether they are being asked for, and whether the numbers have changed since. */
let [asking, changed] = [false, false];
async function askShapes() {
  asking = true;
  while (changed) {
    changed = false;
    const [list, own] = [keys.value, form.value];
    const found = list?.length && own ? await tell('shapes', { form: own.name, keys: sent(list, own) }).catch(() => []) : [];
    shapes.value = form.value === own && keys.value?.length === list?.length ? found : [];
    await new Promise((resolve) => { setTimeout(resolve, 40); });
  }
  asking = false;
}
// They follow a drag.
effect(() => {
  void [keys.value, form.value];
  changed = true;
  if (!asking) untracked(askShapes);
});

/** Whether it can be edited, and if not, why. */
export const held = computed(() => (table.value ? locked.value : 'No motion is open.'));

/** A value within the range of a channel, in its steps. */
export const rounded = (value, { min, max, step }) => Number((Math.round(Math.min(max, Math.max(min, value)) / step) * step).toFixed(6));

/** Edits that give keyframes numbers: [{row, channel, value}], with `null` where there is to be none. */
function numbers(list) {
  const groups = new Map();
  for (const one of list) {
    const own = form.value.channels[one.channel];
    const place = cellOf(one.row, own.cell);
    // A constant that another one names has no such number, or the row has another form.
    if (!place.cell && !table.value.rows[one.row].pairs) continue;
    const value = one.value === null ? null : rounded(one.value, own);
    groups.set(place.table, [...(groups.get(place.table) ?? []), { row: place.row, cell: place.name, value }]);
  }
  return [...groups].map(([name, of]) => ({ edit: 'set_numbers', table: name, numbers: of }));
}

export const setValue = (at, index, value) => edit(numbers([{ row: at, channel: index, value }]));

/** Sets the durations of keyframes: [[row, seconds]]. */
export function setSeconds(list) {
  const [cell, unit] = form.value.time;
  return edit([{ edit: 'set_numbers', table: table.value.key, numbers: list.map(([at, seconds]) => ({ row: at, cell, value: Number((seconds / unit).toFixed(6)) })) }]);
}

/** Makes all durations longer or shorter. */
export const scaleTime = (factor) => setSeconds(keys.value.map(({ seconds }, at) => [at, seconds * factor]));

/** Inserts a copy of the chosen keyframe after it, or the first one. */
export async function insert() {
  const isEmpty = table.value.rows.length === 0;
  const at = isEmpty ? 0 : row.value + 1;
  const done = await edit([{ edit: 'insert_row', table: table.value.key, before: at, ...(isEmpty ? { code: form.value.row } : { copy: row.value }) }]);
  if (done) row.value = at;
}

export async function remove() {
  const at = row.value;
  if (await edit([{ edit: 'delete_row', table: table.value.key, row: at }])) row.value = Math.max(0, Math.min(at, table.value.rows.length - 1));
}

/** Exchanges left and right in keyframes. */
export function mirror(rows) {
  const own = form.value.channels;
  return edit(numbers(rows.flatMap((at) => own.map(({ mirror: [other, changes] }, index) => {
    const { values, written } = keys.value[at];
    const value = !written[other] && table.value.rows[at].pairs ? null : (changes ? -1 : 1) * values[other];
    return { row: at, channel: index, value };
  }))));
}

/** Gives the chosen keyframe measured angles: a Map from the names of joints to rad. In a row of pairs only those that differ from the rest. */
export function take(angles) {
  const pairs = table.value.rows[row.value].pairs;
  return edit(numbers(form.value.channels.flatMap((own, index) => {
    const angle = angles.get(own.moves[0]);
    if (angle === undefined) return [];
    const value = (angle * 180) / Math.PI;
    return [{ row: row.value, channel: index, value: pairs && Math.abs(value - own.rest) < 2 ? null : value }];
  })));
}
