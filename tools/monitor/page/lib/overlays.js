// What components found in an image: information with the unit px, drawn on the picture.

import { css, curveColour } from './theme.js';

/** Lists the information of a tree that can be drawn: [{component, info, name, place}] by component. */
export function drawable(description) {
  const found = [];
  description?.components.forEach((component, place) => {
    const infos = component.info.map((info, index) => ({ ...info, index })).filter(({ unit, name, type }) => unit === 'px' && !/u16|size/.test(type + name));
    const extra = component.info.map((info, index) => ({ ...info, index })).filter(({ name }) => name === 'sighting_confidence');
    if (infos.length > 0) found.push({ component: component.name, place, infos, extra });
  });
  return found;
}

const isPoint = (value) => value !== null && typeof value === 'object' && typeof value.x === 'number' && typeof value.y === 'number';

/** Longest time from the cycle that takes an image in to the last component that has used it, µs. */
const USED = 33e3;

/** Reads the values that belong to an image: the last ones before the next image. */
function valueAt(shown, place, index, time, live) {
  const information = shown.info_of(place, index);
  return live ? information.at(time) : information.now.value?.value;
}

/** Draws one component's findings. `at` maps columns and rows to the panel. */
export function drawOverlay(context, shown, overlay, number, image, at, live) {
  const colour = overlayColour(number);
  const read = ({ index }) => valueAt(shown, overlay.place, index, image.findings_us ?? image.time_us + USED, live);
  const values = overlay.infos.map((info) => ({ info, value: read(info) }));
  const radius = values.find(({ info }) => info.name.startsWith('radius'))?.value;
  const confidence = overlay.extra.length > 0 ? read(overlay.extra[0]) : null;
  context.strokeStyle = colour;
  context.fillStyle = colour;
  context.lineWidth = 2;
  context.font = `12px ${css('--font')}`;
  for (const { info, value } of values) {
    if (isPoint(value)) drawPoint(context, at, value, radius, `${overlay.component}${confidence ? ` ${confidence.toFixed(2)}` : ''}`, colour);
    else if (Array.isArray(value)) drawPoints(context, at, value, info, overlay.component, image);
    else if (typeof value === 'number' && !info.name.startsWith('radius')) drawLine(context, at, value, info.name, image);
  }
}

export const overlayColour = (number) => curveColour(number + 3);

function label(context, text, x, y, colour) {
  const width = context.measureText(text).width;
  context.fillStyle = css('--shade');
  context.beginPath();
  context.roundRect(x, y - 9, width + 10, 18, 4);
  context.fill();
  context.fillStyle = colour;
  context.textBaseline = 'middle';
  context.fillText(text, x + 5, y);
}

function drawPoint(context, at, { x, y }, radius, text, colour) {
  const size = Math.max((radius ?? 3) * at.scale, 4) + 2;
  context.beginPath();
  context.arc(at.x(x), at.y(y), size, 0, 2 * Math.PI);
  context.stroke();
  label(context, text, at.x(x) + size + 5, at.y(y), colour);
}

function drawPoints(context, at, points, info, component, image) {
  const known = points.filter(isPoint);
  if (known.length === 2 && info.name === 'ends') {
    context.beginPath();
    context.moveTo(at.x(known[0].x), at.y(known[0].y));
    context.lineTo(at.x(known[1].x), at.y(known[1].y));
    context.stroke();
    return;
  }
  for (const point of known) {
    context.beginPath();
    context.moveTo(at.x(point.x), at.y(Math.max(0, point.y - image.height / 4)));
    context.lineTo(at.x(point.x), at.y(point.y));
    context.stroke();
    context.beginPath();
    context.arc(at.x(point.x), at.y(point.y), 4, 0, 2 * Math.PI);
    context.fill();
  }
  if (known.length > 0) label(context, component, at.x(known[0].x) + 8, at.y(known[0].y), context.strokeStyle);
}

function drawLine(context, at, row, name, image) {
  if (row < -image.height || row > 2 * image.height) return;
  context.save();
  context.setLineDash([6, 5]);
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(at.x(0), at.y(row));
  context.lineTo(at.x(image.width), at.y(row));
  context.stroke();
  context.restore();
  context.textBaseline = 'bottom';
  context.fillText(name, at.x(0) + 6, at.y(row) - 2);
}
