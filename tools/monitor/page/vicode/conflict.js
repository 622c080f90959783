// A file that was changed here and elsewhere at the same place: both texts, and the choice.

import { html, useState } from '../lib/dom.js';
import { ask, kept, opened } from './sources.js';

/** Lines of a text that the other one does not have, by the longest common begin and end. */
function parts(one, other) {
  const [a, b] = [one.split('\n'), other.split('\n')];
  let first = 0;
  while (first < a.length && a[first] === b[first]) first += 1;
  let last = 0;
  while (last < Math.min(a.length, b.length) - first && a.at(-1 - last) === b.at(-1 - last)) last += 1;
  return { before: a.slice(Math.max(0, first - 3), first), own: a.slice(first, a.length - last), after: a.slice(a.length - last, a.length - last + 3), first, last };
}

function Side({ title, text, other }) {
  const { before, own, after, first } = parts(text, other);
  return html`<figure class="side"><figcaption>${title} <span class="dim">from line ${first + 1}</span></figcaption>
    <pre>${before.join('\n')}${before.length > 0 && '\n'}<mark>${own.join('\n') || '(nothing)'}</mark>${'\n'}${after.join('\n')}</pre></figure>`;
}

export function Conflict() {
  const { file, conflict } = opened.value;
  const [text, setText] = useState(null);
  const keep = async (what) => {
    const done = await ask('resolve_file', { file, keep: what });
    if (done !== undefined && what === 'ours') kept();
  };
  return html`<section class="conflict" role="alertdialog" aria-label="Conflict">
    <h2>${file} was changed here and outside at the same place</h2>
    <p class="dim">Nothing was overwritten. The file keeps its text until you choose; the choice can be undone.</p>
    <div class="sides"><${Side} title="Here" text=${conflict.ours} other=${conflict.theirs} /><${Side} title="In the file" text=${conflict.theirs} other=${conflict.ours} /></div>
    ${text !== null && html`<textarea spellcheck="false" aria-label="Text made of both" value=${text} onInput=${(event) => setText(event.target.value)}></textarea>`}
    <p class="buttons"><button onClick=${() => keep('ours')}>Keep what is here</button><button onClick=${() => keep('theirs')}>Keep what is in the file</button>
      ${text === null ? html`<button onClick=${() => setText(conflict.ours)}>Edit a text of both…</button>` : html`<button class="primary" onClick=${() => keep({ text })}>Keep the edited text</button>`}</p>
  </section>`;
}
