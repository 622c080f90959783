// A film of a panel: its canvases, frame by frame, while the span is played.

import { effect, signal } from './dom.js';
import { time } from './format.js';
import { looping, playSpan } from './playback.js';
import { shownTime } from './axis.js';
import { notify, playing, seek } from './store.js';
import { span } from './span.js';
import { css } from './theme.js';
import { download } from './ui.js';

/** Frames a second, and bits a second. */
const [RATE, BITS] = [30, 8e6];
/** Time in which the first moment is drawn before the film begins, and the last one after playback has ended, ms. */
const SETTLED_MS = 400;
const TYPES = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm', 'video/mp4'];

/** What ends the film that is being made; null if none is. */
export const filming = signal(null);

/** Whether a panel has something that is drawn. */
export const isDrawn = ({ element }) => [...element.querySelectorAll('canvas')].some((canvas) => canvas.clientWidth > 0);

const settled = () => new Promise((resolve) => { setTimeout(resolve, SETTLED_MS); });

/** Draws all canvases of a panel at their places, and the time. */
function paint(context, element) {
  const { canvas } = context;
  const own = element.getBoundingClientRect();
  const scale = canvas.width / own.width;
  context.fillStyle = css('--panel');
  context.fillRect(0, 0, canvas.width, canvas.height);
  for (const one of element.querySelectorAll('canvas')) {
    const { left, top, width, height } = one.getBoundingClientRect();
    if (width > 0 && one.width > 0) context.drawImage(one, (left - own.left) * scale, (top - own.top) * scale, width * scale, height * scale);
  }
  context.font = `${13 * scale}px ${css('--font')}`;
  context.fillStyle = css('--text');
  context.fillText(time(shownTime.peek()), 8 * scale, 20 * scale);
}

/** Plays the span, and saves what a panel, {element, title}, has drawn meanwhile. */
export async function film({ element, title }) {
  const type = globalThis.MediaRecorder && TYPES.find((one) => MediaRecorder.isTypeSupported(one));
  if (!type) return notify('error', 'this browser makes no films', 'use a current Chromium or Firefox, or save pictures of the panel');
  const [begin, end] = span.value;
  const { width, height } = element.getBoundingClientRect();
  const scale = window.devicePixelRatio || 1;
  // Coders take even sizes.
  const canvas = Object.assign(document.createElement('canvas'), { width: 2 * Math.round((width * scale) / 2), height: 2 * Math.round((height * scale) / 2) });
  const context = canvas.getContext('2d', { alpha: false });
  const recorder = new MediaRecorder(canvas.captureStream(RATE), { mimeType: type, videoBitsPerSecond: BITS });
  const parts = [];
  recorder.ondataavailable = ({ data }) => parts.push(data);
  const loops = looping.value;
  [playing.value, looping.value] = [false, false];
  filming.value = () => { playing.value = false; };
  seek(begin);
  await settled();
  let frame = requestAnimationFrame(function draw() {
    paint(context, element);
    frame = requestAnimationFrame(draw);
  });
  recorder.start();
  playSpan();
  await new Promise((resolve) => {
    const stop = effect(() => { if (!playing.value) setTimeout(() => { stop(); resolve(); }); });
  });
  await settled();
  await new Promise((resolve) => {
    recorder.onstop = resolve;
    recorder.stop();
  });
  cancelAnimationFrame(frame);
  [filming.value, looping.value] = [null, loops];
  const name = `${title.toLowerCase().replaceAll(/[^\p{L}\p{N}_]+/gu, '-')}-${(begin / 1e6).toFixed(2)}-${(end / 1e6).toFixed(2)}`;
  return download(`${name}.${type.includes('mp4') ? 'mp4' : 'webm'}`, new Blob(parts, { type: recorder.mimeType }));
}
