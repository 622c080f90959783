// One search over everything: components, states, outputs, parameters, sessions, layouts, panels, and the commands of keys.

import { html, signal, useEffect, useRef, useSignal } from './lib/dom.js';
import * as dock from './lib/dock.js';
import { text as shortText, time, typedNumber } from './lib/format.js';
import { allKeys, namesOf } from './lib/keys.js';
import { PANELS } from './lib/panels.js';
import * as store from './lib/store.js';
import { draft, watches } from './lib/watches.js';
import { wish } from './panels/component/answer.js';

export const paletteShown = signal(false);
/** Most rows that are listed. */
const MOST = 60;

window.addEventListener('keydown', (event) => {
  if (namesOf(event).includes('Ctrl+k') && !dock.isPlain()) {
    event.preventDefault();
    paletteShown.value = !paletteShown.value;
  }
}, true);

/** Shows a component, and brings one of its controls into view. */
function showControl(component, label) {
  dock.openComponent(component);
  setTimeout(() => {
    const control = [...document.querySelectorAll('.tab [aria-label]')].find((one) => one.ariaLabel === label);
    control?.scrollIntoView({ block: 'center' });
    control?.focus();
  }, 200);
}

/** What can be found in the shown session: {kind, name, place, value, run}. */
function ofComponents() {
  const shown = store.session.value;
  const components = shown?.description.value?.components ?? [];
  const now = shown?.moment.value?.components;
  return components.flatMap((component, index) => {
    const { name, states, info, params } = component;
    const [active, , state] = now?.[index] ?? [];
    return [
      { kind: 'component', name, place: component.doc, value: [active ? 'active' : 'latent', states[state]?.name].filter(Boolean).join(', '), run: () => dock.openComponent(name) },
      ...states.map((one, number) => ({ kind: 'state', name: `${name}.${one.name}`, place: one.doc, value: active && number === state ? 'now' : 'the way there', run: () => { wish(name, one.name); dock.openComponent(name); } })),
      ...info.map((one, number) => ({ kind: 'output', name: `${name}.${one.name}`, place: one.doc, value: `${shortText(shown.output(index, number).now.value?.value)} ${one.unit ?? ''}`, run: () => showControl(name, `History of ${one.name}`) })),
      ...params.map((one, number) => ({ kind: 'parameter', name: `${name}.${one.name}`, place: one.doc, value: `${shortText(shown.params.value[index]?.[number])} ${one.unit ?? ''}`, run: () => showControl(name, one.name), set: [index, number] })),
    ];
  });
}

function everything() {
  const sessions = [...store.sessions.value.values()].map(({ id, info, title }) => ({ kind: 'session', name: title, place: info.value.result, value: info.value.connection, run: () => store.show(id) }));
  const layouts = dock.presets().map(([name, { title }, key]) => ({ kind: 'layout', name: title, place: '', value: `key ${key}`, run: () => dock.preset(name) }));
  const panels = Object.entries(PANELS).map(([name, { title }]) => ({ kind: 'panel', name: title, place: '', value: dock.opened.value.has(name) ? 'open' : '', run: () => dock.open(name) }));
  const watched = watches.value.map(({ text }) => ({ kind: 'watch', name: text, place: '', value: '', run: () => { draft.value = text; dock.open('watches'); } }));
  return [...ofComponents(), ...watched, ...sessions, ...layouts, ...panels, ...commands()];
}

const commands = () => allKeys().filter(({ where }) => !where).map(({ key, text, group, run }) => ({ kind: 'command', name: text, place: group, value: key === ' ' ? 'Space' : key, run }));

/** The length of a name's part in which the letters of a word stand in order; none without. */
function spread(name, word) {
  const begin = name.indexOf(word[0]);
  const end = [...word].reduce((from, letter) => (from < 0 ? from : name.indexOf(letter, from) + 1 || -1), begin);
  return begin < 0 || end < 0 ? Infinity : end - begin;
}

/** How well a row fits a text: 0 for not at all. The letters of a word may be apart, as in `laga` for `Lamp.gain`. */
function fit({ name, place }, wanted) {
  const [own, about] = [name.toLowerCase(), (place ?? '').toLowerCase()];
  let score = 1;
  for (const word of wanted) {
    const at = own.indexOf(word);
    if (at === 0) score += 40;
    else if (at > 0) score += /[._ ]/.test(own[at - 1]) ? 30 : 20;
    else if (spread(own, word) <= 3 * word.length) score += 6;
    else if (about.includes(word)) score += 3;
    else return 0;
  }
  return score - own.length / 200;
}

/** The rows for what was typed: `>` commands, `=` a parameter and its value, `@` a time in seconds. */
export function rowsFor(typed) {
  const [sign, rest] = '>=@'.includes(typed[0] ?? ' ') ? [typed[0], typed.slice(1).trim()] : ['', typed.trim()];
  if (sign === '@') {
    const seconds = Number(rest);
    return rest && Number.isFinite(seconds) ? [{ kind: 'time', name: `Show ${time(seconds * 1e6)}`, place: '', value: '', run: () => store.seek(seconds * 1e6) }] : [];
  }
  if (sign === '=') {
    const all = ofComponents().filter(({ set }) => set);
    // The value follows the last space; a name may have spaces, too.
    const [, name, value] = all.some((one) => one.name === rest) ? ['', rest] : rest.match(/^(.*\S)[\s=]+(\S+)$/) ?? ['', rest];
    const found = best(all, name);
    if (!value) return found;
    const number = typedNumber(value);
    return found.map((one) => ({ ...one, name: `${one.name} = ${value}`, run: () => store.setParams([{ component: one.set[0], param: one.set[1], value: Number.isFinite(number) ? number : value === 'true' || (value === 'false' ? false : value) }]) }));
  }
  return best(sign === '>' ? commands() : everything(), rest);
}

function best(rows, text) {
  const wanted = text.normalize('NFC').toLowerCase().split(/\s+/).filter(Boolean);
  return rows.map((row) => ({ row, score: fit(row, wanted) })).filter(({ score }) => score > 0).sort((a, b) => b.score - a.score).slice(0, MOST).map(({ row }) => row);
}

export function Palette() {
  const dialog = useRef(null);
  const typed = useSignal('');
  const chosen = useSignal(0);
  const shown = paletteShown.value;
  useEffect(() => {
    if (!shown) return dialog.current?.close();
    [typed.value, chosen.value] = ['', 0];
    return dialog.current?.showModal();
  }, [shown]);
  const rows = shown ? rowsFor(typed.value) : [];
  const at = Math.min(chosen.value, rows.length - 1);
  const run = (row) => {
    paletteShown.value = false;
    row?.run();
  };
  const key = (event) => {
    const by = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 }[event.key];
    if (by) chosen.value = Math.max(0, Math.min(at + by, rows.length - 1));
    else if (event.key === 'Enter') run(rows[at]);
    else return;
    event.preventDefault();
    setTimeout(() => document.getElementById(`found-${chosen.value}`)?.scrollIntoView({ block: 'nearest' }));
  };
  return html`<dialog ref=${dialog} class="palette" aria-label="Find anything" onClose=${() => { paletteShown.value = false; }} onClick=${(event) => event.target === dialog.current && run(null)}>
    <input type="search" role="combobox" aria-expanded="true" aria-controls="found" aria-activedescendant=${rows.length > 0 ? `found-${at}` : undefined} aria-label="Find anything" placeholder="Component, state, output, parameter, panel … or > command, = set, @ time"
      value=${typed.value} onInput=${(event) => { [typed.value, chosen.value] = [event.target.value, 0]; }} onKeyDown=${key} />
    <ul id="found" role="listbox" aria-label="Found">${rows.map((row, number) => html`<li id=${`found-${number}`} key=${`${row.kind} ${row.name}`} role="option" aria-selected=${number === at} class=${row.kind} onClick=${() => run(row)} onPointerMove=${() => { chosen.value = number; }}>
      <em>${row.kind}</em><b>${row.name}</b><span class="dim place">${row.place}</span><span class="value">${row.value}</span></li>`)}</ul>
    ${rows.length === 0 && html`<p class="dim">Nothing is called so. Try fewer letters.</p>`}
  </dialog>`;
}
