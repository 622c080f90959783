// What can be done to notes on the drawing.

import { askForm } from './ask.js';
import { stage } from './canvas/stage.js';
import { changeNote, chosenNote, move } from './sources.js';

const plain = ({ at, text }) => ({ at, text });

async function askText(title, value) {
  const values = await askForm({ title, submit: 'Keep', fields: [{ name: 'text', label: 'What the note says', kind: 'area', value, hint: 'Ctrl+Enter keeps it' }] });
  return values?.text.trim();
}

/** A new note at a point of the drawing; below the machine if that is drawn automatically. */
export async function addNote([x, y]) {
  const text = await askText('New note', '');
  if (text) await changeNote(null, { at: stage.view.isAutomatic ? null : { x: Math.round(x), y: Math.round(y) }, text });
}

export const setNote = (text, note = chosenNote.value) => text && text !== note.text && changeNote(plain(note), { at: note.at, text });
export const editNote = async (note = chosenNote.value) => setNote(await askText('Note', note.text), note);
export const removeNote = (note = chosenNote.value) => changeNote(plain(note), null);

/** Moves a note from where it is shown. It has a place then, and so have all states. */
export async function moveNote({ x, y, ...note }, dx, dy) {
  const { view } = stage;
  const before = view.k;
  const fixing = view.isAutomatic ? move({}) : null;
  // Places that are fixed are farther apart, in a smaller view.
  const [toX, toY] = [x + dx, y + dy].map((value) => Math.round((value * before) / view.k));
  await fixing;
  await changeNote(plain(note), { at: { x: toX, y: toY }, text: note.text });
}
