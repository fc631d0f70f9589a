// A stand-in for the environment, for drawing the page without one: `?sample` while developing, never in the product.
import type { AnyAct, AnyMessage, LocusView, PinView, PlacedView, Objection, TaskView, Tree } from '../api.gen'
import type { Carrier } from './link'
import { answer } from './answer'
import { plain } from '../texts/say'

type Kinds = Record<string, PinView['kind']>
const KIND: Kinds = { c: 'INCONST', v: 'INVAR', b: 'INBOTH', C: 'OUTCONST', V: 'OUTVAR', B: 'OUTBOTH' }

/** A task from words such as `v:Y=Q_MEZ V:Y^=Q^_MEZ`: kind, coded name, alias. */
function task(
  library: string,
  order: number,
  name: string,
  hz: number,
  pins: string,
  more: Partial<TaskView> = {},
): TaskView {
  const rows = { in: 0, out: 0 }
  const views = pins
    .split(' ')
    .filter(Boolean)
    .map((word): PinView => {
      const [letter = 'v', rest = ''] = [word[0], word.slice(2)]
      const [coded = '', svar = coded] = rest.split('=')
      const side = letter === letter.toLowerCase() ? 'in' : 'out'
      const isCount = coded === 'NDOF'
      const shape = isCount ? 'int' : 'double[6]'
      return {
        name: coded,
        svar,
        kind: KIND[letter]!,
        y: 46 + 9 + 18 * rows[side]++,
        shape,
        unit: isCount ? '' : 'rad',
      }
    })
  const height = 46 + Math.max(rows.in, rows.out, 1) * 18 + 22
  return {
    name,
    library: `/lab/${library}`,
    order,
    hz,
    height,
    pins: views,
    module: name,
    file_hz: hz,
    width: 136,
    description: `What ${name} computes, in one sentence.`,
    path: `/lab/${library}/module/${name}.rmod`,
    code: `/lab/${library}/module/${name}.py`,
    ...more,
  }
}

const TASKS: TaskView[] = [
  task('generic', 1, 'diff', 500, 'c:NDOF v:Y=Q_MEZ V:Y^=Q^_MEZ', {
    module: 'zdiff',
    is_changed: true,
    local: [
      ['CUTOFF', ['40']],
      ['LIMIT', ['0.10']],
    ],
    description: 'Derivative of a vector: difference of two cycles, then a first-order filter.',
  }),
  task('generic', 2, 'fwdkin', 250, 'c:NDOF c:SCREW c:PARENT v:Q_MEZ V:X_MEZ'),
  task('generic', 3, 'gravcomp', 250, 'c:NDOF c:LINK c:PARENT v:Q_MEZ V:TAU_G'),
  task('generic', 4, 'invkin_dls', 250, 'c:NDOF c:SCREW c:PARENT v:X_REF v:X^_REF V:Q_REF'),
  task('generic', 5, 'jtraj', 250, 'c:NDOF v:Q_MEZ V:Q_REF V:Q^_REF', { is_trigger: true, object_type: 'Joint' }),
  task('generic', 6, 'jtraj_trapez', 250, 'c:NDOF v:Q_MEZ V:Q_REF V:Q^_REF', { is_trigger: true }),
  task('generic', 7, 'lowpass', 500, 'c:NDOF v:X V:Y'),
  task('generic', 8, 'recorder', 100, 'v:X'),
  task('generic', 9, 'pd', 500, 'c:NDOF c:KP c:KD v:Q_REF v:Q^_REF v:Q_MEZ v:Q^_MEZ V:TAU=TAU_PD'),
  task('generic', 10, 'pid', 500, 'c:NDOF c:KP c:KD c:KI v:Q_REF v:Q^_REF v:Q_MEZ v:Q^_MEZ V:TAU=TAU_PD'),
  task('generic', 11, 'rvel_gen', 250, 'c:NDOF v:X V:Q^_REF'),
  task('generic', 12, 'torque_sum', 500, 'c:NDOF v:A=TAU_PD v:B=TAU_G V:SUM=TAU_REF'),
  task('generic', 13, 'watchdog', 50, 'b:ALIVE v:X C:LIMIT'),
  task('generic', 14, 'wave_gen', 250, 'c:NDOF B:X_REF'),
  task('puma', 1, 'puma', 500, 'v:TAU_REF C:NDOF C:LINK C:PARENT C:KP C:KD V:Q_MEZ'),
  task('boxes', 1, 'led_monitor', 50, 'V:LED'),
]

const placed = (x: number, y: number, state: PlacedView['state'], more: Partial<PlacedView> = {}): PlacedView => ({
  x,
  y,
  state,
  rtpu: 'rt0',
  ...more,
})

const PLACED: Record<string, PlacedView> = {
  jtraj: placed(64, 166, 'ASKING', {
    ask: {
      items: [
        {
          name: 'endpoint',
          type: 'double',
          count: 6,
          unit: 'rad',
          meaning: 'Where the joints shall be.',
          low: [-2.8, -3.9, -0.8, -1.9, -1.7, -4.6],
          high: [2.8, 0.8, 3.9, 2.9, 1.7, 4.6],
        },
        {
          name: 'duration',
          type: 'double',
          count: 1,
          unit: 's',
          meaning: 'How long it may take.',
          default: [2],
          low: [0.1],
          high: [60],
        },
      ],
      present: { endpoint: [0, -1.57, 1.57, 0, 0, 0] },
    },
  }),
  pd: placed(312, 112, 'ON'),
  torque_sum: placed(536, 94, 'ON'),
  puma: placed(744, 94, 'ON'),
  diff: placed(312, 400, 'ERROR', {
    in_left: false,
    warnings: 1,
    error: {
      text: plain('Q_MEZ[3] jumped 0.41 rad in one cycle; at most 0.10 is believed.'),
      entry: 'cycle',
      line: 41,
      at_s: 42.318,
      path: '/lab/generic/module/zdiff.py',
      values: { Q_MEZ: [0.1, -0.7, 2.9, 0.86, 0, 0], LIMIT: 0.1 },
      traceback: 'Traceback (most recent call last):\n  File "zdiff.py", line 41, in cycle\n    raise ModuleError(...)',
      remedies: [
        { label: plain('Clear, switch on'), act: { t: 'Clear', doc: 'd1', task: 'diff', turns_on: true } },
        { label: plain('Show source'), show: { t: 'ShowSource', task: 'diff', line: 0 } },
      ],
    },
  }),
  gravcomp: placed(536, 400, 'ON', { in_left: false }),
  led_monitor: placed(744, 420, 'OFF', { rtpu: 'rt1' }),
}

const locus = (x: number, y: number, line: LocusView['line'], writers: string[], readers: string[]): LocusView => ({
  x,
  y,
  line,
  writers,
  readers,
})
const constant = (readers: string[]): LocusView => ({
  x: 900,
  y: 40,
  line: 'live',
  is_constant: true,
  is_shown: false,
  writers: ['puma'],
  readers,
})

const LOCI: Record<string, LocusView> = {
  Q_MEZ: locus(700, 356, 'live', ['puma'], ['pd', 'jtraj', 'diff', 'gravcomp']),
  'Q^_MEZ': locus(284, 412, 'stale', ['diff'], ['pd']),
  TAU_G: locus(508, 318, 'live', ['gravcomp'], ['torque_sum']),
  TAU_PD: locus(492, 167, 'live', ['pd'], ['torque_sum']),
  TAU_REF: locus(708, 149, 'live', ['torque_sum'], ['puma']),
  Q_REF: locus(240, 221, 'idle', ['jtraj'], ['pd']),
  'Q^_REF': locus(240, 239, 'idle', ['jtraj'], ['pd']),
  LED: locus(904, 475, 'idle', ['led_monitor'], []),
  NDOF: constant(['pd', 'diff', 'jtraj', 'gravcomp', 'torque_sum']),
  LINK: constant(['gravcomp']),
  PARENT: constant(['gravcomp']),
  KP: constant(['pd']),
  KD: constant(['pd']),
}

const onCanvas: Objection[] = [{ text: plain('on the canvas'), remedies: [] }]
const writes = (svar: string, other: string, mine: string): Objection[] => [
  {
    text: plain(`writes ${svar}, which ${other} already writes`),
    remedies: [
      { label: plain(`Replace ${other}`), act: { t: 'Exchange', doc: 'd1', old: other, new: mine } },
      { label: plain('Alias…'), show: { t: 'ShowLibraryTask', task: mine } },
      { label: plain(`Show ${other}`), show: { t: 'ShowTask', task: other } },
    ],
  },
]

export function sampleTree(): Tree {
  return {
    libraries: {
      '/lab/generic': {
        name: 'generic',
        path: '/lab/generic',
        order: 1,
        tasks: 14,
        faults: [plain('old.rmod:3: expected FREQ or PERIOD, found "FRQ"; the task is left out')],
      },
      '/lab/puma': { name: 'puma', path: '/lab/puma', order: 2, tasks: 1 },
      '/lab/boxes': { name: 'boxes', path: '/lab/boxes', order: 3, tasks: 1 },
    },
    tasks: Object.fromEntries(TASKS.map((task) => [task.name, task])),
    documents: {
      d1: {
        name: 'joint_move',
        order: 1,
        path: '/lab/boxes/conf/joint_move.conf',
        base: '/lab/boxes',
        is_moved: true,
        undo: plain('Move of gravcomp'),
        tasks: PLACED,
        loci: LOCI,
        groups: { balance: { tasks: ['gravcomp', 'torque_sum'] } },
        connection: 'live',
        subsystem: 'boxes',
        holder: 'You',
        is_held_here: true,
        greyed: {
          ...Object.fromEntries(Object.keys(PLACED).map((name) => [name, onCanvas])),
          jtraj_trapez: writes('Q_REF', 'jtraj', 'jtraj_trapez'),
          invkin_dls: writes('Q_REF', 'jtraj', 'invkin_dls'),
          pid: writes('TAU_PD', 'pd', 'pid'),
          rvel_gen: writes('Q^_REF', 'jtraj', 'rvel_gen'),
        },
        objections: { fwdkin: [{ text: plain('needs SCREW, which nobody here writes') }] },
        problems: {
          p1: {
            text: plain('diff is in ERROR: Q_MEZ[3] jumped 0.41 rad in one cycle.'),
            level: 'fault',
            show: { t: 'ShowTask', task: 'diff' },
          },
          w1: {
            text: plain('LED is written and nobody reads it.'),
            level: 'note',
            show: { t: 'ShowLocus', svar: 'LED' },
          },
        },
      },
      d2: { name: 'cart_move', order: 2, path: '/lab/boxes/conf/cart_move.conf' },
      d3: { name: 'Untitled-1', order: 3, is_dirty: true },
    },
    files: Object.fromEntries(
      ['joint_move', 'cart_move', 'home', 'open_gripper', 'close_gripper'].map((name, k) => [
        `/lab/boxes/conf/${name}.conf`,
        { name, base: k < 3 ? '/lab/boxes' : '/lab/puma', path: `/lab/boxes/conf/${name}.conf`, tasks: 4 + k },
      ]),
    ),
    runtime: {
      state: 'linked',
      address: 'this machine',
      units: { rt0: { load: 0.61 }, rt1: { load: 0.14 } },
      worlds: { boxes: true },
      subsystems: { boxes: 'You' },
    },
    preferences: { shows_period: false, warnings: true },
    buttons: { home: { command: 'onika run home.appl', order: 1 } },
    job_types: ['Complete job', 'Joint job'],
    edges: {
      none: [
        'grey',
        [
          [4, 16],
          [-4, 16],
        ],
      ],
      joint: [
        'yellow',
        [
          [0, 9],
          [8, 3],
          [0, 8],
          [-8, 3],
          [0, 9],
        ],
      ],
    },
    people: 1,
  }
}

/** A carrier that behaves as a connection would, to an environment that knows a few acts. */
export function carrier(): Carrier {
  // `?sample=1000`: as many more tasks in the first library
  const many = Number(new URLSearchParams(location.search).get('sample')) || 0
  const tree = sampleTree()
  for (let k = 0; k < many; k++)
    tree.tasks![`t${k}`] = task(
      'generic',
      100 + k,
      `t${k}`,
      100,
      'c:NDOF v:X V:Y'
        .split(' ')
        .slice(0, 1 + (k % 3))
        .join(' '),
    )
  const carrier: Carrier = {
    onopen: null,
    onclose: null,
    onmessage: null,
    send: (text) =>
      void queueMicrotask(() => {
        const { cid, act } = JSON.parse(text) as { cid: number; act: AnyAct }
        answer(act, cid, say)
      }),
    close: () => carrier.onclose?.(undefined as never),
  }
  const say = (message: AnyMessage): void => {
    carrier.onmessage?.({ data: JSON.stringify(message) })
  }
  setTimeout(() => say({ t: 'Snapshot', rev: 0, tree, version: 'sample', you: 'You' }))
  return carrier
}
