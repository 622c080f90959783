// A new component from a blank canvas.

import { html } from '../lib/dom.js';
import { request } from '../lib/connection.js';
import { open as openPanel } from '../lib/dock.js';
import { sentence } from '../lib/format.js';
import { notify } from '../lib/store.js';
import { askForm } from './ask.js';
import { ask, list, open, opened, readList } from './sources.js';

const folderOf = (file) => file.split('/').slice(0, -1).join('/');

const fieldsOf = ({ name, folder, tree, module }) => ({ name: name.trim(), folder: folder.trim(), tree: tree || null, import: tree && module.trim() ? module.trim() : null });

/** Shows the differences before anything is written. */
async function preview(values) {
  if (!values.name.trim()) return html`<p class="dim">Type a name, as in WallFinder, to see what would be written.</p>`;
  try {
    const { files } = await request('source', { request: { type: 'new_component', ...fieldsOf(values), dry: true } });
    return html`<div class="diffs">${files.map(({ file, diff }) => html`<h3>${file}</h3><pre class="diff">${diff}</pre>`)}</div>`;
  } catch (error) {
    return html`<p class="error" role="alert">${sentence(error.text)} ${error.help}</p>`;
  }
}

export async function createComponent() {
  if (!list.value) await readList();
  const files = list.value ?? [];
  const folders = [...new Set(files.map(({ file }) => folderOf(file)))].sort();
  const trees = files.filter((one) => one.trees.length > 0);
  const values = await askForm({
    title: 'New component',
    hint: 'Its file, its mod line and its entry in a tree are written.',
    submit: 'Create',
    preview,
    fields: [
      { name: 'name', label: 'Name', value: '', hint: 'a type’s name, as in WallFinder' },
      { name: 'folder', label: 'Folder', options: folders, value: opened.value ? folderOf(opened.value.file) : folders[0] ?? '' },
      { name: 'tree', label: 'Tree', kind: 'select', options: [['', 'in no tree yet'], ...trees.map((one) => [one.file, `${one.trees.join(', ')} in ${one.file}`])], value: '' },
      { name: 'module', label: 'Import in the tree’s file', value: '', hint: 'as in crate::behaviour; empty: none' },
    ],
  });
  if (!values || !values.name.trim()) return;
  const made = await ask('new_component', { ...fieldsOf(values), dry: false });
  if (!made) return;
  notify('done', `${values.name} was made`, made.file);
  await readList();
  await open(made.file, values.name.trim());
  openPanel('vicode');
}
