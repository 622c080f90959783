// All panels, those of the program's extensions too: the name in a layout, the title, the component that shows it, and
// whether a session has something for it.

import { Tree } from '../panels/tree.js';
import { Timeline } from '../panels/timeline.js';
import { ComponentTab } from '../panels/component.js';
import { Camera } from '../panels/camera.js';
import { GroundMap, hasMap } from '../panels/map.js';
import { Latency } from '../panels/latency.js';
import { Log } from '../panels/log.js';
import { Table } from '../panels/table.js';
import { Watches } from '../panels/watches.js';
import { Drive, canDrive } from '../panels/drive.js';
import { Recordings } from '../panels/recordings.js';
import { later } from './ui.js';
import { EXTENSIONS } from '../extensions.js';

export const PANELS = {
  tree: { title: 'Activation tree', view: Tree },
  timeline: { title: 'Timeline', view: Timeline },
  component: { title: 'Component', view: ComponentTab },
  camera: { title: 'Camera', view: Camera, offered: (shown) => shown.info.value.can.images },
  map: { title: 'Map', view: GroundMap, offered: hasMap },
  plot: { title: 'Plot', view: later(() => import('../panels/plot.js'), 'Plot'), many: true },
  table: { title: 'Table', view: Table, many: true },
  latency: { title: 'Latency', view: Latency, offered: (shown) => shown.info.value.can.costs },
  log: { title: 'Log', view: Log },
  watches: { title: 'Watches', view: Watches },
  drive: { title: 'Drive', view: Drive, offered: canDrive },
  recordings: { title: 'Recordings', view: Recordings },
  vicode: { title: 'Designer', view: later(() => import('../panels/vicode.js'), 'Designer') },
  code: { title: 'Code', view: later(() => import('../panels/code.js'), 'Code') },
  inspector: { title: 'Inspector', view: later(() => import('../panels/inspector.js'), 'Inspector') },
  sources: { title: 'Sources', view: later(() => import('../panels/sources.js'), 'Sources') },
  ...Object.assign({}, ...EXTENSIONS.map(({ panels }) => panels)),
};
