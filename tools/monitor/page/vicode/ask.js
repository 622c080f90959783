// Questions to the user: a name at its place on the canvas, and small forms.

import { html, signal, useEffect, useLayoutEffect, useRef, useState } from '../lib/dom.js';
import { excess, TooLong } from '../lib/ui.js';

/** The name that is being typed on the canvas: {at: [x, y] of the drawing, value, label, done}. */
export const naming = signal(null);
/** The form that is shown. */
const form = signal(null);

/** Asks in a place; what was asked there before is given up. */
const asking = (place, answerOf) => (question) => new Promise((resolve) => {
  place.value?.done(null);
  place.value = { ...question, done(answer) { place.value = null; resolve(answerOf(answer)); } };
});

/** Asks for a name at a point of the drawing; null if it is given up. */
export const askName = asking(naming, (name) => name && name.trim());

/**
 * Asks with a form: {title, hint, submit, fields: [{name, label, value, kind: text, area, number, select or check, options, hint, max}], preview}.
 * `preview(values)` may return more to show. Null if it is given up.
 */
export const askForm = asking(form, (values) => values);

/** The input of a name, over the canvas. */
export function NameField({ view }) {
  const asked = naming.value;
  const input = useRef(null);
  // At once: keys that are typed before the next frame are for it.
  useLayoutEffect(() => {
    if (!asked) return;
    input.current.focus();
    input.current.select();
  }, [asked]);
  if (!asked) return null;
  const [x, y] = view.place(asked.at);
  const place = (element) => {
    input.current = element;
    if (!element) return;
    element.style.left = `${Math.max(4, Math.min(x - 85, view.svg.clientWidth - 176))}px`;
    element.style.top = `${Math.max(4, Math.min(y - 13, view.svg.clientHeight - 30))}px`;
  };
  const key = (event) => {
    event.stopPropagation();
    if (event.key === 'Enter') asked.done(event.target.value);
    if (event.key === 'Escape') asked.done(null);
    if (event.key === 'Enter' || event.key === 'Escape') view.svg.focus({ preventScroll: true });
  };
  return html`<input key=${asked.label + asked.at} class="naming" type="text" spellcheck="false" autocomplete="off" ref=${place} aria-label=${asked.label} value=${asked.value}
    onKeyDown=${key} onBlur=${(event) => naming.value === asked && asked.done(asked.value === event.target.value && !asked.fresh ? null : event.target.value)} />`;
}

/** The form. */
export function Form() {
  const asked = form.value;
  const dialog = useRef(null);
  useLayoutEffect(() => {
    if (asked) dialog.current?.showModal();
  }, [asked]);
  if (!asked) return null;
  // Closing first gives the focus back to where it was.
  const finish = (values) => {
    dialog.current.close();
    asked.done(values);
  };
  return html`<dialog ref=${dialog} class="help ask" aria-label=${asked.title} onClose=${() => form.value === asked && asked.done(null)} onKeyDown=${(event) => event.stopPropagation()}>
    <${Fields} key=${asked.title} asked=${asked} finish=${finish} /></dialog>`;
}

function Fields({ asked, finish }) {
  const [values, setValues] = useState(() => Object.fromEntries(asked.fields.map(({ name, value }) => [name, value ?? ''])));
  const [more, setMore] = useState(null);
  const set = (name, value) => {
    const next = { ...values, [name]: value };
    setValues(next);
    asked.preview?.(next).then(setMore);
  };
  useEffect(() => {
    asked.preview?.(values).then(setMore);
  }, []);
  const submit = (event) => {
    event.preventDefault();
    if (!asked.fields.some(({ name, max }) => excess(values[name], max))) finish(values);
  };
  // A list does not hand Enter on to its form.
  const enter = (event) => event.key === 'Enter' && (event.target.tagName === 'SELECT' || event.ctrlKey) && submit(event);
  return html`<form onSubmit=${submit} onKeyDown=${enter}>
    <header><h2>${asked.title}</h2><button type="button" aria-label="Close" onClick=${() => finish(null)}>×</button></header>
    ${asked.hint && html`<p class="dim">${asked.hint}</p>`}
    ${asked.fields.map((field, index) => html`<label class="field" key=${field.name}><span>${field.label}</span>
      ${field.kind === 'select'
        ? html`<select aria-label=${field.label} autofocus=${index === 0} onChange=${(event) => set(field.name, event.target.value)}>${field.options.map(([value, text]) => html`<option value=${value} selected=${value === values[field.name]}>${text}</option>`)}</select>`
        : field.kind === 'area' ? html`<textarea class="docs-field" rows="4" aria-label=${field.label} autofocus=${index === 0} onInput=${(event) => set(field.name, event.target.value)} value=${values[field.name]}></textarea>`
        : field.kind === 'check' ? html`<input type="checkbox" aria-label=${field.label} checked=${values[field.name]} onChange=${(event) => set(field.name, event.target.checked)} />`
        : html`<input type="text" aria-label=${field.label} autofocus=${index === 0} spellcheck="false" autocomplete="off" inputmode=${field.kind === 'number' ? 'numeric' : undefined} list=${field.options && !field.kind ? `list-${field.name}` : undefined}
            value=${values[field.name]} onInput=${(event) => set(field.name, event.target.value)} />`}
      ${field.options && !field.kind && html`<datalist id=${`list-${field.name}`}>${field.options.map((one) => html`<option value=${one} />`)}</datalist>`}
      <${TooLong} text=${values[field.name]} max=${field.max} />
      ${field.hint && html`<small class="dim">${field.hint}</small>`}</label>`)}
    ${more}
    <p class="buttons"><button class="primary" type="submit">${asked.submit}</button><button type="button" onClick=${() => finish(null)}>Cancel</button></p>
  </form>`;
}
