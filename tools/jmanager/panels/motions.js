// The motion editor for the robots of this program.

import { right } from '../lib/places.js';
import { ask } from '../lib/store.js';
import { later } from '../lib/ui.js';

export default {
  /** The links of the robot with these joints, for the map in three dimensions; null for another robot. */
  body: (session, joints) => ask('extension', { session: session.id, name: 'motions', message: { type: 'body', joints } }),
  panels: { motion: { title: 'Motion', view: later(() => import('../motion/panel.js'), 'Motion') } },
  lastPresets: { motions: { title: 'Editing motions', panels: (width) => [['motion', {}], ['code', right('motion', Math.max(320, width * 0.28))]] } },
};
