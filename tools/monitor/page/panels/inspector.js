// What is selected in the designer, as fields; in its other uses the differences, the trial, or the coverage.

import { html } from '../lib/dom.js';
import { sentence } from '../lib/format.js';
import { Empty } from '../lib/ui.js';
import { TrySide } from '../vicode/attempt.js';
import { CoverageSide } from '../vicode/coverage.js';
import { DiffSide } from '../vicode/diff.js';
import { ArrowFields } from '../vicode/inspector/arrow.js';
import { ComponentFields } from '../vicode/inspector/component.js';
import { Docs } from '../vicode/inspector/fields.js';
import { StateFields } from '../vicode/inspector/state.js';
import { Trees } from '../vicode/inspector/trees.js';
import { mode } from '../vicode/mode.js';
import { removeNote, setNote } from '../vicode/notes.js';
import { chosen, chosenNote, locked, machine, model, openedFile, refusal, selection } from '../vicode/sources.js';

const SIDES = { diff: DiffSide, try: TrySide, coverage: CoverageSide };

export function Inspector() {
  const Side = SIDES[mode.value];
  if (Side) return html`<article class="tab side"><${Side} /></article>`;
  const own = machine.value;
  if (!own && !model.value?.trees) return html`<${Empty} what="Nothing is selected" help="Open a component, then click a state or a transition." />`;
  const one = chosen.value;
  const note = chosenNote.value;
  if (note) return html`<article class="tab inspector" key=${note.key}><h2>Note</h2><${Docs} label="Text of the note" text=${note.text} onCommit=${(text) => setNote(text.trim())} /><button onClick=${() => removeNote()} title="Delete in the canvas">Delete the note</button></article>`;
  const several = selection.value.length;
  return html`<article class="tab inspector" key=${one?.key ?? own?.name ?? openedFile.value}>
    ${refusal.value && html`<p class="refusal" role="alert"><b>${sentence(refusal.value.text)}</b> ${refusal.value.help} <button class="small" aria-label="Dismiss" onClick=${() => { refusal.value = null; }}>×</button></p>`}
    ${locked.value && html`<p class="warn">${locked.value}</p>`}
    ${several > 1 && html`<p class="dim">${several} are selected; this is the last one.</p>`}
    ${!own ? html`<${Trees} />` : one ? ('sources' in one ? html`<${ArrowFields} arrow=${one} machine=${own} />` : html`<${StateFields} state=${one} machine=${own} />`) : html`<${ComponentFields} machine=${own} />`}
  </article>`;
}
