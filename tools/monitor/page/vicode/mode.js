// What the drawing is used for.

import { open as openPanel } from '../lib/dock.js';
import { html, signal } from '../lib/dom.js';

/** 'design', 'diff', 'try' or 'coverage'. */
export const mode = signal('design');

/** Why the drawing cannot be edited in a mode; null if it can be. */
export const heldBy = { diff: 'The drawing shows both versions: press Design to edit it.', try: 'The drawing is tried: press Design to edit it.' };

const MODES = [['design', 'Design', 'Draw and edit'], ['diff', 'Diff', 'What differs from the last commit'], ['try', 'Try it', 'Try the machine without building it'], ['coverage', 'Coverage', 'What the selected session has visited']];

/** The details are in the inspector. */
function use(name) {
  mode.value = name;
  if (name !== 'design') openPanel('inspector');
}

export const Modes = () => html`<span class="join modes" role="group" aria-label="Use of the drawing">${MODES.map(([name, label, title]) => html`
  <button class=${mode.value === name ? 'on' : ''} aria-pressed=${mode.value === name} title=${title} onClick=${() => use(name)}>${label}</button>`)}</span>`;
