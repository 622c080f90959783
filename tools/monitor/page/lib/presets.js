// Layouts for common work: lists of panels, each with its place beside an earlier one.

import { EXTENSIONS } from '../extensions.js';
import { below, narrow, right, within } from './places.js';

export const PRESETS = {
  overview: {
    title: 'Overview',
    panels: (width, height) => (width < 900
      ? narrow('tree', ['camera', 'field', 'component', 'drive'], ['timeline', 'plot:1', 'log', 'latency', 'recordings'])
      : [
        ['tree', {}],
        ['timeline', below('tree', height * 0.32)],
        ['camera', right('tree', width * 0.53)],
        ['component', right('camera', Math.max(290, width * 0.24))],
        ['drive', within('component')],
        ['recordings', within('component')],
        ['field', below('camera', height * 0.34)],
        ['plot:1', within('timeline')],
        ['log', within('timeline')],
        ['latency', within('timeline')],
      ]),
  },
  behaviour: {
    title: 'Debugging behaviour',
    panels: (width, height) => (width < 900
      ? narrow('tree', ['component', 'log'], ['timeline', 'plot:1'])
      : [
        ['tree', {}],
        ['component', right('tree', Math.max(320, width * 0.3))],
        ['timeline', below('tree', height * 0.37)],
        ['log', below('component', height * 0.2)],
        ['plot:1', within('timeline')],
        ['drive', within('component')],
      ]),
  },
  ...Object.assign({}, ...EXTENSIONS.map(({ presets }) => presets ?? {})),
  walking: {
    title: 'Walking',
    panels: (width, height) => (width < 900
      ? narrow('drive', ['field', 'component:Walk'], ['plot:1', 'timeline'])
      : [
        ['drive', {}],
        ['field', right('drive', width * 0.72)],
        ['component:Walk', right('field', Math.max(300, width * 0.25))],
        ['component:Body', within('component:Walk')],
        ['plot:1', { ...below('field', height * 0.42), params: { curves: ['Walk.velocity.forward', 'Walk.velocity.left', 'Walk.velocity.turn'] } }],
        ['timeline', within('plot:1')],
      ]),
  },
  replay: {
    title: 'Replay',
    panels: (width, height) => (width < 900
      ? narrow('camera', ['field', 'tree', 'recordings'], ['timeline', 'log', 'plot:1'])
      : [
        ['camera', {}],
        ['timeline', below('camera', height * 0.36)],
        ['tree', right('camera', width * 0.6)],
        ['field', below('camera', height * 0.3)],
        ['recordings', right('tree', Math.max(290, width * 0.22))],
        ['component', within('recordings')],
        ['log', within('timeline')],
        ['plot:1', within('timeline')],
      ]),
  },
  designer: {
    title: 'Designing state machines',
    panels: (width, height, hasSource) => (!hasSource ? [['vicode', {}], ['tree', right('vicode', width * 0.6)]] : width < 900
      ? narrow('vicode', ['sources', 'tree'], ['code', 'inspector', 'log'])
      : [
        ['sources', {}],
        ['vicode', right('sources', width - Math.max(190, width * 0.14))],
        ['code', right('vicode', Math.max(360, width * 0.33))],
        ['inspector', below('code', height * 0.42)],
        ['tree', within('sources')],
        ['component', within('inspector')],
        ['log', within('inspector')],
      ]),
  },
};
