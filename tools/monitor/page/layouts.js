// Layouts that are saved on the server for all pages, and files of layouts: the part of the menu View.

import { html, useSignal } from './lib/dom.js';
import * as dock from './lib/dock.js';
import { applyFile, shared } from './lib/links.js';
import { ask, hello, notify } from './lib/store.js';
import { download } from './lib/ui.js';
import { askForm } from './vicode/ask.js';

const NAME = { name: 'name', label: 'Name of the layout' };

/** Asks for a name that no other layout has, or that is to be replaced; null if it is given up. */
async function freeName(title, submit, value, known) {
  const name = (await askForm({ title, submit, fields: [{ ...NAME, value, max: hello.value.limits.name }] }))?.name.trim();
  if (!name || name === value) return null;
  if (!Object.hasOwn(known, name)) return name;
  return (await askForm({ title: `Replace the layout “${name}”?`, hint: 'All pages of this server lose the old one.', submit: 'Replace', fields: [] })) ? name : null;
}

async function save(known) {
  const name = await freeName('Save layout', 'Save', '', known);
  if (name) await ask('save_layout', { name, layout: dock.layout() }, `layout “${name}” was saved`);
}

async function rename(known, before) {
  const name = await freeName(`Rename the layout “${before}”`, 'Rename', before, known);
  if (!name || (await ask('save_layout', { name, layout: known[before] })) === undefined) return;
  await ask('save_layout', { name: before, layout: null }, `layout “${before}” is “${name}” now`);
}

async function remove(name) {
  const sure = await askForm({ title: `Delete the layout “${name}”?`, hint: 'All pages of this server lose it.', submit: 'Delete', fields: [] });
  if (sure) await ask('save_layout', { name, layout: null }, `layout “${name}” was deleted`);
}

function openFile() {
  const input = document.createElement('input');
  input.type = 'file';
  input.accept = '.json';
  input.onchange = async () => {
    const file = input.files[0];
    try {
      if (!applyFile(JSON.parse(await file.text()), file.name)) throw new Error('not a layout');
    } catch {
      notify('error', `${file.name} is no layout`, 'choose a file that “Layout to a file” wrote');
    }
  };
  input.click();
}

/** Items of the menu. `saved` is a signal of the layouts of the server. */
export const Layouts = ({ saved }) => html`<h3>Layouts</h3>
  ${dock.presets().map(([name, { title }, key]) => html`<button class="item" onClick=${() => dock.preset(name)}>${title}<kbd>${key}</kbd></button>`)}
  ${Object.entries(saved.value).map(([name, layout]) => html`<div class="saved"><button class="item" onClick=${() => dock.applyLayout(layout, name)}>${name}</button>
    <button class="item" aria-label=${`Rename layout ${name}`} title="Rename" onClick=${() => rename(saved.value, name)}>✎</button><button class="item" aria-label=${`Delete layout ${name}`} title="Delete" onClick=${() => remove(name)}>×</button></div>`)}
  <button class="item" onClick=${() => save(saved.value)}>Save layout as…</button>
  <button class="item" title="With the watches, the session and the moment" onClick=${() => download('jmanager-layout.json', new Blob([JSON.stringify(shared(), null, 1)], { type: 'application/json' }))}>Layout to a file</button>
  <button class="item" onClick=${openFile}>Layout from a file…</button>`;

/** The layouts of the server: a signal, and how to read it again. */
export function useSaved() {
  const saved = useSignal({});
  return [saved, async () => { saved.value = (await ask('layouts')) ?? {}; }];
}
