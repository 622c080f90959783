// The list of keys.

import { html, signal, useEffect, useRef } from './lib/dom.js';
import { allKeys } from './lib/keys.js';

export const helpShown = signal(false);

const NAMES = { ' ': 'Space', ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓' };
const shown = (key) => key.split('+').map((part) => NAMES[part] ?? part).join(' + ') || '+';

export function Help() {
  const dialog = useRef(null);
  useEffect(() => {
    if (helpShown.value) dialog.current?.showModal();
    else dialog.current?.close();
  }, [helpShown.value]);
  const groups = Map.groupBy(allKeys(), (binding) => binding.group);
  return html`<dialog ref=${dialog} class="help" aria-label="Keys" onClose=${() => { helpShown.value = false; }}>
    <header><h2>Keys</h2><button aria-label="Close list of keys" onClick=${() => { helpShown.value = false; }}>×</button></header>
    ${helpShown.value && html`<div class="keys">${[...groups].map(([group, bindings]) => html`<section><h3>${group}</h3><dl>
      ${bindings.map(({ key, text }) => html`<div><dt><kbd>${key === '+' ? '+' : shown(key)}</kbd></dt><dd>${text}</dd></div>`)}</dl></section>`)}</div>`}
  </dialog>`;
}
