// Images: YUYV to RGBA, PNG, and drawing with zoom.

import { useEffect, useRef } from './dom.js';

const CLAMP = new Uint8ClampedArray(1);
// Contributions of Cb and Cr (JFIF), in fixed point.
const RED_OF_CR = Int32Array.from({ length: 256 }, (_, cr) => Math.round(1.402 * (cr - 128)));
const GREEN_OF_CR = Int32Array.from({ length: 256 }, (_, cr) => Math.round(-0.714136 * 65536 * (cr - 128)));
const GREEN_OF_CB = Int32Array.from({ length: 256 }, (_, cb) => Math.round(-0.344136 * 65536 * (cb - 128)));
const BLUE_OF_CB = Int32Array.from({ length: 256 }, (_, cb) => Math.round(1.772 * (cb - 128)));

/** Decodes YUYV into the pixels of an ImageData. */
export function decode(yuyv, data) {
  const count = Math.min(yuyv.length >> 2, data.length >> 3);
  for (let pair = 0, from = 0, to = 0; pair < count; pair += 1, from += 4, to += 8) {
    const [cb, cr] = [yuyv[from + 1], yuyv[from + 3]];
    const red = RED_OF_CR[cr];
    const green = (GREEN_OF_CB[cb] + GREEN_OF_CR[cr]) >> 16;
    const blue = BLUE_OF_CB[cb];
    const [first, second] = [yuyv[from], yuyv[from + 2]];
    // `data` clamps.
    data[to] = first + red;
    data[to + 1] = first + green;
    data[to + 2] = first + blue;
    data[to + 3] = 255;
    data[to + 4] = second + red;
    data[to + 5] = second + green;
    data[to + 6] = second + blue;
    data[to + 7] = 255;
  }
}

/** Y, Cb, Cr of a pixel. */
export function pixel({ width, pixels }, x, y) {
  const at = (y * width + (x & ~1)) * 2;
  return [pixels[at + (x & 1) * 2], pixels[at + 1], pixels[at + 3]];
}

/** RGB of a pixel. */
export function rgb(y, cb, cr) {
  const clamp = (value) => {
    CLAMP[0] = value;
    return CLAMP[0];
  };
  return [clamp(y + RED_OF_CR[cr]), clamp(y + ((GREEN_OF_CB[cb] + GREEN_OF_CR[cr]) >> 16)), clamp(y + BLUE_OF_CB[cb])];
}

/** A picture in a canvas of the image's size, decoded again only for another image. */
export class Picture {
  constructor() {
    this.canvas = document.createElement('canvas');
    this.shown = null;
  }

  of(image) {
    if (this.shown === image) return this.canvas;
    const { width, height } = image;
    if (this.canvas.width !== width || this.canvas.height !== height || !this.data) {
      [this.canvas.width, this.canvas.height] = [width, height];
      this.context = this.canvas.getContext('2d');
      this.data = this.context.createImageData(width, height);
    }
    decode(image.pixels, this.data.data);
    this.context.putImageData(this.data, 0, 0);
    this.shown = image;
    return this.canvas;
  }
}

/** Where an image is drawn in a panel: fitted, then zoomed and moved. */
export function placed(image, width, height, zoom) {
  const fit = Math.min(width / image.width, height / image.height);
  const scale = fit * zoom.scale;
  const left = width / 2 - image.width * scale * zoom.x;
  const top = height / 2 - image.height * scale * zoom.y;
  return {
    scale, left, top,
    x: (column) => left + column * scale,
    y: (row) => top + row * scale,
    pixel: (x, y) => [Math.floor((x - left) / scale), Math.floor((y - top) / scale)],
  };
}

export const FITTED = { scale: 1, x: 0.5, y: 0.5 };

/** Zooms around a point of the panel. */
export function zoomed(image, width, height, zoom, factor, x, y) {
  const place = placed(image, width, height, zoom);
  const [partX, partY] = [(x - place.left) / place.scale / image.width, (y - place.top) / place.scale / image.height];
  const scale = Math.min(Math.max(zoom.scale * factor, 1), 40);
  if (scale === 1) return FITTED;
  const next = placed(image, width, height, { ...zoom, scale });
  return { scale, x: partX + (width / 2 - x) / next.scale / image.width, y: partY + (height / 2 - y) / next.scale / image.height };
}

/**
 * Handlers of a picture: zoom with the wheel, move by dragging, the pixel under the pointer. A press lasts over several renderings: each
 * image of a live camera causes one.
 */
export function usePicture(image, zoom, pointer) {
  const start = useRef(null);
  return {
    onWheel(event) {
      const one = image();
      if (!one) return;
      event.preventDefault();
      const { clientWidth, clientHeight } = event.currentTarget;
      zoom.value = zoomed(one, clientWidth, clientHeight, zoom.value, event.deltaY > 0 ? 0.8 : 1.25, event.offsetX, event.offsetY);
    },
    onPointerDown(event) {
      event.currentTarget.setPointerCapture(event.pointerId);
      start.current = { x: event.offsetX, y: event.offsetY, zoom: zoom.value };
    },
    onPointerMove(event) {
      pointer.value = { x: event.offsetX, y: event.offsetY };
      const [one, from] = [image(), start.current];
      if (!from || !one || event.buttons === 0 || from.zoom.scale === 1) return;
      const { scale } = placed(one, event.currentTarget.clientWidth, event.currentTarget.clientHeight, from.zoom);
      zoom.value = { ...from.zoom, x: from.zoom.x - (event.offsetX - from.x) / scale / one.width, y: from.zoom.y - (event.offsetY - from.y) / scale / one.height };
    },
    onPointerUp() { start.current = null; },
    onPointerLeave() {
      start.current = null;
      pointer.value = null;
    },
  };
}

/** Works on the shown image, again for each new one, one at a time; `work` gets the image. */
export function useEachImage(shown, visible, image, work, period, reads) {
  const latest = useRef(null);
  latest.current = { image, work };
  useEffect(() => {
    if (!shown) return undefined;
    let [busy, last] = [false, null];
    const timer = setInterval(async () => {
      const one = latest.current.image();
      if (busy || !visible.peek() || !one || one.number === last) return;
      [busy, last] = [true, one.number];
      await latest.current.work(one);
      busy = false;
    }, period);
    return () => clearInterval(timer);
  }, [shown, period, reads]);
}
