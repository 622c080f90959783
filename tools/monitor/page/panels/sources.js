// All components of the folder of sources: to open, and to carry onto a state.

import { html, useEffect, useSignal } from '../lib/dom.js';
import { open as openPanel } from '../lib/dock.js';
import { hello } from '../lib/store.js';
import { Bar, Empty } from '../lib/ui.js';
import { carry } from '../vicode/carry.js';
import { createComponent } from '../vicode/create.js';
import { component, list, open, openedFile, readList } from '../vicode/sources.js';

async function show(file, name) {
  openPanel('vicode');
  await open(file, name);
}

/** What the list shows of a file: its components, or else its trees. */
function entries({ file, components, trees, problem }) {
  if (problem) return [{ file, problem, name: null }];
  if (components.length > 0) return components.map((each) => ({ file, ...each }));
  const name = trees.join(', ');
  return [{ file, name, key: name, isTree: true }];
}

export function Sources() {
  const search = useSignal('');
  useEffect(() => { if (hello.value?.source && !list.value) readList(); }, [hello.value]);
  if (hello.value && !hello.value.source) return html`<${Empty} what="No folder of sources is open" help="Start the program with --source FOLDER." />`;
  const wanted = search.value.trim().toLowerCase();
  const all = (list.value ?? []).flatMap(entries);
  const found = all.filter(({ file, key }) => `${key ?? ''} ${file}`.toLowerCase().includes(wanted)).sort((a, b) => (b.machine ? 1 : 0) - (a.machine ? 1 : 0) || (a.name ?? '').localeCompare(b.name ?? ''));
  return html`<${Bar} label="Sources">
      <input type="search" class="grow" placeholder="Search" aria-label="Search sources" value=${search.value} onInput=${(event) => { search.value = event.target.value; }} onKeyDown=${(event) => event.key === 'Enter' && found[0]?.name && show(found[0].file, found[0].key)} />
      <button onClick=${readList} aria-label="Read the folder again" title="Read the folder again">↻</button><button onClick=${createComponent} title="A new component from a blank canvas">New…</button>
    <//>
    <ul class="sources" aria-label="Components">${found.map((one) => html`<li key=${one.file + (one.key ?? '')} class=${one.file === openedFile.value && (one.isTree || one.key === component.value) ? 'shown' : ''}>
      ${one.name
        ? html`<button class="name" onClick=${() => show(one.file, one.key)} onPointerDown=${(event) => !one.isTree && carry(event, one.name)} title=${one.isTree ? `${one.file}\nAn activation tree` : `${one.file}\nDrag onto a state to make it a child`}><b class=${one.machine ? 'kind machine' : ''}>${one.key}</b> <span class="dim">${one.file}</span></button>`
        : html`<span class="error" title=${one.problem}>${one.file}</span>`}</li>`)}
      ${list.value && found.length === 0 && html`<li class="dim">${all.length === 0 ? 'No file has a component.' : 'Nothing is found.'}</li>`}</ul>`;
}
