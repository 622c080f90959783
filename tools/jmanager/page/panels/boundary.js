// The end of the field: scan columns, the first green in each, and the line that the robot found.

import { html, useEffect, useMemo, useSignal } from '../lib/dom.js';
import { Canvas } from '../lib/canvas.js';
import { request } from '../lib/connection.js';
import { text, words } from '../lib/format.js';
import { FITTED, Picture, placed, usePicture } from '../lib/image.js';
import { ask, classified, cursor, session, watch } from '../lib/store.js';
import { css } from '../lib/theme.js';
import { Bar, Empty, Toggle } from '../lib/ui.js';

/** Distance of two scan columns, px, and the green pixels in a row that begin the field. */
const COLUMNS = 8;
const RUN = 4;
/** A point farther than this share of the image's height above or below the found line is thrown out. */
const FAR = 0.04;

export function Boundary({ visible }) {
  const shown = session.value;
  const description = shown?.description.value;
  const component = shown?.find('FieldBoundary') ?? -1;
  const columns = useSignal(true);
  const zoom = useSignal(FITTED);
  const pointer = useSignal(null);
  const held = useSignal(null);
  const picture = useMemo(() => new Picture(), []);
  const infos = description?.components[component]?.info ?? [];
  useEffect(() => {
    if (!visible.value || component < 0) return undefined;
    return watch({ images: true, info: infos.map((_, index) => [component, index, 1]) });
  }, [visible.value, component, description]);
  const image = () => (held.value?.session === shown?.id ? held.value : shown?.image.value ?? null);
  const green = useGreen(shown, visible, image, component);
  const handlers = usePicture(image, zoom, pointer);

  if (!shown || component < 0) return html`<${Empty} what="No end of field" help=${shown ? 'This tree has no component FieldBoundary.' : 'Open a session first.'} />`;
  if (!shown.info.value.can.images) return html`<${Empty} what="No images" help="This session sends no images." />`;
  const read = (name, time) => {
    const index = infos.findIndex((info) => info.name === name);
    if (index < 0) return null;
    const information = shown.info_of(component, index);
    return (cursor.value === null ? information.at(time) : information.now.value?.value) ?? null;
  };
  const draw = (context, width, height) => {
    const one = image();
    if (!one) return;
    const at = placed(one, width, height, zoom.value);
    context.drawImage(picture.of(one), at.left, at.top, one.width * at.scale, one.height * at.scale);
    const corners = read('corners', one.time_us)?.points ?? [];
    if (columns.value && green.value !== null && classified.value?.session === shown.id && classified.value.number === one.number) drawColumns(context, at, classified.value, green.value, corners);
    context.strokeStyle = css('--cursor');
    context.lineWidth = 2.5;
    context.beginPath();
    for (const { x, y } of corners) context.lineTo(at.x(x), at.y(y));
    context.stroke();
  };
  return html`<${Bar} label="End of field"><${Toggle} on=${columns.value} label="Scan columns" title="The page computes them from the classes of the pixels" onChange=${(on) => { columns.value = on; }} />
      <span class="dim">● first green of a column · <span class="warn">× far from the line</span> · — found by the robot</span><span class="grow"></span>
      <${Toggle} on=${held.value?.session === shown.id} label="Freeze" onChange=${(on) => { held.value = on ? shown.image.value : null; }} /><//>
    <div class="fill picture"><${Canvas} reads=${() => { void [shown.image.value, held.value, classified.value, columns.value, zoom.value, cursor.value, green.value]; }} draw=${draw} visible=${visible} label="End of the field in the image" ...${handlers} /></div>
    <dl class="facts-row">${infos.map((info, index) => html`<div title=${info.doc}><dt>${words(info.name)}</dt><dd>${visible.value ? text(shown.info_of(component, index).now.value?.value) : ''} ${info.unit ?? ''}</dd></div>`)}</dl>`;
}

/** Classifies one image at a time; returns the index of the green class. */
function useGreen(shown, visible, image, component) {
  const green = useSignal(null);
  useEffect(() => {
    if (!shown || component < 0) return undefined;
    let [busy, last] = [false, null];
    const timer = setInterval(async () => {
      const one = image();
      if (busy || !visible.peek() || !one || one.number === last) return;
      busy = true;
      last = one.number;
      if (green.peek() === null) {
        const read = await request('colours', { session: shown.id }).catch(() => null);
        const index = read?.classes?.findIndex(({ name }) => name.toLowerCase().includes('green')) ?? -1;
        green.value = index < 0 ? null : index;
      }
      if (green.peek() !== null) await ask('classify', { session: shown.id, image: one.number });
      busy = green.peek() === null;
    }, 200);
    return () => clearInterval(timer);
  }, [shown, component]);
  return green;
}

function drawColumns(context, at, { width, height, pixels }, green, corners) {
  context.lineWidth = 1;
  for (let x = COLUMNS / 2; x < width; x += COLUMNS) {
    let [run, top] = [0, null];
    for (let y = 0; y < height && top === null; y += 1) {
      run = pixels[y * width + x] === green ? run + 1 : 0;
      if (run === RUN) top = y - RUN + 1;
    }
    context.strokeStyle = css('--scan');
    context.beginPath();
    context.moveTo(at.x(x), at.y(0));
    context.lineTo(at.x(x), at.y(top ?? height));
    context.stroke();
    if (top === null) continue;
    const right = corners.findIndex((corner, index) => index > 0 && corner.x >= x);
    const [from, to] = [corners[right - 1], corners[right]];
    const line = from ? from.y + ((to.y - from.y) * (x - from.x)) / (to.x - from.x || 1) : top;
    const far = Math.abs(top - line) > FAR * height;
    context.fillStyle = css(far ? '--warn' : '--perceive');
    context.beginPath();
    if (far) context.fillText('×', at.x(x) - 4, at.y(top) + 4);
    else context.arc(at.x(x), at.y(top), 3, 0, 2 * Math.PI);
    context.fill();
  }
}
