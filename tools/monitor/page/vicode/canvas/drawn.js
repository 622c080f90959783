// States and transitions as elements of the drawing.

import { html } from '../../lib/dom.js';
import { labelWidth, waitText } from './labels.js';
import { isMachine } from '../trail.js';
import { stage } from './stage.js';

const KIND = { requirement: 'reads', modulation: 'writes', rate: 'sets the rate of' };

/** What was drawn last, by key. The same object tells Preact that nothing has to be compared. */
let kept = new Map();

/** Draws `of`, a part of the machine, unless it was drawn with the same flags and the same facts. */
function keep(next, key, { of, place, flags: all }, make) {
  const known = kept.get(key);
  const marks = JSON.stringify(all);
  // While only the selection changes, most parts are the same objects.
  const isSame = known?.of === of && known.marks === marks && known.place === place;
  const signature = isSame ? known.signature : JSON.stringify([facts(of), place]);
  const one = isSame || (known?.signature === signature && known.marks === marks) ? { ...known, of, place } : { of, place, marks, signature, drawn: make() };
  next.set(key, one);
  return one.drawn;
}

/** What a drawing depends on; JSON leaves out what is undefined. */
const facts = (one) => ({ ...one, function: undefined });

/** All arrows, their names, then all states: what is later lies above. */
export function Drawn({ machine, chosen, found, stops }) {
  const near = ({ from, to, any }) => chosen.has(`s:${to}`) || (!any && chosen.has(`s:${from}`));
  const next = new Map();
  const flagsOf = ({ key, name }) => ({ chosen: chosen.has(key), found: found(name), stop: stops.has(key) });
  const arrows = machine.arrows.map((arrow) => {
    const all = { ...flagsOf(arrow), near: near(arrow) };
    return keep(next, arrow.key, { of: arrow, place: stage.courses.get(arrow.key), flags: all }, () => html`<${Arrow} key=${arrow.key} arrow=${arrow} ...${all} />`);
  });
  const states = machine.states.map((state) => {
    const { x, y, width } = stage.boxes.get(state.name);
    const all = flagsOf(state);
    return keep(next, state.key, { of: state, place: `${x} ${y} ${width}`, flags: all }, () => html`<${State} key=${state.key} state=${state} at=${stage.boxes.get(state.name)} ...${all} />`);
  });
  const names = machine.arrows.map((arrow) => {
    const all = { ...flagsOf(arrow), near: near(arrow) };
    return keep(next, `label ${arrow.key}`, { of: arrow, place: stage.courses.get(arrow.key), flags: all }, () => html`<${Name} key=${arrow.key} arrow=${arrow} ...${all} />`);
  });
  kept = next;
  return html`<g class="arrows">${arrows}</g><g class="names">${names}</g><g class="states">${states}</g>`;
}

const flags = (...all) => all.filter(Boolean).join(' ');
const mark = (found) => (found === null ? '' : found ? 'found' : 'other');

function Arrow({ arrow, chosen, near, found, stop }) {
  const course = stage.courses.get(arrow.key);
  const timer = waitText(arrow);
  const name = `Transition ${arrow.name}: ${arrow.any ? 'any state' : arrow.from} to ${arrow.to}${timer && `, ${timer}`}${arrow.carries === null ? '' : `, carries ${arrow.carries}`}`;
  return html`<g class=${arrowFlags({ arrow, chosen, near, found, stop })} data-key=${arrow.key}
      role="button" tabindex="0" aria-label=${name} aria-pressed=${chosen}>
    <path class="hit" d=${course.d} /><path class="line" d=${course.d} marker-end=${`url(#tip${chosen ? '-chosen' : ''})`} />
    <circle class="stop" r="5" cx=${course.start[0]} cy=${course.start[1]} /><title>${name}</title></g>`;
}

/** The name of an arrow; those of one bundle have it in the same place. Without room it is shown under the pointer only, as the arrow's title. */
function Name({ arrow, chosen, near, found, stop }) {
  const course = stage.courses.get(arrow.key);
  const timer = waitText(arrow);
  const width = labelWidth(arrow);
  return html`<g class=${`label ${arrowFlags({ arrow, chosen, near, found, stop })} ${(course.owner ?? arrow.key) === arrow.key ? '' : 'shared'} ${course.crowded ? 'crowded' : ''}`} data-key=${arrow.key} aria-hidden="true" transform=${`translate(${course.label[0].toFixed(1)} ${course.label[1].toFixed(1)})`} text-anchor=${course.anchor}>
    <title>${arrow.docs || arrow.name}</title>
    <rect class="ground" x=${course.anchor === 'start' ? -4 : -width / 2} y="-8" width=${width} height="16" rx="3" />
    <text y="4"><tspan class="fault">⚠ </tspan>${arrow.sign && html`<tspan class="sign">${arrow.sign} </tspan>`}${arrow.any && html`<tspan class="dim">any · </tspan>`}${arrow.name}${timer && html`<tspan class="timer" dx="4">${timer}</tspan>`}</text>
    <text class="live" y="17"></text></g>`;
}

const arrowFlags = ({ arrow, chosen, near, found, stop }) => flags('arrow', chosen && 'chosen', near && 'near', mark(found), arrow.any && 'any', (arrow.after_ms !== null || arrow.after !== null) && 'timed', stop && 'stopped', arrow.mark);

/** `at` is its place. */
function State({ state, at: { x, y, width, height, box }, chosen, found, stop }) {
  const told = [state.initial && 'initial', state.last && (state.end ?? 'last'), state.takes && `takes ${state.takes}`, ...state.hooks.map((hook) => `${hook.role} hook ${hook.name}`), ...state.asks.map((one) => `asks ${one}`), ...state.children.map(({ kind, child }) => `${KIND[kind]} ${child}`)].filter(Boolean).join(', ');
  return html`<g class=${flags('box', chosen && 'chosen', mark(found), state.initial && 'initial', state.last && 'last', stop && 'stopped', state.mark)} data-key=${state.key} data-state=${state.name}
      transform=${`translate(${x - width / 2} ${y - height / 2})`} role="button" tabindex="0" aria-label=${`State ${state.name}`} aria-description=${told} aria-pressed=${chosen}>
    <title>${state.docs || state.name}</title>
    ${state.initial && html`<circle class="begin" cx="-34" cy="20" r="6" /><path class="line" d="M-28 20L-7 20" marker-end="url(#tip)" />`}
    <rect class="body" width=${width} height=${height} rx="9" />
    ${state.last && html`<rect class="inner" x="3.5" y="3.5" width=${width - 7} height=${height - 7} rx="6" />`}
    <circle class="stop" cx="12" cy="17" r="5"><title>Breakpoint (b)</title></circle>
    <text class="fault" x="-4" y="4">⚠</text><text class="name" x="24" y="21">${state.sign && `${state.sign} `}${state.name}${box.takes && html`<tspan class="dim" font-size="11">${box.takes}</tspan>`}</text>
    <text class="live" x=${width - 10} y="21" text-anchor="end">${state.initial ? 'initial' : state.last ? (state.end ?? 'last') : ''}</text>
    ${box.docs && html`<text class="docs" x="10" y=${box.docs.y}>${box.docs.text}</text>`}
    ${box.hooks.map((hook) => html`<text class="hook" x="10" y=${hook.y}>${hook.text}</text>`)}
    ${box.chips.map((chip) => html`<g class=${`link-chip ${chip.kind} ${isMachine(chip.child) ? 'opens' : ''}`} data-child=${chip.child} transform=${`translate(${chip.x} ${chip.y})`}>
      <title>${`${state.name} ${KIND[chip.kind]} ${chip.child}${isMachine(chip.child) ? ', a machine: double-click opens it' : ''}`}</title>
      <rect width=${chip.width} height=${chip.height} rx="10" /><text x=${chip.width / 2} y="14" text-anchor="middle">${chip.text}</text></g>`)}
    ${['0 0.5', '1 0.5', '0.5 0', '0.5 1'].map((at) => {
      const [px, py] = at.split(' ').map(Number);
      return html`<circle class="handle" cx=${px * width} cy=${py * height} r="6"><title>Drag to draw a transition</title></circle>`;
    })}</g>`;
}

/** Arrow heads. */
export const Tips = () => html`<defs>
  ${['', '-chosen', '-live', '-far'].map((kind) => html`<marker id=${`tip${kind}`} class=${`tip${kind}`} viewBox="0 0 10 10" refX="8" refY="5" markerWidth="9" markerHeight="9" markerUnits="userSpaceOnUse" orient="auto-start-reverse"><path d="M0 0.5L10 5L0 9.5z" /></marker>`)}
  <pattern id="grid" width="24" height="24" patternUnits="userSpaceOnUse"><circle cx="1" cy="1" r="1" /></pattern></defs>`;
