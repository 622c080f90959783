// The end of the field: scan columns, the first green in each, and the line that the robot found.

import { html, useEffect, useMemo, useSignal } from '../lib/dom.js';
import { Canvas, line } from '../lib/canvas.js';
import { text, words } from '../lib/format.js';
import { FITTED, Picture, placed, useEachImage, usePicture } from '../lib/image.js';
import { ask, cursor, session, watch } from '../lib/store.js';
import { css } from '../lib/theme.js';
import { Bar, Empty, Toggle } from '../lib/ui.js';

function Boundary({ visible }) {
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
  const found = useSignal(null);
  useEachImage(component < 0 ? null : shown, visible, image, async ({ number }) => {
    const answer = await ask('extension', { session: shown.id, name: 'boundary', message: { image: number } });
    if (answer) found.value = { ...answer, number };
  }, 200);
  const handlers = usePicture(image, zoom, pointer);

  if (!shown || component < 0) return html`<${Empty} what="No end of field" help=${shown ? 'This tree has no component FieldBoundary.' : 'Open a session first.'} />`;
  if (!shown.info.value.can.images) return html`<${Empty} what="No images" help="This session sends no images." />`;
  const read = (name, time) => {
    const index = infos.findIndex((info) => info.name === name);
    if (index < 0) return null;
    const output = shown.output(component, index);
    return (cursor.value === null ? output.at(time) : output.now.value?.value) ?? null;
  };
  const draw = (context, width, height) => {
    const one = image();
    if (!one) return;
    const at = placed(one, width, height, zoom.value);
    context.drawImage(picture.of(one), at.left, at.top, one.width * at.scale, one.height * at.scale);
    const corners = read('corners', one.time_us)?.points ?? [];
    if (columns.value && found.value?.number === one.number) drawColumns(context, at, found.value.columns, one.height);
    context.strokeStyle = css('--cursor');
    context.lineWidth = 2.5;
    context.beginPath();
    for (const { x, y } of corners) context.lineTo(at.x(x), at.y(y));
    context.stroke();
  };
  return html`<${Bar} label="End of field"><${Toggle} on=${columns.value} label="Scan columns" title="The program scans the image with the colours under edit and the thresholds of the robot" onChange=${(on) => { columns.value = on; }} />
      <span class="dim">● first green of a column · <span class="warn">× rejected</span> · — found by the robot</span><span class="grow"></span>
      <${Toggle} on=${held.value?.session === shown.id} label="Freeze" onChange=${(on) => { held.value = on ? shown.image.value : null; }} /><//>
    <div class="fill picture"><${Canvas} reads=${() => { void [shown.image.value, held.value, found.value, columns.value, zoom.value, cursor.value]; }} draw=${draw} visible=${visible} label="End of the field in the image" ...${handlers} /></div>
    <dl class="facts-row">${infos.map((info, index) => html`<div title=${info.doc}><dt>${words(info.name)}</dt><dd>${visible.value ? text(shown.output(component, index).now.value?.value) : ''} ${info.unit ?? ''}</dd></div>`)}</dl>`;
}

function drawColumns(context, at, columns, height) {
  context.lineWidth = 1;
  for (const { x, y, verdict } of columns) {
    context.strokeStyle = css('--scan');
    line(context, at.x(x), at.y(0), at.x(x), at.y(y ?? height));
    if (y === null) continue;
    context.fillStyle = css(verdict === 'inlier' ? '--perceive' : '--warn');
    context.beginPath();
    if (verdict === 'inlier') context.arc(at.x(x), at.y(y), 3, 0, 2 * Math.PI);
    else context.fillText('×', at.x(x) - 4, at.y(y) + 4);
    context.fill();
  }
}

export default { panels: { boundary: { title: 'End of field', view: Boundary, offered: (shown) => shown.find('FieldBoundary') >= 0 && shown.info.value.can.images } } };
