// The colour tuner: pixels of an image are assigned to classes, or taken away; the segmented image is beside it.

import { html, signal, useEffect, useMemo, useRef, useSignal } from '../lib/dom.js';
import { Canvas } from '../lib/canvas.js';
import { request } from '../lib/connection.js';
import { FITTED, Picture, pixel, placed, useEachImage, usePicture } from '../lib/image.js';
import { act, ask, command, classified, session, watch } from '../lib/store.js';
import { below, right, within } from '../lib/places.js';
import { css } from '../lib/theme.js';
import { Bar, Empty, Toggle } from '../lib/ui.js';

/** The fields of a message to the tuner in the program. */
const tuner = (type, fields = {}) => ({ name: 'tuner', message: { type, ...fields } });

/** Pixels that are sent at once. */
const MAX_PIXELS = 2000;
/** Colours of classes without one. */
const CLASS_COLOURS = { orange: [255, 130, 30], yellow: [245, 220, 40], blue: [60, 140, 255], green: [50, 170, 80], white: [240, 240, 240] };

/** Kept while the panel is closed: the image that is held, and the classes. */
const edited = signal(null);
const colours = signal(null);
/** Why the classes are not known: {text, help}. */
const unknown = signal(null);

function rgbOf(one, index) {
  if (Array.isArray(one?.colour)) return one.colour;
  if (typeof one?.colour === 'string' && /^#[0-9a-f]{6}$/i.test(one.colour)) return [1, 3, 5].map((at) => Number.parseInt(one.colour.slice(at, at + 2), 16));
  const name = Object.keys(CLASS_COLOURS).find((known) => one?.name.toLowerCase().includes(known));
  return CLASS_COLOURS[name] ?? [[255, 80, 160], [120, 220, 220], [180, 120, 255]][index % 3];
}

const classColour = (index) => `rgb(${rgbOf(colours.value?.classes[index], index).join(' ')})`;

function Tuner({ visible }) {
  const shown = session.value;
  const chosen = useSignal(0);
  const remove = useSignal(false);
  const brush = useSignal('pixel');
  const live = useSignal(true);
  const score = useSignal(null);
  const saveName = useSignal('tuned');
  const zoom = useSignal(FITTED);
  const pointer = useSignal(null);
  const region = useSignal(null);
  const [picture, segments, plane] = useMemo(() => [new Picture(), new Segments(), new Plane()], []);
  useEffect(() => (visible.value && shown ? watch({ images: true }) : undefined), [visible.value, shown]);
  // The limits that are in force change with the robot's parameters.
  const params = shown?.params.value[shown.find('Colours')];
  useEffect(() => {
    if (visible.value && shown?.description.value) readColours();
  }, [visible.value, shown, shown?.description.value, params]);
  const isHeld = () => edited.value !== null && edited.value.session === shown?.id;
  const image = () => (isHeld() ? edited.value : shown?.image.value ?? null);
  // Again after each change of the limits.
  const classify = ({ number }) => ask('extension', { session: shown.id, ...tuner('classify', { image: number }) });
  useEachImage(shown, visible, () => (colours.peek() ? image() : null), classify, live.value ? 150 : 300, params);
  const pick = async (pixels) => {
    const one = image();
    if (!one || pixels.length === 0) return;
    const step = Math.ceil(pixels.length / MAX_PIXELS);
    const next = await command('extension', tuner('pick', { class: chosen.value, remove: remove.value, image: one.number, pixels: pixels.filter((_, index) => index % step === 0) }));
    if (next) await changed(shown, one, next, score);
  };
  // The image is held, so that the pressed pixel is the one that is picked.
  const hold = () => {
    edited.value = image();
    live.value = false;
  };
  const pickHandlers = usePicking({ image, zoom, pointer, region, brush, remove, pick, hold });
  const segmentsHandlers = usePicture(image, zoom, pointer);

  if (!shown || !shown.info.value.can.images) return html`<${Empty} what="No images to tune on" help="Open a world, a recording with images, or a robot that sends its camera." />`;
  if (!colours.value) return html`<${Empty} what=${unknown.value?.text ?? 'No colour classes yet'} help=${unknown.value?.help ?? 'They come from the component Colours of the tree.'} />`;
  const { classes } = colours.value;
  const replace = async (type, fields) => {
    const next = await command('extension', tuner(type, fields));
    if (next) await changed(shown, image(), next, score);
  };
  const reads = () => { void [shown.image.value, edited.value, classified.value, zoom.value, pointer.value, region.value, chosen.value, colours.value]; };
  const drawPicture = (context, width, height) => {
    const one = image();
    if (!one) return;
    const at = placed(one, width, height, zoom.value);
    context.imageSmoothingEnabled = at.scale < 3;
    context.drawImage(picture.of(one), at.left, at.top, one.width * at.scale, one.height * at.scale);
    drawBrush(context, at, pointer.value, region.value, classColour(chosen.value), remove.value);
  };
  const drawSegments = (context, width, height) => {
    const one = image();
    const found = classified.value;
    if (!one || found?.session !== shown.id) return;
    const at = placed(found, width, height, zoom.value);
    context.imageSmoothingEnabled = false;
    context.drawImage(segments.of(found, colours.value), at.left, at.top, found.width * at.scale, found.height * at.scale);
  };
  const drawPlane = (context, width, height) => {
    const one = image();
    if (one) plane.draw(context, width, height, one, classified.value?.number === one.number ? classified.value : null, chosen.value);
  };
  const save = () => ask('extension', { session: shown.id, ...tuner('save', { name: saveName.value }) }, `the profile ${saveName.value}.toml is saved`);
  const measure = async () => { score.value = (await act('extension', tuner('score'))) ?? null; };
  return html`<${Bar} label="Colour tuner">
      <div class="classes" role="radiogroup" aria-label="Class">${classes.map((one, index) => html`<button role="radio" aria-checked=${chosen.value === index} class=${chosen.value === index ? 'on' : ''} onClick=${() => { chosen.value = index; }}>
        <i class="dot edged" ref=${(dot) => { if (dot) dot.style.background = classColour(index); }}></i>${one.name}</button>`)}</div>
      <${Toggle} on=${remove.value} label="Take away" title="Picked pixels are not of the class (or hold Alt)" onChange=${(on) => { remove.value = on; }} />
      <select aria-label="How to pick" onChange=${(event) => { brush.value = event.target.value; }}>${['pixel', 'region', 'paint'].map((name) => html`<option selected=${brush.value === name}>${name}</option>`)}</select>
      <button onClick=${() => replace('undo')}>Undo</button>
      <button title="Begin again with the limits that the robot has now" onClick=${() => replace('load', { name: 'robot' })}>From robot</button>
      <${Toggle} on=${live.value} label="Live" title="Follow the camera; picking holds the image" onChange=${(on) => { live.value = on; if (on) edited.value = null; else edited.value = shown.image.value; }} />
      <span class="grow"></span>
      <button onClick=${measure} title="On labelled images, if the program was started with --images">Score</button>
      <button class="primary" onClick=${() => command('extension', tuner('send'), 'the colours are on the robot')}>Send to robot</button>
      <form class="join" onSubmit=${(event) => { event.preventDefault(); save(); }}><input class="short" aria-label="Name of the profile" value=${saveName.value} onInput=${(event) => { saveName.value = event.target.value; }} /><button>Save profile</button></form>
    <//>
    <div class="tuner fill">
      <figure><figcaption>image ${image()?.number ?? ''} ${isHeld() ? '(held)' : ''}</figcaption><div class="picture pick"><${Canvas} reads=${reads} draw=${drawPicture} visible=${visible} label="Image to pick colours from" ...${pickHandlers} /></div></figure>
      <figure><figcaption>classes</figcaption><div class="picture"><${Canvas} reads=${reads} draw=${drawSegments} visible=${visible} label="Classes of the pixels" ...${segmentsHandlers} /></div></figure>
      <figure><figcaption>Cb to the right, Cr up: all pixels grey, ${classes[chosen.value]?.name} coloured</figcaption><div class="picture"><${Canvas} reads=${reads} draw=${drawPlane} visible=${visible} label="Histogram of Cb and Cr" /></div></figure>
      <figure class="score"><figcaption>limits${score.value ? ' and score' : ''}</figcaption><div>
        ${score.value && html`<table><thead><tr><th>object</th><th class="n">recall</th><th class="n">precision</th></tr></thead><tbody>${score.value.rows.map((row) => html`<tr><td>${row.object}</td><td class="n">${percent(row.recall)}</td><td class="n">${percent(row.precision)}</td></tr>`)}</tbody></table>`}
        <${Limits} one=${classes[chosen.value]} /></div></figure>
    </div>`;
}

const percent = (share) => (share === null || share === undefined ? '–' : `${(share * 100).toFixed(1)} %`);

function Limits({ one }) {
  if (!one?.limits) return null;
  return html`<dl class="limits">${Object.entries(one.limits).map(([name, value]) => html`<div><dt>${name.replaceAll('_', ' ')}</dt><dd>${Array.isArray(value) ? value.join(' to ') : String(value)}</dd></div>`)}</dl>`;
}

async function readColours() {
  const shown = session.peek();
  if (!shown?.info.peek().can.images) return;
  try {
    colours.value = await request('extension', { session: shown.id, ...tuner('read') });
    unknown.value = null;
  } catch (error) {
    colours.value = null;
    unknown.value = error;
  }
}

async function changed(shown, image, next, score) {
  colours.value = next;
  if (image) await ask('extension', { session: shown.id, ...tuner('classify', { image: image.number }) });
  if (score.value) score.value = (await ask('extension', { session: shown.id, ...tuner('score') })) ?? score.value;
}

/** Click: a pixel. Region: a rectangle. Paint: what the pointer passes. Alt takes away. */
function usePicking({ image, zoom, pointer, region, brush, remove, pick, hold }) {
  const base = usePicture(image, zoom, pointer);
  /** The pixel at which the pointer was pressed, and what it has passed since then: {start, painted}, or null. */
  const press = useRef(null);
  const at = (event) => {
    const one = image();
    if (!one) return null;
    const place = placed(one, event.currentTarget.clientWidth, event.currentTarget.clientHeight, zoom.value);
    const [x, y] = place.pixel(event.offsetX, event.offsetY);
    return x >= 0 && y >= 0 && x < one.width && y < one.height ? [x, y] : null;
  };
  const withAlt = async (event, pixels) => {
    const before = remove.value;
    if (event.altKey) remove.value = !before;
    await pick(pixels);
    remove.value = before;
  };
  return {
    ...base,
    onPointerDown(event) {
      if (event.button !== 0) return;
      const start = at(event);
      if (start) hold();
      press.current = start && { start, painted: new Map() };
      event.currentTarget.setPointerCapture(event.pointerId);
    },
    onPointerMove(event) {
      pointer.value = { x: event.offsetX, y: event.offsetY };
      const [now, pressed] = [at(event), press.current];
      if (!pressed || !now) return;
      if (brush.value === 'region') region.value = [...pressed.start, ...now];
      if (brush.value === 'paint') pressed.painted.set(now.join(), now);
    },
    onPointerUp(event) {
      const [now, pressed] = [at(event), press.current];
      if (pressed && now) withAlt(event, brush.value === 'region' ? inside(region.value ?? [...pressed.start, ...now]) : brush.value === 'paint' ? [...pressed.painted.set(now.join(), now).values()] : [now]);
      press.current = null;
      region.value = null;
    },
  };
}

function inside([x1, y1, x2, y2]) {
  const pixels = [];
  for (let y = Math.min(y1, y2); y <= Math.max(y1, y2); y += 1) for (let x = Math.min(x1, x2); x <= Math.max(x1, x2); x += 1) pixels.push([x, y]);
  return pixels;
}

function drawBrush(context, at, pointer, region, colour, removes) {
  context.strokeStyle = removes ? css('--error') : colour;
  context.lineWidth = 2;
  if (region) {
    const [x1, y1, x2, y2] = region;
    context.strokeRect(at.x(Math.min(x1, x2)), at.y(Math.min(y1, y2)), (Math.abs(x2 - x1) + 1) * at.scale, (Math.abs(y2 - y1) + 1) * at.scale);
  } else if (pointer) {
    const [x, y] = at.pixel(pointer.x, pointer.y);
    context.strokeRect(at.x(x) - 1, at.y(y) - 1, at.scale + 2, at.scale + 2);
  }
}

/** The classes of an image as a picture. */
class Segments {
  constructor() { this.canvas = document.createElement('canvas'); }

  of(found, table) {
    if (this.shown === found && this.table === table) return this.canvas;
    [this.shown, this.table] = [found, table];
    [this.canvas.width, this.canvas.height] = [found.width, found.height];
    const context = this.canvas.getContext('2d');
    const data = context.createImageData(found.width, found.height);
    const palette = new Uint32Array(256).fill(0xff1d1a17);
    table.classes.forEach((one, index) => {
      const [red, green, blue] = rgbOf(one, index);
      palette[index] = (0xff000000 | (blue << 16) | (green << 8) | red) >>> 0;
    });
    const words = new Uint32Array(data.data.buffer);
    for (let index = 0; index < words.length; index += 1) words[index] = palette[found.pixels[index]];
    context.putImageData(data, 0, 0);
    return this.canvas;
  }
}

/** Histogram of Cb and Cr, and the part of a class. */
class Plane {
  constructor() {
    this.canvas = document.createElement('canvas');
    this.canvas.width = this.canvas.height = 256;
  }

  draw(context, width, height, image, found, chosen) {
    if (this.image !== image || this.found !== found || this.chosen !== chosen) {
      Object.assign(this, { image, found, chosen });
      this.count(image, found, chosen);
    }
    const size = Math.min(width, height) - 8;
    context.imageSmoothingEnabled = true;
    context.drawImage(this.canvas, (width - size) / 2, (height - size) / 2, size, size);
    context.strokeStyle = css('--line');
    context.strokeRect((width - size) / 2, (height - size) / 2, size, size);
  }

  count(image, found, chosen) {
    const [all, own] = [new Uint32Array(65536), new Uint32Array(65536)];
    for (let y = 0; y < image.height; y += 2) {
      for (let x = 0; x < image.width; x += 2) {
        const [, cb, cr] = pixel(image, x, y);
        const at = (255 - cr) * 256 + cb;
        all[at] += 1;
        if (found?.pixels[y * image.width + x] === chosen) own[at] += 1;
      }
    }
    const context = this.canvas.getContext('2d');
    const data = context.createImageData(256, 256);
    const [red, green, blue] = rgbOf(colours.value?.classes[chosen], chosen);
    for (let at = 0; at < 65536; at += 1) {
      if (all[at] === 0) continue;
      const strength = Math.min(255, 70 + 40 * Math.log2(1 + all[at]));
      const mine = own[at] > 0;
      data.data.set(mine ? [red, green, blue, 255] : [140, 146, 156, strength], at * 4);
    }
    context.putImageData(data, 0, 0);
  }
}

const style = new CSSStyleSheet();
style.replaceSync(`
  .tuner { display: grid; grid-template: 1fr 1fr / 1fr 1fr; gap: 1px; background: var(--line); }
  @container (max-width: 560px) { .tuner { grid-template: repeat(4, 1fr) / 1fr; } }
  .tuner figure { background: var(--panel); display: flex; flex-direction: column; min-width: 0; min-height: 0; }
  .tuner figcaption { font-size: 11.5px; color: var(--dim); padding: 3px 8px; }
  .tuner figure > div { flex: 1; position: relative; min-height: 0; }
  .tuner .score > div { overflow: auto; padding: 2px 10px; }
  .tuner table { width: 100%; border-collapse: collapse; margin-bottom: 8px; }
  .tuner th { text-align: left; color: var(--dim); font-weight: 500; }
  .tuner th.n { text-align: right; }
  .classes { display: inline-flex; gap: 3px; flex-wrap: wrap; }
  .classes button { display: inline-flex; align-items: center; }
`);
document.adoptedStyleSheets.push(style);

export default {
  panels: { tuner: { title: 'Colours', view: Tuner, offered: (shown) => shown.find('Colours') >= 0 && shown.info.value.can.images } },
  presets: {
    colours: {
      title: 'Tuning colours',
      needs: 'tuner',
      panels: (width, height) => [
        ['tuner', {}],
        ['camera', right('tuner', width * 0.36)],
        ['boundary', within('camera')],
        ['component:Colours', below('camera', height * 0.45)],
        ['component:BallDetector', within('component:Colours')],
      ],
    },
  },
};
