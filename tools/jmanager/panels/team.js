// The players of a match in one view: a map of all of them, and a row for each.

import { below, right, within } from '../lib/places.js';

const NAME = '{GameController.me.team}-{GameController.me.player}';
const GROUP = 'GameController.me.team';
const COLUMNS = ['GameController.state', 'GameController.order', 'GameController.penalty', 'GameController.message_budget', 'Roles.role', 'Roles.time_to_ball', 'Roles.claim', 'TeamComm.intention', 'TeamBall.own_age', 'TeamBall.age'];

const map = { shown: ['FieldPose.field_pose', 'TeamBall.own_position', 'TeamBall.fused'], label: `${NAME} {Roles.role} · {TeamComm.intention}`, short: '{GameController.me.player}', group: GROUP };
const table = { rows: COLUMNS, sessions: true, group: GROUP };

export default {
  label: NAME,
  panels: {},
  lastPresets: {
    team: {
      title: 'Team',
      needs: 'component:TeamComm',
      first: 2,
      panels: (width, height) => [
        ['map', { params: map }],
        ['table:1', { ...(width < 1400 ? below('map', height * 0.37) : right('map', width * 0.52)), title: 'Players', params: table }],
        ['component:GameController', width < 1400 ? within('table:1') : below('table:1', height * 0.55)],
        ['timeline', within(width < 1400 ? 'table:1' : 'component:GameController')],
        ['log', within('timeline')],
      ],
    },
  },
};
