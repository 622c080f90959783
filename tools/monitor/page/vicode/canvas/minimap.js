// The whole machine in small, with the part that is seen.

import { html, useEffect, useRef, useSignal } from '../../lib/dom.js';
import { bounds } from './boxes.js';
import { stage } from './stage.js';

const { view } = stage;

export function Minimap({ chosen }) {
  const svg = useRef(null);
  const seen = useSignal(null);
  useEffect(() => {
    const measure = () => {
      if (!view.svg) return;
      seen.value = { x: -view.x / view.k, y: -view.y / view.k, width: view.width / view.k, height: view.height / view.k };
    };
    view.listeners.add(measure);
    measure();
    return () => view.listeners.delete(measure);
  }, []);
  const boxes = stage.all();
  const area = bounds(boxes);
  const inView = seen.value && seen.value.x <= area.x + 40 && seen.value.y <= area.y + 40 && seen.value.x + seen.value.width >= area.x + area.width - 40 && seen.value.y + seen.value.height >= area.y + area.height - 40;
  if (boxes.length < 2 || inView) return null;
  const show = (event) => {
    if (event.buttons === 0) return;
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.current.getScreenCTM().inverse());
    view.centre(point.x, point.y);
  };
  return html`<svg class="minimap" ref=${svg} viewBox=${`${area.x} ${area.y} ${area.width} ${area.height}`} role="img" aria-label="Overview of the machine" onPointerDown=${show} onPointerMove=${show}>
    ${boxes.map(({ name, x, y, width, height }) => html`<rect class=${`mini ${chosen.has(`s:${name}`) ? 'chosen' : ''}`} x=${x - width / 2} y=${y - height / 2} width=${width} height=${height} rx="12" />`)}
    ${seen.value && html`<rect class="seen" ...${seen.value} />`}</svg>`;
}
