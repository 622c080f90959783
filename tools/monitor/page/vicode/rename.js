// A new name for a function: the list of places in other files first.

import { askForm } from './ask.js';
import { ask, change, component, locked, opened } from './sources.js';
import { notify } from '../lib/store.js';

/** Renames a function, in this file and at the chosen places of uses. */
export async function renameUsed(name, to) {
  if (locked.value) return notify('error', locked.value);
  const { file } = opened.value;
  const uses = await ask('uses', { file, component: component.value, function: name });
  if (uses === undefined) return;
  if (uses.length === 0) return change({ edit: 'rename', function: name, to });
  const values = await askForm({
    title: `${name} becomes ${to}`,
    hint: 'Other files use the name. Places of which the type is not known are chosen only if you choose them; all others must be.',
    submit: 'Rename',
    fields: uses.map((one, index) => ({ name: String(index), label: `${one.file}:${one.line}`, kind: 'check', value: one.certain, hint: one.text.trim() })),
  });
  if (!values) return;
  const places = uses.filter((_, index) => values[index]).map(({ file: of, span }) => ({ file: of, span }));
  await ask('rename_uses', { file, component: component.value, function: name, to, places });
}
