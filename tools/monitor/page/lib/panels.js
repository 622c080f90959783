// All panels, those of the program's extensions too: the name in a layout, the title, and the component that shows it.

import { Tree } from '../panels/tree.js';
import { Timeline } from '../panels/timeline.js';
import { ComponentTab } from '../panels/component.js';
import { Camera } from '../panels/camera.js';
import { FieldMap } from '../panels/field.js';
import { Plot } from '../panels/plot.js';
import { Latency } from '../panels/latency.js';
import { Log } from '../panels/log.js';
import { Drive } from '../panels/drive.js';
import { Recordings } from '../panels/recordings.js';
import { Designer } from '../panels/vicode.js';
import { Code } from '../panels/code.js';
import { Inspector } from '../panels/inspector.js';
import { Sources } from '../panels/sources.js';
import { EXTENSIONS } from '../extensions.js';

export const PANELS = {
  tree: { title: 'Activation tree', view: Tree },
  timeline: { title: 'Timeline', view: Timeline },
  component: { title: 'Component', view: ComponentTab },
  camera: { title: 'Camera', view: Camera },
  field: { title: 'Field', view: FieldMap },
  plot: { title: 'Plot', view: Plot, many: true },
  latency: { title: 'Latency', view: Latency },
  log: { title: 'Log', view: Log },
  drive: { title: 'Drive', view: Drive },
  recordings: { title: 'Recordings', view: Recordings },
  vicode: { title: 'Designer', view: Designer },
  code: { title: 'Code', view: Code },
  inspector: { title: 'Inspector', view: Inspector },
  sources: { title: 'Sources', view: Sources },
  ...Object.assign({}, ...EXTENSIONS.map(({ panels }) => panels)),
};
