// The chosen keyframe from the side, from behind, and its soles from above with the centre of mass.

import { Canvas, line } from '../lib/canvas.js';
import { html } from '../lib/dom.js';
import { css } from '../lib/theme.js';
import { row, shapes } from './model.js';

/** Two coordinates of a point that a view shows. */
const VIEWS = [
  { name: 'from the right', of: ([x, , z]) => [x, z], ground: true },
  { name: 'from behind', of: ([, y, z]) => [-y, z], ground: true },
  { name: 'from above', of: ([x, y]) => [-y, x] },
];

/** The part of space that all keyframes need in a view: [left, right, low, high], m. */
function extent(view) {
  const points = shapes.value.flatMap(({ shape }) => (view.ground ? [...shape.lines.flat(), ...shape.soles.flat()] : [...shape.soles.flat(), shape.centre])).map(view.of);
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  return [Math.min(...xs) - 0.03, Math.max(...xs) + 0.03, Math.min(...ys) - 0.03, Math.max(...ys) + 0.03];
}

function drawView(context, view, left, width, height) {
  const { shape } = shapes.value[row.value];
  const [low, high, bottom, top] = extent(view);
  const scale = Math.min(width / (high - low), (height - 18) / (top - bottom));
  const to = (point) => {
    const [x, y] = view.of(point);
    return [left + width / 2 + (x - (low + high) / 2) * scale, height - 4 - (y - bottom) * scale];
  };
  const path = (points, closed) => {
    context.beginPath();
    points.forEach((point) => context.lineTo(...to(point)));
    if (closed) context.closePath();
    context.stroke();
  };
  context.fillStyle = css('--dim');
  context.textAlign = 'center';
  context.fillText(view.name, left + width / 2, 12);
  context.strokeStyle = css('--line');
  context.lineWidth = 1;
  if (view.ground) line(context, left + 4, to([0, 0, 0])[1], left + width - 4, to([0, 0, 0])[1]);
  context.strokeStyle = css('--perceive');
  context.lineWidth = 1.6;
  shape.soles.forEach((sole) => path(sole, true));
  if (view.ground) {
    context.lineCap = context.lineJoin = 'round';
    shape.lines.forEach((one, index) => {
      // Trunk, then arm and leg of the left, then of the right side.
      context.strokeStyle = css(index === 0 ? '--text' : index < 3 ? '--control' : '--machine');
      context.lineWidth = index === 0 ? 5 : 3.5;
      path(one, false);
    });
  }
  const [x, y] = to(shape.centre);
  context.fillStyle = context.strokeStyle = css(shape.margin > 0 ? '--ok' : '--error');
  context.lineWidth = 1;
  if (view.ground) {
    context.setLineDash([3, 3]);
    line(context, x, y, x, to([0, 0, 0])[1]);
    context.setLineDash([]);
  }
  context.beginPath();
  context.arc(x, y, 4, 0, 2 * Math.PI);
  context.fill();
}

export function Figure({ visible }) {
  const draw = (context, width, height) => {
    if (!shapes.value[row.value]) return;
    context.font = '11px system-ui, sans-serif';
    VIEWS.forEach((view, index) => drawView(context, view, (index * width) / 3, width / 3, height));
  };
  const now = shapes.value[row.value]?.shape;
  const margin = now && Number.isFinite(now.margin) ? `${Math.abs(now.margin * 1000).toFixed(0)} mm ${now.margin > 0 ? 'within' : 'beyond'} the edge of the soles on the ground` : 'no sole on the ground';
  const loads = (now?.load ?? []).toSorted((a, b) => b[1] - a[1]).slice(0, 3).map(([joint, load]) => `${joint} ${(load * 100).toFixed(0)} %`);
  return html`<figure class="figure"><div class="space"><${Canvas} reads=${() => { void [shapes.value, row.value]; }} draw=${draw} visible=${visible} label="Posture of the keyframe" /></div>
    <figcaption><b class="left">left</b> and <b class="right">right</b> limbs · ● centre of mass: ${now ? margin : ''}${loads.length > 0 && html`<br /><span title="Current that holds the posture at rest, as a share of what the motor bears continuously">load at rest: ${loads.join(', ')}</span>`}</figcaption></figure>`;
}
