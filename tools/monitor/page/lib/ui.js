// Small parts that panels share.

import { html, signal, useRef, useState } from './dom.js';
import { cursor } from './store.js';

/** Two lines in a panel without content: what is missing, and the remedy. */
export const Empty = ({ what, help }) => html`<div class="empty" role="status"><strong>${what}</strong><span>${help}</span></div>`;

/** The bar above a panel's content. */
export const Bar = ({ children, label }) => html`<div class="bar" role="toolbar" aria-label=${label}>${children}</div>`;

export const Toggle = ({ on, label, title, onChange, colour, disabled }) => html`
  <button type="button" class=${`toggle ${on ? 'on' : ''}`} role="switch" aria-checked=${on} title=${title} disabled=${disabled}
    onClick=${() => onChange(!on)}>${colour && html`<i class="dot" ref=${(dot) => dot && (dot.style.background = colour)}></i>`}${label}</button>`;

/** A text field that commits its value on Enter, or when it loses the focus. */
export function Field({ value, label, onCommit, type = 'text', width, ...rest }) {
  const [typed, setTyped] = useState(null);
  const commit = () => {
    if (typed !== null && typed !== String(value)) onCommit(typed);
    setTyped(null);
  };
  return html`<input type=${type} aria-label=${label} value=${typed ?? value} class=${width ?? ''} ...${rest}
    onInput=${(event) => setTyped(event.target.value)} onBlur=${commit}
    onKeyDown=${(event) => {
      if (event.key === 'Enter') commit();
      if (event.key === 'Escape') {
        setTyped(null);
        event.target.blur();
      }
    }} />`;
}

/** Number of characters beyond a limit; 0 without a limit. */
export const excess = (text, max = Infinity) => Math.max(0, [...String(text)].length - max);

/** Says while somebody types that a text is too long. */
export const TooLong = ({ text, max }) => excess(text, max) > 0 && html`<small class="warn" role="alert">at most ${max} characters; this has ${max + excess(text, max)}</small>`;

/** A curve of the last values before the shown moment, drawn as one path. */
export function Spark({ output, path, pick, span = 10e6 }) {
  void output.version.value;
  const { times, values } = output;
  const end = cursor.value === null ? times.length : output.count(cursor.value);
  const last = times[end - 1];
  if (last === undefined) return html`<svg class="spark" aria-hidden="true"></svg>`;
  let start = end;
  while (start > 0 && times[start - 1] >= last - span) start -= 1;
  const step = Math.max(1, Math.floor((end - start) / 60));
  const points = [];
  for (let index = start; index < end; index += step) {
    const value = pick(values[index], path);
    if (value !== null) points.push([times[index], Number(value)]);
  }
  if (points.length < 2) return html`<svg class="spark" aria-hidden="true"></svg>`;
  let [low, high] = [Infinity, -Infinity];
  for (const [, value] of points) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (high === low) [low, high] = [low - 1, high + 1];
  const line = points.map(([time, value], index) => `${index ? 'L' : 'M'}${(((time - last + span) / span) * 100).toFixed(1)} ${(17 - ((value - low) / (high - low)) * 14).toFixed(1)}`).join('');
  return html`<svg class="spark" viewBox="0 0 100 20" preserveAspectRatio="none" aria-hidden="true"><path d=${line} /></svg>`;
}

/** A menu under a button; with `inline`, a class, it stands open in a wide window. */
export function Menu({ label, title, children, onOpen, inline }) {
  const button = useRef(null);
  const items = useRef(null);
  const opens = (event) => { if (event.newState === 'open') onOpen?.(); };
  // In its place before it is painted: what moves under the pointer is not clicked.
  const toggle = () => {
    items.current.togglePopover();
    if (!items.current.matches(':popover-open')) return;
    const { left, right, bottom } = button.current.getBoundingClientRect();
    const { offsetWidth, offsetHeight, style } = items.current;
    style.left = `${Math.max(4, left + offsetWidth > innerWidth - 4 ? right - offsetWidth : left)}px`;
    style.top = `${Math.max(4, Math.min(bottom + 4, document.getElementById('app').offsetHeight - offsetHeight - 4))}px`;
  };
  const done = (event) => {
    if (event.target.closest('button.item')) items.current.hidePopover();
  };
  return html`<button ref=${button} class=${inline ? 'opener' : ''} aria-label=${title} aria-haspopup="menu" title=${title} onClick=${toggle}>${label}</button>
    <div class=${`menu ${inline ? `inline ${inline}` : ''}`} popover="auto" role="group" aria-label=${title} ref=${items} onBeforeToggle=${opens} onClick=${done}>${children}</div>`;
}

/** A panel whose module is loaded when it is shown first; `name` is what the module exports. */
export function later(load, name) {
  const view = signal(null);
  const failed = () => html`<${Empty} what="This panel cannot be loaded" help="The program does not answer: load the page again when it runs." />`;
  return (props) => {
    if (!view.value && props.visible.value) load().then((module) => { view.value = module[name]; }, () => { view.value = failed; });
    return view.value && html`<${view.value} ...${props} />`;
  };
}

/** Writes a file that the browser saves. */
export function download(name, blob) {
  const url = URL.createObjectURL(blob);
  const anchor = document.createElement('a');
  anchor.href = url;
  anchor.download = name;
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

/** Changes the text of an element if it is another one. */
export function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
