// Modulations of a component: forms; calls are repeated while a button is held.

import { html, useEffect, useRef, useSignal } from '../../lib/dom.js';
import { niceStep, number, words } from '../../lib/format.js';
import { on } from '../../lib/listen.js';
import { act, operate, session } from '../../lib/store.js';

/** Time between two calls while a button is held. */
export const REPEAT_MS = 100;

export function Modulations({ component, index }) {
  return html`<section aria-label="Modulations"><h3>Modulations</h3>
    ${component.modulations.map((modulation, number) => html`<${Modulation} key=${modulation.name} ...${{ modulation, component: index, number, name: component.name }} />`)}</section>`;
}

/** The value of an argument before anybody sets it. */
export const initial = (argument) => argument.default ?? ('min' in argument ? Math.min(Math.max(0, argument.min), argument.max) : argument.kind === 'bool' ? false : argument.variants?.[0]?.name);

function Modulation({ modulation, component, number: place, name }) {
  const values = useSignal(modulation.arguments.map(initial));
  const timer = useRef(null);
  const can = session.value?.info.value.can.operate;
  const call = () => act('modulate', { component, modulation: place, arguments: values.value });
  const once = async () => (await operate()) && call();
  const begin = async (event) => {
    event.preventDefault();
    if (timer.current !== null) return;
    timer.current = 0;
    if (!(await operate())) {
      timer.current = null;
      return;
    }
    if (timer.current === null) return;
    call();
    timer.current = setInterval(async () => {
      if ((await call()) === undefined) end();
    }, REPEAT_MS);
  };
  const end = () => {
    clearInterval(timer.current);
    timer.current = null;
  };
  useEffect(() => {
    const ends = [on(window, { blur: end }), end];
    return () => ends.forEach((one) => one());
  }, []);
  const key = (event) => {
    if (event.key !== ' ' && event.key !== 'Enter') return;
    if (event.type === 'keydown') begin(event);
    else end();
    event.preventDefault();
  };
  return html`<fieldset class="modulation" disabled=${!can}><legend title=${modulation.doc}>${words(modulation.name)}</legend>
    <p class="dim">${modulation.doc}</p>
    ${modulation.arguments.map((argument, at) => html`<${Argument} ...${{ argument, value: values.value[at], set: (value) => { values.value = values.value.with(at, value); } }} />`)}
    <div class="buttons"><button class="small" aria-label=${`Call ${name}.${modulation.name} once`} onClick=${once}>Call once</button>
      <button class="small hold" aria-label=${`Hold ${name}.${modulation.name}`} title="Calls ten times a second while it is held" onPointerDown=${begin} onPointerUp=${end} onPointerLeave=${end} onPointerCancel=${end} onKeyDown=${key} onKeyUp=${key} onBlur=${end}>Hold to repeat</button></div>
  </fieldset>`;
}

export function Argument({ argument, value, set }) {
  const { name, kind, unit } = argument;
  if (kind === 'bool') return html`<div class="row"><label>${words(name)}</label><input type="checkbox" aria-label=${name} checked=${value} onChange=${(event) => set(event.target.checked)} /></div>`;
  if (kind === 'choice') {
    return html`<div class="row" title=${argument.doc}><label>${words(name)}</label><select class="wide2" aria-label=${name} onChange=${(event) => set(event.target.value)}>
      ${argument.variants.map((variant) => html`<option selected=${variant.name === value} title=${variant.doc}>${variant.name}</option>`)}</select></div>`;
  }
  return html`<div class="row" title=${argument.doc}><label>${words(name)}</label>
    <input type="range" aria-label=${name} min=${argument.min} max=${argument.max} step=${argument.step ?? niceStep(argument.max - argument.min)} value=${value} onInput=${(event) => set(Number(event.target.value))} />
    <span class="v">${number(value)} <span class="unit">${unit ?? ''}</span></span></div>`;
}
