// The activation tree: what is active, in which state, at which rate and cost.

import { request } from '../lib/connection.js';
import { effect, html, useEffect, useMemo, useRef, useSignal, useState } from '../lib/dom.js';
import { bind, isPointed } from '../lib/keys.js';
import { openComponent } from '../lib/dock.js';
import { command, hovered, selected, session, watch } from '../lib/store.js';
import { Bar, Empty, Toggle } from '../lib/ui.js';
import { carry } from '../vicode/carry.js';
import { LOW, SEVERAL, TALL, drawBox, widthsOf, writtenBy } from './tree/boxes.js';

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
  const kinds = shown?.kinds.value;
  const search = useSignal('');
  const activeOnly = useSignal(false);
  const folded = useSignal(new Set());
  const box = useSignal(null);
  const size = useSignal([600, 400]);
  const drawing = useDrawing(description, kinds, size.value);
  const field = useRef(null);
  useEffect(() => bind({ key: '/', text: 'search a component', group: 'Tree', run: () => field.current?.focus() }), []);
  useEffect(() => (visible.value ? watch({ costs: true }) : undefined), [visible.value]);

  if (!shown) return html`<${Empty} what="No session is open" help="Press + in the bar above to open a world, a robot or a recording." />`;
  if (!description) {
    const info = shown.info.value;
    return html`<${Empty} what=${info.connection === 'connecting' ? `Connecting to ${info.name}` : `Nothing is known of ${info.name} yet`} help=${info.note || 'The tree is drawn as soon as the robot has described it.'} />`;
  }
  if (!kinds?.length) return html`<${Empty} what="This tree is too large to draw" help="Use the search of the timeline, and the component tabs." />`;
  const found = description.components.filter((component) => matches(component, search.value)).length;
  const fit = () => { if (drawing) box.value = [0, 0, drawing.width, drawing.height]; };
  const zoom = (factor) => { if (drawing) box.value = zoomed(box.value ?? first(drawing, size.value), factor, 0.5, 0.5); };
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
    <${Holds} shown=${shown} />
    ${drawing && html`<${Drawn} ...${{ shown, description, kinds, drawing, search, activeOnly, folded, box, size, visible }} />`}`;
}

/** The drawing of a tree in a panel of a size; until the server has laid it out, as it was before. */
function useDrawing(description, kinds, size) {
  const [last, set] = useState({});
  useEffect(() => {
    let isWanted = Boolean(kinds?.length);
    if (isWanted) laidOut(description, size).then((drawing) => isWanted && set({ description, drawing }), () => {});
    return () => { isWanted = false; };
  }, [description, kinds, size]);
  return last.description === description ? last.drawing : null;
}

/** The ages and outcomes for which components ask: [{from, of, kind}]. */
const queriesOf = ({ components }) => components.flatMap(({ queries = [] }, from) => queries.map((one) => ({ from, ...one })));

/** The layout by the server: {boxes, width, height, lines: path of each link and then of each query, trunks: number of the trunk of each link}. Components with the same children share one trunk. */
async function laidOut(description, size) {
  const { components } = description;
  const children = components.map(({ links }) => [...new Set(links.map(({ to }) => to))].sort((a, b) => a - b).join());
  const names = [...new Set(children)];
  const links = components.flatMap((component, from) => component.links.map(({ to }) => [from, to, names.indexOf(children[from])]));
  const drawing = await request('arrange', { drawing: { kind: 'tree', widths: widthsOf(components), links, queries: queriesOf(description).map(({ from, of }) => [from, of]), size, heights: [LOW, TALL] } });
  return { ...drawing, trunks: links.map(([, , trunk]) => trunk) };
}

/** What is held, and the button that ends it. */
function Holds({ shown }) {
  const { components } = shown.description.value;
  const held = (shown.moment.value?.components ?? []).flatMap(([, hold], index) => (hold === 'tree' ? [] : [{ index, hold, name: components[index].name }]));
  if (held.length === 0) return null;
  const release = async () => {
    for (const { index } of held) if ((await command('hold', { component: index, hold: 'tree' })) === undefined) return;
  };
  return html`<div class="holds" role="status"><b>${held.length} hold${held.length > 1 ? 's' : ''}</b> <span class="names">${held.map(({ name, hold }) => `${name} ${hold}`).join(' · ')}</span>
    <span class="dim until">end 3 s after this page is gone</span><span class="grow"></span><button disabled=${!shown.info.value.can.operate} onClick=${release}>Release all</button></div>`;
}

/** Least scale at which the names of a tree can be read. */
const READABLE = 0.96;

const matches = (component, text) => component.name.toLowerCase().includes(text.toLowerCase().trim());
/** The text of a search, or an empty one if no component matches. */
const foundAny = ({ components }, text) => (components.some((component) => matches(component, text)) ? text : '');
/** What is shown first: all, or the upper part if nothing could be read otherwise. */
const first = ({ width, height }, [wide, tall]) => (Math.min(wide / width, tall / height) < READABLE ? [(width - wide) / 2, 0, wide, tall] : [0, 0, width, height]);

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

function Drawn({ shown, description, kinds, drawing, search, activeOnly, folded, box, size, visible }) {
  const svg = useRef(null);
  const links = useMemo(() => description.components.flatMap((component, from) => component.links.map((one) => ({ from, ...one }))), [description]);
  const queries = useMemo(() => queriesOf(description), [description]);
  const [x, y, width, height] = box.value ?? first(drawing, size.value);

  useEffect(() => {
    const observer = new ResizeObserver(([{ contentRect }]) => {
      const now = [contentRect.width, contentRect.height].map(Math.floor);
      if (now[0] > 0 && now.join() !== size.peek().join()) [size.value, box.value] = [now, null];
    });
    observer.observe(svg.current);
    return () => observer.disconnect();
  }, []);

  // State and costs change often: they are written to the elements, without a new rendering.
  useEffect(() => {
    const boxes = [...svg.current.querySelectorAll('.component')];
    const paths = links.map((_, index) => svg.current.querySelector(`[data-link="${index}"]`));
    const dotted = [...svg.current.querySelectorAll('.query')];
    return effect(() => {
      if (!visible.value) return;
      const components = shown.moment.value?.components;
      const costs = shown.costs.value;
      const hidden = hiddenBy(description, folded.value);
      const text = foundAny(description, search.value);
      boxes.forEach((element, index) => {
        const [component, now] = [description.components[index], components?.[index]];
        const isFound = text !== '' && matches(component, text);
        drawBox(element, drawing.boxes[index], {
          component, now, cost: costs?.components[index], window: costs?.window_us, folded: folded.value.has(index), found: isFound,
          other: text !== '' && !isFound, gone: hidden.has(index) || (activeOnly.value && !now?.[0]),
        });
      });
      dotted.forEach((element, index) => {
        const { from, of } = queries[index];
        const near = hovered.value === from || hovered.value === of;
        element.classList.toggle('near', near);
        element.classList.toggle('gone', hidden.has(from) || hidden.has(of) || folded.value.has(from) || (!components?.[from]?.[0] && !near));
      });
      paths.forEach((element, index) => {
        const { from, to } = links[index];
        const active = isActive(components, links[index]);
        element.classList.toggle('active', active);
        const near = hovered.value === from || hovered.value === to;
        element.classList.toggle('near', near);
        element.classList.toggle('gone', hidden.has(from) || hidden.has(to) || folded.value.has(from) || (!active && !near));
      });
    });
  }, [shown, description, drawing]);

  const wheel = (event) => {
    event.preventDefault();
    const bounds = svg.current.getBoundingClientRect();
    box.value = zoomed(box.value ?? first(drawing, size.value), event.deltaY > 0 ? 1.15 : 1 / 1.15, (event.clientX - bounds.x) / bounds.width, (event.clientY - bounds.y) / bounds.height);
  };
  const drag = (event) => {
    if (event.target.closest('.component') || event.button !== 0) return;
    const start = [event.clientX, event.clientY];
    const from = box.value ?? first(drawing, size.value);
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
  // The focus may go to a component that is outside.
  const reveal = (event) => {
    const { x: middle, y: centre } = drawing.boxes[description.components.findIndex(({ name }) => name === event.target.ariaLabel)] ?? { x, y };
    if (middle < x || middle > x + width || centre < y || centre > y + height) box.value = [middle - width / 2, centre - height / 2, width, height];
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
  return html`<svg class="tree fill" ref=${svg} viewBox=${`${x} ${y} ${width} ${height}`} role="group" aria-label="Activation tree" onFocusIn=${reveal} onWheel=${wheel} onPointerDown=${drag}>
    ${trunksOf(drawing).map((all) => html`<g class=${`wires ${kinds[links[all[0]].from]}`}>${all.map((index) => html`<path class="link" data-link=${index} d=${drawing.lines[index]} />`)}</g>`)}
    ${queries.map(({ from, kind }, index) => html`<path class=${`query ${kinds[from]}`} d=${drawing.lines[links.length + index]}><title>${kind}</title></path>`)}
    ${description.components.map((component, index) => {
      const { x: centre, y: middle, width: wide, height: tall } = drawing.boxes[index];
      const two = tall >= TALL;
      return html`<g key=${component.name} class=${`component ${kinds[index]}`} transform=${`translate(${centre - wide / 2} ${middle - tall / 2})`} role="button" tabindex=${index === stop ? 0 : -1} aria-label=${component.name}
        aria-pressed=${selected.value === component.name} onClick=${(event) => openComponent(component.name, event.shiftKey)} onPointerDown=${(event) => carry(event, component.name)} onDblClick=${() => fold(index)} onKeyDown=${(event) => key(event, component, index)}
        onPointerEnter=${() => { hovered.value = index; }} onPointerLeave=${() => { hovered.value = null; }}>
        <title>${[component.doc || component.name, writtenBy(description, component)].filter(Boolean).join('\n')}${'\n'}Click: show. Shift-click: own tab. Double click or f: fold. Drag onto a state: make it a child.</title>
        <rect class="frame" width=${wide} height=${tall} rx="5" /><text class="title" x=${wide / 2} y=${two ? 18 : 16.5}>${component.name}${component.writers ? SEVERAL : ''}<tspan class="now"></tspan></text><text class="sub" x=${wide / 2} y="33"></text>
        <rect class="cost" x="6" y=${tall - 4.5} height="2" width="0" rx="1" /><g class="badge" transform=${`translate(${wide - 34} -9)`}><rect width="42" height="16" rx="8" /><text x="21" y="12"></text></g></g>`;
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

/** The numbers of the links of each trunk. */
const trunksOf = ({ trunks }) => [...Map.groupBy(trunks.keys(), (index) => trunks[index]).values()];
