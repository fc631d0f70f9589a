// Programs and runs of them, as lessons of the courses see them.
import type { ApplicationView, DictionaryView, OnikonView, RunView, StepView } from '../../src/api.gen'
import type { Seen } from '../../src/help/tutorial'

export const OPEN: StepView = { role: 'job', name: 'opengripC' }
export const MOVE: StepView = { role: 'job', name: 'jmoveC' }
export const MOVE_RIGHT: StepView = { role: 'job', name: 'jmove_rightC' }
export const VISIT: StepView = { role: 'application', name: 'visit' }
const onikon = (more: Partial<OnikonView>): OnikonView => ({
  type: '',
  role: 'job',
  order: 0,
  dictionary: '/shipped',
  left: '0',
  right: '0',
  picture: '',
  ...more,
})
const onikons = {
  opengripC: onikon({ hardware: ['gripper'] }),
  jmoveC: onikon({ hardware: ['puma'], takes: ['Joint object'] }),
  jmove_rightC: onikon({ hardware: ['puma_right'], takes: ['Joint object'] }),
  visit: onikon({ role: 'application' }),
  mine: onikon({ role: 'application', dictionary: '/own' }),
}
const dictionaries: Record<string, DictionaryView> = {
  '/shipped': { name: 'boxes', path: '/shipped', order: 0, onikons: 4, is_shipped: true },
  '/own': { name: 'own', path: '/own', order: 1, onikons: 1 },
}

export const view = (flows: Record<string, StepView[]>, more: Partial<ApplicationView> = {}): ApplicationView => {
  const steps: Record<string, StepView> = {}
  const numbered = Object.entries(flows).map(([path, all]) => {
    const numbers = all.map((step) => {
      const number = Object.keys(steps).length + 1
      steps[number] = step
      return number
    })
    return [path, { steps: numbers }] as const
  })
  return { name: 'x', order: 0, flows: Object.fromEntries(numbered), steps, ...more }
}
/** A run that came to its end, in which the steps were done so often. */
export const over = (times: Record<number, number> = {}, more: Partial<RunView> = {}): RunView => ({
  doc: 'a1',
  name: 'x',
  number: 1,
  state: 'over',
  is_completed: true,
  steps: Object.fromEntries(Object.entries(times).map(([number, times]) => [number, { times }])),
  ...more,
})
export const meeting = (...tags: string[]): Partial<RunView> => ({
  meets: tags.map((tag) => ({ tag, flows: ['flow0', 'flow1'], skew_us: 0, at_s: 1 })),
})
export const seen = (view: ApplicationView, run: RunView | null): Seen => ({
  isUpper: true,
  app: 'a1',
  view,
  run,
  types: {},
  onikons,
  dictionaries,
})
export const named = (
  name: string,
  flows: Record<string, StepView[]>,
  more: Partial<ApplicationView> = {},
): ApplicationView => view(flows, { name, base: '/shipped', ...more })
export const incomplete = { is_completed: false }
export const stopped: Partial<RunView> = {
  is_completed: false,
  stops: { flow0: { text: { key: 'x' } as never, kind: 'error', at_s: 1 } },
}
export const ofAnother = { doc: 'a2' }
