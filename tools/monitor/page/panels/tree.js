// The activation tree: what is active, in which state, at which rate and cost.

import { effect, html, useEffect, useMemo, useRef, useSignal } from '../lib/dom.js';
import { bind, isPointed } from '../lib/keys.js';
import { duration, number } from '../lib/format.js';
import { openComponent } from '../lib/dock.js';
import { hovered, selected, session, watch } from '../lib/store.js';
import { Bar, Empty, Toggle } from '../lib/ui.js';
import { carry } from '../vicode/carry.js';

const [WIDTH, HEIGHT] = [104, 38];
/** Shares of the budget from which the cost is drawn as a warning, and as an error. */
const [NEAR, OVER] = [0.8, 1];
/** Scale below which names stand on two lines. */
const COMPACT = 0.74;

/** Components that a folded one hides: those that the root reaches only through it. */
function hiddenBy(description, folded) {
  if (folded.size === 0) return new Set();
  const reached = new Set();
  const visit = (index) => {
    if (reached.has(index)) return;
    reached.add(index);
    if (!folded.has(index)) description.components[index].links.forEach((one) => visit(one.to));
  };
  visit(description.root);
  return new Set(description.components.keys().filter((index) => !reached.has(index)));
}

export function Tree({ visible }) {
  const shown = session.value;
  const description = shown?.description.value;
  const drawing = shown?.drawing.value;
  const search = useSignal('');
  const activeOnly = useSignal(false);
  const folded = useSignal(new Set());
  const box = useSignal(null);
  const field = useRef(null);
  useEffect(() => bind({ key: '/', text: 'search a component', group: 'Tree', run: () => field.current?.focus() }), []);
  useEffect(() => (visible.value ? watch({ costs: true }) : undefined), [visible.value]);

  if (!shown) return html`<${Empty} what="No session is open" help="Press + in the bar above to open a world, a robot or a recording." />`;
  if (!description) {
    const info = shown.info.value;
    return html`<${Empty} what=${info.connection === 'connecting' ? `Connecting to ${info.name}` : `Nothing is known of ${info.name} yet`} help=${info.note || 'The tree is drawn as soon as the robot has described it.'} />`;
  }
  if (!drawing?.boxes.length) return html`<${Empty} what="This tree is too large to draw" help="Use the search of the timeline, and the component tabs." />`;
  const found = description.components.filter((component) => matches(component, search.value)).length;
  const fit = () => { box.value = null; };
  const zoom = (factor) => { box.value = zoomed(box.value ?? whole(drawing), factor, 0.5, 0.5); };
  return html`<${Bar} label="Activation tree">
      <input ref=${field} type="search" placeholder="Search ( / )" aria-label="Search components" value=${search.value} onInput=${(event) => { search.value = event.target.value; }}
        onKeyDown=${(event) => event.key === 'Enter' && openFirst(description, search)} />
      <span class="dim count" role="status"><${Counts} shown=${shown} />${search.value ? html` · <span class=${found ? '' : 'warn'}>${found} found</span>` : ''}</span>
      <span class="grow"></span>
      <${Toggle} on=${activeOnly.value} label="Active only" title="Hide latent components" onChange=${(on) => { activeOnly.value = on; }} />
      <button aria-label="Zoom in" onClick=${() => zoom(0.8)}>+</button><button aria-label="Zoom out" onClick=${() => zoom(1.25)}>−</button>
      <button onClick=${fit} title="Show the whole tree">Fit</button>
      ${folded.value.size > 0 && html`<button onClick=${() => { folded.value = new Set(); }}>Unfold all</button>`}
    <//>
    <${Drawn} ...${{ shown, description, drawing, search, activeOnly, folded, box, visible }} />`;
}

const matches = (component, text) => component.name.toLowerCase().includes(text.toLowerCase().trim());
/** The text of a search, or an empty one if no component matches. */
const foundAny = ({ components }, text) => (components.some((component) => matches(component, text)) ? text : '');
const whole = (drawing) => [0, 0, drawing.width, drawing.height];

/** Opens the first component that is found; the search ends then. */
function openFirst(description, search) {
  const first = description.components.find((component) => matches(component, search.value));
  if (!first) return;
  openComponent(first.name);
  search.value = '';
}

function zoomed([x, y, width, height], factor, partX, partY) {
  return [x + width * (1 - factor) * partX, y + height * (1 - factor) * partY, width * factor, height * factor];
}

function Counts({ shown }) {
  const components = shown.moment.value?.components;
  if (!components) return null;
  return `${components.filter(([active]) => active).length} of ${components.length} active`;
}

function Drawn({ shown, description, drawing, search, activeOnly, folded, box, visible }) {
  const svg = useRef(null);
  const compact = useSignal(false);
  const links = useMemo(() => description.components.flatMap((component, from) => component.links.map((one) => ({ from, ...one }))), [description]);
  const [x, y, width, height] = box.value ?? whole(drawing);

  // Where the tree is drawn small, names are larger and stand on two lines.
  useEffect(() => {
    const measure = () => {
      const [, , boxWidth, boxHeight] = box.value ?? whole(drawing);
      compact.value = Math.min(svg.current.clientWidth / boxWidth, svg.current.clientHeight / boxHeight) < COMPACT;
    };
    const observer = new ResizeObserver(measure);
    observer.observe(svg.current);
    const stop = effect(() => {
      void box.value;
      measure();
    });
    return () => {
      observer.disconnect();
      stop();
    };
  }, [drawing]);

  // State and costs change often: they are written to the elements, without a new rendering.
  useEffect(() => {
    const boxes = [...svg.current.querySelectorAll('.component')];
    const paths = [...svg.current.querySelectorAll('.link')];
    return effect(() => {
      if (!visible.value) return;
      const components = shown.moment.value?.components;
      const costs = shown.costs.value;
      const hidden = hiddenBy(description, folded.value);
      boxes.forEach((element, index) => drawComponent(element, { index, now: components?.[index], cost: costs?.components[index], window: costs?.window_us, description, hidden, folded: folded.value.has(index), search: foundAny(description, search.value), activeOnly: activeOnly.value, compact: compact.value }));
      paths.forEach((element, index) => {
        const { from, to, state } = links[index];
        const active = isActive(components, links[index]);
        element.classList.toggle('active', active);
        const near = hovered.value === from || hovered.value === to;
        element.classList.toggle('near', near);
        const gone = hidden.has(from) || hidden.has(to) || folded.value.has(from) || (activeOnly.value && !active) || (state !== null && !active && !near);
        element.classList.toggle('gone', gone);
      });
    });
  }, [shown, description, drawing]);

  const wheel = (event) => {
    event.preventDefault();
    const bounds = svg.current.getBoundingClientRect();
    box.value = zoomed(box.value ?? whole(drawing), event.deltaY > 0 ? 1.15 : 1 / 1.15, (event.clientX - bounds.x) / bounds.width, (event.clientY - bounds.y) / bounds.height);
  };
  const drag = (event) => {
    if (event.target.closest('.component') || event.button !== 0) return;
    const start = [event.clientX, event.clientY];
    const from = box.value ?? whole(drawing);
    const scale = from[2] / svg.current.clientWidth;
    const move = (moved) => { box.value = [from[0] - (moved.clientX - start[0]) * scale, from[1] - (moved.clientY - start[1]) * scale, from[2], from[3]]; };
    svg.current.setPointerCapture(event.pointerId);
    svg.current.onpointermove = move;
    svg.current.onlostpointercapture = () => { svg.current.onpointermove = null; };
  };
  const fold = (index) => {
    const next = new Set(folded.value);
    if (!next.delete(index)) next.add(index);
    folded.value = next;
  };
  // Tab reaches one component; the arrow keys go to its neighbours.
  const stop = Math.max(0, selected.value ? description.components.findIndex((component) => component.name === selected.value) : description.root);
  const key = (event, component, index) => {
    if (event.key === 'Enter' || (event.key === ' ' && !isPointed(event.currentTarget))) openComponent(component.name, event.shiftKey);
    else if (event.key === 'f') fold(index);
    else if (event.key in TURNS && !isPointed(event.currentTarget)) walk(event.currentTarget, TURNS[event.key]);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return html`<svg class="tree fill" ref=${svg} viewBox=${`${x} ${y} ${width} ${height}`} role="group" aria-label="Activation tree" onWheel=${wheel} onPointerDown=${drag}>
    ${drawing.links.map(({ from, path }) => html`<path class=${`link ${drawing.boxes[from].kind}`} d=${path} />`)}
    ${description.components.map((component, index) => {
      const { x: centre, y: top, kind } = drawing.boxes[index];
      return html`<g key=${component.name} class=${`component ${kind}`} transform=${`translate(${centre - WIDTH / 2} ${top})`} role="button" tabindex=${index === stop ? 0 : -1} aria-label=${component.name}
        aria-pressed=${selected.value === component.name} onClick=${(event) => openComponent(component.name, event.shiftKey)} onPointerDown=${(event) => carry(event, component.name)} onDblClick=${() => fold(index)} onKeyDown=${(event) => key(event, component, index)}
        onPointerEnter=${() => { hovered.value = index; }} onPointerLeave=${() => { hovered.value = null; }}>
        <title>${component.doc || component.name}${'\n'}Click: show. Shift-click: own tab. Double click or f: fold. Drag onto a state: make it a child.</title>
        <rect width=${WIDTH} height=${HEIGHT} rx="6" /><text class="title" x=${WIDTH / 2} y="17">${component.name}</text><text class="sub" x=${WIDTH / 2} y="30"></text>
        <rect class="cost" x="5" y=${HEIGHT - 5} height="2" width="0" rx="1" /><text class="held" x=${WIDTH - 6} y="11"></text></g>`;
    })}
  </svg>`;
}

/** Directions of the arrow keys. */
const TURNS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** Moves the focus to the nearest box in a direction. */
function walk(from, [ux, uy]) {
  const centre = (element) => {
    const { x, y, width, height } = element.getBoundingClientRect();
    return [x + width / 2, y + height / 2];
  };
  const [x, y] = centre(from);
  const others = [...from.parentElement.querySelectorAll('.component:not(.gone)')].map((element) => {
    const [dx, dy] = centre(element).map((value, axis) => value - [x, y][axis]);
    const ahead = dx * ux + dy * uy;
    return { element, ahead, cost: ahead + 2 * Math.abs(dx * uy + dy * ux) };
  });
  others.filter(({ ahead }) => ahead > 4).sort((a, b) => a.cost - b.cost)[0]?.element.focus();
}

/** Whether a link activates its target now. */
function isActive(components, { from, to, state }) {
  const [source, target] = [components?.[from], components?.[to]];
  return Boolean(source?.[0] && target?.[0] && (state === null || source[2] === state));
}

function drawComponent(element, { index, now, cost, window, description, hidden, folded, search, activeOnly, compact }) {
  const component = description.components[index];
  const active = now?.[0] ?? false;
  const { classList } = element;
  classList.toggle('active', active);
  classList.toggle('gone', hidden.has(index) || (activeOnly && !active));
  classList.toggle('found', search !== '' && matches(component, search));
  classList.toggle('other', search !== '' && !matches(component, search));
  classList.toggle('folded', folded);
  const [, , title, sub, bar, held] = element.children;
  const runs = cost && window ? (cost[0] / window) * 1e6 : null;
  const state = now?.[2] === null || now?.[2] === undefined ? null : component.states[now[2]]?.name;
  const [first, second] = compact ? split(component.name, state) : [component.name, state ?? rateText(component, now, runs, active)];
  write(title, first);
  write(sub, second);
  classList.toggle('compact', compact);
  classList.toggle('two', compact && state === null);
  title.setAttribute('y', second === '' ? '24' : '17');
  const share = component.budget_us && cost?.[0] ? cost[1] / component.budget_us : 0;
  bar.setAttribute('width', String(Math.min(share, 1) * (WIDTH - 10)));
  bar.setAttribute('class', `cost ${share > OVER ? 'over' : share > NEAR ? 'nearly' : ''}`);
  write(held, now?.[1] === 'active' ? '▲' : now?.[1] === 'latent' ? '▼' : folded ? '…' : '');
  const text = [active ? 'active' : 'latent', state && `state ${state}`, now && now[1] !== 'tree' && `held ${now[1]}`, runs !== null && active && `${runs.toFixed(0)} Hz`,
    cost?.[0] && `${duration(cost[1])}${component.budget_us ? ` of ${number(component.budget_us)} µs` : ''}`].filter(Boolean).join(', ');
  if (element.getAttribute('aria-description') !== text) element.setAttribute('aria-description', text);
}

/** Two lines of a small box: the name and the state, or the two halves of the name. */
function split(name, state) {
  if (state !== null) return [name, state.replaceAll('_', ' ')];
  const parts = name.split(/(?=[A-Z])/);
  const half = Math.ceil(parts.length / 2);
  return [parts.slice(0, half).join(''), parts.slice(half).join('')];
}

function rateText(component, now, runs, active) {
  const wanted = now?.[3] ?? component.hz;
  if (!active) return wanted ? `${number(wanted)} Hz` : '';
  const reached = runs !== null && runs > 0 ? runs.toFixed(0) : null;
  if (!wanted) return reached ? `${reached} Hz` : 'each cycle';
  return reached ? `${reached} of ${number(wanted)} Hz` : `${number(wanted)} Hz`;
}

function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
