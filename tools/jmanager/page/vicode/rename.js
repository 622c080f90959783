// A new name for what other files use: the list of their places first.

import { askForm } from './ask.js';
import { ask, change, component, locked, opened } from './sources.js';
import { notify } from '../lib/store.js';

/** Renames information or a modulation, in this file and at the chosen places of others. */
export async function renameUsed(name, to) {
  if (locked.value) {
    notify('error', locked.value);
    return;
  }
  const { file } = opened.value;
  const uses = await ask('uses', { file, component: component.value, function: name });
  if (uses === undefined) return;
  const others = uses.filter((one) => one.file !== file);
  if (others.length === 0) {
    await change({ edit: 'rename', function: name, to });
    return;
  }
  const values = await askForm({
    title: `${name} becomes ${to}`,
    hint: 'Other files use the name. Places of which the type is not known are chosen only if you choose them.',
    submit: 'Rename',
    fields: others.map((one, index) => ({ name: String(index), label: `${one.file}:${one.line}`, kind: 'check', value: one.certain, hint: one.text.trim() })),
  });
  if (!values) return;
  const places = others.filter((_, index) => values[index]).map(({ file: of, span }) => ({ file: of, span }));
  await ask('rename_uses', { file, component: component.value, function: name, to, places });
}
