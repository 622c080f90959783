// The camera's image, with what the components found in it.

import { html, useEffect, useMemo, useRef, useSignal } from '../lib/dom.js';
import { Canvas } from '../lib/canvas.js';
import { number, time } from '../lib/format.js';
import { ground, groundInfo } from '../lib/ground.js';
import { FITTED, Picture, pixel, placed, rgb, usePicture } from '../lib/image.js';
import { drawOverlay, drawable } from '../lib/overlays.js';
import { bind } from '../lib/keys.js';
import { classified, cursor, seek, session, watch } from '../lib/store.js';
import { css, theme } from '../lib/theme.js';
import { Bar, Empty, Menu, Toggle, download } from '../lib/ui.js';
import { inImage, useActions } from './actions.js';

export function Camera({ visible }) {
  const shown = session.value;
  const description = shown?.description.value;
  const overlays = useMemo(() => drawable(description), [description, theme.value]);
  const findings = useMemo(() => overlays.flatMap(({ place, infos }) => infos.map(({ index }) => [place, index])), [overlays]);
  const hidden = useSignal(new Set());
  const frozen = useSignal(null);
  const only = useSignal('');
  const zoom = useSignal(FITTED);
  const pointer = useSignal(null);
  const picture = useMemo(() => new Picture(), []);
  const last = useRef(null);
  useEffect(() => {
    if (!visible.value || !shown || !description) return undefined;
    const info = findings.map((one) => [...one, 1]);
    return watch({ images: true, info: [...info, ...groundInfo(shown)] });
  }, [visible.value, shown, description]);
  const freeze = () => { frozen.value = isFrozen() ? null : session.value?.image.value ?? null; };
  const isFrozen = () => frozen.value !== null && frozen.value.session === session.value?.id;
  useEffect(() => bind({ key: 'z', text: 'freeze the image', group: 'Camera', run: freeze }), []);

  const image = () => {
    if (frozen.value?.session === shown?.id) return frozen.value;
    const [newest, isLive] = [shown?.image.value, cursor.value === null];
    const one = newest && isLive ? shown.matchedImage(findings) : newest;
    const isWanted = one && (only.value === '' || only.value === one.camera);
    // Between two live images of the camera that is wanted the last one stays.
    if (isWanted || !isLive || last.current?.session !== shown?.id) last.current = isWanted ? one : null;
    return last.current;
  };
  const handlers = usePicture(image, zoom, pointer);
  const at = ({ currentTarget: { clientWidth, clientHeight }, offsetX, offsetY }) => {
    const one = image();
    if (!one) return null;
    const [column, row] = placed(one, clientWidth, clientHeight, zoom.value).pixel(offsetX, offsetY);
    return ({ axis }) => ({ column, row })[axis];
  };
  const { handlers: opens, menu } = useActions({ shown, list: inImage(shown), at });
  if (!shown || !shown.info.value.can.images) {
    return html`<${Empty} what="No images" help=${shown ? 'This session sends no images. A world, a recording with images, or a robot that sends its camera does.' : 'Open a session first.'} />`;
  }
  const reads = () => {
    // An image is drawn when its findings arrive.
    if (findings.length > 0) void shown.output(...findings[0]).version.value;
    void [shown.image.value, frozen.value, only.value, zoom.value, pointer.value, hidden.value, cursor.value];
  };
  const draw = (context, width, height) => {
    const one = image();
    if (!one) {
      context.fillStyle = css('--dim');
      context.font = `13px ${css('--font')}`;
      context.fillText(cursor.value === null ? 'Waiting for an image' : `No image ${only.value === '' ? '' : `of ${only.value} `}is known of this moment`, 12, 24);
      return;
    }
    const at = placed(one, width, height, zoom.value);
    context.imageSmoothingEnabled = at.scale < 3;
    context.drawImage(picture.of(one), at.left, at.top, one.width * at.scale, one.height * at.scale);
    context.save();
    context.beginPath();
    context.rect(at.left, at.top, one.width * at.scale, one.height * at.scale);
    context.clip();
    const taken = [];
    overlays.forEach((overlay) => {
      const active = shown.moment.value?.components?.[overlay.place]?.[0];
      if (active && !hidden.value.has(overlay.component)) drawOverlay(context, shown, overlay, one, { at, live: cursor.value === null, taken });
    });
    context.restore();
    if (pointer.value) drawPixel(context, shown, one, at, pointer.value, width, height);
  };
  const toggle = (component) => {
    const next = new Set(hidden.value);
    if (!next.delete(component)) next.add(component);
    hidden.value = next;
  };
  const one = image();
  const which = one?.camera || 'image';
  const cameras = shown.cameras.value;
  const toggles = () => overlays.map(({ component, colour }) => html`<${Toggle} on=${!hidden.value.has(component)} label=${component} colour=${colour} title=${`Findings of ${component}`} onChange=${() => toggle(component)} />`);
  return html`<${Bar} label="Camera">
      ${cameras.length > 1 && html`<select aria-label="Which camera" class="brief" onChange=${(event) => { only.value = event.target.value; }}>${['', ...cameras].map((name) => html`<option value=${name} selected=${only.value === name}>${name || 'all'}</option>`)}</select>`}
      <span class="dim place" title=${one && `${one.camera} image ${one.number}, ${one.width}×${one.height} px, at ${time(one.time_us)}`}>${one ? `${which} ${one.number} · ${time(one.time_us)}` : 'no image yet'}</span>
      <span class="grow"></span>
      <span class="overlays many">${toggles()}</span><span class="overlays few"><${Menu} label="Findings" title="Findings of components">${toggles()}<//></span>
      <${Toggle} on=${isFrozen()} label="Freeze" title="Key z" onChange=${freeze} />
      <button aria-label="Previous image" title="Previous image" onClick=${() => stepImage(shown, -1)}>◂</button><button aria-label="Next image" title="Next image" onClick=${() => stepImage(shown, 1)}>▸</button>
      ${zoom.value.scale > 1 && html`<button onClick=${() => { zoom.value = FITTED; }}>Fit</button>`}
      <${Menu} label="Save" title="Save the image">
        <button class="item" disabled=${!one} onClick=${() => savePng(one)}>as PNG</button><button class="item" disabled=${!one} onClick=${() => download(`image-${one.number}.yuyv`, new Blob([one.pixels]))}>as YUYV</button><//>
    <//>
    <div class="fill picture"><${Canvas} reads=${reads} draw=${draw} visible=${visible} label="Camera image" ...${{ ...handlers, ...opens }} />${menu}</div>`;
}

/** Moves the cursor by one image. */
function stepImage(shown, by) {
  const now = shown.image.value;
  if (!now) return;
  // Images come at most every other cycle; the server answers with the last image that is not later.
  seek((cursor.value ?? now.time_us) + by * 33400);
}

function classOf(shown, image, x, y) {
  const classes = classified.value;
  if (classes?.session !== shown.id || classes.number !== image.number) return null;
  return classes.pixels[y * classes.width + x];
}

function drawPixel(context, shown, image, at, { x, y }, width, height) {
  const [column, row] = at.pixel(x, y);
  if (column < 0 || row < 0 || column >= image.width || row >= image.height) return;
  const [luma, cb, cr] = pixel(image, column, row);
  const lines = [`${column}, ${row}   Y ${luma}  Cb ${cb}  Cr ${cr}`];
  const found = classOf(shown, image, column, row);
  if (found !== null) lines.push(found === 255 ? 'no class' : `class ${found}`);
  const ray = ground(shown, column, row);
  if (ray) lines.push(ray.x === null ? 'above the horizon' : `ground about ${number(ray.x)} m ahead, ${number(Math.abs(ray.y))} m ${ray.y >= 0 ? 'left' : 'right'}`);
  context.font = `12px ${css('--font')}`;
  const wide = Math.max(...lines.map((line) => context.measureText(line).width)) + 42;
  const high = lines.length * 17 + 10;
  const left = Math.min(x + 14, width - wide - 4);
  const top = Math.min(y + 14, height - high - 4);
  context.fillStyle = css('--shade');
  context.beginPath();
  context.roundRect(left, top, wide, high, 5);
  context.fill();
  context.fillStyle = `rgb(${rgb(luma, cb, cr).join(' ')})`;
  context.fillRect(left + 8, top + 8, 18, 18);
  context.fillStyle = css('--shade-text');
  context.textBaseline = 'middle';
  lines.forEach((line, index) => context.fillText(line, left + 34, top + 14 + index * 17));
}

function savePng(image) {
  new Picture().of(image).toBlob((blob) => download(`image-${image.number}.png`, blob));
}

