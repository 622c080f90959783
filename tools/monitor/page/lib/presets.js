// Layouts for common work: lists of panels, each with its place beside an earlier one.

import { EXTENSIONS } from '../extensions.js';
import { driven } from '../panels/drive.js';
import { below, belowIfWide, right, within } from './places.js';

/** Tabs of what moves the body of a robot, and curves of its velocity. */
function driving(description) {
  const { body } = description ? driven(description) : {};
  if (!body) return [[], []];
  const { components } = description;
  const moved = components[body.component].links.filter(({ kind }) => kind === 'modulation');
  const parts = [...new Set([body.component, ...moved.map(({ to }) => to)])].map((index) => components[index]);
  const moving = parts.flatMap(({ name, info }) => info.filter(({ unit }) => unit === 'm/s, rad/s').map((one) => `${name}.${one.name}`)).at(-1);
  return [parts.map(({ name }) => `component:${name}`), moving ? body.arguments.map(({ name }) => `${moving}.${name}`) : []];
}

export const PRESETS = {
  overview: {
    title: 'Overview',
    panels: (width, height) => [
      ['tree', {}],
      ['timeline', below('tree', height * 0.32)],
      ['camera', right('tree', width * 0.5)],
      ['component', right('camera', Math.max(290, width * 0.24))],
      ['drive', within('component')],
      ['recordings', within('component')],
      ['map', belowIfWide('camera', height * 0.34, width)],
      ['plot:1', within('timeline')],
      ['watches', within('timeline')],
      ['log', within('timeline')],
      ['latency', within('timeline')],
    ],
  },
  behaviour: {
    title: 'Debugging behaviour',
    panels: (width, height) => [
      ['tree', {}],
      ['component', right('tree', Math.max(320, width * 0.3))],
      ['timeline', below('tree', height * 0.37)],
      ['log', below('component', height * 0.2)],
      ['plot:1', within('timeline')],
      ['watches', within('timeline')],
      ['drive', within('component')],
    ],
  },
  ...Object.assign({}, ...EXTENSIONS.map(({ presets }) => presets ?? {})),
  driving: {
    title: 'Driving',
    needs: 'drive',
    panels: (width, height, { shown }) => {
      const [own, curves] = driving(shown?.description.value);
      return [
        ['drive', {}],
        ['map', right('drive', width * 0.72)],
        ['component', right('map', Math.max(300, width * 0.25))],
        ...own.map((id) => [id, within('component')]),
        ['plot:1', { ...below('map', height * 0.42), params: { curves } }],
        ['timeline', within('plot:1')],
      ];
    },
  },
  replay: {
    title: 'Replay',
    panels: (width, height) => [
      ['camera', {}],
      ['timeline', below('camera', height * 0.36)],
      ['tree', right('camera', width * 0.6)],
      ['map', belowIfWide('camera', height * 0.3, width)],
      ['recordings', right('tree', Math.max(290, width * 0.22))],
      ['component', within('recordings')],
      ['log', within('timeline')],
      ['plot:1', within('timeline')],
      ['watches', within('timeline')],
    ],
  },
  designer: {
    title: 'Designing state machines',
    panels: (width, height, { hasSource }) => (!hasSource ? [['vicode', {}], ['tree', right('vicode', width * 0.6)]] : [
      ['sources', {}],
      ['vicode', right('sources', width - Math.max(190, width * 0.14))],
      ['code', right('vicode', Math.max(360, width * 0.33))],
      ['inspector', below('code', height * 0.42)],
      ['tree', within('sources')],
      ['component', within('inspector')],
      ['log', within('inspector')],
    ]),
  },
  ...Object.assign({}, ...EXTENSIONS.map(({ lastPresets }) => lastPresets ?? {})),
};
