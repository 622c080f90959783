// A canvas that is drawn at most once a frame, only if it is visible and something that it shows changed.

import { effect, html, useEffect, useRef } from './dom.js';
import { theme } from './theme.js';

/**
 * A canvas that fills its parent. `reads` reads the signals on which the drawing depends; `draw(context, width, height)` draws in
 * CSS pixels.
 */
export function Canvas({ reads, draw, visible, label, onReady, ...handlers }) {
  const canvas = useRef(null);
  const latest = useRef(draw);
  latest.current = draw;
  const schedule = useRef(() => {});

  useEffect(() => {
    const element = canvas.current;
    const context = element.getContext('2d');
    let frame = 0;
    const paint = () => {
      frame = 0;
      const { clientWidth: width, clientHeight: height } = element;
      if (!visible.peek() || width === 0 || height === 0) return;
      const scale = window.devicePixelRatio || 1;
      const [pixelsX, pixelsY] = [Math.round(width * scale), Math.round(height * scale)];
      if (element.width !== pixelsX || element.height !== pixelsY) {
        element.width = pixelsX;
        element.height = pixelsY;
      }
      context.setTransform(scale, 0, 0, scale, 0, 0);
      context.clearRect(0, 0, width, height);
      latest.current(context, width, height);
    };
    schedule.current = () => { frame ||= requestAnimationFrame(paint); };
    const observer = new ResizeObserver(() => schedule.current());
    observer.observe(element);
    onReady?.(element, () => schedule.current());
    return () => {
      observer.disconnect();
      cancelAnimationFrame(frame);
    };
  }, []);
  // With another session other signals are read.
  useEffect(() => effect(() => {
    void theme.value;
    void visible.value;
    reads();
    schedule.current();
  }));

  return html`<canvas ref=${canvas} class="fill" role="img" aria-label=${label} ...${handlers}></canvas>`;
}

/** Draws a straight line. */
export function line(context, x1, y1, x2, y2) {
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(x2, y2);
  context.stroke();
}

/** Draws within a rectangle only. */
export function within(context, x, y, width, height, draw) {
  context.save();
  context.beginPath();
  context.rect(x, y, width, height);
  context.clip();
  draw();
  context.restore();
}

/** Fills a rectangle with round corners. */
export function rounded(context, x, y, width, height, radius) {
  context.beginPath();
  context.roundRect(x, y, width, height, radius);
  context.fill();
}
