// What can be done at a place: actions of the world, and modulations with an argument that a map or an image can give.

import { html, useRef, useSignal } from '../lib/dom.js';
import { words } from '../lib/format.js';
import { ask, notify, operate } from '../lib/store.js';
import { Menu } from '../lib/ui.js';
import { Argument, initial } from './component/modulations.js';

/** Actions and modulations: {title, doc, arguments, moves, request(values)}. */
function calls(description) {
  const actions = description.actions.map((call) => ({ ...call, title: words(call.name), request: (values) => ({ type: 'world', action: call.name, arguments: values }) }));
  const modulations = description.components.flatMap((component) => component.modulations.map((call) => ({
    ...call,
    title: `${component.name} · ${words(call.name)}`,
    request: (values) => ({ type: 'modulate', component: component.name, modulation: call.name, arguments: values }),
  })));
  return [...actions, ...modulations];
}

const has = (call, axis) => call.arguments.some(({ place }) => place?.axis === axis);

/** What can be done with a session; nothing if it cannot be operated. */
const available = (shown) => (shown?.description.value && shown.info.value.can.operate ? calls(shown.description.value) : []);

/** What can be done at a point of a map: actions, and modulations that take a point. */
export const onGround = (shown) => available(shown).filter((call) => !has(call, 'column')
  && (call.request([]).type === 'world' || (has(call, 'x') && has(call, 'y'))));

/** What can be done at a pixel of an image. */
export const inImage = (shown) => available(shown).filter((call) => has(call, 'column') && has(call, 'row'));

/** The action that moves an item of the true state on the ground. */
export const mover = (shown, { name, frame }) => onGround(shown).find((call) => call.moves === name
  && ['x', 'y'].every((axis) => call.arguments.some(({ place }) => place?.axis === axis && place.frame === frame)));

const rounded = (value) => Math.round(value * 1000) / 1000;

/** A number within the range of an argument: a place may be beyond it. */
export const within = ({ min, max }, value) => Math.min(Math.max(value, min ?? -Infinity), max ?? Infinity);

/** One value for each argument: what `known(place)` gives, within its range, or the default. */
export const valuesAt = (call, known) => call.arguments.map((argument) => {
  const value = argument.place && known(argument.place);
  if (value === undefined || value === null) return initial(argument);
  return typeof value === 'number' ? within(argument, rounded(value)) : value;
});

/** A form that requests a call. */
function Call({ shown, call, values }) {
  const typed = useSignal(values);
  const set = (index) => (value) => { typed.value = typed.value.with(index, value); };
  const submit = async (event) => {
    event.preventDefault();
    const given = call.arguments.map((argument, index) => {
      const value = typed.value[index];
      return 'min' in argument && typeof value === 'string' ? (value.trim() === '' ? NaN : Number(value.trim().replace('−', '-'))) : value;
    });
    const wrong = given.findIndex((value) => Number.isNaN(value));
    if (wrong >= 0) {
      const { name, min, max, unit } = call.arguments[wrong];
      notify('error', `“${typed.value[wrong]}” is no number`, `give ${words(name)} as a number from ${min} to ${max} ${unit ?? ''}`);
      return;
    }
    if (await operate()) ask('operate', { session: shown.id, request: call.request(given) }, `${call.title}: done`);
  };
  const field = (argument, index) => ('min' in argument
    ? html`<label title=${argument.doc}>${words(argument.name)}${argument.unit && `, ${argument.unit}`} <input class="short" inputmode="decimal" autocomplete="off" aria-label=${`${call.title} ${words(argument.name)}`}
      value=${typed.value[index]} onInput=${(event) => set(index)(event.target.value)} /></label>`
    : html`<${Argument} ...${{ argument, value: typed.value[index], set: set(index) }} />`);
  return html`<h3>${call.title}</h3><p class="hint">${call.doc}</p>
    <form class="form" onSubmit=${submit}>${call.arguments.map(field)}<button aria-label=${call.title}>Do it</button></form>`;
}

/** The forms of calls with what is known when a menu opens; `opened` differs each time. */
const Calls = ({ shown, list, known, opened }) => list.map((call) => html`<${Call} key=${`${opened} ${call.title}`} ...${{ shown, call, values: valuesAt(call, (place) => known(place, call)) }} />`);

/** The menu of the bar. `known(place, call)` is the value of an argument. */
export function ActionsMenu({ shown, list, known }) {
  const opened = useSignal(0);
  if (list.length === 0) return null;
  return html`<${Menu} label="Actions" title="What can be done here" onOpen=${() => { opened.value += 1; }}><${Calls} ...${{ shown, list, known, opened: opened.value }} /><//>`;
}

/**
 * The menu at the pointer. `at(event)` returns the function `known(place, call)` of the place under the pointer. Returns the
 * handlers of the canvas and the menu.
 */
export function useActions({ shown, list: all, at }) {
  const list = all.filter((call) => call.arguments.some(({ place }) => place));
  const items = useRef(null);
  const open = useSignal({ known: () => null, opened: 0 });
  const handlers = {
    onContextMenu: (event) => {
      const known = list.length > 0 && at(event);
      if (!known) return;
      event.preventDefault();
      open.value = { known, opened: open.value.opened + 1 };
      items.current.showPopover();
      const { offsetWidth, offsetHeight, style } = items.current;
      style.left = `${Math.max(4, Math.min(event.clientX, innerWidth - offsetWidth - 4))}px`;
      style.top = `${Math.max(4, Math.min(event.clientY, innerHeight - offsetHeight - 4))}px`;
    },
  };
  const menu = html`<div class="menu" popover="auto" role="group" aria-label="What can be done at this place" ref=${items}><${Calls} ...${{ shown, list, ...open.value }} /></div>`;
  return { handlers, menu };
}
